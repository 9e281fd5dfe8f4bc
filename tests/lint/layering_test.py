#!/usr/bin/env python3
"""What no compiler checks here: wrong-way includes, the co_await lambda trap, file length, namespaces of tests.

Every rule is a function of (path, text) that yields messages; `SAMPLES` holds for each rule text it must flag
and text it must not, so that a rule which stops working fails as loudly as a file which breaks it.
Standard library only. Run it alone with: python3 tests/lint/layering_test.py
"""
import os
import re
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
LONGEST_FILE = 500
SOURCE = (".cpp", ".hpp", ".ts", ".tsx", ".py", ".css", ".js", ".mjs", ".sh")
GENERATED = {"node_modules", "dist", "build", "coverage", ".git", "fixtures"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)

SOCKETS = r"boost/(asio|beast)\b|sys/socket\.h|sys/un\.h|netinet/|arpa/inet|netdb\.h"
JSON = r"nlohmann/"
DRACO = r"draco/"
VTK = r"vtk[A-Z]\w*\.h"

CORE = "core"
IMPORTED = ["core", "store", "protocol/api", "importer/base", "importer/fields"]
READERS = [*IMPORTED, "importer/assembly", *(f"importer/sources/{one}" for one in ("blocks", "files", "series"))]
SERVICE = ["server/base", "server/data", "server/live", "server/sessions"]
FORMATS = ("cgns", "ensight", "exodus", "netcdf", "openfoam", "plot3d", "vtk")

# Folder -> what it may include besides itself. The longest that a path begins with counts, so `server/sessions` is what lies
# in that folder alone. tests/ may include everything, and nothing may include tests/.
MAY_INCLUDE = {
    "core/base": [],
    "core/dataset": ["core/base"],
    "core/integrate": ["core/base"],
    "core/field": ["core/base", "core/dataset", "core/integrate"],
    "core/surface": ["core"],
    "protocol/wire": ["core"],
    "protocol/api": ["core"],
    "protocol/files": ["core", "protocol/api"],
    "store": ["core", "protocol/api"],
    "store/command": ["core/base"],
    "importer/base": ["core", "store"],
    "importer/fields": ["core", "store", "importer/base"],
    "importer/assembly": IMPORTED,
    "importer/sources/files": IMPORTED[:4],
    "importer/sources/blocks": IMPORTED,
    "importer/sources/series": [*IMPORTED, "importer/sources/files"],
    **{f"importer/sources/{one}": READERS for one in FORMATS},
    "importer/sources": [*READERS, "importer/sources"],
    "importer": [*IMPORTED, "importer"],
    "importer/filter": ["core", "importer", "protocol/files"],
    "server/base": ["core", "protocol/api"],
    "server/remote": ["core/base", "server/remote/web", "server/remote/zarr"],
    "server/remote/web": ["core/base", "store"],
    "server/remote/zarr": ["core", "store", "protocol/api", "server/remote/web"],
    "server/data": ["core", "store", "protocol", "server/base", "server/remote/remote_dataset.hpp", "server/data"],
    "server/data/bricks": ["core", "store", "server/base"],
    "server/data/bricks/ranks": ["core/base", "store", "server/data/bricks"],
    "server/live": ["core", "protocol", "server/base", "server/data", "server/live/compute"],
    "server/live/compute": ["core", "protocol/wire", "server/base"],
    "server/sessions": ["core", "protocol/api", "server/base", "server/data", "server/live", "server/sessions"],
    "server/sessions/journal": ["core/base", "server/base"],
    "server/sessions/records": ["core", "protocol", "server/base", "server/data", "server/live/surface_events.hpp"],
    "server/sessions/people": ["core", "protocol/api", "server/base", "server/data", "server/sessions/records"],
    "server/net": ["core", "protocol", *SERVICE, "server/net/methods"],
    "server/net/methods": ["core", "protocol", *SERVICE],
    "server/app": ["core", "protocol", "store", *SERVICE, "server/remote/remote_dataset.hpp", "server/net"],
}

