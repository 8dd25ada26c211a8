# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenario: installs and uninstalls the extension from within Blender; it is not installed at the start."""

import sys
from pathlib import Path

import bpy
from window import screen

sys.path.append(str(Path(__file__).parents[1] / "blender"))
REPOSITORY, ID = "user_default", "fovea"


def is_an_engine():
    engines = (cls for cls in bpy.types.RenderEngine.__subclasses__() if getattr(cls, "is_registered", False))
    return "FOVEA" in {getattr(cls, "bl_idname", None) for cls in engines}


def coming_and_going(folder, archive):
    yield from screen.fill()
    told = {"before": {"engine": is_an_engine(), "modules": modules()}}
    with screen.override():
        bpy.ops.extensions.package_install_files(filepath=archive, repo=REPOSITORY, enable_on_install=True)
    bpy.context.scene.render.engine = "FOVEA"
    screen.space().shading.type = "RENDERED"
    from watch import Watch  # which needs the add-on

    watch = Watch()
    yield from watch.refined()
    told["installed"] = {"engine": is_an_engine(), "ink": float((1 - screen.picture()[16:]).mean())}
    watch.end()

    repositories = list(bpy.context.preferences.extensions.repos)
    index = next(i for i, one in enumerate(repositories) if one.module == REPOSITORY)
    screen.space().region_3d.view_distance *= 0.8
    screen.swap()
    with screen.override():
        bpy.ops.extensions.package_uninstall(repo_index=index, pkg_id=ID)
    # Blender goes on with EEVEE, which takes a minute to begin in software.
    bpy.context.scene.render.engine = "BLENDER_WORKBENCH"
    screen.space().shading.type = "SOLID"
    yield from screen.rest(0.5)
    files = sorted(str(path.name) for path in Path(repositories[index].directory).glob(f"{ID}/*"))
    told["after"] = {"engine": is_an_engine(), "files": files, "chosen": bpy.context.scene.render.engine}
    return told


def modules():
    return [name for name in sys.modules if name.endswith(f".{REPOSITORY}.{ID}")]
