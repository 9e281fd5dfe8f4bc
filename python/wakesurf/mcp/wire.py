"""Messages of JSON-RPC 2.0, one a line, on two streams: reading any input, and writing whole messages."""
from __future__ import annotations

import json
import select
import threading
from typing import IO, Any, Callable, Dict, Iterator, List, Optional, Union

from ..plain import Json

LONGEST_LINE = 1 << 20  # bytes
PARSE_ERROR, INVALID_REQUEST, METHOD_NOT_FOUND, INVALID_PARAMETERS, INTERNAL = -32700, -32600, -32601, -32602, -32603

Id = Union[str, int, None]
Reply = Callable[[Json], None]  # takes the answer to one request


class Refused(Exception):
    """The message is invalid, or its call cannot be made."""

    def __init__(self, code: int, message: str) -> None:
        super().__init__(message)
        self.code, self.message = code, message


def result(number: Id, value: Json) -> Json:
    """Returns an answer."""
    return {"jsonrpc": "2.0", "id": number, "result": value}


def fault(number: Id, problem: Refused) -> Json:
    """Returns an answer to a refused message."""
    return {"jsonrpc": "2.0", "id": number, "error": {"code": problem.code, "message": problem.message}}


def lines(stream: IO[bytes]) -> Iterator[Union[bytes, Refused]]:
    """Yields each line that is not empty, until the stream ends. A line that is too long is dropped."""
    while True:
        line = stream.readline(LONGEST_LINE + 1)
        if not line:
            return
        if len(line) > LONGEST_LINE:
            while line and not line.endswith(b"\n"):
                line = stream.readline(LONGEST_LINE)
            yield Refused(INVALID_REQUEST, f"the message is longer than {LONGEST_LINE} bytes")
        elif line.strip():
            yield line


def message_of(line: bytes) -> Any:
    """Returns the JSON of a line. Error: Refused."""
    def no_number(word: str) -> Any:
        raise ValueError(f"{word} is not a JSON number")

    try:
        return json.loads(line.decode("utf-8"), parse_constant=no_number)
    except (ValueError, RecursionError) as problem:
        raise Refused(PARSE_ERROR, f"this is not JSON: {problem}") from None


class Out:
    """Writes messages, from any thread, each whole."""

    def __init__(self, stream: IO[bytes]) -> None:
        self._stream, self._lock, self._gone = stream, threading.Lock(), False

    def send(self, message: Any) -> None:
        """Sends a message; does nothing if the reader has gone."""
        line = json.dumps(message, separators=(",", ":"), allow_nan=False).encode() + b"\n"
        with self._lock:
            try:
                self._stream.write(line)
                self._stream.flush()
            except (OSError, ValueError):
                self._gone = True

    def gone(self) -> bool:
        """Whether the reader has gone, as far as the system reports it: the other end of a pipe or a socket is
        closed."""
        if not self._gone and hasattr(select, "poll"):
            poll = select.poll()
            poll.register(self._stream, 0)
            self._gone = any(events & (select.POLLERR | select.POLLHUP | select.POLLNVAL) for _, events in poll.poll(0))
        return self._gone

    def notify(self, method: str, parameters: Json) -> None:
        """Sends a message that has no answer."""
        self.send({"jsonrpc": "2.0", "method": method, "params": parameters})


class Batch:
    """Several requests of one message, as clients of 2025-03-26 may send them: their answers go out together."""

    def __init__(self, count: int, out: Out) -> None:
        self._missing, self._out, self._lock = count, out, threading.Lock()
        self._answers: List[Json] = []

    def reply(self, answer: Optional[Json]) -> None:
        """Adds an answer; None: this request has none."""
        with self._lock:
            self._missing -= 1
            if answer is not None:
                self._answers.append(answer)
            if self._missing == 0 and self._answers:
                self._out.send(self._answers)


def checked(message: Any) -> Dict[str, Any]:
    """Returns a request or a notification. Error: Refused."""
    if not isinstance(message, dict) or message.get("jsonrpc") != "2.0" or not isinstance(message.get("method"), str):
        raise Refused(INVALID_REQUEST, 'a message is an object with "jsonrpc": "2.0" and a "method"')
    if "id" in message and (isinstance(message["id"], bool) or not isinstance(message["id"], (str, int))):
        raise Refused(INVALID_REQUEST, "an id is a text or a whole number")
    if not isinstance(message.get("params", {}), dict):
        raise Refused(INVALID_PARAMETERS, "params are an object")
    return message