# Room of the including file -> what it may not include, and why.
FORBIDDEN = [
    (r"core/", "|".join((SOCKETS, JSON, DRACO)), "core knows no sockets, no JSON text, no Draco"),
    (r"protocol/", SOCKETS, "protocol is bytes in, values out: no sockets"),
    (r"store/", "|".join((SOCKETS, DRACO)), "a store is files: no sockets, no meshes"),
    (r"(?!importer/|tests/importer/|tests/bench/)", VTK, "only the importer, its tests and the benchmarks know VTK"),
    (r"(core|protocol|store|server)/.*\.hpp$", r"boost/beast|nlohmann/json\.hpp",
     "Beast and json.hpp cost seconds in every file that sees them: keep them in .cpp files"),
    (r"", r"boost/(asio|beast)\.hpp$", "include the single Asio and Beast headers that are needed"),
    (r"", r".*\.cpp$", "a .cpp file is nobody's interface"),
    (r"server/(base|remote|data|live|sessions)/", r"boost/(asio|beast)", "only net and app know sockets"),
    (r"server/(sessions|live)/", r"nlohmann/json\.hpp", "a session knows no JSON text"),
    (r"server/(?!data/bricks/ranks/)", r"server/data/bricks/ranks/", "wakesurf-bricks is a program of its own"),
    (r"(?!server/data/bricks/ranks/)", r"mpi\.h$", "only the ranks that hold bricks know MPI"),
    (r"server/sessions/journal/", r"nlohmann/", "what keeps records knows no JSON"),
    (r"(?!server/sessions/journal/|tests/)", r"sqlite3\.h", "only the journal knows SQLite"),
    (r"(?!server/remote/web/|tests/)", r"curl/", "only server/remote/web knows libcurl"),
    (r"(?!server/remote/zarr/|tests/)", r"(blosc|zstd)\.h$", "only server/remote/zarr knows what packs chunks"),
]


def folder_of(path):
    """The folder of MAY_INCLUDE that a path lies in."""
    return max((each for each in MAY_INCLUDE if path.startswith(each + "/")), key=len, default=None)


def without_comments_and_strings(text):
    """Same length and lines; comments and literals blanked, so that patterns meet code only."""
    token = re.compile(
        r'//[^\n]*|/\*.*?\*/|R"(?P<d>[^(\s]*)\(.*?\)(?P=d)"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\'',
        re.DOTALL)
    return token.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def wrong_includes(path, text):
    if not path.endswith((".cpp", ".hpp", ".h")):
        return
    home = folder_of(path)
    for match in INCLUDE.finditer(text):
        target = match.group(2)
        place = f"{path}:{line_of(text, match.start())}: includes {target}"
        for room, pattern, why in FORBIDDEN:
            if re.match(room, path) and re.match(pattern, target):
                yield f"{place}: {why}"
        if match.group(1) == "<":
            continue
        if not re.match(r"(core|importer|protocol|server|store|tests)/", target):
            yield f"{place}: write it from the root"
        elif home and folder_of(target) != home and not any(
                target == allowed or re.match(rf"{allowed}\b[/.]?", target) for allowed in MAY_INCLUDE[home]):
            yield f"{place}: {home} may not, see MAY_INCLUDE"


def arrows(texts, name):
    """name(path) -> the names of what it includes, others than itself; `texts`: path -> text."""
    out = {}
    for path, text in texts.items():
        if re.match(r"(core|importer|protocol|server|store)/.*\.(cpp|hpp|h)$", path):
            out.setdefault(name(path), set()).update(
                name(match.group(2)) for match in INCLUDE.finditer(text) if match.group(1) == '"')
    return {start: ends - {start} for start, ends in out.items()}


def circle(graph):
    """A way through the graph that comes back to where it began, as a list; empty: there is none."""
    done = set()

    def walk(node, way):
        if node in way:
            return way[way.index(node):]
        if node in done:
            return []
        for following in sorted(graph.get(node, ())):
            if found := walk(following, [*way, node]):
                return found
        done.add(node)
        return []
    return next((found for node in sorted(graph) if (found := walk(node, []))), [])


def unit_of(path):
    """A header and the source beside it are one unit."""
    return path.rsplit(".", 1)[0]


