# SPDX-License-Identifier: GPL-3.0-or-later
"""Zip files whose bytes depend on nothing but the names and contents of their members."""

import zipfile

DAY = (1980, 1, 1, 0, 0, 0)  # the first that zip files know


def write(file, members):
    """members: name -> bytes; they are stored in the order of their names."""
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, content in sorted(members.items()):
            told = zipfile.ZipInfo(name, DAY)
            told.create_system, told.external_attr, told.compress_type = 3, 0o100644 << 16, zipfile.ZIP_DEFLATED
            archive.writestr(told, content)


def normalize(file):
    """Rewrites a zip file, as others store the time and the order in which they found its members."""
    with zipfile.ZipFile(file) as archive:
        members = {told.filename: archive.read(told) for told in archive.infolist() if not told.is_dir()}
    fresh = file.with_name(f"{file.name}.fresh")
    write(fresh, members)
    fresh.replace(file)
