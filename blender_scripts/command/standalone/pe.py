# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the interface of Windows' libraries and programs: the tables of imports and exports."""

import struct

from .interface import Interface, text

MAGIC = b"MZ"
BY_NUMBER = 1 << 63  # an import without a name


def read(data):
    found = Interface()
    (header,) = struct.unpack_from("<I", data, 0x3C)
    (sections,) = struct.unpack_from("<H", data, header + 6)
    (optional,) = struct.unpack_from("<H", data, header + 20)
    tables = header + 24 + 112
    rows = [
        struct.unpack_from("<8sIIII", data, header + 24 + optional + 40 * index)[1:] for index in range(sections)
    ]  # size in memory, address, size in the file, offset in the file

    def offset(address):
        for _, start, size, place in rows:
            if start <= address < start + size:
                return place + address - start
        raise ValueError("the tables of the library point out of it")

    exports, _, imports, _ = struct.unpack_from("<IIII", data, tables)
    if exports:
        _read_exports(data, offset, offset(exports), found)
    if imports:
        _read_imports(data, offset, offset(imports), found)
    return found


def _read_exports(data, offset, table, found):
    count, _functions, names = struct.unpack_from("<III", data, table + 24)
    for index in range(count):
        (name,) = struct.unpack_from("<I", data, offset(names) + 4 * index)
        found.exports.add(text(data, offset(name)))


def _read_imports(data, offset, table, found):
    while True:
        lookup, _, _, name, addresses = struct.unpack_from("<IIIII", data, table)
        if not name:
            return
        library = text(data, offset(name))
        found.libraries.add(library)
        entry = offset(lookup or addresses)
        while (value := struct.unpack_from("<Q", data, entry)[0]) != 0:
            symbol = f"#{value & 0xFFFF}" if value & BY_NUMBER else text(data, offset(value) + 2)
            found.imports[symbol] = library
            entry += 8
        table += 20
