# SPDX-License-Identifier: GPL-3.0-or-later
"""The shorter sub-commands, one function each: takes the target and the sub-command's arguments (`words`), returns the
exit status."""

import argparse
import importlib
import json
import os
import shutil
import sys
from pathlib import Path

import ending
import scenes

from . import build as native
from . import draw_options, output, packages, render_options
from . import package as extension
from .standalone import toolchain
from .target import PROJECT, SHARED, StepFailed, say, tail


def build(target, words):
    argparse.ArgumentParser("fovea build").parse_args(words)
    print(native.module(target))
    return 0


def package(target, words):
    parser = argparse.ArgumentParser("fovea package")
    parser.add_argument("-o", "--output", type=Path, help="copy the zip there: a folder or a file")
    toolchain.add_platforms(parser)
    options = parser.parse_args(words)
    place = options.output
    if platforms := toolchain.wanted_platforms(options):
        return all_packages(target, platforms, place)
    if place:
        output.check(place / f"{extension.ID}.zip" if place.is_dir() else place)
    archive = extension.package(target)
    if place:
        place = place / archive.name if place.is_dir() else place
        with output.written(place) as fresh:
            shutil.copy2(archive, fresh)
    print(place or archive)
    return 0


def all_packages(target, platforms, place):
    """Writes the packages for platforms into a folder, which is `place` if that is given."""
    if place:
        for each in (place, place / "repository"):
            output.check_folder(each)
    folder = packages.write(target, platforms)
    for file in sorted(path for path in folder.rglob("*") if path.is_file()):
        if place:
            copy = place / file.relative_to(folder)
            copy.parent.mkdir(parents=True, exist_ok=True)
            with output.written(copy) as fresh:
                shutil.copy2(file, fresh)
        print(copy if place else file)
    return 0


def blender(target, words):
    extension.install(target)
    os.execvpe(target.blender, [target.blender, *words], target.environment())


def draw(target, words):
    options = draw_options.parse(words)
    if options.style:
        check_style(target, options.style)
    extension.install(target)
    script = PROJECT / "blender_scripts" / "draw.py"
    in_blender(target, f"drawing {options.scene}", script, words)
    return 0


def render(target, words):
    options = render_options.parse(words)
    extension.install(target)
    frames = "-".join(map(str, options.frames)) if options.frames else "all frames"
    environment = {"FOVEA_ATOMIC": "1", "FOVEA_RESUME": "1" if options.resume else "0"}
    script = PROJECT / "blender_scripts" / "render.py"
    in_blender(target, f"rendering {options.file.name} {frames}", script, words, **environment)
    return 0


def check_style(target, words):
    """ValueError if --style names no style, or a file that is none: told before Blender starts."""
    style = imported(target, "style")
    try:
        remark = style.remark(style.named(words))
    except ValueError as error:
        raise ValueError(f"--style {words}: {error}") from error
    if remark:
        say(f"--style {words}: {remark}")


def imported(target, name):
    """A module of the staged add-on, without Blender."""
    extension.stage(target)
    sys.path.insert(0, str(extension.importable(target)))
    return importlib.import_module(f"addon.{name}")


def scene(target, words):
    parser = argparse.ArgumentParser("fovea scene")
    parser.add_argument("scene", help="NAME[:N]")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="OUT.blend")
    options = parser.parse_args(words)
    scenes.parse(options.scene)
    if options.output.suffix != ".blend":
        raise ValueError(f"a scene is saved as a .blend, not {options.output.name}")
    output.check(options.output)
    extension.install(target)
    in_blender(target, f"building {options.scene}", PROJECT / "blender_scripts" / "save_scene.py", words)
    return 0