def statement_start(code, at):
    """Back over whole brackets to the last `;` or `{`; a block on the way counts only inside a call's `(`."""
    depth = 0
    block = None
    for i in range(at - 1, -1, -1):
        c = code[i]
        if c in ")]}":
            if c == "}" and depth == 0 and block is None:
                block = i
            depth += 1
        elif c in "([{":
            if depth > 0:
                depth -= 1
            elif c == "{":
                return (block if block is not None else i) + 1
            else:
                block = None
        elif c == ";" and depth == 0:
            return (block if block is not None else i) + 1
    return 0


def statement_end(code, start, at):
    """On to the `;` outside all brackets; `if (...) {` and its kin end at the brace."""
    depth = 0
    heads_a_block = re.match(r"\s*(else\s+)?(if|while|for|switch)\b", code[start:at])
    for i in range(start, len(code)):
        c = code[i]
        if c in "([":
            depth += 1
        elif c == "{":
            if depth == 0 and heads_a_block and i > at:
                return i
            depth += 1
        elif c in ")]}":
            depth -= 1
            if depth < 0:
                return i
        elif c == ";" and depth == 0 and i > at:
            return i
    return len(code)


# A lambda with captures: not [], not an [[attribute]], not a subscript (which follows a name, `)` or `]`).
CAPTURING = re.compile(r"(?<!\[)\[(?!\[|\s*\])[^\[\];{}]*\](?=\s*(?:\(|\{|<|mutable\b|noexcept\b|->))")


def co_await_lambdas(path, text):
    """g++ 12 destroys the captures twice (heap corruption). Name the lambda on the line before."""
    if not path.endswith((".cpp", ".hpp")) or "co_await" not in text:
        return
    code = without_comments_and_strings(text)
    for awaited in re.finditer(r"\bco_await\b", code):
        start = statement_start(code, awaited.start())
        end = statement_end(code, start, awaited.start())
        for capture in CAPTURING.finditer(code, start, end):
            before = re.search(r"(\w+|[)\]])\s*$", code[start:capture.start()])
            if before and before.group(1) not in ("return", "co_return", "co_yield", "co_await"):
                continue
            yield (f"{path}:{line_of(code, capture.start())}: capturing lambda in a co_await expression: "
                   "g++ 12 miscompiles it, name it on the line before")
            break


def too_long(path, text):
    lines = text.count("\n")
    if lines > LONGEST_FILE:
        yield f"{path}: {lines} lines, at most {LONGEST_FILE}: one idea a file"


def no_namespace_of_its_own(path, text):
    """Tests are compiled in groups of files, so what two of them call by one name may not meet."""
    stem = re.match(r"tests/.*?(\w+_test)\.cpp$", path)
    if stem and not re.search(rf"^namespace wakesurf::\w+::{stem.group(1)} \{{$", text, re.MULTILINE):
        yield f"{path}: its names belong in a namespace of its own, wakesurf::ROOM::{stem.group(1)}"


RULES = [wrong_includes, co_await_lambdas, too_long, no_namespace_of_its_own]

