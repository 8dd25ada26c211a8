# SPDX-License-Identifier: GPL-3.0-or-later
"""The linker of modules for Linux: zig's, with one word more."""

import subprocess
from types import SimpleNamespace

import pytest
from command.standalone import linker, toolchain

LINUX = toolchain.PLATFORMS["linux-x64"]


@pytest.fixture
def linked(tmp_path):
    """linked(folder, said): (status, what the linker wrote, the words of zig), the compiler saying so."""

    def run(folder, said):
        work, sources = tmp_path / folder / "work", tmp_path / folder / "sources"
        compiler, zig, told = work / "compilers" / LINUX.name / "c++", sources / "zig" / "zig", tmp_path / "told"
        write(compiler, f"printf '%s\\n' '{said}' \"verbose $ZIG_VERBOSE_LINK $1\" >&2")
        write(zig, f"echo \"$@\" >'{told}'")
        option = linker.option(SimpleNamespace(work=work), sources, LINUX)
        assert option == f"-DFOVEA_LINKER={compiler.with_name('ld')}"
        done = subprocess.run([compiler.with_name("ld"), "-shared"], capture_output=True, text=True, check=False)
        return done.returncode, done.stderr, told.read_text().strip() if told.exists() else ""

    return run


def write(program, line):
    program.parent.mkdir(parents=True, exist_ok=True)
    program.write_text(f"#!/bin/sh\n{line}\n")
    program.chmod(0o755)


def test_it_links_as_zig_says_and_folds_functions(linked):
    said = "a warning\nld.lld -shared -o of_a_library.a\nld.lld -shared -o _native.so a.o"
    assert linked("a", said) == (0, "", "ld.lld -shared -o _native.so a.o --icf=safe")


def test_what_zig_does_not_say_is_told(linked):
    status, told, _ = linked("a", "another way")
    assert status == 1 and "zig did not say how it links: another way" in told and "verbose 1 -shared" in told


def test_paths_with_spaces_which_zig_does_not_quote_stay_as_zig_links_them(linked):
    assert linked("with a space", "ld.lld -o /with a space/a.so") == (0, "", "")


def test_a_failure_of_zig_is_told(linked, tmp_path):
    linked("a", "ld.lld a.o")
    folder = tmp_path / "a" / "work" / "compilers" / LINUX.name
    write(folder / "c++", "echo 'error: no a.o' >&2; exit 3")
    done = subprocess.run([folder / "ld"], capture_output=True, text=True, check=False)
    assert done.returncode == 1 and done.stderr == "error: no a.o\n"
