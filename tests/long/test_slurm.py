# SPDX-License-Identifier: GPL-3.0-or-later
"""An array of Slurm, of which a task is killed and a node restarts, renders the frames of an undisturbed run: Slurm's
own programs, on this machine alone, in the test's folder."""

import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

import frames
import pytest

SBATCH = Path(__file__).parents[2] / "addon" / "farm" / "fovea.sbatch"
CHUNK = 4
ARRAY = f"0-{frames.FRAMES // CHUNK - 1}%2"
NODES = ("n1", "n2")
PATIENCE = 600  # seconds after which something is taken for hanging

SETTINGS = """
ClusterName=fovea
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.s
CredType=cred/munge
SlurmctldPort={ports[0]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdTimeout=10
MpiDefault=none
NodeName=n1 NodeHostname=localhost NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname=localhost NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1 State=UNKNOWN
PartitionName=farm Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class Cluster:
    """Two nodes of one processor each, and their controller, as root of the sandbox."""

    def __init__(self, folder):
        self.folder = folder
        folder.chmod(0o700)
        (folder / "state").mkdir()
        (folder / "slurm.conf").write_text(SETTINGS.format(folder=folder, ports=free_ports(3)))
        (folder / "cgroup.conf").write_text("CgroupPlugin=disabled\n")
        (folder / "munge.key").write_bytes(os.urandom(1024))
        (folder / "munge.key").chmod(0o600)
        self.environment = os.environ | {"SLURM_CONF": str(folder / "slurm.conf")}
        files = {"key-file": "key", "socket": "s", "pid-file": "pid", "log-file": "log", "seed-file": "seed"}
        self.run("munged", "--force", *(f"--{option}={folder}/munge.{name}" for option, name in files.items()))
        self.run("slurmctld")
        for node in NODES:
            self.run("slurmd", "-N", node)
        until(lambda: self.states() == ["idle"] * len(NODES))

    def run(self, *words):
        # Not by a pipe, which daemons would hold.
        with (self.folder / "told").open("w+") as told:
            done = subprocess.run(words, env=self.environment, stdout=told, stderr=subprocess.STDOUT, timeout=60)
            told.seek(0)
            said = told.read()
        assert done.returncode == 0, said
        return said

    def states(self):
        return self.run("sinfo", "-h", "-N", "-o", "%T").split()

    def submit(self, file, place):
        words = [file, "1", frames.FRAMES, CHUNK, place / "box_####"]
        log = f"--output={self.folder}/task-%a.log"
        return self.run("sbatch", "--parsable", f"--array={ARRAY}", log, SBATCH, *map(str, words)).strip()

    def running(self):
        """{node: id of the task that runs there}."""
        tasks = self.run("squeue", "-h", "-t", "R", "-o", "%N %i").splitlines()
        return dict(line.split() for line in tasks)

    def finish(self):
        """Waits until no task is left; those that wait for their node begin at once."""

        def done():
            for task in self.run("squeue", "-h", "-r", "-t", "PD", "-o", "%i").split():
                subprocess.run(["scontrol", "update", f"JobId={task}", "StartTime=now"], env=self.environment)
            return not self.run("squeue", "-h").strip()

        until(done)

    def restart(self, node):
        """As if its machine was switched off, until the controller finds out, and on: all that runs there is gone."""
        tasks = [pid for pid in processes() if f"SLURMD_NODENAME={node}" in environment_of(pid)]
        steps = [pid for pid in {parent_of(pid) for pid in tasks} if name_of(pid) == "slurmstepd"]
        assert tasks and steps
        for pid in (int((self.folder / f"{node}.pid").read_text()), *steps, *tasks):
            kill(pid)
        until(lambda: any(state.startswith("down") for state in self.states()))
        self.run("slurmd", "-N", node, "-b")

    def stop(self):
        for name in (*NODES, "slurmctld", "munge"):
            kill(int((self.folder / f"{name}.pid").read_text()))


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def until(condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, "it hangs"
        time.sleep(0.2)


def processes():
    return [int(path.name) for path in Path("/proc").iterdir() if path.name.isdigit()]


def environment_of(pid):
    return read(pid, "environ").split("\0")


def parent_of(pid):
    return int(read(pid, "stat").rpartition(")")[2].split()[1])


def name_of(pid):
    return read(pid, "comm").strip()


def read(pid, name):
    try:
        return Path("/proc", str(pid), name).read_text(errors="replace")
    except OSError:
        return "() ? 0"  # it has ended


def kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


@pytest.fixture
def cluster():
    missing = [name for name in ("munged", "slurmctld", "slurmd") if not shutil.which(name)]
    assert not missing, f"Debian's slurm-wlm and munge have {missing}"
    with tempfile.TemporaryDirectory(dir="/tmp") as folder:  # names of sockets are short
        made = Cluster(Path(folder))
        yield made
        made.stop()


def test_a_killed_task_and_a_restarted_node_change_no_pixel(tmp_path, cluster):
    file, out = frames.saved(tmp_path), tmp_path / "out"
    whole = frames.undisturbed(file, tmp_path / "whole")
    cluster.submit(file, out)
    until(lambda: len(list(out.glob("*.png"))) > 1)
    until(lambda: set(cluster.running()) == set(NODES))
    cluster.run("scancel", "--full", "--signal=KILL", cluster.running()["n1"])
    until(lambda: "n2" in cluster.running() and any("SLURMD_NODENAME=n2" in environment_of(p) for p in processes()))
    cluster.restart("n2")
    cluster.finish()
    killed = [log.name for log in sorted(cluster.folder.glob("task-*.log")) if "Killed" in log.read_text()]
    print("killed:", killed, "frames:", len(list(out.glob("*.png"))))
    cluster.submit(file, out)
    cluster.finish()
    assert frames.same(out, whole)