# (rule, path, text it must flag), (rule, path, text it must leave alone)
BAD = [
    (wrong_includes, "core/field/flow.hpp", '#include "protocol/wire/lattice.hpp"\n'),
    (wrong_includes, "core/field/flow.cpp", '#include "server/net/listener.hpp"\n'),
    (wrong_includes, "core/base/disk.cpp", "#include <sys/socket.h>\n"),
    (wrong_includes, "core/base/disk.cpp", "#include <boost/asio/post.hpp>\n"),
    (wrong_includes, "core/base/disk.cpp", "#  include <nlohmann/json_fwd.hpp>\n"),
    (wrong_includes, "core/surface/front.cpp", "#include <draco/mesh/mesh.h>\n"),
    (wrong_includes, "core/dataset/store.cpp", '#include "core/surface/rake.hpp"\n'),
    (wrong_includes, "protocol/wire/frame.cpp", '#include "server/sessions/session.hpp"\n'),
    (wrong_includes, "protocol/frame.cpp", "#include <boost/beast/core/flat_buffer.hpp>\n"),
    (wrong_includes, "protocol/frame.hpp", "#include <nlohmann/json.hpp>\n"),
    (wrong_includes, "server/net/listener.hpp", "#include <boost/beast/websocket/stream.hpp>\n"),
    (wrong_includes, "server/net/listener.cpp", '#include "server/net/methods/router.cpp"\n'),
    (wrong_includes, "server/net/listener.cpp", "#include <boost/asio.hpp>\n"),
    (wrong_includes, "server/data/store.cpp", "#include <vtkImageData.h>\n"),
    (wrong_includes, "tests/core/surface/peer_test.cpp", "#include <vtkStreamSurface.h>\n"),
    (wrong_includes, "server/sessions/session.cpp", "#include <nlohmann/json.hpp>\n"),
    (wrong_includes, "server/sessions/session.cpp", '#include "listener.hpp"\n'),
    (wrong_includes, "server/sessions/session.cpp", "#include <sqlite3.h>\n"),
    (wrong_includes, "store/store_reader.cpp", "#include <curl/curl.h>\n"),
    (wrong_includes, "server/remote/web/web_disk.cpp", '#include "server/data/open_dataset.hpp"\n'),
    (wrong_includes, "server/sessions/journal/state_store.cpp", "#include <nlohmann/json.hpp>\n"),
    (wrong_includes, "server/live/compute/budgets.hpp", '#include "server/sessions/people/grants.hpp"\n'),
    (wrong_includes, "server/sessions/records/observer.hpp", '#include "server/live/compute/pass_budgets.hpp"\n'),
    (wrong_includes, "importer/main.cpp", '#include "server/app/rake_text.hpp"\n'),
    (wrong_includes, "server/data/bricks/job_talk.cpp", '#include "server/data/open_dataset.hpp"\n'),
    (wrong_includes, "server/data/bricks/job_talk.cpp", "#include <mpi.h>\n"),
    (wrong_includes, "server/data/open_dataset.cpp", '#include "server/data/bricks/ranks/brick_window.hpp"\n'),
    (wrong_includes, "importer/sources/series/pvd_series.cpp", '#include "importer/sources/vtk/vtk_file.hpp"\n'),
    (wrong_includes, "importer/sources/exodus/exodus_source.cpp",
     '#include "importer/sources/netcdf/netcdf_file.hpp"\n'),
    (co_await_lambdas, "server/a.cpp",
     "awaitable<void> f() {\n    co_await post(pool, [self = shared_from_this()] { self->run(); });\n}\n"),
    (co_await_lambdas, "server/a.cpp", "auto f() {\n    auto x = g([&] {\n a; b; }, co_await h());\n}\n"),
    (co_await_lambdas, "server/a.cpp", "auto f() { co_await [x]() -> task { co_return; }(); }\n"),
    (co_await_lambdas, "server/a.cpp", "auto f() { co_await run(ex,\n  [n]() mutable { return n; },\n  token); }\n"),
    (co_await_lambdas, "server/a.cpp", "auto f() { if (co_await g(h(1), [&x] { return x; })) { return; } }\n"),
    (too_long, "core/a.cpp", "\n" * (LONGEST_FILE + 1)),
    (no_namespace_of_its_own, "tests/core/a_test.cpp", "namespace wakesurf::core {\n"),
    (no_namespace_of_its_own, "tests/server/net/a_test.cpp", "namespace wakesurf::server::b_test {\n"),
]
GOOD = [
    (wrong_includes, "server/sessions/journal/database.cpp", "#include <sqlite3.h>\n"),
    (wrong_includes, "server/remote/web/curl_transport.cpp", "#include <curl/curl.h>\n"),
    (wrong_includes, "protocol/frame.cpp", '#include "core/surface/rake.hpp"\n#include <draco/mesh/mesh.h>\n'),
    (wrong_includes, "protocol/frame.hpp", "#include <nlohmann/json_fwd.hpp>\n"),
    (wrong_includes, "importer/reader.cpp", "#include <vtkImageData.h>\n"),
    (wrong_includes, "server/data/bricks/ranks/brick_window.hpp", "#include <mpi.h>\n"),
    (wrong_includes, "server/live/compute/budgets.hpp", '#include "server/base/visitor.hpp"\n'),
    (wrong_includes, "importer/sources/plot3d/plot3d_source.cpp",
     '#include "importer/sources/files/source_files.hpp"\n#include "importer/fields/physical_units.hpp"\n'),
    (wrong_includes, "tests/bench/vtk/peer.cpp", "#include <vtkStreamSurface.h>\n"),
    (wrong_includes, "core/surface/front.cpp", "#include <vector>\n#include <oneapi/tbb/parallel_for.h>\n"),
    (wrong_includes, "server/net/listener.cpp", "#include <boost/beast/websocket/stream.hpp>\n"),
    (co_await_lambdas, "server/a.cpp",
     "auto f() {\n    auto work = [x] { return x; };\n    co_await post(pool, std::move(work));\n}\n"),
    (co_await_lambdas, "server/a.cpp", "auto f() { co_spawn(ex, [s]() -> task { co_await s->run(); }, detached); }\n"),
    (co_await_lambdas, "server/a.cpp", "auto f() { co_await send(items[i](3), [] { return 1; }); }\n"),
    (co_await_lambdas, "server/a.cpp", "auto f() {\n  if (co_await g(x)) {\n  auto h = [x] { return x; };\n  }\n}\n"),
    (co_await_lambdas, "server/a.cpp", "auto f() {\n  if (a) {\n  g([x] { return x; });\n  }\n  co_await h();\n}\n"),
    (co_await_lambdas, "server/a.cpp", "// co_await post([x] {});\nauto s = \"co_await [x]{}\";\n"),
    (too_long, "core/a.cpp", "\n" * LONGEST_FILE),
    (no_namespace_of_its_own, "tests/server/net/a_test.cpp", "namespace wakesurf::server::a_test {\n"),
    (no_namespace_of_its_own, "tests/support/places.cpp", "namespace wakesurf::tests {\n"),
]


