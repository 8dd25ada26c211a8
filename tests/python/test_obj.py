# SPDX-License-Identifier: GPL-3.0-or-later
"""The OBJ reader of `fovea lines`: vertices and polygons exactly as the file has them."""

import numpy as np
import pytest
from command import ears, obj


@pytest.fixture
def read(tmp_path):
    def from_text(text):
        file = tmp_path / "model.obj"
        file.write_text(text)
        return obj.read(file)

    return from_text


SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"


def polygons(found):
    return [list(part) for part in np.split(found.corner_verts, found.offsets[1:-1])]


def test_every_way_to_write_a_corner(read):
    assert polygons(read(SQUARE + "f 1/1/1 2//2 3/3\nf -4 -2 -1\nf\t1 2 \\\n 3 4\n")) == [
        [0, 1, 2],
        [0, 2, 3],
        [0, 1, 2, 3],
    ]


def test_negative_indices_count_from_where_they_stand(read):
    assert polygons(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nf -4 -3 -1")) == [[0, 1, 2], [0, 1, 3]]


def test_numbers_after_the_coordinates_are_left_out(read):
    assert read("v 1 2 3 0.5 0.5 0.5\nv 4 5 6\n").positions.tolist() == [[1, 2, 3], [4, 5, 6]]


def test_positions_keep_double_precision(read):
    assert read("v 0.1234567890123456 1e-300 -7\n").positions[0, 0] == 0.1234567890123456


def test_faces_without_area_to_speak_of_and_other_lines_are_left_out(read):
    found = read("# text\nmtllib x.mtl\no thing\n" + SQUARE + "vn 0 0 1\nvt 0 0\nf 1 2\nl 1 2 3\nf 1 2 3\ns off\n")
    assert polygons(found) == [[0, 1, 2]]


@pytest.mark.parametrize(
    "text", ["v 1 2\n", "v a b c\n", SQUARE + "f 0 1 2\n", SQUARE + "f 1 2 9\n", SQUARE + "f -9 2 3\n"]
)
def test_what_is_wrong_is_said_with_the_files_name(read, text):
    with pytest.raises(ValueError, match="model.obj"):
        read(text)


def test_an_empty_file_has_nothing(read):
    found = read("")
    assert len(found.positions) == 0 and found.offsets.tolist() == [0]


def area(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a).sum(axis=0)) / 2


@pytest.mark.parametrize("turned", [False, True])
def test_a_hollow_polygon_is_cut_inside_its_outline(turned):
    star = np.array([[r * np.cos(t), r * np.sin(t), 0] for t, r in zip(np.arange(10) * np.pi / 5, [1, 0.4] * 5)])
    points = star[::-1] if turned else star
    triangles = ears.triangulate(points)
    assert len(triangles) == 8
    outline = np.linalg.norm(np.cross(points, np.roll(points, -1, axis=0)).sum(axis=0)) / 2
    single = sum(area(points, triangle[None]) for triangle in triangles)
    assert np.isclose(single, outline) and np.isclose(area(points, triangles), outline)


def test_a_polygon_that_crosses_itself_still_ends():
    assert ears.triangulate(np.random.default_rng(1).random((12, 3))).shape == (10, 3)


def test_polygons_have_the_material_named_last(read):
    found = read(f"{SQUARE}f 1 2 3\nusemtl a\nf 1 2\nf 1 2 3\nusemtl  b \nf 1 2 4\nusemtl a\nf 2 3 4\n")
    assert found.material.tolist() == [0, 1, 2, 1]
    assert read(f"{SQUARE}f 1 2 3\n").material.tolist() == [0] and read("").material.tolist() == []


@pytest.mark.parametrize("broken", ["1e30 0 0", "nan 0 0", "inf nan 5"])
def test_what_is_drawn_has_neither_vertices_without_a_polygon_nor_polygons_with_a_broken_vertex(read, broken):
    found = read(f"{SQUARE}v {broken}\nf 1 2 3 4\n")
    assert found.drawn_positions().tolist() == found.positions[:4].tolist()
    found = read(f"{SQUARE}v nan 0 0\nv 9 9 9\nf 1 2 3 4\nf 1 5 6\nf 1 2 3\n")
    assert found.drawn_positions().tolist() == found.positions[:4].tolist()
    assert read("").drawn_positions().tolist() == []
