# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea standalone`: self-contained modules, built by this machine's own Python; blender_scripts/fovea starts it."""

import argparse
import hashlib
import signal
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

from command import output, temporary
from command.main import interrupt
from command.standalone import build, checks, sources, toolchain, trial, wine
from command.target import INTERRUPTS, PROJECT, StepFailed, Target, say


def main(words):
    """words: CACHE ARGUMENTS..."""
    for number in INTERRUPTS:
        signal.signal(number, interrupt)
    cache = Path(words[0]) / "standalone"
    work = cache / f"work-{hashlib.sha256(str(PROJECT).encode()).hexdigest()[:8]}"
    try:
        options = parse(words[1:])
        with temporary.folder(work / "tmp") as held:
            target = Target("standalone", work, cache, "", "", held)
            if options.fetch:
                print(sources.unpacked(cache))
                return 0
            status = build_all(target, chosen(options.modules))
            if options.wine is not None:
                status = max(status, wine.run(target, options.wine))
            return max(status, trial.run(target, options.test) if options.test is not None else 0)
    except (StepFailed, ValueError, OSError) as error:
        say(f"standalone: {error}")
    except KeyboardInterrupt:
        return 130
    return 1


def build_all(target, wanted):
    """Builds and checks modules (platform -> Pythons), prints where they are; 1 if one breaks a rule."""
    status = 0
    for name, pythons in wanted.items():
        platform = toolchain.PLATFORMS[name]
        for python, place in zip(pythons, build.modules(target, platform, pythons), strict=True):
            for problem in checks.problems(place, platform, python, build.names_of_python(target, platform, python)):
                say(f"{place}: {problem}")
                status = 1
            print(place, flush=True)
    return status


def parse(words):
    parser = argparse.ArgumentParser("fovea standalone")
    parser.add_argument("--fetch", action="store_true", help="only fetch what is needed, so that all else needs no net")
    parser.add_argument(
        "--test", metavar="NAMES", nargs="?", const="", help="run tests/python with this machine's Python"
    )
    parser.add_argument("--wine", nargs=argparse.REMAINDER, help="what `fovea test windows` runs; words for pytest")
    parser.add_argument("--of-package", nargs=argparse.REMAINDER, help="the modules of what `fovea package` is to make")
    parser.add_argument("modules", nargs="*", metavar="MODULE", help="such as linux-x64 or linux-x64-cp311")
    options = parser.parse_args(words)
    if options.wine is not None:
        wine.program()
        options.modules = [wine.WINDOWS.name]
    if options.of_package is not None:
        options.modules = platforms_of(options.of_package)
    return options


def platforms_of(words):
    """Names of the platforms of which `fovea package` with these words makes zips. ValueError where these cannot be
    written, before anything is built."""
    parser = argparse.ArgumentParser("fovea package")
    parser.add_argument("-o", "--output")
    toolchain.add_platforms(parser)
    options = parser.parse_known_args(words)[0]
    if options.output:
        output.check_folder(options.output)
    return toolchain.wanted_platforms(options)


def chosen(names):
    """Platform -> Pythons, of names such as linux-x64-cp311, or linux-x64 for those of blender.org's Blenders; all: of
    every platform; no names: Linux'."""
    found = {}
    names = list(toolchain.PLATFORMS) if names == ["all"] else names
    for name in names or ("linux-x64",):
        platform, _, end = name.rpartition("-")
        by_tag = {build.tag(python): python for python in toolchain.PYTHONS}
        if platform == "linux-x64":
            by_tag |= {build.tag(python): python for python in toolchain.SUITES}
        if name in toolchain.PLATFORMS:
            found[name] = list(toolchain.PYTHONS)
        elif platform in toolchain.PLATFORMS and end in by_tag:
            found.setdefault(platform, []).append(by_tag[end])
        else:
            known = ", ".join(f"{known}[-{each}]" for known in toolchain.PLATFORMS for each in by_tag)
            raise ValueError(f"there is no module {name}; there are {known}")
    return found


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
