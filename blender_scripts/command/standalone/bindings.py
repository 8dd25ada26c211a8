# SPDX-License-Identifier: GPL-3.0-or-later
"""To which libraries the dynamic linker binds the symbols of a loaded module: in Blender's process there are other
copies of what a module consists of, which it must not use."""

import os
import re
import subprocess

# In what the linker writes with LD_DEBUG=bindings.
BINDING = re.compile(r"binding file (\S+) \[\d+\] to (\S+) \[\d+\]: \S+ symbol `([^']+)'")
# Blender's memory allocator takes the place of the C library's everywhere.
ALLOWED = re.compile(
    r"(libc|libm|libpthread|libdl|librt|libpython3\.\d+|libjemalloc|libtbbmalloc_proxy|ld-linux-x86-64)\.so"
)
LOAD = """
import importlib.util, sys
spec = importlib.util.spec_from_file_location("_native", {file!r})
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
print("loaded", sorted(module.definitions())[:1] if hasattr(module, "definitions") else "")
"""


def told(text, module):
    """Library -> symbols of it that a module (its path) uses, of what the linker wrote."""
    found = {}
    for user, library, symbol in BINDING.findall(text):
        if user == module:
            found.setdefault(library, set()).add(symbol)
    return found


def strange(found, module):
    """Those of `told` that a module must not use: all but the system's, Python's, and its own."""
    return {
        library: symbols
        for library, symbols in found.items()
        if library != module and not ALLOWED.match(os.path.basename(library))
    }


def inside(blender, module, folder):
    """What a module uses that a Blender loads; folder: for the linker's files. ValueError if it is not loaded."""
    environment = os.environ | {"LD_DEBUG": "bindings", "LD_BIND_NOW": "1", "LD_DEBUG_OUTPUT": str(folder / "bindings")}
    words = [
        blender,
        "-b",
        "--factory-startup",
        "--python-exit-code",
        "3",
        "--python-expr",
        LOAD.format(file=str(module)),
    ]
    done = subprocess.run(words, env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    if done.returncode != 0 or "loaded" not in done.stdout:
        raise ValueError(f"{blender} does not load {module}: {(done.stdout + done.stderr)[-400:]}")
    texts = (file.read_text(errors="replace") for file in folder.glob("bindings.*"))
    return told("".join(text for text in texts if str(module) in text), str(module))
