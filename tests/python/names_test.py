"""Every method of the server by its name in Python, what is sent for it, and what is said to wrong names."""
import inspect
import os
import sys
import typing
import unittest
import warnings

from real_server import ROOT, RealServer
import wakesurf
from wakesurf.generated.methods import Methods
from wakesurf.plain import NULL, given

sys.path.insert(0, os.path.join(ROOT, "protocol/api"))
from generator import schema  # noqa: E402
from generator.python import group_of, python_name  # noqa: E402

LINE = [(0.4, 0.4, 0.1), (0.6, 0.6, 0.1)]


class EveryMethod(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.methods = schema.load().methods

    def called(self, method, session=None):
        sent = []
        api = Methods(lambda name, _timeout=None, /, **parameters: sent.append((name, given(parameters))), session)
        noun, name = group_of(method)
        function = getattr(getattr(api, noun), name)
        example = {name: NULL if value is None else value for name, value in method.data["x-example"]["params"].items()}
        function(**{python_name(name): value for name, value in example.items()})
        return sent

    def test_sends_the_example_of_the_description(self):
        self.assertGreater(len(self.methods), 50)
        for method in self.methods:
            with self.subTest(method.name):
                self.assertEqual(self.called(method), [(method.name, method.data["x-example"]["params"])])

    def test_takes_the_session_that_it_belongs_to_unless_another_one_is_given(self):
        for method in self.methods:
            with self.subTest(method.name):
                ((_, parameters),) = self.called(method, "mine")
                takes = any(each.name == "session" for each in method.params.fields)
                there = method.data["x-example"]["params"].get("session", "mine" if takes else None)
                self.assertEqual(parameters.get("session"), there)

    def test_has_a_signature_that_says_all_types(self):
        for method in self.methods:
            noun, name = group_of(method)
            function = getattr(getattr(Methods(None), noun), name)
            with self.subTest(method.name):
                signature = inspect.signature(function)
                self.assertEqual(list(signature.parameters), sorted(signature.parameters, key=lambda each: (
                    each == "session", signature.parameters[each].default is not inspect.Parameter.empty)))
                self.assertNotIn(inspect.Signature.empty, [signature.return_annotation,
                                                           *(each.annotation for each in signature.parameters.values())])
                self.assertTrue(function.__doc__)

    def test_records_are_types_that_can_be_asked_for(self):
        self.assertGreater(len(wakesurf.records.__all__), 60)
        for name in wakesurf.records.__all__:
            with self.subTest(name):
                self.assertTrue(typing.is_typeddict(getattr(wakesurf.records, name)))


class WrongNames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = RealServer("flow:tornado")
        cls.session = wakesurf.Client(cls.server.url).session()
        cls.rake = cls.session.rake(line=LINE, seeds=8)

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def refused(self, call, words):
        with self.assertRaises(wakesurf.UnknownParameter) as raised:
            call()
        self.assertIsInstance(raised.exception, TypeError)
        self.assertIn(words, str(raised.exception))

    def test_of_parameters_are_refused_with_the_one_that_may_be_meant(self):
        surface = self.session.surface(self.rake, "stream", dataset="tornado", to=1)
        self.refused(lambda: self.session.surface(self.rake, "stream", dataset="tornado", to=1, seperation=1), "did you mean `separation`?")
        self.refused(lambda: surface.set(maxQuad=9), "did you mean `max_quads`?")
        self.refused(lambda: self.session.rake(lines=LINE), "did you mean `line`?")
        self.refused(lambda: self.session.rake(colours=1, line=LINE), "did you mean `colour`?")
        self.refused(lambda: self.session.api.bookmark.set(vew={}), "did you mean `view`?")
        self.refused(lambda: self.session.api.session.rename(zebra=1), "there are name")

    def test_of_parameters_that_are_missing_are_said_with_what_they_are(self):
        for call, words in ((lambda: self.session.surface(self.rake, "streak", to=2), "surface needs `dataset` (an id from dataset.list)"),
                            (lambda: self.session.surface(self.rake, dataset="tornado", to=2), "surface needs `kind` (stream: streamlines"),
                            (lambda: self.session.film("film"), "film needs `times`"),
                            (lambda: self.session.api.dataset.describe(), "describe needs `dataset` (an id from dataset.list)"),
                            (lambda: self.session.api.bookmark.set(), "set needs `")):
            with self.assertRaises(wakesurf.MissingParameter) as raised:
                call()
            self.assertIn(words, str(raised.exception))
            self.assertIsInstance(raised.exception, TypeError)

    def test_spelt_as_the_server_spells_them_are_taken_with_a_word(self):
        with self.assertWarnsRegex(DeprecationWarning, "`maxQuads` of surface is spelt `max_quads`.*did you mean"):
            surface = self.session.surface(self.rake, "stream", dataset="tornado", to=1, maxQuads=5000)
        self.assertEqual(surface.record()["maxQuads"], 5000)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            surface = self.session.surface(self.rake, "stream", dataset="tornado", **{"from": 0.5, "to": 1})
            self.assertEqual(surface.record()["from"], 0.5)
            self.refused(lambda: surface.set(max_quads=1, maxQuads=2), "given twice")

    def test_of_methods_are_errors_with_the_one_that_may_be_meant(self):
        for thing, name, right in ((self.session, "setTime", "set_time"), (self.session, "surfacs", "surfaces"),
                                   (self.session.client, "data_sets", "datasets"), (self.rake, "colur", "colour"),
                                   (self.session.api.surface, "stat", "stats")):
            with self.subTest(name), self.assertRaisesRegex(AttributeError, f"no `{name}`: did you mean `{right}`"):
                getattr(thing, name)
        self.assertFalse(hasattr(self.session, "zebra"))

    def test_of_looks_are_refused_before_a_browser_is_started(self):
        from wakesurf.view import page_state
        self.refused(lambda: page_state({"look": {"color_by": "age"}}, ["s1"]), "did you mean `colour_by`?")
        self.refused(lambda: page_state({"camra": {}}, []), "did you mean `camera`?")


if __name__ == "__main__":
    unittest.main()
