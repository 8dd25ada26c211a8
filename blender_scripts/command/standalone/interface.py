# SPDX-License-Identifier: GPL-3.0-or-later
"""What a shared library of any system takes from others and hands out, read from the file itself: Linux' ELF, Windows'
PE and macOS' Mach-O, 64 bits each."""

from dataclasses import dataclass, field


@dataclass
class Interface:
    libraries: set = field(default_factory=set)  # that the system loads with it
    imports: dict = field(default_factory=dict)  # symbol -> library, or version, that it is taken from; "": any
    exports: set = field(default_factory=set)
    replaceable: set = field(default_factory=set)  # symbols of its own, in whose place the system may take others'
    system: str = ""  # the oldest system that it is for, if the file says so
    is_signed: bool = False


class Unreadable(ValueError):
    """The file is no shared library of a known kind."""


def read(file):
    """The interface of a library."""
    from . import elf, macho, pe

    data = file.read_bytes()
    for kind in (elf, pe, macho):
        if data.startswith(kind.MAGIC):
            return kind.read(data)
    raise Unreadable(f"{file} is no library for 64-bit Linux, Windows or macOS")


def text(data, offset):
    """The string at an offset, up to its zero byte."""
    return data[offset : data.index(b"\0", offset)].decode()
