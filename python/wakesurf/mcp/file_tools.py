"""Tools that make pictures and files: picture, film, export."""
from __future__ import annotations

import os
import re
import typing
from typing import Optional, cast

from ..plain import Json
from ..progress import Progress
from ..view import Look, SurfaceLook
from .tool import PAIR, POINT, SURFACE as SURFACE_ID, TIME, Answer, Call, schema_of, tool
from .work import Work, short

_MOST_FRAMES = 600
_FRAME = re.compile(r"frame_\d{4,}\.png")
_LARGEST_SHOWN = 2 << 20  # bytes of a picture in a message, where there is a file of it as well
_PATH: Json = {"type": "string", "description": "where to write it, below the folder that this program was given"}
_OVERWRITE: Json = {"type": "boolean", "description": "true: a file of someone else may be replaced"}
_CAMERA: Json = {"type": "object", "description": "left out: as the page begins, with everything in view", "properties": {
    "position": {**POINT, "description": "of the eye"}, "target": {**POINT, "description": "the middle of the picture"},
    "orthographic": {"type": "boolean"}}}
_LOOK: Json = {"type": "object", "description": "how surfaces look; colour_by is speed, age, s, constant, vorticity, q_criterion, deformation, error or "
               "field:NAME", "properties": {name: PAIR if name == "range" else schema_of(hint)
                                             for name, hint in typing.get_type_hints(SurfaceLook).items()}}


def _size(name: str, usual: int) -> Json:
    return {"type": "integer", "minimum": 64, "maximum": 4096, "description": f"{name} in pixels; {usual}"}


def _view(given: Json) -> Optional[Look]:
    view = {name: given[name] for name in ("camera", "look") if name in given}
    return cast(Look, view) if view else None


def _picture(work: Work, given: Json, call: Call) -> Answer:
    size = given.get("width", 1200), given.get("height", 800)
    path = work.place.take(given["path"], (".png",), given.get("overwrite", False)) if "path" in given else None
    drawn = work.session.picture(path, size, time=given.get("time"), view=_view(given), caption=given.get("caption"),
                                 rakes=given.get("rakes", False), background=given.get("background", "shown"),
                                 timeout=given.get("seconds", _USUAL_WAIT))
    call.check()
    numbers: Json = {"width": size[0], "height": size[1], "bytes": len(drawn.data), "scalar_bar": not drawn.bar_left_out}
    if path is not None:
        numbers["path"] = work.place.shown(path)
    where = f" in {numbers['path']}" if path is not None else ""
    where += ", too small for the scalar bar" if drawn.bar_left_out else ""
    if path is not None and len(drawn.data) > _LARGEST_SHOWN:
        return Answer(f"A picture of {size[0]} x {size[1]} pixels{where}, too large to be sent along.", numbers)
    return Answer(f"A picture of {size[0]} x {size[1]} pixels{where}.", numbers, drawn.data)


def _film(work: Work, given: Json, call: Call) -> Answer:
    size = given.get("width", 1280), given.get("height", 720)
    first, last, count = given["from"], given["to"], given.get("frames", 50)
    times = [first + (last - first) * i / max(1, count - 1) for i in range(count)]
    path = work.place.take(given["path"], ("", ".mp4", ".webm"), given.get("overwrite", False))

    def report(progress: Progress) -> None:
        call.progress(progress.share, progress.message)

    made = work.session.film(path, times, size, fps=given.get("fps", 25.0), view=_view(given), progress=report, timeout=given.get("seconds", _USUAL_WAIT))
    if os.path.isdir(path):
        for each in filter(_FRAME.fullmatch, os.listdir(path)):
            if os.path.join(path, each) not in made:
                os.remove(os.path.join(path, each))  # of an earlier film, which was longer
    shown = work.place.shown(path)
    return Answer(f"{count} pictures from {first:g} to {last:g} in {shown}.",
                  {"path": shown, "frames": count, "files": len(made), "times": short([first, last])})


def _export(work: Work, given: Json, call: Call) -> Answer:
    surface = work.surface(given.get("surface"))
    path = work.place.take(given["path"], (".vtp", ".glb", ".ply", ".obj", ".drc"), given.get("overwrite", False))
    call.check()
    surface.export(path, time=given.get("time"), lines=given.get("lines"), tessellate=given.get("tessellate", 1))
    shown, size = work.place.shown(path), os.path.getsize(path)
    return Answer(f"{surface.id} is in {shown}.", {"surface": surface.id, "path": shown, "bytes": size})


_USUAL_WAIT = 120
_VIEW = {"camera": _CAMERA, "look": _LOOK,
         "seconds": {"type": "number", "minimum": 1, "maximum": 3600, "description": f"at most so long for one picture; {_USUAL_WAIT}"}}
PICTURE = tool("picture", "Draw a picture", "A picture of the session as people see it on the page. It needs Chromium where this program runs. Ask for numbers first: "
               "they say more, and cost less.",
               {"path": {**_PATH, "description": "a .png to write as well, below the folder that this program was given"}, "width": _size("width", 1200),
                "height": _size("height", 800), "time": TIME, **_VIEW, "rakes": {"type": "boolean", "description": "true: rakes are shown"},
                "background": {"type": "string", "enum": ["shown", "white", "clear"]}, "caption": {"type": "string"}, "overwrite": _OVERWRITE})(_picture)
FILM = tool("film", "Draw a film", "Pictures at evenly spaced times, as a folder of .png, or as .mp4 or .webm where ffmpeg is. No one's clock moves.",
            {"path": _PATH, "from": {"type": "number", "description": "first time"}, "to": {"type": "number", "description": "last time"},
             "frames": {"type": "integer", "minimum": 1, "maximum": _MOST_FRAMES, "description": "50"}, "width": _size("width", 1280),
             "height": _size("height", 720), "fps": {"type": "number", "minimum": 1, "maximum": 120, "description": "frames a second; 25"}, **_VIEW,
             "overwrite": _OVERWRITE}, ["path", "from", "to"])(_film)
EXPORT = tool("export", "Write a surface to a file", "A surface as .vtp (ParaView), .glb, .ply, .obj or .drc.",
              {"surface": SURFACE_ID, "path": _PATH, "time": TIME,
               "lines": {"type": "string", "description": "instead of the mesh: timelines:8, arrows:every=0.5,width=0.1, or points in a .ply"},
               "tessellate": {"type": "integer", "minimum": 1, "maximum": 16, "description": "each cell cut into so many quads each way"},
               "overwrite": _OVERWRITE}, ["path"])(_export)
