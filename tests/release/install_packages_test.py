"""packaging/install_packages and ./run with an apt of paper: which names they pick, what they say before they start, what they never do."""
import os
import shutil
import subprocess
import tempfile
import unittest

from real_server import ROOT

SCRIPT = os.path.join(ROOT, "packaging/install_packages")

APT_GET = """#!/bin/sh
echo "apt-get $*" >>"$FAKE/calls"
case "$*" in
*" -s "*)
    [ ! -e "$FAKE/conflict" ] || { cat "$FAKE/conflict" >&2; exit 100; }
    cat "$FAKE/plan"
    ;;
*--print-uris*)
    echo "'http://mirror/a.deb' a.deb 2000000 SHA256:0"
    echo "'http://mirror/b.deb' b.deb 40500000 SHA256:0"
    ;;
esac
"""

APT_CACHE = """#!/bin/sh
shift
for name in "$@"; do
    grep -qx -e "$name" "$FAKE/known" && printf '%s:\\n  Installed: (none)\\n  Candidate: 1.0\\n' "$name"
    grep -qx -e "$name" "$FAKE/virtual" && printf '%s:\\n  Installed: (none)\\n  Candidate: (none)\\n' "$name"
done
exit 0
"""

DPKG_QUERY = """#!/bin/sh
for name in "$@"; do grep -x -e "ii  $name" "$FAKE/installed"; done
exit 0
"""

LIST = """# package group command
libfmt9|libfmt10   run   -
libssl3|libssl3t64 run   -
zlib1g             run   -
nodejs             web   sh
"""


class PaperApt(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        bin_folder = os.path.join(self.folder.name, "bin")
        os.mkdir(bin_folder)
        sudo = '#!/bin/sh\n[ "$1" != -n ] || shift\nexec "$@"\n'
        for name, text in (("apt-get", APT_GET), ("apt-cache", APT_CACHE), ("dpkg-query", DPKG_QUERY), ("sudo", sudo)):
            path = os.path.join(bin_folder, name)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            os.chmod(path, 0o755)
        for name in ("known", "virtual", "installed", "calls"):
            self.write(name, "")
        self.write("plan", "Inst libfmt10 (1.0)\nInst libssl3t64 (1.0)\nConf libfmt10 (1.0)\n")
        self.write("packages.txt", LIST)
        self.environment = {"PATH": bin_folder + os.pathsep + os.environ["PATH"], "FAKE": self.folder.name,
                            "WAKESURF_PACKAGE_LIST": os.path.join(self.folder.name, "packages.txt")}

    def write(self, name, text):
        with open(os.path.join(self.folder.name, name), "w", encoding="utf-8") as file:
            file.write(text)


class InstallPackagesTest(PaperApt):
    def run_script(self, *groups):
        ran = subprocess.run([SCRIPT, *groups], env=self.environment, stdin=subprocess.DEVNULL, text=True, timeout=60,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        with open(os.path.join(self.folder.name, "calls"), encoding="utf-8") as file:
            calls = file.read().splitlines()
        installs = [call for call in calls if " install " in call and " -s " not in call and "--print-uris" not in call]
        return ran.returncode, ran.stdout, installs

    def test_a_package_goes_by_the_name_that_this_release_has_for_it(self):
        self.write("known", "libfmt10\nlibssl3t64\nzlib1g\n")
        self.write("virtual", "libssl3\n")  # Debian 13 knows the name, but has no package of it
        status, said, installs = self.run_script("run")
        self.assertEqual(status, 0, said)
        self.assertEqual([call.split("--no-install-recommends ")[1].split() for call in installs],
                         [["libfmt10", "libssl3t64", "zlib1g"]])

    def test_an_installed_alternative_is_enough(self):
        self.write("installed", "ii  libfmt10\nii  libssl3t64\nii  zlib1g\n")
        status, said, installs = self.run_script("run", "web")
        self.assertEqual((status, said, installs), (0, "", []))

    def test_it_says_what_it_will_download_before_it_starts_and_asks_nobody_where_nobody_is(self):
        self.write("known", "libfmt10\nlibssl3t64\nzlib1g\n")
        status, said, _ = self.run_script("run")
        self.assertEqual(status, 0, said)
        self.assertIn("2 packages, 43 MB to download, some 1 min", said)
        self.assertNotIn("Continue?", said)

    def test_what_no_release_calls_so_is_named_and_nothing_is_installed(self):
        self.write("known", "libssl3\nzlib1g\n")
        status, said, installs = self.run_script("run")
        self.assertEqual((status, installs), (1, []))
        self.assertIn("libfmt9|libfmt10", said)
        self.assertIn("WAKESURF_PACKAGES=present", said)

    def test_it_takes_away_nothing_that_is_installed(self):
        self.write("known", "libfmt10\nlibssl3t64\nzlib1g\n")
        self.write("plan", "Remv paraview [5.11.0]\nInst libfmt10 (1.0)\n")
        status, said, installs = self.run_script("run")
        self.assertEqual((status, installs), (3, []))
        self.assertIn("would remove paraview", said)

    def test_a_conflict_is_told_in_the_words_of_apt(self):
        self.write("known", "libfmt10\nlibssl3t64\nzlib1g\n")
        self.write("conflict", "Reading package lists...\n a : Conflicts: b but 1 is to be installed\nE: broken\n")
        status, said, installs = self.run_script("run")
        self.assertEqual((status, installs), (3, []))
        self.assertIn("a : Conflicts: b", said)

    def test_an_unknown_group_is_wrong_usage(self):
        status, said, _ = self.run_script("nonsense")
        self.assertEqual(status, 2)
        self.assertIn("nonsense", said)


class FirstStartTest(PaperApt):
    """./run of a clone, as far as the packages, which apt refuses here."""

    def setUp(self):
        super().setUp()
        self.clone = os.path.join(self.folder.name, "clone")
        shutil.copytree(os.path.join(ROOT, "packaging"), os.path.join(self.clone, "packaging"))
        shutil.copy(os.path.join(ROOT, "run"), self.clone)
        self.write("packages.txt", "libssl3 build -\nlibvtk9.1 vtk -\nnodejs web sh\n")
        self.write("known", "libssl3\nlibvtk9.1\n")
        self.write("conflict", "E: broken\n")

    def run_clone(self):
        ran = subprocess.run([os.path.join(self.clone, "run")], env=self.environment, stdin=subprocess.DEVNULL, text=True,
                             timeout=60, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(ran.returncode, 3, ran.stdout)
        return ran.stdout

    def test_says_what_npm_will_download_and_how_long_it_compiles_before_it_starts(self):
        said = self.run_clone()
        self.assertRegex(said, r"^the first start takes up to \d+ MB of npm packages to download "
                               r"and some \d+ min of compiling on the \d+ cores of this machine\n")
        self.assertIn("apt cannot install", said)

    def test_says_nothing_of_what_is_there(self):
        os.makedirs(os.path.join(self.clone, "web-client/node_modules"))
        os.makedirs(os.path.join(self.clone, "build/release/bin"))
        with open(os.path.join(self.clone, "build/release/bin/wakesurf"), "w", encoding="utf-8"):
            pass
        self.assertNotIn("first start", self.run_clone())


if __name__ == "__main__":
    unittest.main()
