"""The protocol: agreeing on a version, listing tools, calling them one after the other, and giving up calls that are cancelled.

The thread that reads answers at once what needs no flow: so a client that waits for a surface can ask whether anyone is there, and cancel.
"""
from __future__ import annotations

import base64
import json
import queue
import sys
import threading
import traceback
from typing import IO, Any, Dict, List, Mapping, Optional, Tuple

from ..errors import WakesurfError
from ..generated.version import VERSION
from ..plain import Json
from . import edit_tools, file_tools, number_tools
from .name_mapping import hint_in_tools, in_tools
from .tool import Answer, Call, Stopped, Tool
from .wire import INTERNAL, INVALID_PARAMETERS, INVALID_REQUEST, METHOD_NOT_FOUND, Batch, Id, Out, Refused, Reply, checked, fault, lines, \
    message_of, result
from .work import Work

VERSIONS = ("2025-06-18", "2025-03-26", "2024-11-05")  # of the protocol, the newest first
WITH_BATCHES = "2025-03-26"
TOOLS: Mapping[str, Tool] = {each.name: each for each in (
    edit_tools.OPEN, edit_tools.SUGGEST, edit_tools.RAKE, edit_tools.SURFACE, number_tools.WAIT, number_tools.NUMBERS, number_tools.COMPARE,
    file_tools.PICTURE, file_tools.FILM, file_tools.EXPORT, number_tools.EXPLAIN, edit_tools.UNDO)}

INSTRUCTIONS = (
    "wakesurf computes integral surfaces of simulated flow: sheets of particles released from a line, the rake. Begin with open, which says what "
    "data there are, and suggest. Make a surface (kind streak is smoke or dye, stream one frozen moment, path the ways of particles, time a "
    "drifting patch), wait for it, and read numbers before you ask for a picture. People may be in the same session: they see every edit, and "
    "undo takes back only what was done by the same link. explain says why a surface ends where it does.")

_POLL_SECONDS = 0.2  # whether anyone reads the answers

Job = Tuple[Id, Tool, Json, Call, Reply]


