# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the interface of macOS' libraries: load commands and the table of symbols."""

import struct

from .interface import Interface, text

MAGIC = b"\xcf\xfa\xed\xfe"
SYMBOLS, LIBRARY, WEAK_LIBRARY, SIGNATURE, SYSTEM = 0x2, 0xC, 0x80000018, 0x1D, 0x32  # load commands
EXTERNAL, KIND, DEBUGGING = 0x01, 0x0E, 0xE0  # bits of a symbol's type
PRIVATE = 0x10
DYNAMIC_LOOKUP = 0xFE  # the number of no library: any that is loaded


def read(data):
    found = Interface()
    (count,) = struct.unpack_from("<I", data, 16)
    place, libraries, symbols = 32, [], None
    for _ in range(count):
        command, size = struct.unpack_from("<II", data, place)
        if command in (LIBRARY, WEAK_LIBRARY):
            libraries.append(text(data, place + struct.unpack_from("<I", data, place + 8)[0]))
        elif command == SYMBOLS:
            symbols = struct.unpack_from("<IIII", data, place + 8)
        elif command == SYSTEM:
            (version,) = struct.unpack_from("<I", data, place + 12)
            found.system = f"{version >> 16}.{version >> 8 & 0xFF}"
        elif command == SIGNATURE:
            found.is_signed = True
        place += size
    found.libraries = set(libraries)
    if symbols:
        _read_symbols(data, symbols, libraries, found)
    return found


def _read_symbols(data, symbols, libraries, found):
    table, count, strings, _ = symbols
    for index in range(count):
        name, kind, _section, description, _value = struct.unpack_from("<IBBHQ", data, table + 16 * index)
        if kind & DEBUGGING or not kind & EXTERNAL or kind & PRIVATE:
            continue
        symbol = text(data, strings + name)
        if kind & KIND:
            found.exports.add(symbol)
        else:
            number = description >> 8
            found.imports[symbol] = libraries[number - 1] if 0 < number <= len(libraries) else ""