def project_files():
    for room in ("core", "protocol", "store", "importer", "server", "python", "web-client", "tests", "docker", "packaging", ".ci"):
        for folder, folders, files in os.walk(os.path.join(ROOT, room)):
            folders[:] = sorted(f for f in folders if f not in GENERATED)
            for name in sorted(files):
                if name.endswith(SOURCE):
                    yield os.path.relpath(os.path.join(folder, name), ROOT)
    for name in ("run", "check"):
        if os.path.isfile(os.path.join(ROOT, name)):
            yield name


def texts_of(paths):
    out = {}
    for path in paths:
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            out[path] = file.read()
    return out


class TheProject(unittest.TestCase):
    def test_has_no_circle_of_units(self):
        self.assertEqual(circle(arrows(texts_of(project_files()), unit_of)), [])

    def test_has_no_circle_of_folders(self):
        self.assertEqual(circle(arrows(texts_of(project_files()), os.path.dirname)), [])


class TheLinter(unittest.TestCase):
    def test_flags_every_bad_sample(self):
        for rule, path, text in BAD:
            with self.subTest(rule=rule.__name__, path=path, text=text[:80]):
                self.assertTrue(list(rule(path, text)))

    def test_leaves_every_good_sample_alone(self):
        for rule, path, text in GOOD:
            with self.subTest(rule=rule.__name__, path=path, text=text[:80]):
                self.assertEqual(list(rule(path, text)), [])

    def test_has_a_bad_and_a_good_sample_for_every_rule(self):
        self.assertEqual({r for r, _, _ in BAD}, set(RULES))
        self.assertEqual({r for r, _, _ in GOOD}, set(RULES))

    def test_sees_circles_of_units_and_folders(self):
        there = {"core/a/x.hpp": '#include "core/b/y.hpp"\n', "core/b/y.cpp": '#include "core/b/z.hpp"\n'}
        for back in ("core/b/z.hpp", "core/b/y.hpp"):
            texts = {**there, back: '#include "core/a/x.hpp"\n'}
            self.assertEqual(circle(arrows(texts, os.path.dirname)), ["core/a", "core/b"])
            self.assertIn("core/a/x", circle(arrows(texts, unit_of)))
        self.assertEqual(circle(arrows(there, unit_of)), [])

    def test_sees_the_project(self):
        self.assertIn("core/base/result.hpp", list(project_files()))


def rule_test(rule):
    def test(self):
        found = []
        for path in project_files():
            with open(os.path.join(ROOT, path), encoding="utf-8") as file:
                found += rule(path, file.read())
        if found:
            self.fail("\n" + "\n".join(found))
    return test


for each in RULES:
    setattr(TheProject, "test_" + each.__name__, rule_test(each))

if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]] + sys.argv[1:])
