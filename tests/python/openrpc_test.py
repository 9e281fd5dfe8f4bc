"""The OpenRPC document keeps the specification's rules, and tells the truth: every method is called, and every parameter
and result is checked against the schema the document gives for it."""
import copy
import json
import os
import subprocess
import tempfile
import unittest

from jsonschema import Draft7Validator, RefResolver

from openrpc_rules import faults, resolve
from real_server import BINARY, RealServer
import wakesurf
from wakesurf.plain import NULL

GENERIC = {"type": "object"}
PIXEL = ("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")


class OpenRpcTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.store = os.path.join(cls.folder.name, "stored")
        subprocess.run([BINARY, "generate", "uniform", cls.store, "--grid", "9,9,9", "--times", "0:1:3"], stdout=subprocess.DEVNULL, check=True)
        cls.server = RealServer("flow:lamb-oseen", "flow:double-gyre", cls.store)
        cls.client = wakesurf.Client(cls.server.url)
        cls.document = json.loads(cls.client._request("/openrpc.json")[2])
        cls.methods = {each["name"]: each for each in cls.document["methods"]}

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()
        cls.folder.cleanup()

    def test_the_document_keeps_the_rules(self):
        self.assertEqual((faults(self.document)), [])
        self.assertEqual(self.client.call("rpc.discover"), self.document)

    def test_the_rules_find_what_is_wrong(self):
        def broken(change):
            document = copy.deepcopy(self.document)
            change(document)
            return (faults(document))

        self.assertTrue(broken(lambda d: d["methods"].append(d["methods"][0])))
        self.assertTrue(broken(lambda d: d["methods"][0]["errors"].append({"$ref": "#/components/errors/no"})))
        self.assertTrue(broken(lambda d: d["methods"][0]["result"].update(schema={"$ref": "#/components/schemas/No"})))
        self.assertTrue(broken(lambda d: d["methods"][0]["result"].update(schema={"type": "thing"})))
        self.assertTrue(broken(lambda d: self._with(d, "rake.set")["params"].reverse()))

    @staticmethod
    def _with(document, name):
        return next(each for each in document["methods"] if each["name"] == name)

    def test_every_method_says_what_it_answers_and_every_error_is_one_of_the_contract(self):
        for name, method in self.methods.items():
            self.assertNotEqual(method["result"]["schema"], GENERIC, f"{name} does not say what it answers")
            self.assertTrue(method["summary"], name)
            for each in method["params"]:
                self.assertTrue(each["description"], f"{name} {each['name']}")
        codes = {each["code"] for each in self.document["components"]["errors"].values()}
        self.assertEqual(codes, {-32602, -32603, -32800, -32801, -32001, -32003, -32004, -32011, -32012, -32013, -32014,
                                 -32015})

    def test_it_says_what_parameters_are_that_are_left_out(self):
        of_surfaces = {each["name"]: each["schema"]["default"] for each in self.methods["surface.set"]["params"]
                       if "default" in each["schema"]}
        self.assertEqual(of_surfaces, {
            "default": False, "accuracy": "balanced", "interpolation": "linear", "between": "linear", "refine": "on", "merge": 0.35,
            "angle": 20, "stagnationSpeed": 1e-6, "maxQuads": 1_000_000, "fields": []})

    def test_examples_are_calls_and_answers_that_the_schemas_allow(self):
        self.assertEqual([name for name, method in self.methods.items() if not method.get("examples")], [])
        examples = [(method, each) for method in self.methods.values() for each in method["examples"]]
        for method, example in examples:
            schemas = {each["name"]: each["schema"] for each in method["params"]}
            given = {each["name"]: each["value"] for each in example["params"]}
            for each in method["params"]:
                self.assertTrue(each["name"] in given or not each["required"], f"{method['name']}: {each['name']}")
            for name, value in given.items():
                self.check(schemas[name], value, f"{method['name']} {name}")
            self.check(method["result"]["schema"], example["result"]["value"], method["name"])

    # The truth.

    def check(self, schema, value, where):
        resolver = RefResolver("", self.document)
        problems = [f"{'/'.join(map(str, each.absolute_path))}: {each.message}"
                    for each in Draft7Validator(schema, resolver=resolver).iter_errors(value)]
        self.assertEqual(problems, [], where)

    def ask(self, socket, name, /, **parameters):
        """A call whose parameters, result or error are as documented."""
        method = self.methods[name]
        known = {each["name"]: each for each in method["params"]}
        self.assertLessEqual(set(parameters), set(known), name)
        for each in method["params"]:
            if each["name"] in parameters:
                self.check(each["schema"], parameters[each["name"]], f"{name} {each['name']}")
            else:
                self.assertFalse(each["required"], f"{name} {each['name']}")
        self.called.add(name)
        try:
            result = socket.call(name, **{key: NULL if value is None else value for key, value in parameters.items()})
        except wakesurf.WakesurfError as problem:
            documented = [resolve(self.document, each["$ref"])["code"] for each in method["errors"]]
            self.assertIn(problem.code, documented, f"{name}: {problem}")
            self.check(self.document["components"]["schemas"]["ErrorData"],
                       {"kind": problem.kind, "hint": problem.hint, **problem.data}, name)
            raise
        self.check(method["result"]["schema"], result, name)
        return result

    def test_every_method_keeps_its_word(self):
        self.called = set()
        with wakesurf.Connection(self.client, 30) as host, wakesurf.Connection(self.client, 30) as other:
            def ask(name, /, **parameters):
                return self.ask(host, name, **parameters)

            def refused(kind, socket, name, /, **parameters):
                with self.assertRaises(kind, msg=name):
                    self.ask(socket, name, **parameters)

            for name in ("rpc.discover", "server.info", "server.ping", "dataset.list", "session.list"):
                ask(name)
            if "server.stats" in self.methods:
                ask("server.stats")
            for dataset in ("lamb-oseen", "double-gyre"):
                ask("dataset.describe", dataset=dataset)
                ask("dataset.open", dataset=dataset, timeoutMs=60000, workDoneToken="opening")
                ask("dataset.suggest", dataset=dataset)
                ask("cache.status", dataset=dataset)
            ask("probe.sample", dataset="lamb-oseen", points=[[0, 0, 0], [50, 0, 0]], time=0)
            ask("dataset.open", dataset="stored", timeoutMs=60000)
            ask("family.make", dataset="stored", name="psi", workDoneToken="f", **{"from": "inflow"})
            refused(wakesurf.InvalidParameters, host, "family.make", dataset="stored", name="psi", **{"from": "inflow"})
            ask("family.make", dataset="stored", name="phi", point=[1, 0, 0], normal=[1, 0, 0], scalar="psi", accuracy="exact",
                length=50, time=0, **{"from": "plane"})
            ask("family.make", dataset="stored", name="chi", rakeKind="circle", points=[[0, 0, 0], [0, 1, 0], [0, 0, 1]],
                **{"from": "curve"})
            self.assertEqual([each["name"] for each in ask("dataset.describe", dataset="stored")["families"]],
                             ["psi", "phi", "chi"])
            self.assertIn(["psi", "phi", "chi"], [each.get("families") for each in ask("dataset.list")["datasets"]])
            ask("family.remove", dataset="stored", name="phi")
            refused(wakesurf.NotFound, host, "family.remove", dataset="stored", name="phi")
            ask("mean.make", dataset="stored", fields=["velocity"], label="all", workDoneToken="m", **{"from": 0, "to": 1})
            ask("mean.make", dataset="stored", fields=["vorticity"], period=1, phases=2)
            self.assertIn("vorticity_phase", ask("dataset.describe", dataset="stored")["surfaceFields"])
            self.assertIn("velocity_k_all", [name for each in ask("dataset.list")["datasets"] for name in each.get("means", [])])
            refused(wakesurf.InvalidParameters, host, "mean.make", dataset="stored", fields=["velocity"], phases=3)
            ask("mean.remove", dataset="stored", name="velocity_k_all")
            refused(wakesurf.NotFound, host, "mean.remove", dataset="stored", name="velocity_k_all")
            session = ask("session.create", name="truth")["session"]
            me = ask("session.join", session=session, name="host", colour="#00ff00")
            guest = self.ask(other, "session.join", session=session, name="guest")
            ask("presence.update", pointer=[0, 0, 0], selected="r1", dragging={"rake": "r1", "points": [[0, 0, 0]]},
                camera={"position": [0, 0, 1], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 40})
            rake = ask("rake.set", kind="line", points=[[0.2, 0, -1], [1, 0, -1]], seeds=9, dragging=True)["rake"]
            refused(wakesurf.Leased, other, "rake.set", rake=rake, kind="line", points=[[0, 0, 0], [1, 0, 0]], seeds=3)
            ask("rake.set", rake=rake, kind="line", points=[[9, 0, 0], [14, 0, 0]], seeds=9, dragging=False)
            refused(wakesurf.Stale, host, "rake.set", rake=rake, kind="line", points=[[0, 0, 0], [1, 0, 0]], seeds=3,
                    ifRev=1)
            refused(wakesurf.OutsideDomain, host, "rake.set", kind="line", points=[[0, 0, 99], [1, 0, 99]], seeds=3)
            ask("rake.set", rake=rake, kind="polyline", points=[[0.2, 0, -1], [1, 0, -1]], seeds=9)
            circle = ask("rake.set", kind="circle", points=[[1, 0.5, 0], [1.2, 0.5, 0], [1, 0.7, 0]], seeds=9)["rake"]
            surface = ask("surface.set", rake=rake, kind="stream", dataset="lamb-oseen", to=2, separation=0.1,
                          **{"from": 0})["surface"]
            moving = ask("surface.set", rake=circle, kind="time", dataset="double-gyre", to=2, sweep=[0, 0, 0.2],
                         separation=0.1, **{"from": 0})["surface"]
            refused(wakesurf.NotFound, host, "surface.set", rake="r99", kind="stream", dataset="lamb-oseen", to=2,
                    **{"from": 0})
            ask("rake.list")
            ask("surface.list")
            ask("surface.stats", surface=surface)
            ask("surface.wait", surface=surface, timeoutMs=60000, workDoneToken="t")
            ask("surface.twin", surface=surface, twin={"accuracy": "exact", "offset": [0, 0, 0.1]})
            self.assertAlmostEqual(ask("surface.wait", surface=surface, timeoutMs=60000, checked=True)["twin"]["all"]["p50"], 0.1, 4)
            ask("surface.recipe", surface=surface)
            ask("surface.twin", surface=surface)
            ask("surface.wait", surface=surface, timeoutMs=60000)
            ask("surface.wait", surface=moving, timeoutMs=60000)
            ask("surface.stop", surface=moving)
            ask("surface.stats", surface=moving)
            subscription = ask("surface.subscribe", surface=surface)["subscription"]
            if "frame.ack" in self.methods:
                epoch = ask("surface.stats", surface=surface)["epoch"]
                ask("frame.ack", subscription=subscription, epoch=epoch, seq=0)
            ask("surface.unsubscribe", subscription=subscription)
            refused(wakesurf.NotFound, host, "surface.unsubscribe", subscription=subscription)
            if "time.set" in self.methods:
                ask("time.set", time=1.0)
                ask("time.play", speed=2, loop=True, **{"from": 0, "to": 2})
                ask("time.pause")
                ask("time.set", time=None)
            mark = ask("bookmark.set", name="here", view={"camera": [1, 2]}, time=1.5)["bookmark"]
            note = ask("annotation.set", text="look", position=[0, 0, 0], surface=surface)["annotation"]
            plane = ask("slice.set", dataset="lamb-oseen", origin=[0, 0, 0], normal=[0, 0, 1], field="vorticity_z")["slice"]
            refused(wakesurf.OutsideDomain, host, "slice.set", dataset="lamb-oseen", origin=[0, 0, 99], normal=[0, 0, 1])
            ask("slice.list")
            lines = ask("lines.set", dataset="lamb-oseen", kind="line", points=[[0.1, 0, 0], [1.5, 0, 0]], seeds=10)["lines"]
            refused(wakesurf.OutsideDomain, host, "lines.set", dataset="lamb-oseen", kind="sphere", points=[[0, 0, 99]], distance=1, seeds=10)
            ask("lines.list")
            ask("bookmark.list")
            ask("annotation.list")
            ask("session.state")
            ask("history.undo")
            ask("history.redo")
            ask("history.redo")
            fork = ask("session.fork", session=session)["session"]
            ask("session.rename", session=fork, name="copy")
            ask("session.setUnits", session=fork, length="mm", time="s")
            ask("session.thumbnail", session=fork, image=PIXEL)
            refused(wakesurf.InvalidParameters, host, "session.thumbnail", session=fork, image="no picture")
            file = ask("session.export", session=fork)["file"]
            ask("session.import", file=file, name="twin")
            refused(wakesurf.InvalidParameters, host, "session.import", file={})
            ask("session.delete", session=fork)
            ask("session.list", trash=True)
            refused(wakesurf.NotFound, host, "session.export", session=fork)
            ask("session.restore", session=fork)
            ask("session.delete", session=fork)
            ask("session.delete", session=fork, forever=True)
            first = ask("session.create")["session"]
            scene = ask("rake.set", session=first, kind="line", points=[[0, 0, 0], [1, 0, 0]], seeds=3, default=True)["rake"]
            ask("surface.set", session=first, rake=scene, kind="stream", dataset="lamb-oseen", to=1, default=True,
                **{"from": 0})
            refused(wakesurf.InvalidParameters, host, "rake.set", session=first, kind="line",
                    points=[[0, 0, 0], [1, 0, 0]], seeds=3, default=True)
            share = ask("session.share", role="viewer", expiresIn=60)
            ask("session.share", role="editor")
            ask("session.shares")
            ask("session.unshare", grant=share["grant"])
            refused(wakesurf.NotFound, host, "session.unshare", grant=share["grant"])
            ask("session.setRole", participant=guest["you"], role="viewer")
            refused(wakesurf.NotPermitted, other, "rake.delete", rake=rake)
            refused(wakesurf.NotPermitted, other, "family.remove", dataset="stored", name="psi")
            refused(wakesurf.NotPermitted, other, "mean.remove", dataset="stored", name="vorticity_phase")
            ask("bookmark.delete", bookmark=mark)
            ask("annotation.delete", annotation=note)
            ask("slice.delete", slice=plane)
            ask("lines.delete", lines=lines)
            ask("surface.delete", surface=moving)
            ask("rake.delete", rake=rake)
            ask("$/cancelRequest", id=12345)
            ask("session.kick", participant=guest["you"])
            ask("session.leave")
            back = ask("session.join", session=session, resumeToken=me["resumeToken"], lastSeq=me["seq"])
            self.assertIn("seq", back)
        self.assertEqual(self.called, set(self.methods), "each method is called above")


if __name__ == "__main__":
    unittest.main()
