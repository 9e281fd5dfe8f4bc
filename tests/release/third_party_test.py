"""THIRD_PARTY.txt names what the programs are made of: what they link, and what they include."""
import importlib.machinery
import importlib.util
import os
import re
import subprocess
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TREE = os.path.join(ROOT, "build", "release")
# Libraries that leave code in the programs by their headers, by what an #include of them begins with.
HEADERS = {"boost/": "libboost-dev", "nlohmann/": "nlohmann-json3-dev", "glm/": "libglm-dev", "tl/": "libexpected-dev",
           "CLI/": "libcli11-dev", "fmt/": "libfmt-dev", "spdlog/": "libspdlog-dev", "draco/": "libdraco-dev",
           "tbb/": "libtbb-dev", "oneapi/tbb/": "libtbb-dev", "prometheus/": "prometheus-cpp-dev", "openssl/": "libssl-dev"}
PLAIN = {"tiny_gltf.h": "libtinygltf-dev", "sqlite3.h": "libsqlite3-dev", "curl/curl.h": "libcurl4-openssl-dev", "zlib.h": "zlib1g-dev", "blosc.h": "libblosc-dev", "zstd.h": "libzstd-dev", "seccomp.h": "libseccomp-dev",
         "udunits2.h": "libudunits2-dev", "mpi.h": "libopenmpi-dev", "netcdf.h": "libnetcdf-dev", "hdf5.h": "libhdf5-dev"}
SYSTEM = re.compile(r"(sys|linux|bits|arpa|netinet|net|asm)/|[a-z_0-9]+(\.h)?$")  # of the C++ library and the system


def load_script():
    path = os.path.join(ROOT, "packaging", "third_party")
    loader = importlib.machinery.SourceFileLoader("third_party", path)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("third_party", loader))
    loader.exec_module(module)
    return module


def text():
    with open(os.path.join(ROOT, "THIRD_PARTY.txt"), encoding="utf-8") as file:
        return file.read()


def unnamed_headers(sources, table):
    """Headers of libraries that the table has no entry for."""
    packages = set(re.findall(r"    package +(\S+)", table))
    for path, code in sources:
        for header in re.findall(r"#\s*include <([^>]+)>", code):
            package = PLAIN.get(header) or next((name for start, name in HEADERS.items() if header.startswith(start)), None)
            if package is None and header.startswith("vtk"):
                package = "libvtk9-dev"
            if package is None and not SYSTEM.match(header):
                yield f"{path}: <{header}> is of a library that this test does not know"
            if package is not None and package not in packages:
                yield f"{path}: <{header}> is of {package}, which THIRD_PARTY.txt does not name"


def sources():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "command", "core", "importer", "protocol", "store", "server"], capture_output=True, text=True,
                            check=True).stdout.split()
    for path in listed:
        if path.endswith((".cpp", ".hpp")) and os.path.exists(os.path.join(ROOT, path)):
            with open(os.path.join(ROOT, path), encoding="utf-8") as file:
                yield path, file.read()


class ThirdParty(unittest.TestCase):
    maxDiff = None

    @unittest.skipUnless(all(os.path.exists(os.path.join(TREE, "bin", name)) for name in load_script().PROGRAMS), "not all is built")
    def test_names_each_library_that_the_programs_link_and_by_which(self):
        script = load_script()
        made, faults = script.corrected(text(), script.of_tree(TREE))
        self.assertEqual(faults, [])
        self.assertEqual(made, text(), "run packaging/third_party build/release")

    def test_names_each_library_whose_headers_are_included(self):
        self.assertEqual(list(unnamed_headers(sources(), text())), [])


class TheLinter(unittest.TestCase):
    TABLE = "zlib\n    package   zlib1g-dev\n    use       shared library\n    libraries libz\n    linked by wakesurf\n\n-----\nrest"

    def test_writes_who_links_a_library(self):
        made, faults = load_script().corrected(self.TABLE, {"wakesurf": {"libz"}, "wakesurf-import": {"libz"}, "wakesurf-bricks": set()})
        self.assertEqual((made, faults), (self.TABLE.replace("by wakesurf", "by wakesurf, wakesurf-import"), []))

    def test_flags_a_library_without_entry_and_an_entry_without_library(self):
        _, faults = load_script().corrected(self.TABLE, {"wakesurf": {"libhdf5"}, "wakesurf-import": set(), "wakesurf-bricks": set()})
        self.assertEqual(faults, ["libz is not linked by any program", "wakesurf links libhdf5, which no entry names"])

    def test_flags_headers_of_a_library_without_entry(self):
        flagged = list(unnamed_headers([("a.cpp", "#include <zlib.h>\n#include <vector>\n#include <netcdf.h>\n#include <eigen/core>")], self.TABLE))
        self.assertEqual(len(flagged), 2)
        self.assertIn("netcdf.h", flagged[0])
        self.assertIn("does not know", flagged[1])


if __name__ == "__main__":
    unittest.main()
