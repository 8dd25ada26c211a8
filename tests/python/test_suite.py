# SPDX-License-Identifier: GPL-3.0-or-later
"""A suite has the mirror that the machine's apt uses, and nothing else of its configuration. The machine is made up:
its programs are scripts that say what they would do."""

import subprocess
from pathlib import Path

import pytest

HERE = Path(__file__).parents[2] / "blender_scripts" / "command"
SECRET = "pa55word"
REACHING = [
    f'Acquire::http::Proxy "http://user:{SECRET}@proxy.example:3128/";',
    'Acquire::http::Proxy::deb.example.org "DIRECT";',
    f'Acquire::https::Proxy "http://user:{SECRET}@proxy.example:3128/";',
    'Acquire::https::Timeout "20";',
    'Acquire::Retries "3";',
    'Acquire::Check-Valid-Until "false";',
    'Acquire::Check-Date "false";',
]
OTHERS = [
    'APT::Get::AllowUnauthenticated "true";',
    'Acquire::AllowInsecureRepositories "true";',
    'Acquire::http::User-Agent "other";',
    'Acquire::http::Proxy-Auto-Detect "/usr/local/bin/find-proxy";',
    'Acquire::https::Verify-Peer "false";',
    'Acquire::https::Verify-Host "false";',
    f'Acquire::https::SslKey "/root/{SECRET}.key";',
    'Acquire::https "";',
]
PROGRAMS = {
    "apt-config": "cat <<'END'\n{settings}\nEND",
    # Of debootstrap folders are left, of what runs in the suite its words and what it is given.
    "bwrap": """case "$*" in
        *debootstrap*) mkdir -p "$root.partial/etc/apt/apt.conf.d" "$root.partial/etc/dpkg/dpkg.cfg.d" ;;
        *) echo "$*" >>"$said" && cat >>"$given" ;;
    esac""",
}
SCRIPT = """
here=$1 cache=$2 suite=sid suite_folder=$2/sid root=$2/sid/root mirror=http://mirror.example/debian archive_keyring=k
export root said=$2/said given=$2/given
for part in say suite; do . "$here/$part.sh"; done
id() { echo 0; }
find_host_tools() { :; }
find_mirror() { :; }
find_keyring() { :; }
sync() { :; }
mkdir -p "$cache/log"
"""


@pytest.fixture
def shell(tmp_path):
    """Runs lines of a shell that knows suite.sh, on the machine that is made up; the folder of its cache."""
    for name, text in PROGRAMS.items():
        program = tmp_path / "bin" / name
        program.parent.mkdir(exist_ok=True)
        program.write_text("#!/bin/sh\n" + text.replace("{settings}", "\n".join(OTHERS[:5] + REACHING + OTHERS[5:])))
        program.chmod(0o755)

    def run(lines):
        cache = tmp_path / "cache"
        command = ["/bin/sh", "-eu", "-c", SCRIPT + lines, "sh", HERE, cache]
        path = f"{tmp_path / 'bin'}:/usr/bin:/bin"
        done = subprocess.run(command, env={"PATH": path}, capture_output=True, text=True, check=True)
        return cache, done.stdout

    return run


def test_what_reaching_the_archive_needs_is_told_and_nothing_else(shell):
    assert shell("reaching_settings")[1].splitlines() == REACHING


def test_packages_are_installed_with_it_and_the_suite_keeps_none_of_it(shell):
    cache, _ = shell("set_up_suite sid blender")
    assert set((cache / "given").read_text().splitlines()) == set(REACHING)
    assert "--ro-bind-data 0 /etc/apt/apt.conf.d/90host" in (cache / "said").read_text()
    kept = [path for path in (cache / "sid").rglob("*") if path.is_file()]
    texts = "".join(path.read_text() for path in kept + list((cache / "log").iterdir()))
    assert kept and SECRET not in texts and SECRET not in (cache / "said").read_text()
    assert not any(line in texts for line in OTHERS + REACHING)


def test_what_earlier_versions_stored_is_forgotten(shell):
    lines = 'mkdir -p "$root/etc/apt/apt.conf.d"; echo old >"$root$host_settings"; '
    cache, _ = shell(lines + 'set_up_suite sid blender; echo old >"$root$host_settings"; set_up_suite sid blender')
    assert (cache / "sid/root/etc/apt/apt.conf.d/90host").read_text() == ""