def bench(target, words):
    """`bench NAME [WORDS]`; if NAME is a scene, `bench peers` for that scene only."""
    name, *rest = words or ["peers"]
    alone = {
        "lines": bench_lines, "agreement": agreement, "ink": bench_ink, "over": bench_over, "light": bench_light,
    }  # fmt: skip
    if by_name := alone.get(name):
        return by_name(target, rest)
    if name not in ("peers", "visibility", "focus", "coherence", "viewport", "scale"):
        name, rest = "peers", ["--scenes", name, *rest]
    module = importlib.import_module(f"bench.{name}")
    module.parse(rest)  # reports usage errors before anything is built
    extension.install(target)
    return module.main(rest, target.blender, target.environment(), shared())


def bench_lines(target, words):
    from bench import lines

    lines.parse(words)
    return lines.main(words, imported(target, "native").load(), shared())


def bench_ink(target, words):
    from . import ink

    return ink.ink(target, words)


def shared():
    """The folder of models that are not part of the project, or None if it is missing."""
    return SHARED if SHARED.is_dir() else None


def agreement(target, words):
    """Prints as JSON the agreement of depth-buffer visibility with exact visibility; `words`: those of `fovea draw`."""
    return bench_by_script(target, "agreement", "comparing visibility on", words or ["office"])


def bench_over(target, words):
    """Prints as JSON what lines over another engine's render cost; `words`: those of `fovea draw`, with --over."""
    words = words or ["office"]
    engine = [] if "--over" in words else ["--over", "workbench"]
    return bench_by_script(target, "over", "measuring lines over renders of", [*words, *engine])


def bench_light(target, words):
    """Prints as JSON what lines, shade and shadows by light cost, beside Line Art's."""
    from bench import peers

    parser = argparse.ArgumentParser("fovea bench light")
    known = "office", "boxes:100"
    parser.add_argument("--scenes", type=peers.scene_list, default=list(known), metavar="A,B", help=", ".join(known))
    parser.add_argument("--repeats", type=peers.count, default=3, metavar="N", help="of which medians are taken (3)")
    parser.add_argument("--size", type=peers.frame_size, default=(1920, 1080), metavar="WxH", help="(1920x1080)")
    options = parser.parse_args(words)
    asked = vars(options) | {"shared": str(shared() or "")}
    print(written_by(target, f"measuring light in {', '.join(options.scenes)}", "bench/light.py", asked))
    return 0


def bench_by_script(target, name, sentence, words):
    """Prints what a script of bench/ writes to a file, which it gets besides words of `fovea draw`."""
    scene = draw_options.parse(words).scene
    print(written_by(target, f"{sentence} {scene}", f"bench/{name}.py", words))
    return 0


def written_by(target, sentence, script, asked):
    """What a script of blender_scripts/ writes, as text; it runs in Blender with the extension. `asked`: words, before
    which it gets the path of its file, or a dictionary, which it gets as JSON, with the path as `out`."""
    extension.install(target)
    out = Path(os.environ["TMPDIR"], "written.json")
    words = [json.dumps(asked | {"out": str(out)})] if isinstance(asked, dict) else [out, *asked]
    in_blender(target, sentence, PROJECT / "blender_scripts" / script, words)
    return out.read_text()


def in_blender(target, sentence, script, words, **environment):
    """Runs a script in Blender in background mode, and prints the paths of the files it wrote, or figures about them,
    of all of them or of those before an error, and says its notes, each once. StepFailed on an error, with the script's
    message if it has one (ending.py), else with the end of the log."""
    command = [target.blender, "-b", "--python-exit-code", "1", "-P", script, "--", *words]
    log, status = target.attempt(sentence, command, **environment)
    lines = log.read_text(errors="replace").splitlines()
    for line in lines:
        if told := ending.announced(line) or ending.told(line):
            print(told)
    for line in dict.fromkeys(line for line in lines if line.startswith(ending.NOTE)):
        say(line.removeprefix(ending.NOTE))
    if status == 0:
        return
    for line in lines:
        if line.startswith(ending.MARK):
            raise StepFailed(line.removeprefix(ending.MARK))
    how = f"by signal {-status}, as when memory is too small" if status < 0 else status
    raise StepFailed(f"{sentence} FAILED ({how}); the last lines of {log}:\n{tail(log, 25)}")
