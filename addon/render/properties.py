# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of scenes, objects and materials. A scene has the focus, the method of drawing and a pointer to its style.

Styles are separate datablocks: style_data.py.
"""

import bpy

from ..focus import focus_settings
from ..scene import followed, own_lines, repair, section
from ..scene.property_kinds import SHARE, choice, new_group, number, part, pointer, redraw, switch, text, whole_number
from ..scene.shapes import SHAPES
from ..style import style_data, style_read
from . import drawing_scale, gpu_context, lines_over, methods, passes, vector_settings


def style_of(scene, styled=None, given=None):
    """The Style of a scene, with focus and mix applied; of an evaluated scene, with the animated values of its frame.
    `styled`: the scene whose style it is, if that is another one. `given`: a Style to draw with in place of the scene's
    own and of what that is mixed with.

    Creates no datablocks: scenes without a style draw the default one."""
    chosen = given or _own_style(styled or scene)
    transparent = chosen.paper.transparent or scene.render.film_transparent
    paper = chosen.paper.replace(transparent=transparent)
    return chosen.replace(paper=paper, focus=focus_settings.focus_of(scene.fovea))


def _own_style(scene):
    tree, other = style_data.of(scene), scene.fovea.mixed_style
    chosen = style_read.read(tree) if tree else style_data.default()
    if scene.fovea.mix > 0.0 and style_data.is_style(other):
        chosen = chosen.mixed(style_read.read(other), scene.fovea.mix)
    return chosen


def style_drawn(depsgraph, given=None, lines_alone=False):
    """The Style that renders of a depsgraph's scene draw. `given`: as for `style_of`. `lines_alone`: without paper and
    colors, as that of scenes always is that draw lines over another one's renders."""
    chosen = style_of(followed.evaluated(depsgraph), _styled(depsgraph), given)
    if not (lines_alone or followed.follows(depsgraph.scene)):
        return chosen
    return chosen.replace(paper=chosen.paper.replace(transparent=True), color=chosen.color.replace(shading="plain"))


def _styled(depsgraph):
    """The evaluated scene whose style a depsgraph's renders draw: one that follows another may have its own."""
    return depsgraph.scene_eval if style_data.of(depsgraph.scene_eval) else followed.evaluated(depsgraph)


def line_set_names(scene):
    """Names of the line sets that renders of a scene may draw, whatever its mix is at some frame."""
    tree, other = style_data.of(scene), scene.fovea.mixed_style
    sets = list(tree.fovea.line_sets if tree else style_data.default().line_sets)
    sets += other.fovea.line_sets if style_data.is_style(other) else ()
    return [line_set.name for line_set in sets]


def density_map(depsgraph):
    """The image that controls the density of lines in elision, or None."""
    tree = style_data.of(_styled(depsgraph))
    return tree.fovea.elision.density_image if tree else None


def _backend_chosen(settings, context):
    if settings.backend == "GPU":
        gpu_context.demand()
    redraw(settings, context)


BACKENDS = [
    ("AUTO", "Automatic", "GPU where it is hardware, else CPU"),
    ("CPU", "CPU", "The same picture on every machine"),
    ("GPU", "GPU", "OpenGL through Blender, in software where there is no hardware"),
]
BLENDS = [
    ("OVER", "Over", "Lines have the colors of their pens"),
    ("MULTIPLY", "Multiply", "Lines darken the picture, as pencils do"),
]
USAGES = [
    ("BOTH", "Include", "Has lines and hides what lies behind"),
    ("OCCLUDE", "Occlusion Only", "Hides what lies behind, has no lines"),
    ("DRAW", "No Occlusion", "Has lines and hides nothing"),
    ("IGNORE", "Exclude", "Is not there"),
]
HAIR = [
    ("RIBBONS", "Ribbons", "Each strand is as wide as its radius: it has an outline and hides what lies behind"),
    ("LINES", "Lines", "Each strand is a line, as loose edges are, and hides nothing"),
    ("OFF", "Off", "Hair is not there"),
]
ESTIMATORS = [
    ("AUTOMATIC", "Automatic", "Accurate, over a radius by how noisy the mesh is"),
    ("JETS", "Accurate", "Polynomials fitted to the surroundings of each vertex"),
    ("ONE_RING", "Fast", "Differences of neighboring normals, for regular meshes"),
]
OCCLUSIONS = [
    ("AUTOMATIC", "Automatic", "Hides what lies behind where it is opaque, by the image of its alpha"),
    ("ALWAYS", "Always", "Hides what lies behind, as a whole"),
    ("NEVER", "Never", "Lines behind it show"),
]


