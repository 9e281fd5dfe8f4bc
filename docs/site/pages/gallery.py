"""docs/gallery.md: every picture of gallery.json with the command that makes its surface."""
import re

from .base import MADE, read_json

SCENES = "docs/site/gallery.json"
INTRO = """# Gallery

Every picture is of built-in flows or of the bundled simulation, drawn by the page itself. The command below a picture makes the same
surface as a file. To make the pictures themselves again, from a clone that has been built:

```sh elsewhere
npm --prefix web-client run pictures
npm --prefix web-client run pictures -- wake-streak
```

"""
# Of a scene's surface: what the command line spells otherwise than `surface.set`.
NOT_OPTIONS = ("rake", "rake2", "seeds", "sweep", "fields")


def scenes():
    return read_json(SCENES)["scenes"]


def plain(value):
    return f"{value:g}" if isinstance(value, (int, float)) else str(value)


def point(values):
    return ",".join(map(plain, values))


def option(name):
    return "--" + re.sub(r"[A-Z]", lambda match: "-" + match.group().lower(), name)


def commands(scene):
    """`wakesurf surface ...`, of the scene's surface, and before it that of the family it is a level set of."""
    surface = scene["surface"]
    data = f"\"{scene['data']}\"" if "?" in scene["data"] else scene["data"]
    family = scene.get("family")
    first = [] if family is None else [
        f"wakesurf family {data} --name {family['name']} --from {family['from']}={family['scalar']} --time {plain(family['time'])}"]
    words = ["wakesurf surface", data, "--kind", surface["kind"]]
    for name in ("rake", "rake2"):
        if name in surface and surface["kind"] != "level":
            words += ["--" + name, '"' + " ".join(map(point, surface[name])) + '"']
    if "seeds" in surface:
        words += ["--seeds", plain(surface["seeds"])]
    if "sweep" in surface:
        words += ["--sweep", '"' + point(surface["sweep"]) + '"']
    for name, value in surface.items():
        if name not in (*NOT_OPTIONS, "kind"):
            words += [option(name), plain(value)]
    if "fields" in surface:
        words += ["--fields", ",".join(surface["fields"])]
    return [*first, " ".join([*words, "-o", scene["name"] + ".vtp"])]


def text():
    parts = [MADE.format(source=SCENES) + INTRO]
    for section in read_json(SCENES)["sections"]:
        parts.append(f"## {section}\n\n")
        for scene in scenes():
            if scene["section"] == section:
                parts.append(f"### {scene['title']}\n\n![{scene['title']}](pictures/{scene['name']}.webp)\n\n{scene['words']}\n\n"
                             "```sh run\n" + "\n".join(commands(scene)) + "\n```\n\n")
    return "".join(parts).rstrip() + "\n"
