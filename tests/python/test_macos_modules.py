# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules for macOS: what the dynamic linker reads in them, and the linker that makes them. Nothing is built."""

import struct

import pytest
from command.standalone import interface, linker, toolchain
from command.target import StepFailed

MACOS = toolchain.PLATFORMS["macos-arm64"]
ENTRY = b"_PyInit__native\0"
# An edge to the node at 19, which has a symbol (two bytes are said of it) and no more edges.
EXPORTS = b"\0\1" + ENTRY + bytes([19]) + bytes([2, 0, 8, 0])


def library(tmp_path, *commands):
    """A file of these load commands: (number, data before which its offset and size stand); two data: LC_DYLD_INFO with
    a list of weak bindings, and exports."""
    sizes = [48 if len(data) == 2 else 16 for _, *data in commands]
    place, head, tail = 32 + sum(sizes), b"", b""
    for (number, *data), size in zip(commands, sizes, strict=True):
        spans = [number for each in data for number in (place + len(tail) + data_before(data, each), len(each))]
        words = [0] * 4 + spans[:2] + [0, 0] + spans[2:] if len(data) == 2 else spans
        head += struct.pack(f"<II{len(words)}I", number, size, *words)
        tail += b"".join(data)
    file = tmp_path / "_native.so"
    file.write_bytes(struct.pack("<4s7I", b"\xcf\xfa\xed\xfe", 0, 0, 8, len(commands), len(head), 0, 0) + head + tail)
    return interface.read(file)


def data_before(data, each):
    return 0 if each is data[0] else len(data[0])


def test_exports_are_those_that_the_dynamic_linker_knows(tmp_path):
    for found in (library(tmp_path, (0x80000022, b"", EXPORTS)), library(tmp_path, (0x80000033, EXPORTS))):
        assert found.exports == {"_PyInit__native"} and found.replaceable == set()


def test_exports_that_begin_alike_are_told_apart(tmp_path):
    trie = b"\0\1__Z\0" + bytes([7]) + b"\0\2nwm\0" + bytes([20]) + b"dlPv\0" + bytes([23]) + b"\1\0\0" + b"\1\0\0"
    assert library(tmp_path, (0x80000033, trie)).exports == {"__Znwm", "__ZdlPv"}


def test_symbols_that_others_may_replace_are_read(tmp_path):
    weak = b"\x40__Znwm\0\x51\x72\x98\x80\x04\x90" + b"\xc0\x02\x08" + b"\x48__ZTISt9exception\0\xa0\x40\x90\0"
    assert library(tmp_path, (0x22, weak, EXPORTS)).replaceable == {"__Znwm", "__ZTISt9exception"}


@pytest.mark.parametrize(
    "command, reason", [((0x80000034, b"chains"), "chains"), ((0x80000033, b"\0\1a\0\0"), "circles")]
)
def test_what_cannot_be_judged_is_refused(tmp_path, command, reason):
    with pytest.raises(ValueError, match=reason):
        library(tmp_path, command)


@pytest.fixture
def programs(tmp_path, monkeypatch):
    """Writes programs that say a sentence, the only ones there are."""
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))
    (tmp_path / "bin").mkdir()

    def write(name, sentence):
        program = tmp_path / "bin" / name
        program.write_text(f"#!/bin/sh\necho '{sentence}'\n")
        program.chmod(0o755)
        return str(program)

    return write


def test_an_old_linker_is_refused(programs):
    programs("ld64.lld", "Debian LLD 14.0.6 (compatible with GNU linkers)")
    with pytest.raises(StepFailed, match="apt-get install lld-19"):
        linker.installed()
    new = programs("ld64.lld-19", "Debian LLD 19.1.7 (compatible with GNU linkers)")
    assert linker.installed() == (new, "Debian LLD 19.1.7 (compatible with GNU linkers)")


class Target:
    """Of which a step says where archives are that zig has made."""

    def __init__(self, work):
        self.work, self.cache, self.steps = work, work / "the cache", 0

    def run(self, _sentence, _words):
        self.steps += 1
        words = []
        for number, name in enumerate(linker.RUNTIME):
            made = self.cache / "zig" / "o" / f"0a{number}" / name
            made.parent.mkdir(parents=True, exist_ok=True)
            made.write_text(name)
            words.append(str(made))
        log = self.work / "log"
        log.write_text(f"zig ld -dylib -o t.so {' '.join(words)} -lSystem\n")
        return log


def test_the_linker_is_made_once_with_the_runtime_that_zig_has_built(tmp_path, programs):
    program = programs("ld64.lld", "LLD 21.1.0")
    target, sources = Target(tmp_path), tmp_path / "sources" / "0123"
    for _ in range(2):
        option = linker.option(target, sources, MACOS)
        assert option == f"-DFOVEA_LINKER={tmp_path}/compilers/macos-arm64/ld" and target.steps == 1
    text = (tmp_path / "compilers" / "macos-arm64" / "ld").read_text()
    assert f"exec {program} -arch arm64 -platform_version macos 11.0 11.0" in text and "libSystem.tbd" in text
    for name in linker.RUNTIME:
        assert (tmp_path / "compilers" / "macos-arm64" / "runtime" / name).read_text() == name
    programs("ld64.lld", "LLD 22.1.0")
    linker.option(target, sources, MACOS)
    assert target.steps == 2, "another linker is another"


def test_a_runtime_that_zig_does_not_name_is_told(tmp_path, programs):
    programs("ld64.lld", "LLD 19.1.7")
    target = Target(tmp_path)
    target.cache = tmp_path / "another"
    run, target.run = target.run, lambda *words: log_without_archives(run(*words))
    with pytest.raises(StepFailed, match=r"did not say where its libc\+\+abi.a is"):
        linker.option(target, tmp_path / "sources", MACOS)


def log_without_archives(log):
    log.write_text("zig ld -dylib\n")
    return log