def _scene_group(vectors):
    of_style = {"type": bpy.types.NodeTree, "poll": lambda _settings, tree: style_data.is_style(tree)}
    follows = "The scene over whose pictures this one draws lines"
    lies = "How lines lie over what another engine renders"
    in_viewports = "Lines lie over 3D viewports in Solid, Material Preview and Rendered shading, too"
    told = "Another style, into which the drawing may go over: lines of both go from pen to pen, others fade"
    annotations = {
        "style": pointer("Style", "How the lines look and what lies under them; none: the default style", **of_style),
        "mixed_style": pointer("Mix With", told, **of_style),
        "mix": number("Mix", "How far the drawing has gone over into the other style: 0 not at all, 1 wholly", **SHARE),
        "backend": choice("Device", "What draws the lines", items=BACKENDS, update=_backend_chosen),
        "vectors": part(vectors),
        **methods.properties(),
        **focus_settings.annotations(),
        "lines_blend": choice("Blend", lies, items=BLENDS, get=lines_over.blend, set=lines_over.set_blend),
        "lines_in_viewports": switch("Show in Viewports", in_viewports, default=True),
        "lines_of": pointer("Lines Of", follows, type=bpy.types.Scene, options={"HIDDEN"}),
        "lines_of_layer": switch("Of a View Layer", "Only those of one of its view layers", options={"HIDDEN"}),
        **section.annotations(),
        **drawing_scale.annotations(),
    }
    return new_group("FoveaSceneSettings", "How a scene is drawn.", annotations)


def _object_group(kinds):
    told = "Of lines that crowd each other, those of objects with more priority stay"
    group = "Objects with the same name here have one outline together: no silhouette or contour between them"
    annotations = {
        "usage": choice("Usage", "Whether the object has lines, and hides those behind it", items=USAGES),
        "hair": choice("Hair", "How hair curves, and hair of particles, are drawn", items=HAIR),
        "priority": number("Priority", told, default=0.5, **SHARE),
        "shape": choice("Draw As", "What the faces stand for, which decides the lines that suit them", items=SHAPES),
        "outline_group": text("Outline Group", group),
        **_curvature_properties(),
        **own_lines.annotations(kinds),
        **_shape_properties(),
    }
    return new_group("FoveaObjectSettings", "How an object is drawn.", annotations, **repair.removed_attributes())


def _curvature_properties():
    rings = "How many edges around each vertex count, 0: by how noisy the mesh is"
    smoothing = "How far curvature is averaged, in edge lengths; never across hard edges"
    return {
        "curvature_estimator": choice(
            "Curvature", "How curvature, which many lines follow, is found", items=ESTIMATORS
        ),
        "curvature_rings": whole_number("Radius (Edges)", rings, min=0, max=32),
        "curvature_smoothing": number("Smoothing", smoothing, min=0.0, max=8.0),
    }


def _material_group():
    lines = (
        "Faces of this material have lines. Off: only those they share with faces of another material, "
        "as for an eye or a decal"
    )
    hides = "Whether surfaces of this material hide the lines behind them"
    annotations = {
        "lines": switch("Lines", lines, default=True),
        "occlusion": choice("Hides Lines", hides, items=OCCLUSIONS),
    }
    return new_group("FoveaMaterialSettings", "How a material is drawn.", annotations)


def _collection_group():
    told = "Objects of this collection have one outline together: no silhouette or contour between them"
    return new_group(
        "FoveaCollectionSettings", "How a collection is drawn.", {"one_outline": switch("One Outline", told)}
    )


def _shape_properties():
    """Settings for processing an object's mesh before drawing: subdivision.py and repair.py."""
    refine = "Draw the smooth surface that subdividing the mesh (Catmull-Clark) for ever would give"
    level = "Each face becomes 2 x 2 per level; at least the levels of a subdivision modifier at the end"
    length = {"subtype": "DISTANCE", "min": 0.0, "soft_max": 10.0, "step": 0.1, "precision": 4}
    return {
        "refine": switch("Limit Surface", refine),
        "refine_level": whole_number("Level", level, default=2, min=1, max=6),
        "repair_orient": switch("Recalculate Outside", "Turn faces that disagree with their neighbors"),
        "repair_resample": whole_number("Resample", "Steps towards triangles of equal sides", min=0, max=50),
        "repair_edge_length": number("Edge Length", "Of the triangles; 0: as the mesh has it on average", **length),
    }


_registered = []  # (Blender type that gets the settings, or None for a nested group; PropertyGroup)


def register():
    kinds, titles = own_lines.kinds(), vector_settings.titles_group()
    vectors = vector_settings.group(titles)
    _registered[:] = [
        (None, kinds),
        (None, titles),
        (None, vectors),
        (bpy.types.Scene, _scene_group(vectors)),
        (bpy.types.Object, _object_group(kinds)),
        (bpy.types.Material, _material_group()),
        (bpy.types.Collection, _collection_group()),
        (bpy.types.ViewLayer, passes.layer_group()),
    ]
    for owner, group in _registered:
        bpy.utils.register_class(group)
        if owner:
            owner.fovea = part(group)


def unregister():
    for owner, group in reversed(_registered):
        if owner:
            del owner.fovea
        bpy.utils.unregister_class(group)
    _registered.clear()
