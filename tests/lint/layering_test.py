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
GENERATED = {"node_modules", "dist", "build", "coverage", ".git", "fixtures", "test-artefacts"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)

SOCKETS = r"boost/(asio|beast)\b|sys/socket\.h|sys/un\.h|netinet/|arpa/inet|netdb\.h"
JSON = r"nlohmann/"
DRACO = r"draco/"
VTK = r"vtk[A-Z]\w*\.h"

FORMATS = ("cgns", "ensight", "exodus", "netcdf", "openfoam", "plot3d", "vtk")

# Room of the including file -> what it may not include, and why.
FORBIDDEN = [
    (r"core/", r"(protocol|store|server|tests)/", "core stands below every other room"),
    (r"core/", "|".join((SOCKETS, JSON, DRACO)), "core knows no sockets, no JSON text, no Draco"),
    (r"protocol/", r"(store|server|tests)/", "protocol stands below store and server"),
    (r"protocol/", SOCKETS, "protocol is bytes in, values out: no sockets"),
    (r"protocol/wire/", r"protocol/(api|files)/", "the wire stands alone"),
    (r"protocol/api/", r"protocol/(wire|files)/", "the API knows neither frames nor files"),
    (r"protocol/files/", r"protocol/wire/", "files know no frames"),
    (r"store/", r"(server|tests)/", "store stands below server"),
    (r"store/", "|".join((SOCKETS, DRACO)), "a store is files: no sockets, no meshes"),
    (r"store/", r"protocol/(wire|files)/", "of protocol, a store takes only how JSON is read"),
    (r"server/", r"tests/", "the product does not depend on its tests"),
    (r"(?!server/import/|tests/server/import/|tests/bench/)", VTK,
     "only the importer, its tests and the benchmarks know VTK"),
    (r"(core|protocol|store|server)/.*\.hpp$", r"boost/beast|nlohmann/json\.hpp",
     "Beast and json.hpp cost seconds in every file that sees them: keep them in .cpp files"),
    (r"", r"boost/(asio|beast)\.hpp$", "include the single Asio and Beast headers that are needed"),
    (r"", r".*\.cpp$", "a .cpp file is nobody's interface"),
    (r"server/base/", r"server/(?!base/|limits|metrics/)", "base stands below the rest of server"),
    (r"server/compute/", r"server/(app|catalogue|cli|import|net|rpc|session|state)/",
     "who computes when depends on no session, only on who asks"),
    (r"server/session/data/", r"server/session/(records|people|live|session)", "data know no session"),
    (r"server/session/records/", r"server/(compute|session/(people|live|session))",
     "records know neither people nor surfaces, nor who computes when"),
    (r"server/session/people/", r"server/(compute|session/(live|session))", "people know no surfaces"),
    (r"server/session/live/", r"server/session/(people|session)", "surfaces know no people"),
    (r"server/(?!app/|cli/)", r"server/app/", "the composition root is used by the command line alone"),
    (r"server/session/", r"server/net/|boost/beast|boost/asio/ip/|nlohmann/json\.hpp",
     "a session knows neither sockets nor JSON text"),
    (r"server/(catalogue|import)/", r"server/(net|rpc|session)/", "datasets know no clients"),
    (r"server/import/", r"server/(?!base/|import/)", "the importer is a program of its own"),
    (r"server/import/sources/(files|blocks)/", r"server/import/sources/(?!(files|blocks)/)",
     "single files and blocks know no format"),
    (r"server/import/sources/series/", r"server/import/sources/(?!(files|series)/)", "a series knows no format"),
    *((f"server/import/sources/{one}/", rf"server/import/sources/(?!({one}|files|blocks|series)/)\w+/",
       "a format knows no other") for one in FORMATS),
    (r"server/bricks/", r"server/(?!base/|bricks/)", "bricks know a store, and neither datasets nor clients"),
    (r"(?!server/bricks/ranks/)", r"mpi\.h$", "only the ranks that hold bricks know MPI"),
    (r"server/(?!bricks/ranks/)", r"server/bricks/ranks/", "wakesurf-bricks is a program of its own"),
    (r"server/state/", r"server/(net|rpc|catalogue)/|nlohmann/", "what keeps records knows neither clients nor JSON"),
    (r"(core|protocol|store|server/(?!state/))", r"sqlite3\.h", "only server/state knows SQLite"),
    (r"(core|protocol|store|server/(?!web/))", r"curl/", "only server/web knows libcurl"),
    (r"(core|protocol|store|server/(?!zarr/))", r"(blosc|zstd)\.h$", "only server/zarr knows what packs chunks"),
    (r"server/zarr/", r"server/(?!zarr/|web/|base/)", "what reads a Zarr knows no dataset, session or client"),
    (r"server/web/", r"server/(?!web/|base/)", "what reads the web knows no dataset, session or client"),
    # Inside the engine.
    (r"core/base/", r"core/(dataset|integrate|field|surface)/", "base stands below the rest of core"),
    (r"core/dataset/", r"core/(integrate|field|surface)/", "dataset knows no flow"),
    (r"core/integrate/", r"core/(dataset|field|surface)/", "integrate knows only what a field must offer"),
    (r"core/field/", r"core/surface/", "a flow knows no surface"),
]


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
    for match in INCLUDE.finditer(text):
        target = match.group(2)
        for room, pattern, why in FORBIDDEN:
            if re.match(room, path) and re.match(pattern, target):
                yield f"{path}:{line_of(text, match.start())}: includes {target}: {why}"
        if match.group(1) == '"' and not re.match(r"(core|protocol|store|server|tests)/", target):
            yield f"{path}:{line_of(text, match.start())}: includes {target}: write it from the root"


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
    (wrong_includes, "protocol/frame.cpp", '#include "server/session/session.hpp"\n'),
    (wrong_includes, "protocol/frame.cpp", "#include <boost/beast/core/flat_buffer.hpp>\n"),
    (wrong_includes, "protocol/frame.hpp", "#include <nlohmann/json.hpp>\n"),
    (wrong_includes, "server/net/listener.hpp", "#include <boost/beast/websocket/stream.hpp>\n"),
    (wrong_includes, "server/net/listener.cpp", '#include "server/rpc/router.cpp"\n'),
    (wrong_includes, "server/net/listener.cpp", "#include <boost/asio.hpp>\n"),
    (wrong_includes, "server/catalogue/store.cpp", "#include <vtkImageData.h>\n"),
    (wrong_includes, "tests/core/surface/peer_test.cpp", "#include <vtkStreamSurface.h>\n"),
    (wrong_includes, "server/session/session.cpp", "#include <nlohmann/json.hpp>\n"),
    (wrong_includes, "server/session/session.cpp", '#include "listener.hpp"\n'),
    (wrong_includes, "server/session/session.cpp", "#include <sqlite3.h>\n"),
    (wrong_includes, "store/store_reader.cpp", "#include <curl/curl.h>\n"),
    (wrong_includes, "server/web/web_disk.cpp", '#include "server/catalogue/open_dataset.hpp"\n'),
    (wrong_includes, "server/state/state_store.cpp", "#include <nlohmann/json.hpp>\n"),
    (wrong_includes, "server/compute/budgets.hpp", '#include "server/session/people/grants.hpp"\n'),
    (wrong_includes, "server/session/records/observer.hpp", '#include "server/compute/pass_budgets.hpp"\n'),
    (wrong_includes, "server/import/main.cpp", '#include "server/cli/rake_text.hpp"\n'),
    (wrong_includes, "server/bricks/job_talk.cpp", '#include "server/catalogue/open_dataset.hpp"\n'),
    (wrong_includes, "server/bricks/job_talk.cpp", "#include <mpi.h>\n"),
    (wrong_includes, "server/catalogue/open_dataset.cpp", '#include "server/bricks/ranks/brick_window.hpp"\n'),
    (wrong_includes, "server/import/sources/series/pvd_series.cpp", '#include "server/import/sources/vtk/xml_file.hpp"\n'),
    (wrong_includes, "server/import/sources/exodus/exodus_source.cpp",
     '#include "server/import/sources/netcdf/netcdf_file.hpp"\n'),
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
    (wrong_includes, "server/state/database.cpp", "#include <sqlite3.h>\n"),
    (wrong_includes, "server/web/curl_transport.cpp", "#include <curl/curl.h>\n"),
    (wrong_includes, "protocol/frame.cpp", '#include "core/surface/rake.hpp"\n#include <draco/mesh/mesh.h>\n'),
    (wrong_includes, "protocol/frame.hpp", "#include <nlohmann/json_fwd.hpp>\n"),
    (wrong_includes, "server/import/reader.cpp", "#include <vtkImageData.h>\n"),
    (wrong_includes, "server/bricks/ranks/brick_window.hpp", "#include <mpi.h>\n"),
    (wrong_includes, "server/compute/budgets.hpp", '#include "server/base/visitor.hpp"\n'),
    (wrong_includes, "server/import/sources/plot3d/plot3d_files.cpp",
     '#include "server/import/sources/files/named_path.hpp"\n#include "server/import/sources/physical_units.hpp"\n'),
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
    for room in ("core", "protocol", "store", "server", "web-client", "tests", "docker", ".ci"):
        for folder, folders, files in os.walk(os.path.join(ROOT, room)):
            folders[:] = sorted(f for f in folders if f not in GENERATED)
            for name in sorted(files):
                if name.endswith(SOURCE):
                    yield os.path.relpath(os.path.join(folder, name), ROOT)
    for name in ("run", "check"):
        if os.path.isfile(os.path.join(ROOT, name)):
            yield name


class TheProject(unittest.TestCase):
    pass


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
