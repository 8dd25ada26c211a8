"""How a scene comes to draw with a Style that no file has."""

from . import pens, properties


def apply(scene, chosen):
    """Makes a scene draw with a Style; sentences about what of it cannot be said."""
    settings, last = scene.fovea, chosen.line_sets[-1]
    settings.style = "plain"
    kinds = {name: values for line_set in chosen.line_sets for name, values in line_set.kinds.items()}
    for definition in properties.definitions():
        setattr(settings, definition["name"], definition["name"] in kinds)
        properties.set_parameters(settings, definition["name"], kinds.get(definition["name"], {}))
    pens.set_pen(settings, pens.VISIBLE, last.pen)
    pens.set_hidden(settings, last)
    return [f"'{line_set.name}': its pen" for line_set in chosen.line_sets[:-1] if line_set.pen != last.pen]
