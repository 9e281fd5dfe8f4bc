"""`wakesurf info` and `wakesurf surface`: which fields there are, which can be carried, and what is said of a name that is none."""
import json
import os
import subprocess
import tempfile
import unittest

from real_server import BINARY, ROOT

CYLINDER = os.path.join(ROOT, "data/sqcyl/sqcyl.pvd")
LINE = "0.4,0.4,0.1 0.6,0.6,0.1"


class InfoTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.store = os.path.join(cls.folder, "store")
        cls.said("generate", "flow:tornado", cls.store, "--grid", "9,9,9", "--times", "0:2:3")
        cls.said("family", cls.store, "--name", "psi", "--plane", "0.5,0.5,0.5 0,0,1", "--time", "0,1")

    @classmethod
    def said(cls, *words, status=0):
        done = subprocess.run([BINARY, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60, check=False,
                              env={**os.environ, "WAKESURF_STORE": os.path.join(cls.folder, "imported")})
        if done.returncode != status:
            raise AssertionError(f"{words}: {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def refused(self, *words):
        return self.said("surface", self.store, *words, "-o", os.path.join(self.folder, "a.vtp"), status=1)

    def test_lists_the_families_with_what_they_are_of_their_values_and_their_times(self):
        said = self.said("info", self.store)
        self.assertIn("  family    psi: y on a plane\n            at time 0: ", said)
        self.assertRegex(said, r"at time 1: \S+ to \S+, \d+ of 729 nodes have a value\n")
        self.assertNotIn("field     psi", said)
        families = json.loads(self.said("info", self.store, "--json"))["families"]
        self.assertEqual([(each["name"], [step["time"] for step in each["steps"]]) for each in families], [("psi", [0, 1])])

    def test_lists_the_families_of_a_source_which_are_in_its_store(self):
        self.assertNotIn("family", self.said("info", CYLINDER))
        self.said("family", CYLINDER, "--name", "height", "--from", "inflow=z", "--time", "8.5")
        self.assertIn("  family    height: z where the flow enters\n", self.said("info", CYLINDER))
        self.assertIn("height", json.loads(self.said("info", CYLINDER, "--json"))["surfaceFields"])

    def test_says_which_fields_can_be_carried_and_which_are_not_stored(self):
        told = json.loads(self.said("info", CYLINDER, "--json"))
        self.assertEqual([each.get("stored", True) for each in told["fields"] if each["name"] in ("U", "mask")], [True, False])
        self.assertNotIn("mask", told["surfaceFields"])
        self.assertIn("mask, 1 component, point data, 0 to 1; not stored", self.said("info", CYLINDER))
        refused = self.said("surface", CYLINDER, "--kind", "stream", "--fields", "mask", "-o", os.path.join(self.folder, "a.vtp"), status=1)
        self.assertIn("--fields names a field that was not stored when the dataset was imported: mask", refused)

    def test_says_which_field_may_be_meant_and_which_there_are(self):
        for words, meant in ((("--kind", "stream", "--fields", "vorticty"), "--fields names a field the dataset does not have: vorticty (did you mean "
                              "vorticity? There is psi, velocity, deformation, "),
                             (("--kind", "level", "--level", "1", "--field", "q_criterium"), "(did you mean q_criterion? There is psi, velocity, vorticity, ")):
            self.assertIn(meant, self.refused(*words))

    def test_names_the_times_that_a_family_has_where_a_level_set_is_at_another(self):
        said = self.refused("--kind", "level", "--field", "psi", "--level", "0.5", "--from", "2", "--to", "2")
        self.assertIn("psi has no values (psi has values at t = 0, 1: ", said)

    def test_spells_what_a_hint_names_as_the_command_line_does(self):
        said = self.refused("--kind", "stream", "--rake", LINE, "--max-quads", "1", "--separation", "0.05")
        self.assertIn("raise --max-quads", said)
        with tempfile.TemporaryDirectory() as state:
            self.assertNotIn("`session.", self.said("sessions", "export", "nothing", "--state", state, status=1))


if __name__ == "__main__":
    unittest.main()