class Server:
    """Reads from one stream and writes to another until the first ends and all calls are answered, or the reader has
    gone."""

    def __init__(self, work: Work, source: IO[bytes], out: Out) -> None:
        self._work, self._source, self._out = work, source, out
        self._version = VERSIONS[0]
        self._jobs: "queue.SimpleQueue[Optional[Job]]" = queue.SimpleQueue()
        self._calls: Dict[Id, Call] = {}
        self._lock = threading.Lock()
        self._worker = threading.Thread(target=self._works, name="wakesurf-mcp", daemon=True)

    def run(self) -> None:
        """Runs until the stream has ended and all its calls are answered: a list of calls may come from a file. An
        earlier end, by a signal or because the reader has gone, cancels the remaining calls."""
        self._worker.start()
        try:
            for line in lines(self._source):
                self._take(line)
            self._jobs.put(None)
            while self._worker.is_alive() and not self._out.gone():
                self._worker.join(_POLL_SECONDS)
        finally:
            with self._lock:
                for call in self._calls.values():
                    call.cancelled.set()
            self._jobs.put(None)

    def join(self, seconds: float) -> None:
        """Waits until the running call has noticed, but not longer than that."""
        self._worker.join(seconds)

    def _take(self, line: "bytes | Refused") -> None:
        try:
            if isinstance(line, Refused):
                raise line
            message = message_of(line)
            if not isinstance(message, list):
                return self._handle(message, self._out.send)
            if self._version != WITH_BATCHES or not message:
                raise Refused(INVALID_REQUEST, f"several messages in one are part of {WITH_BATCHES} only")
        except Refused as problem:
            return self._out.send(fault(None, problem))
        batch = Batch(len(message), self._out)
        for each in message:
            if isinstance(each, dict) and ("method" not in each or "id" not in each):
                batch.reply(None)
                self._handle(each, self._out.send)
            else:
                self._handle(each, batch.reply)
        return None

    def _handle(self, message: Any, reply: Reply) -> None:
        if isinstance(message, dict) and "method" not in message and ("result" in message or "error" in message):
            return  # an answer, and nothing was asked
        number: Id = message.get("id") if isinstance(message, dict) and isinstance(message.get("id"), (str, int)) else None
        try:
            request = checked(message)
            given: Json = request.get("params", {})
            if "id" not in request:
                return self._notified(request["method"], given)
            if request["method"] == "tools/call":
                return self._call(number, given, reply)
            reply(result(number, self._answer(request["method"], given)))
        except Refused as problem:
            reply(fault(number, problem))

    def _answer(self, method: str, given: Json) -> Json:
        if method == "initialize":
            wanted = given.get("protocolVersion")
            if not isinstance(wanted, str):
                raise Refused(INVALID_PARAMETERS, "initialize needs the text `protocolVersion`, as 2025-06-18")
            self._version = wanted if wanted in VERSIONS else VERSIONS[0]
            return {"protocolVersion": self._version, "capabilities": {"tools": {"listChanged": False}},
                    "serverInfo": {"name": "wakesurf", "title": "wakesurf: integral surfaces of flow", "version": VERSION},
                    "instructions": INSTRUCTIONS}
        if method == "ping":
            return {}
        if method == "tools/list":
            return {"tools": [each.described() for each in TOOLS.values()]}
        raise Refused(METHOD_NOT_FOUND, f"there is no method `{method[:80]}`: there are initialize, ping, tools/list and tools/call")

    def _notified(self, method: str, given: Json) -> None:
        if method != "notifications/cancelled":
            return
        with self._lock:
            number = given.get("requestId")
            call = self._calls.get(number) if isinstance(number, (str, int)) and not isinstance(number, bool) else None
            if call is not None:
                call.cancelled.set()

    def _call(self, number: Id, given: Json, reply: Reply) -> None:
        name, arguments = given.get("name"), given.get("arguments") or {}
        if not isinstance(name, str) or name not in TOOLS:
            raise Refused(INVALID_PARAMETERS, f"there is no tool `{str(name)[:80]}`: there are {', '.join(TOOLS)}")
        if not isinstance(arguments, dict):
            raise Refused(INVALID_PARAMETERS, "`arguments` is an object")
        meta = given.get("_meta")
        token = meta.get("progressToken") if isinstance(meta, dict) else None
        call = Call(None if token is None else lambda percent, words: self._out.notify(
            "notifications/progress", {"progressToken": token, "progress": percent, "total": 100, "message": words}))
        with self._lock:
            if number in self._calls:
                raise Refused(INVALID_REQUEST, f"the id {number!r} is that of a call that still runs")
            self._calls[number] = call
        self._jobs.put((number, TOOLS[name], arguments, call, reply))

    def _works(self) -> None:
        while True:
            job = self._jobs.get()
            if job is None:
                return
            number, tool, arguments, call, reply = job
            made = _made(tool, self._work, arguments, call)
            with self._lock:
                del self._calls[number]
            if made is not None and not call.cancelled.is_set():
                reply(result(number, made))
            elif reply != self._out.send:  # the others of its batch wait for it; alone it has no answer
                reply(fault(number, Refused(INTERNAL, "the call was cancelled")))


def _made(tool: Tool, work: Work, arguments: Json, call: Call) -> Optional[Json]:
    """Returns the answer of tools/call. A tool that fails says so to the model, which can correct itself; None: it
    was cancelled."""
    try:
        call.check()
        tool.check(arguments)
        return _content(tool.function(work, arguments, call))
    except Stopped:
        return None
    except WakesurfError as problem:
        message, hint = problem.message, problem.hint
        if problem.original:  # by the server, which knows no tools
            message, hint = in_tools(problem.original[0]), hint_in_tools(problem.original[1])
        about = {"kind": problem.kind or type(problem).__name__, "message": message, "hint": hint}
        return {"content": [_text(message + (f" ({hint})" if hint else ""))], "structuredContent": {"error": about}, "isError": True}
    except (ImportError, OSError, ValueError) as problem:
        about = {"kind": type(problem).__name__, "message": str(problem), "hint": ""}
        return {"content": [_text(str(problem))], "structuredContent": {"error": about}, "isError": True}
    except Exception:  # a fault of ours ends one call, not all
        traceback.print_exc(file=sys.stderr)
        return {"content": [_text(f"wakesurf failed in {tool.name}: its standard error has the details")], "isError": True}


def _content(answer: Answer) -> Json:
    content: List[Json] = [_text(answer.text), _text(json.dumps(answer.numbers, separators=(",", ":"), allow_nan=False))]
    if answer.png is not None:
        content.append({"type": "image", "data": base64.b64encode(answer.png).decode(), "mimeType": "image/png"})
    return {"content": content, "structuredContent": answer.numbers, "isError": False}


def _text(words: str) -> Json:
    return {"type": "text", "text": words}
