# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the interface of macOS' libraries: load commands, the table of symbols, and what the dynamic linker reads: the
trie of exports, and the list of places that it binds to whichever library has a symbol first."""

import struct

from .interface import Interface, text

MAGIC = b"\xcf\xfa\xed\xfe"
# Load commands
SYMBOLS, LIBRARY, WEAK_LIBRARY, SIGNATURE, SYSTEM = 0x2, 0xC, 0x80000018, 0x1D, 0x32
BINDINGS, TRIE, CHAINS = (0x22, 0x80000022), 0x80000033, 0x80000034
EXTERNAL, KIND, DEBUGGING = 0x01, 0x0E, 0xE0  # bits of a symbol's type
PRIVATE = 0x10
# What follows an opcode (its upper four bits) in a list of bindings: a string, or so many numbers.
STRING, NUMBERS = 0x40, {0x20: 1, 0x60: 1, 0x70: 1, 0x80: 1, 0xA0: 1, 0xC0: 2}


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
        elif command in BINDINGS:
            weak, weak_size, _, _, trie, trie_size = struct.unpack_from("<6I", data, place + 24)
            found.replaceable |= _bound(data[weak : weak + weak_size])
            found.exports |= _exported(data[trie : trie + trie_size])
        elif command == TRIE:
            trie, trie_size = struct.unpack_from("<II", data, place + 8)
            found.exports |= _exported(data[trie : trie + trie_size])
        elif command == CHAINS:
            raise ValueError("what it binds is written as chains, for newer systems")
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


def _bound(opcodes):
    """Symbols of a list of bindings."""
    found, place = set(), 0
    while place < len(opcodes):
        opcode = opcodes[place] & 0xF0
        place += 1
        if opcode == STRING:
            found.add(text(opcodes, place))
            place = opcodes.index(0, place) + 1
        for _ in range(NUMBERS.get(opcode, 0)):
            _, place = _number(opcodes, place)
    return found


def _exported(trie):
    """Symbols of a trie of exports: a node has what is said of its own symbol, if it is one, and letters to others."""
    found, seen, left = set(), set(), [(0, "")] if trie else []
    while left:
        node, symbol = left.pop()
        if node in seen:
            raise ValueError("its table of exports goes round in circles")
        seen.add(node)
        size, place = _number(trie, node)
        if size:
            found.add(symbol)
        place += size
        count, place = trie[place], place + 1
        for _ in range(count):
            letters = text(trie, place)
            child, place = _number(trie, trie.index(0, place) + 1)
            left.append((child, symbol + letters))
    return found


def _number(data, place):
    """A number of seven bits per byte (LEB128), and the place after it."""
    value = shift = 0
    while True:
        byte = data[place]
        value, shift, place = value | (byte & 0x7F) << shift, shift + 7, place + 1
        if not byte & 0x80:
            return value, place
