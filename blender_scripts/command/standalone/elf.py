# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the interface of Linux' libraries: the dynamic section, symbols, and versions of those that are taken."""

import struct

from .interface import Interface, text

MAGIC = b"\x7fELF\2\1"
SECTIONS = {6: "dynamic", 11: "symbols", 0x6FFFFFFF: "versions", 0x6FFFFFFE: "wanted"}  # by type
NEEDED = 1  # tag of an entry of the dynamic section
PROTECTED_LOCALLY = (1, 2)  # visibilities that nothing outside sees: internal, hidden


def read(data):
    found = Interface()
    place, size, count = *struct.unpack_from("<Q", data, 0x28), *struct.unpack_from("<HH", data, 0x3A)
    headers = [struct.unpack_from("<IIQQQQIIQQ", data, place + size * index) for index in range(count)]
    sections = {SECTIONS[header[1]]: header for header in headers if header[1] in SECTIONS}
    strings = headers[sections["symbols"][6]][4]
    for tag, value in struct.iter_unpack("<QQ", _content(data, sections["dynamic"])):
        if tag == NEEDED:
            found.libraries.add(text(data, strings + value))
    versions = _wanted_versions(data, sections["wanted"], strings) if "wanted" in sections else {}
    numbers = (
        [number for (number,) in struct.iter_unpack("<H", _content(data, sections["versions"]))] if versions else []
    )
    symbols = struct.iter_unpack("<IBBHQQ", _content(data, sections["symbols"]))
    for index, (name, info, visibility, section, _value, _size) in enumerate(symbols):
        if section == 0 and name:
            number = numbers[index] & 0x7FFF if numbers else 0
            found.imports[text(data, strings + name)] = versions.get(number, "")
        elif section and info >> 4 and visibility & 3 not in PROTECTED_LOCALLY:
            found.exports.add(text(data, strings + name))
    return found


def _content(data, header):
    return data[header[4] : header[4] + header[5]]


def _wanted_versions(data, header, strings):
    """Number -> name of the versions of symbols that are taken from other libraries."""
    names = {}
    place = header[4]
    while True:
        _, count, _file, first, following = struct.unpack_from("<HHIII", data, place)
        entry = place + first
        for _ in range(count):
            _, _flags, number, name, step = struct.unpack_from("<IHHII", data, entry)
            names[number] = text(data, strings + name)
            entry += step
        if not following:
            return names
        place += following
