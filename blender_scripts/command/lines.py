"""`fovea lines`: one line definition on a model, extracted without Blender and before visibility, as arrays."""

import argparse
import importlib
import sys
from pathlib import Path

import numpy as np

from . import assignment, obj, package
from .target import say

UNSET = 0xFFFFFFFF


def lines(target, words):
    options = parse(words)
    package.stage(target)
    sys.path.insert(0, str(package.importable(target)))
    arrays, report, reason = extract(importlib.import_module("addon.native").load(), options)
    np.savez_compressed(options.output, **arrays)
    if reason:
        say(f"curvature: {reason}")
    skipped = "".join(f", {count} {name.replace('_', ' ')}" for name, count in report.items() if count)
    say(f"{len(arrays['closed'])} paths{skipped}")
    print(options.output)
    return 0


def parse(words):
    parser = argparse.ArgumentParser("fovea lines")
    parser.add_argument("model", type=Path, metavar="MODEL.obj")
    parser.add_argument("--definition", required=True, metavar="NAME")
    parser.add_argument("--eye", type=_vector, required=True, metavar="X,Y,Z", help="object space")
    parser.add_argument("--ortho", action="store_true", help="X,Y,Z is the direction towards the viewer")
    parser.add_argument("--param", action="append", type=assignment.parse, default=[], metavar="NAME=VALUE")
    parser.add_argument("--corner-angle", type=float, default=60.0, metavar="DEG", help="paths end at sharper turns")
    parser.add_argument("--estimator", choices=("automatic", "jets", "one_ring"), default="automatic")
    parser.add_argument("--degree", type=int, default=0, help="of jets, 2 to 4 (0: automatic)")
    parser.add_argument("--rings", type=int, default=0, help="of neighbours that jets are fitted to (0: automatic)")
    parser.add_argument("--smoothing", type=float, default=0.0, metavar="EDGES", help="how far curvature is averaged")
    parser.add_argument("-o", "--output", type=_output, required=True, metavar="OUT.npz")
    # argparse would take "-1,2,3" for an option.
    eyes = [f"--eye={value}" for word, value in zip(words, words[1:]) if word == "--eye"]
    others = [word for before, word in zip(["", *words], words) if "--eye" not in (before, word)]
    return parser.parse_args(eyes + others)


def extract(native, options):
    """The arrays of the file, counts of what was skipped in the model, and how curvature was estimated, if it was."""
    style = importlib.import_module("addon.style")
    definitions, given = native.line_definitions(), dict(options.param)
    kinds = {options.definition: style.parameters(options.definition, given, "definition", definitions)}
    polygons = obj.read(options.model)
    surface = _surface(native, options.model.stem, polygons)
    surface.set_field_options(options.estimator, options.degree, options.rings, options.smoothing)
    paths, view_to_object = _paths(native, surface, polygons.positions, kinds, options)
    arrays = {**_arrays(paths, surface, polygons.positions, view_to_object), "definition": np.array(options.definition)}
    return arrays, surface.report, surface.fields_reason


def _output(text):
    path = Path(text).absolute()
    if path.suffix != ".npz" or not path.parent.is_dir():
        raise argparse.ArgumentTypeError(f"'{text}' is no .npz file in a folder that exists")
    return path


def _vector(text):
    vector = np.array(text.split(","), float)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise argparse.ArgumentTypeError(f"'{text}' is not X,Y,Z")
    return vector


def _surface(native, name, polygons):
    edge_verts, corner_edges = native.polygon_edges(polygons.offsets, polygons.corner_verts)
    triangles, owners = polygons.ngon_triangles()
    positions = polygons.positions.astype(np.float32)
    return native.Surface(
        name, positions, edge_verts, polygons.corner_verts, corner_edges, polygons.offsets, triangles, owners,
        polygons.material,
    )  # fmt: skip


def _paths(native, surface, positions, kinds, options):
    """The model alone in a scene, seen by a view that has all of it in its frame; and the way back from the view."""
    usage = native.DRAW | native.OCCLUDE
    scene = native.Scene([surface], np.zeros(1, np.int32), np.eye(4)[None], np.ones(1, np.uint64), np.full(1, usage, np.uint8))
    seen_from = view(positions, options.eye, options.ortho)
    tracer = native.Tracer(scene, native.View(*seen_from))
    paths = native.extract_paths(tracer, [(kinds, options.corner_angle)])
    return paths, np.linalg.inv(seen_from[0])


def view(positions, eye, ortho):
    """What a native View is made of, with world_to_view first: from `eye` (for an orthographic view the direction
    towards the viewer), all positions in its frame."""
    finite = positions[np.isfinite(positions).all(axis=1)]
    low, high = (finite.min(axis=0), finite.max(axis=0)) if len(finite) else (np.zeros(3), np.ones(3))
    centre, radius = (low + high) / 2, max(np.linalg.norm(high - low) / 2, 1e-30)
    towards = eye if ortho else eye - centre
    if not towards.any():
        if ortho:
            raise ValueError("--eye 0,0,0 is no direction")
        towards = np.array([0.0, 0.0, 1.0])  # from inside any way will do: what is partly in the frame is extracted whole
    distance = 2 * radius if ortho else np.linalg.norm(towards)
    backwards = towards / np.linalg.norm(towards)
    eye = centre + distance * backwards if ortho else eye
    near, far = (0.5 * radius, 4 * radius) if ortho else (1e-3 * max(distance, radius), distance + 2 * radius)
    clip = _orthographic(radius, near, far) if ortho else _perspective(near, far)
    return _looking(eye, backwards), clip, 1024, 1024, ortho, near, far


def _looking(eye, backwards):
    """World to view: the eye at the origin, looking along -z."""
    aside = np.eye(3)[np.abs(backwards).argmin()]
    right = np.cross(aside, backwards)
    right /= np.linalg.norm(right)
    matrix = np.eye(4)
    matrix[:3, :3] = right, np.cross(backwards, right), backwards
    matrix[:3, 3] = -matrix[:3, :3] @ eye
    return matrix


def _perspective(near, far):
    depth = far - near
    return np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -(far + near) / depth, -2 * far * near / depth], [0, 0, -1, 0]])


def _orthographic(half, near, far):
    depth = far - near
    return np.array([[1 / half, 0, 0, 0], [0, 1 / half, 0, 0], [0, 0, -2 / depth, -(far + near) / depth], [0, 0, 0, 1]])


def _arrays(paths, surface, positions, view_to_object):
    """What the file holds; points on edges in the model's own double precision, from where they lie on them. Lines of
    the image come in view space."""
    points = paths.points_obj.astype(np.float64)
    on_edge = paths.place < len(surface.edges)
    ends = positions[surface.edges[paths.place[on_edge]]]
    t = paths.edge_t[on_edge, None].astype(np.float64)
    points[on_edge] = (1 - t) * ends[:, 0] + t * ends[:, 1]
    in_image = np.repeat(paths.placement == UNSET, np.diff(paths.offsets))
    points[in_image] = points[in_image] @ view_to_object[:3, :3].T + view_to_object[:3, 3]
    return {
        "points": points,
        "offsets": paths.offsets.astype(np.int64),
        "closed": paths.closed.astype(bool),
        "path_id": paths.ids,
        "strength": paths.strength,
    }
