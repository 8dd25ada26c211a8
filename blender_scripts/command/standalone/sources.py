# SPDX-License-Identifier: GPL-3.0-or-later
"""The compiler and the sources of libraries: which, from where, and their checksums, as sources.json tells; fetched
into the cache by this machine's apt and npm, and unpacked. Once they are there nothing is fetched any more."""

import fnmatch
import hashlib
import json
import os
import re
import shutil
import subprocess
import tarfile
from dataclasses import dataclass
from pathlib import Path

from ..target import PROJECT, StepFailed, say

TABLE = PROJECT / "native" / "standalone" / "sources.json"
APT_HELPER = "/usr/lib/apt/apt-helper"


@dataclass(frozen=True)
class Source:
    name: str  # of its folder
    version: str
    sha256: str  # of the archive
    npm: str = ""  # its package in npm, or
    suite: str = ""  # the Debian suite that has it, and
    file: str = ""  # its archive below `pool` of Debian's
    root: str = ""  # what is taken is below this folder of the archive
    take: tuple = ("/",)  # what is taken: folders end in a slash, other patterns name files of one folder
    licenses: tuple = ()  # files of the archive; of all that modules consist of

    @property
    def archive(self):
        """Name of its file in the cache."""
        return self.file.rpartition("/")[2] or f"{self.npm.lstrip('@').replace('/', '-')}-{self.version}.tgz"

    def place(self, member):
        """Where a member of the archive (without its top folder) belongs in the source's folder; None: not needed."""
        if member in self.licenses:
            return f"licenses/{member.rpartition('/')[2]}"
        inner = member.removeprefix(f"{self.root}/") if self.root else member
        if self.root and inner == member:
            return None
        return inner if any(_fits(inner, pattern) for pattern in self.take) else None


def _fits(name, pattern):
    if pattern.endswith("/"):
        return f"/{name}".startswith(f"/{pattern.lstrip('/')}")
    return name.count("/") == pattern.count("/") and fnmatch.fnmatchcase(name, pattern)


def declared():
    rows = json.loads(TABLE.read_text(encoding="utf-8"))
    return [
        Source(**{key: tuple(value) if isinstance(value, list) else value for key, value in row.items()})
        for row in rows
    ]


def unpacked(cache, sources=None):
    """The folder with all sources, each in a folder of its name; fetched and unpacked where they are not yet."""
    sources = sources or declared()
    digest = hashlib.sha256(repr(sources).encode()).hexdigest()[:16]
    folder = cache / "sources" / digest
    if folder.is_dir():
        return folder
    archives = [_fetched(cache / "archives", source) for source in sources]
    fresh = folder.with_name(f"{digest}.fresh")
    shutil.rmtree(fresh, ignore_errors=True)
    for source, archive in zip(sources, archives, strict=True):
        _unpack(source, archive, fresh / source.name)
    fresh.rename(folder)
    return folder


def _fetched(folder, source):
    """The archive, which has its checksum."""
    archive = folder / source.archive
    if archive.exists() and digest_of(archive) == source.sha256:
        return archive
    folder.mkdir(parents=True, exist_ok=True)
    say(f"fetching {source.name} {source.version}")
    fresh = folder / "fresh"
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir()
    try:
        said = (_from_npm if source.npm else _from_debian)(source, fresh)
        got = next((file for file in fresh.iterdir() if file.is_file()), None)
        if not got:
            door = "npm" if source.npm else "Debian archive"
            raise StepFailed(
                f"{source.name} {source.version} ({source.npm or source.file}) cannot be had by this machine's {door} "
                f"({said}); put a file with the SHA256 {source.sha256} there: {archive}"
            )
        if (found := digest_of(got)) != source.sha256:
            raise StepFailed(
                f"{source.archive} is another file than it was: its SHA256 is {found}, not {source.sha256}"
            )
        got.replace(archive)
    finally:
        shutil.rmtree(fresh, ignore_errors=True)
    return archive


def _from_npm(source, folder):
    """Fetches by the machine's npm; returns the last thing it said."""
    if not shutil.which("npm"):
        raise StepFailed(f"{source.name} is fetched by npm, which is missing: install it (apt-get install npm)")
    return _last_line(["npm", "pack", f"{source.npm}@{source.version}"], folder)


def _from_debian(source, folder):
    """Fetches from the archives that the machine's apt uses, the first that has it; returns the last thing said."""
    said = "apt names no archive"
    for archive in _archives():
        file = source.archive
        said = _last_line(
            [APT_HELPER, "download-file", f"{archive}/pool/{source.file}", file, f"SHA256:{source.sha256}"], folder
        )
        if (folder / file).exists():
            break
    return said


def _archives():
    """Where the machine's apt looks for packages, in its order: what is above `dists`."""
    told = subprocess.run(["apt-get", "update", "--print-uris"], capture_output=True, text=True, check=False).stdout
    return list(dict.fromkeys(re.findall(r"^'([^']+)/dists/", told, re.MULTILINE)))


def _last_line(command, folder):
    """Runs a command in a folder; what it says of the reason if it fails, in one line."""
    done = subprocess.run(
        command, cwd=folder, env=os.environ, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
    )
    lines = [line.strip() for line in (done.stdout + done.stderr).splitlines() if line.strip()]
    told = [line for line in lines if re.match(r"E:|Err|\d{3} |npm (ERR|error)", line)] or lines or ["it said nothing"]
    return told[0]


def _unpack(source, archive, folder):
    folder.mkdir(parents=True)
    if archive.suffix == ".deb":
        with subprocess.Popen(["dpkg-deb", "--fsys-tarfile", archive], stdout=subprocess.PIPE) as opened:
            with tarfile.open(fileobj=opened.stdout, mode="r|") as members:
                _take(source, members, folder, top="./")
    else:
        with tarfile.open(archive) as members:
            _take(source, members, folder)


def _take(source, members, folder, top=None):
    """Writes the files that are needed; `top`: what their names begin with, or their first folder."""
    for member in members:
        inner = member.name.removeprefix(top) if top else member.name.partition("/")[2]
        place = source.place(inner) if member.isfile() else None
        if place is None or ".." in Path(place).parts:
            continue
        file = folder / place
        file.parent.mkdir(parents=True, exist_ok=True)
        with file.open("wb") as written:
            shutil.copyfileobj(members.extractfile(member), written)
        file.chmod(0o755 if member.mode & 0o100 else 0o644)


def digest_of(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()
