# SPDX-License-Identifier: GPL-3.0-or-later
"""Creases of machine parts that are not part of the project: all of their sharp edges."""

import numpy as np
import pytest
from command import lines, obj
from command.target import SHARED

from addon import native

if native.problem():
    pytest.skip("the native module is not built", allow_module_level=True)


@pytest.fixture
def model(request):
    file = SHARED / "models" / f"{request.param}.obj"
    if not file.exists():
        pytest.skip(f"there is no {file.name} in {file.parent.name} of the shared models")
    return file


def creases(model, tmp_path):
    words = [str(model), "--definition", "crease", "--eye", "9,8,7", "-o", str(tmp_path / "out.npz")]
    return lines.extract(native.load(), lines.parse(words))[0]


def length_of_lines(found):
    steps = np.linalg.norm(np.diff(found["points"], axis=0), axis=1)
    inside = np.ones(len(steps), bool)
    inside[found["offsets"][1:-1] - 1] = False
    return steps[inside].sum()


def edges(model):
    """Of a closed model: length of each edge, and the angle between its two faces in degrees."""
    mesh = obj.read(model)
    points = np.asarray(mesh.positions, float)
    sides = {}
    for face, corners in enumerate(np.split(mesh.corner_verts, mesh.offsets[1:-1])):
        for a, b in zip(corners, np.roll(corners, -1), strict=True):
            sides.setdefault((min(a, b), max(a, b)), []).append(face)
    normals = []
    for corners in np.split(mesh.corner_verts, mesh.offsets[1:-1]):
        p = points[corners]
        normal = np.cross(p, np.roll(p, -1, axis=0)).sum(axis=0)
        normals.append(normal / max(np.linalg.norm(normal), 1e-30))
    normals, both = np.array(normals), [(edge, faces) for edge, faces in sides.items() if len(faces) == 2]
    ends, faces = np.array([edge for edge, _ in both]), np.array([faces for _, faces in both])
    cosine = (normals[faces[:, 0]] * normals[faces[:, 1]]).sum(axis=1)
    return np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1), np.degrees(np.arccos(cosine.clip(-1, 1)))


@pytest.mark.parametrize("model", ["cad/fandisk", "cad/crank-arm", "cad/hammer", "cad/pump-cover"], indirect=True)
def test_every_sharp_edge_of_a_machine_part_is_a_crease(model, tmp_path):
    length, angle = edges(model)
    found = length_of_lines(creases(model, tmp_path))
    assert found >= 0.999 * length[angle >= 30].sum() > 0
    assert found <= 1.1 * length[angle >= 30].sum()
