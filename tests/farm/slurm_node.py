# SPDX-License-Identifier: Apache-2.0
"""A Slurm of one node, on the loopback interface and in a folder of its own: started on entry, stopped on exit.

usage, to try something by hand: slurm_node.py COMMAND ARGUMENT..., for example slurm_node.py sinfo
"""
import contextlib
import getpass
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "srun", "squeue")
CPUS = 4  # as the configuration says, whatever the machine has


def find(program):
    return shutil.which(program, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def missing():
    """Returns the programs that are not installed."""
    return [program for program in PROGRAMS if not find(program)]


def free_ports(count):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]


def configuration(folder):
    """Returns slurm.conf: one node, no accounting, no cgroups, all by the user who runs this."""
    control, node = free_ports(2)
    user = getpass.getuser()
    return f"""ClusterName=bench
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort={control}
SlurmdPort={node}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0,defer
MpiDefault=pmix
ReturnToService=2
SlurmdParameters=config_overrides
NodeName=localhost NodeAddr=127.0.0.1 CPUs={CPUS} State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=10 State=UP
"""


class SlurmNode:
    def __enter__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="slurm-"))
        self.processes = []
        try:
            self.start()
        except BaseException:
            self.__exit__()
            raise
        return self

    def start(self):
        self.folder.chmod(0o755)
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.conf = self.folder / "slurm.conf"
        self.conf.write_text(configuration(self.folder))
        # No control groups are used; without these lines slurmd wants them mounted all the same.
        (self.folder / "cgroup").mkdir()
        (self.folder / "cgroup.conf").write_text(f"CgroupPlugin=cgroup/v1\nCgroupMountpoint={self.folder}/cgroup\n")
        self.environment = {**os.environ, "SLURM_CONF": str(self.conf)}
        named = {name: f"--{name}={self.folder}/munge.{name}" for name in ("socket", "pid-file", "log-file", "seed-file")}
        self.spawn("munged", "--foreground", "--force", f"--key-file={key}", *named.values())
        self.wait_for(lambda: (self.folder / "munge.socket").exists(), "munged")
        self.spawn("slurmctld", "-D", "-f", self.conf)
        self.spawn("slurmd", "-D", "-f", self.conf, "-N", "localhost")
        self.wait_for(lambda: "idle" in self.run("sinfo", "-h", "-o", "%T", check=False).stdout, "the node")

    def spawn(self, program, *arguments):
        with (self.folder / f"{program}.out").open("wb") as out:
            self.processes.append(subprocess.Popen([find(program), *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=out,
                                                   stderr=out, env=self.environment, start_new_session=True))

    def wait_for(self, ready, what, seconds=60):
        end = time.monotonic() + seconds
        while not ready():
            dead = [process.args[0] for process in self.processes if process.poll() is not None]
            if dead or time.monotonic() > end:
                raise RuntimeError(f"{what} is not ready; ended: {dead}\n{self.logs()}")
            time.sleep(0.2)

    def logs(self):
        return "\n".join(f"== {path.name}\n{path.read_text(errors='replace')[-3000:]}" for path in self.folder.glob("*.out"))

    def run(self, *command, check=True, timeout=240, cwd=None):
        """Runs a command that may use Slurm."""
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=self.environment,
                              timeout=timeout, cwd=cwd)
        if check and done.returncode != 0:
            raise RuntimeError(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}\n{self.logs()}")
        return done

    def __exit__(self, *_):
        for sign in (signal.SIGTERM, signal.SIGKILL):
            for process in reversed(self.processes):
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(process.pid, sign)
            for process in self.processes:
                with contextlib.suppress(subprocess.TimeoutExpired):
                    process.wait(10)
        shutil.rmtree(self.folder, ignore_errors=True)


if __name__ == "__main__":
    if missing():
        sys.exit(f"not installed: {', '.join(missing())}; scripts/setup.sh farm installs them")
    with SlurmNode() as node:
        done = node.run(*sys.argv[1:], check=False)
        sys.stdout.write(done.stdout)
        sys.stderr.write(done.stderr)
    sys.exit(done.returncode)
