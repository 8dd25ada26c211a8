# SPDX-License-Identifier: GPL-3.0-or-later
"""What opacity images of materials cut out of a mesh."""

from dataclasses import dataclass

import bpy
import numpy as np

from .color_corners import Corners

# Sentences on materials whose alpha cuts out nothing.
UNTOLD = "Material '{material}' hides lines as a whole: where its alpha is opaque cannot be told, as {why}"
UNREAD = "Material '{material}' hides lines as a whole: its image '{image}' cannot be read; look for missing files"
UNPLACED = "'{name}': material '{material}' hides lines as a whole: the mesh lacks the UV map of its alpha"
REPAIRED = "'{name}': material '{material}' hides lines as a whole: alpha does not cut meshes that are repaired"
# And on meshes that differ for being cut.
REFINED = "'{name}': drawn as Blender subdivides it, as material '{material}' is cut out by an image"


def remarks(text, obj, slots):
    """One of the sentences above for each material that is cut out elsewhere."""
    return [text.format(name=obj.name, material=slot.name) for slot in slots if slot.cut]


def untold(slots):
    """A sentence for each material whose alpha cannot be told."""
    return [UNTOLD.format(material=slot.name, why=slot.unknown) for slot in slots if slot.unknown]


@dataclass(frozen=True, eq=False)
class CutOuts:
    """Opacity images of a mesh, as arguments of a native CutSurface."""

    cuts: list  # native Cuts
    cut_of_slot: list  # per material slot: an index into `cuts`, or -1
    px_per_unit: float
    key: tuple  # hashes of all that these depend on

    def surface(self, core, name, mesh, arrays):
        """The native CutSurface of a native Mesh, and its MeshArrays."""
        polygons = len(arrays.polygon_offsets) - 1
        slot = np.zeros(polygons, np.int32) if arrays.material is None else arrays.material
        cut = np.array(self.cut_of_slot, np.int32)[np.clip(slot, 0, len(self.cut_of_slot) - 1)]
        return core.CutSurface(name, mesh, self.cuts, cut, px_per_unit=self.px_per_unit)


class Opacities:
    """Native Opacities during one traversal of a scene. `images`: an ImageCache."""

    def __init__(self, images):
        self.core, self._images, self._known = images.core, images, {}

    def of(self, source):
        """(content hash, native Opacity) of an opacity_nodes.Source, or None."""
        if source not in self._known:
            image = next((image for image in bpy.data.images if image.name_full == source.image), None)
            self._known[source] = image and self._images.opacity(image, source)
        return self._known[source]


def of(opacities, obj, mesh, slots, px_per_unit):
    """(CutOuts, remarks) of an evaluated mesh: None if nothing is cut out of it. `opacities`: Opacities."""
    core, cuts, cut_of_slot, key, told = opacities.core, [], [], [], []
    corners = Corners(core, obj, mesh, None, None, None)
    for slot in slots:
        cut_of_slot.append(-1)
        if slot.cut is None:
            continue
        found = opacities.of(slot.cut)
        uv = corners.uv(slot.cut.uv, slot.cut.place)
        if not found or uv is None:
            why = UNREAD if uv is not None else UNPLACED
            told.append(why.format(name=obj.name, material=slot.name, image=slot.cut.image))
            continue
        content, opacity = found
        cut_of_slot[-1] = len(cuts)
        cuts.append(core.Cut(corners.uvs[uv], opacity))
        key += [core.content_hash(corners.uvs[uv]), content, slot.cut]
    if not cuts:
        return None, told
    return CutOuts(cuts, cut_of_slot, px_per_unit, (*key, *cut_of_slot, px_per_unit)), told
