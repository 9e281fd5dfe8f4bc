"""A Slurm of two nodes that are this machine, by Debian's slurm-wlm and munge, without root's rights: every daemon and job is one ordinary
user's. For tests that are run by hand."""
import os
import pwd
import shutil
import socket
import subprocess
import tempfile

from real_server import until

DAEMONS = ("munged", "slurmctld", "slurmd", "sbatch", "srun")
CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
KillWait=2
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdSpoolDir={folder}/%n
SlurmdPidFile={folder}/%n/slurmd.pid
SlurmdLogFile={folder}/%n.log
TmpFS={folder}/%n
SlurmdParameters=config_overrides
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
NodeName=node1 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=2 RealMemory=1000 State=UNKNOWN
NodeName=node2 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=2 RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP MaxTime=60
"""


def installed():
    return all(shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin") for name in DAEMONS)


def free_ports(count):
    taken = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [each.getsockname()[1] for each in taken]
    for each in taken:
        each.close()
    return ports


class Cluster:
    def __init__(self):
        # Slurm runs no job of root's without root's rights.
        self.user = "slurm" if os.getuid() == 0 else pwd.getpwuid(os.getuid()).pw_name
        self.folder = tempfile.mkdtemp(prefix="slurm-")
        self.environment = {"PATH": os.environ["PATH"] + ":/usr/sbin", "HOME": self.folder,
                            "SLURM_CONF": os.path.join(self.folder, "slurm.conf")}
        self.daemons = []
        for name in ("state", "node1", "node2"):
            os.mkdir(self.path(name))
        with open(self.path("slurm.conf"), "w", encoding="utf-8") as file:
            file.write(CONFIGURATION.format(folder=self.folder, host=socket.gethostname(), user=self.user, ports=free_ports(3)))
        with open(self.path("munge.key"), "wb") as file:
            file.write(os.urandom(1024))
        if os.getuid() == 0:
            for name in ("", *os.listdir(self.folder)):
                shutil.chown(self.path(name), self.user)
        os.chmod(self.path("munge.key"), 0o600)
        os.chmod(self.folder, 0o755)

    def path(self, name):
        return os.path.join(self.folder, name)

    def start(self):
        self._begin("munged", "--foreground", "--force", *(f"--{name}={self.path('munge.' + end)}" for name, end in (
            ("key-file", "key"), ("socket", "socket"), ("pid-file", "pid"), ("log-file", "log"), ("seed-file", "seed"))))
        until(lambda: os.path.exists(self.path("munge.socket")))
        self._begin("slurmctld", "-D", "-c")
        for node in ("node1", "node2"):
            self._begin("slurmd", "-D", "-N", node)
        until(lambda: self.output("sinfo", "-h", "-N", "-o", "%T").split() == ["idle", "idle"])

    def _begin(self, *words):
        with open(self.path(words[0] + ".out"), "ab") as said:
            self.daemons.append(self.begin(*words, stdin=subprocess.DEVNULL, stdout=said, stderr=said))

    def begin(self, *words, **options):
        return subprocess.Popen(words, env=self.environment, cwd=self.folder, **self._as_user(), **options)

    def output(self, *words, **more):
        done = subprocess.run(words, env={**self.environment, **more}, cwd=self.folder, capture_output=True, text=True, check=False,
                              **self._as_user())
        return done.stdout

    def _as_user(self):
        return {"user": self.user, "group": self.user, "extra_groups": []} if os.getuid() == 0 else {}

    def stop(self):
        self.output("scancel", "--user", self.user)
        until(lambda: not self.output("squeue", "-h").strip())
        for each in reversed(self.daemons):
            each.terminate()
            each.wait()
        shutil.rmtree(self.folder, ignore_errors=True)
