"""docs/troubleshooting.md: every kind of error, notice, empty surface and closing, with cause and cure.

The kinds come from the description of the API and from the code that names more; the words from cures.json. A kind without
words, or words of a kind that there is not, is an error.
"""
import os
import re

from .base import MADE, ROOT, api, read, read_json

INTRO = """# Troubleshooting

Every error has a `kind`, a message that says what is wrong, and a hint that says what to do. The page shows message and hint, scripts and curl also
the kind. This page is in the order of kinds.

- [Nothing starts](#nothing-starts)
- [Errors](#errors), by kind
- [The surface is empty](#the-surface-is-empty)
- [Notices](#notices) of the server
- [The connection was closed](#the-connection-was-closed)
- [Errors of the Python client](#errors-of-the-python-client)

## Nothing starts

| you see | why | what to do |
|---|---|---|
| "cannot listen on 127.0.0.1:8080" | another program has the port | `--listen 127.0.0.1:0` takes a free one; `./run` does so by itself |
| the page says that it needs WebGL 2 | the browser draws without a graphics card, or forbids it | switch hardware acceleration on, or use a current browser |
| the page says that it needs a token | the address was copied without its end | copy all of it, with `#token=...` |
| "there is nothing at this path" at `/` | the program was started without the page's files | `--web FOLDER`, or `cmake --install` |
| an import that never ends | large data on a slow disk | `wakesurf info` first; `import --times` for a part |
| turning the view is slow | the browser draws without the graphics card | switch hardware acceleration on, or make the window smaller |

"""
API = "docs/api.md"
CODE = ("importer", "protocol", "server")


def kinds_in_code():
    """Kinds that C++ names beside those of the description."""
    found = set()
    for room in CODE:
        for folder, _, names in os.walk(os.path.join(ROOT, room)):
            for name in names:
                if name.endswith(".cpp"):
                    with open(os.path.join(folder, name), encoding="utf-8") as file:
                        found.update(re.findall(r"\bfault\.kind = \"(\w+)\"", file.read()))
    return found


def error_kinds(description):
    """kind -> code, of all there are."""
    out = {kind: data["code"] for kind, data in description.errors.items()}
    for kind in sorted(kinds_in_code() - out.keys()):
        out[kind] = out["invalidParameters"]
    return out


def notice_kinds(description):
    """Of server.notice, as its description lists them."""
    words = next(told for name, _, told, _ in description.notifications if name == "server.notice")
    listed = re.sub(r"\([^)]*\)", "", words[words.index("Kinds:") + len("Kinds:"):])
    return [each.strip(" .") for each in listed.split(",")]


def empty_kinds():
    return read_json("protocol/api/subscription.schema.json")["$defs"]["EmptyReason"]["enum"]


def closing_codes():
    """Codes of our own that a WebSocket is closed with."""
    return re.findall(r"= (4\d{3})\b", read("server/net/methods/client.hpp"))


def client_kinds(kinds):
    """Errors of the Python client that have no section among `kinds`."""
    names = re.findall(r"^class (\w+)\(WakesurfError", read("python/wakesurf/errors.py"), re.M)
    return [name for name in names if name[0].lower() + name[1:] not in kinds]


def differences(there, words, what):
    missing, left = set(there) - set(words), set(words) - set(there)
    if missing or left:
        raise ValueError(f"docs/site/cures.json, {what}: no words for {sorted(missing)}; no such kind {sorted(left)}")


def entry(title, words):
    cause, cure = words
    return f"### {title}\n\n{cause}\n\n**Cure:** {cure}\n\n"


def text():
    description, words = api(), read_json("docs/site/cures.json")
    kinds, notices = error_kinds(description), notice_kinds(description)
    differences(kinds, words["errors"], "errors")
    differences(notices, words["notices"], "notices")
    differences(empty_kinds(), words["empty"], "empty")
    differences(client_kinds(kinds), words["client"], "client")
    differences(closing_codes(), [each for each in words["closings"] if each > "4000"], "closings")
    out = MADE.format(source="protocol/api/*.schema.json and docs/site/cures.json") + INTRO + f"## Errors\n\nThe [API]({os.path.basename(API)}#errors) has the code of each.\n\n"
    for kind in kinds:
        out += entry(kind, words["errors"][kind])
    out += "## The surface is empty\n\n`surface.stats` and `--stats` have the reason under `empty`; the page shows it beside the rake.\n\n"
    for kind in empty_kinds():
        out += entry(kind, words["empty"][kind])
    out += "## Notices\n\n`server.notice` reports what happened to a connection, its session or the server. The page shows its text.\n\n"
    for kind in notices:
        out += entry(kind, words["notices"][kind])
    out += "## The connection was closed\n\nThe code of the WebSocket says why; the page shows it in words.\n\n"
    out += "| code | why | what to do |\n|---|---|---|\n"
    for code, (cause, cure) in words["closings"].items():
        out += f"| {code} | {cause} | {cure} |\n"
    out += "\n## Errors of the Python client\n\nThe client has a class for each kind above, and these.\n\n"
    for kind in client_kinds(kinds):
        out += entry(kind, words["client"][kind])
    return out.rstrip() + "\n"
