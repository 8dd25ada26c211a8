# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheels that carry modules in the extension's zips: one for a platform and a Python, with the licenses of all
that the module consists of."""

import base64
import hashlib
import json

from . import archive, build, sources

PACKAGE = "fovea_native"  # the beginning of its name; the build follows
INIT = """# SPDX-License-Identifier: GPL-3.0-or-later
# The native module of the Blender extension Fovea is `_native`.
"""
METADATA = """Metadata-Version: 2.1
Name: {name}
Version: {version}
Summary: The native module of the Blender extension Fovea
License: GPL-3.0-or-later
Requires-Python: =={python}.*
"""
TAGS = """Wheel-Version: 1.0
Generator: fovea
Root-Is-Purelib: false
Tag: {tag}
"""


def write(folder, module, platform, python, version, licenses):
    """Writes the wheel of a module (file) into a folder; `licenses`: name -> text. Returns its file. Each build is a
    package of its own: Blender unpacks it beside the one that is loaded, whose file Windows lets nobody replace, and
    beside that of another Python."""
    content = module.read_bytes()
    package = f"{PACKAGE}_{hashlib.sha256(content).hexdigest()[:8]}"
    tag = f"{build.tag(python)}-{build.tag(python)}-{platform.wheel}"
    info = f"{package}-{version}.dist-info"
    members = {
        f"{package}/__init__.py": INIT.encode(),
        f"{package}/{module.name}": content,
        f"{info}/METADATA": METADATA.format(name=package.replace("_", "-"), version=version, python=python).encode(),
        f"{info}/WHEEL": TAGS.format(tag=tag).encode(),
    } | {f"{info}/licenses/{name}": text for name, text in licenses.items()}
    rows = [f"{name},{_digest(content)},{len(content)}" for name, content in sorted(members.items())]
    members[f"{info}/RECORD"] = "".join(f"{row}\n" for row in [*rows, f"{info}/RECORD,,"]).encode()
    file = folder / f"{package}-{version}-{tag}.whl"
    archive.write(file, members)
    return file


def licenses(folder, own, platform):
    """Name -> text, of all that is in a module for a platform. folder: that of the sources; own: the file of the
    project's license."""
    found = {"LICENSE": own.read_bytes()}
    for source in sources.declared():
        for name in source.licenses:
            file = folder / source.name / source.place(name)
            found[f"{source.name}-{file.name}"] = file.read_bytes()
    if platform.license:
        file = folder / "zig_lib" / platform.license
        found[f"{platform.name}-{file.name}"] = file.read_bytes()
    told = {source.name: source.version for source in sources.declared() if source.licenses}
    found["components.json"] = (json.dumps(told, indent=1) + "\n").encode()
    return found


def _digest(content):
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
