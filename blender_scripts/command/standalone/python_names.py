# SPDX-License-Identifier: GPL-3.0-or-later
"""The names that a Python has for modules: what its headers declare where they are compiled for a platform. Of them
Windows' import libraries are made, and every module's imports are checked against them."""

import re
import subprocess

from ..target import StepFailed

# How the headers mark what programs may use, on Windows and elsewhere, after the preprocessor.
MARK = r'__declspec\(dllimport\)|__attribute__\s*\(\((?:visibility\s*\("default"\)|dllimport)\)\)'
# Until the end of a declaration, or the body of an inline function.
DECLARATION = re.compile(rf"(?:{MARK})([^;{{]*)[;{{]")
ATTRIBUTE = re.compile(r"__attribute__\s*\(\(.*?\)\)+")


def declared(compiler, include):
    """Name -> whether it is data, of Python.h. compiler: the program; include: folders of headers."""
    words = [compiler, "-E", "-P", "-w", "-x", "c", "-DMS_WIN64=", *(f"-I{folder}" for folder in include), "-"]
    done = subprocess.run(words, input="#include <Python.h>\n", capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise StepFailed(f"the headers of Python in {include[-1]} cannot be read: {done.stderr.strip()[-400:]}")
    return names(done.stdout)


def names(text):
    """Name -> whether it is data, of headers without their macros."""
    found = {}
    for declaration in DECLARATION.findall(text):
        declaration = ATTRIBUTE.sub("", declaration)
        if pointer := re.search(r"\(\s*\*\s*(\w+)\s*\)\s*\(", declaration):
            found[pointer[1]] = True
        elif function := re.match(r"[^(]*?(\w+)\s*\(", declaration, re.DOTALL):
            found[function[1]] = False
        elif data := re.search(r"(\w+)\s*(\[[^\]]*\])*\s*$", declaration):
            found[data[1]] = True
    return found


def definition(library, found):
    """The text of a module definition file, of which an import library is made."""
    rows = [f"    {name}{' DATA' if is_data else ''}" for name, is_data in sorted(found.items())]
    return "\n".join([f"LIBRARY {library}", "EXPORTS", *rows, ""])
