# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea lines`: extracts one line definition from a model without Blender, as arrays of whole paths or visible
runs."""

import argparse
import importlib
import sys
from pathlib import Path

import numpy as np

from . import eye, model_files, obj, output, package, quantities
from .target import say


def lines(target, words):
    options = parse(words)
    output.check(options.output)
    package.stage(target)
    sys.path.insert(0, str(package.importable(target)))
    arrays, report, reason = extract(importlib.import_module("addon.native").load(), options)
    with output.written(options.output) as fresh:
        np.savez_compressed(fresh, **arrays)
    if reason:
        say(f"curvature: {reason}")
    skipped = "".join(f", {count} {name.replace('_', ' ')}" for name, count in report.items() if count)
    say(f"{len(arrays['closed'])} {'runs' if options.visible else 'paths'}{skipped}")
    print(options.output)
    return 0


def parse(words):
    parser = argparse.ArgumentParser("fovea lines", usage=argparse.SUPPRESS)
    parser.add_argument("model", type=Path, metavar="MODEL.obj")
    drawn = parser.add_mutually_exclusive_group(required=True)
    drawn.add_argument("--definition", metavar="NAME")
    drawn.add_argument("--style", metavar="NAME|FILE.json", help="with --visible: the lines of a style")
    parser.add_argument("--eye", type=_vector, required=True, metavar="X,Y,Z", help="object space")
    parser.add_argument("--ortho", action="store_true", help="X,Y,Z is the direction towards the viewer")
    parser.add_argument("--light", action="append", type=_vector, default=[], metavar="X,Y,Z", help="a point light")
    parser.add_argument("--sun", action="append", type=_vector, default=[], metavar="X,Y,Z", help="towards a sun")
    parser.add_argument("--param", action="append", type=quantities.assignment, default=[], metavar="NAME=VALUE")
    parser.add_argument("--model", dest="given", type=model_files.file, metavar="FILE", help="that a definition needs")
    turn = quantities.finite("degrees")
    parser.add_argument("--corner-angle", type=turn, default=60.0, metavar="DEG", help="paths end at sharper turns")
    parser.add_argument("--estimator", choices=("automatic", "jets", "one_ring"), default="automatic")
    parser.add_argument("--degree", type=int, default=0, help="of jets, 2 to 4 (0: automatic)")
    parser.add_argument("--rings", type=int, default=0, help="of neighbors that jets are fitted to (0: automatic)")
    parser.add_argument("--smoothing", type=float, default=0.0, metavar="EDGES", help="how far curvature is averaged")
    parser.add_argument("--visible", action="store_true", help="only what is seen, also in pixels")
    parser.add_argument("--hidden", action="store_true", help="with --visible: hidden parts, too")
    parser.add_argument("--size", type=quantities.frame_size, default=(1024, 1024), metavar="WxH", help="pixels")
    parser.add_argument("--fov", type=_angle, metavar="DEG", help="over the frame's shorter side (all of the model)")
    parser.add_argument("-o", "--output", type=_output, required=True, metavar="OUT.npz")
    # argparse would parse "-1,2,3" as an option.
    vectors = "--eye", "--light", "--sun"
    places = [f"{word}={value}" for word, value in zip(words, words[1:]) if word in vectors]
    others = [word for before, word in zip(["", *words], words) if before not in vectors and word not in vectors]
    options = parser.parse_args(places + others)
    for name in ("hidden", "style"):
        if getattr(options, name) and not options.visible:
            parser.error(f"--{name} goes with --visible")
    if options.style and options.hidden:
        parser.error("--hidden goes with --definition: a style says itself what it draws of hidden lines")
    if options.style and options.given:
        parser.error("--model goes with --definition: a style names its files itself")
    return options


def extract(native, options):
    """(arrays of the file, {name: count} of skipped elements of the model, how curvature was estimated or "")."""
    pipeline = importlib.import_module("addon.pipeline")
    polygons = obj.read(options.model)
    surface = _surface(native, options.model.stem, polygons)
    surface.set_field_options(options.estimator, options.degree, options.rings, options.smoothing)
    scene, view, view_to_object = _look(native, surface, polygons.drawn_positions(), options)
    chosen = _style(options)
    frame = pipeline.frame(scene, view, chosen, native.CpuBackend(), pipeline.options(all_paths=True))
    frame.find()
    if options.visible:
        arrays = importlib.import_module("addon.line_arrays").seen(frame, view_to_object)
        arrays["size"] = np.array(options.size)
    else:
        arrays = _whole(frame.paths, surface, polygons.positions, view_to_object)
    del arrays["path"]  # redundant with path_id for a single model
    arrays |= {"definition": np.array(options.definition)} if options.definition else {}
    names = (name for name in dir(surface.report) if not name.startswith("_"))
    counts = {name: getattr(surface.report, name) for name in names}
    return arrays, counts, surface.fields_reason


def _style(options):
    """The Style for --definition or --style."""
    style = importlib.import_module("addon.style")
    if options.definition:
        style.check(style.LineSet, "corner_angle", options.corner_angle, "--corner-angle")
        given = {options.definition: style.parameters(options.definition, _given(options), "definition")}
        lines_of = importlib.import_module("addon.pipeline").style_of_lines
        return lines_of(given, options.corner_angle, options.hidden)
    return style.named(options.style)


def _given(options):
    """{parameter: value} of --param, and of the file that the definition needs. ValueError if that is none."""
    if not options.given or options.definition not in importlib.import_module("addon.catalogue").by_name():
        return dict(options.param)
    files = importlib.import_module("addon.line_files").parameters([options.definition], options.given)
    return dict(options.param) | files[options.definition]


def _output(text):
    path = Path(text).absolute()
    if path.suffix != ".npz":
        raise argparse.ArgumentTypeError(f"'{text}' is no .npz file")
    return path


def _vector(text):
    vector = np.array(text.split(","), float)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise argparse.ArgumentTypeError(f"'{text}' is not X,Y,Z")
    return vector


def _angle(text):
    try:
        angle = float(text)
    except ValueError:
        angle = 0.0
    if not 0.0 < angle < 180.0:
        raise argparse.ArgumentTypeError(f"'{text}' is not between 0 and 180 degrees")
    return angle


def _surface(native, name, polygons):
    edges = native.PolygonEdges(polygons.offsets, polygons.corner_verts)
    triangles, owners = polygons.ngon_triangles()
    mesh = native.Mesh(
        positions=polygons.positions.astype(np.float32),
        edge_verts=edges.edge_verts,
        corner_verts=polygons.corner_verts,
        corner_edges=edges.corner_edges,
        polygon_offsets=polygons.offsets,
        ngon_triangles=triangles,
        ngon_polygon=owners,
        material=polygons.material,
    )
    return native.Surface(name, mesh)


def _look(native, surface, positions, options):
    """(native Scene of the model alone, native View, (4, 4) view-to-object matrix). Reference pixels are as in a
    Blender render of this height."""
    usage = native.Usage.DRAW | native.Usage.OCCLUDE
    points = [native.Light("point", place, (0, 0, -1), (1, 1, 1), id=i) for i, place in enumerate(options.light)]
    suns = [native.Light("sun", (0, 0, 0), -way, (1, 1, 1), id=len(points) + i) for i, way in enumerate(options.sun)]
    scene = native.Scene(
        [surface],
        np.zeros(1, np.int32),
        np.eye(4)[None],
        np.ones(1, np.uint64),
        np.full(1, usage, np.uint8),
        lights=points + suns,
    )
    # Whole paths do not depend on the frame; a wide one contains more of a near model.
    fov = options.fov if options.visible or options.fov else 90.0
    seen_from = eye.view(positions, options.eye, options.ortho, options.size, fov)
    view = native.View(*seen_from, reference_scale=options.size[1] / 1080)
    return scene, view, np.linalg.inv(seen_from[0])


def _whole(paths, surface, positions, view_to_object):
    """The arrays of line_arrays.whole; points on mesh edges are recomputed in double precision from the model's
    positions."""
    found = importlib.import_module("addon.line_arrays").whole(paths, view_to_object)
    on_edge = paths.place < len(surface.edges)
    ends = positions[surface.edges[paths.place[on_edge]]]
    t = paths.edge_t[on_edge, None].astype(np.float64)
    found["points"][on_edge] = (1 - t) * ends[:, 0] + t * ends[:, 1]
    return found
