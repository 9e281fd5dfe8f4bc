"""Importers end with their server, however that ends."""
import os
import signal
import tempfile
import time
import unittest

from real_server import RealServer


def parent_of(process):
    try:
        with open(f"/proc/{process}/stat", encoding="ascii", errors="replace") as file:
            state, parent = file.read().rpartition(")")[2].split()[:2]
        return None if state == "Z" else int(parent)
    except OSError:
        return None


def below(process):
    parents = {each: parent_of(each) for each in map(int, filter(str.isdigit, os.listdir("/proc")))}
    found, new = set(), {process}
    while new:
        new = {each for each, parent in parents.items() if parent in new}
        found |= new
    return found


def wait_for(fact):
    end = time.monotonic() + 30
    while not fact():
        if time.monotonic() > end:
            raise AssertionError("it never came to that")
        time.sleep(0.02)


class ImportersEnd(unittest.TestCase):
    def test_when_their_server_is_killed_while_they_tell_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            nodes = 64
            numbers = "0.5 " * (3 * nodes ** 3)
            extent = f"0 {nodes - 1} " * 3
            with open(os.path.join(folder, "slow_0.vti"), "w", encoding="ascii") as file:
                file.write(f"""<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="{extent}" Origin="0 0 0"
Spacing="1 1 1"><Piece Extent="{extent}"><PointData><DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">
{numbers}</DataArray></PointData></Piece></ImageData></VTKFile>""")
            for step in range(1, 30):
                os.link(os.path.join(folder, "slow_0.vti"), os.path.join(folder, f"slow_{step}.vti"))
            server = RealServer(os.path.join(folder, "slow_0.vti"), "--store", os.path.join(folder, "stores"))
            own = server.process.pid
            wait_for(lambda: len(below(own)) >= 2)
            importers = below(own)
            watching = [each for each in importers if parent_of(each) == own]
            for each in importers - set(watching):
                os.kill(each, signal.SIGSTOP)  # a survey that takes minutes tells nothing either
            server.process.kill()
            server.process.wait()
            server.process.stdout.close()
            wait_for(lambda: all(parent_of(each) is None for each in importers))


if __name__ == "__main__":
    unittest.main()
