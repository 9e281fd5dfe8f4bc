"""One WebSocket: calls, notifications in between, and mesh frames; and listening by it, in a loop or with asyncio."""
from __future__ import annotations

import asyncio
import collections
import itertools
import json
import threading
from typing import TYPE_CHECKING, Any, AsyncIterator, Callable, Deque, Generator, Optional, Union

from .api_base import Notification
from .errors import Unauthenticated, Unreachable, WaitTimeout, WakesurfError
from .generated.methods import Methods
from .generated.records import Joined
from .notifications import notification_of
from .name_mapping import error_of
from .plain import Json, given

if TYPE_CHECKING:
    from .client import Client


class Connection:
    """A WebSocket with its own `api`, where those methods work too that need one. `timeout`: seconds without any message after
    which waiting for one fails. Use it in a `with`."""

    def __init__(self, client: Client, timeout: Optional[float]) -> None:
        try:
            import websocket
        except ImportError:
            raise ImportError("this needs the package websocket-client (Debian: python3-websocket)") from None
        self._module, self._timeout = websocket, timeout
        address = client.url.replace("http", "ws", 1) + "/ws"
        headers = ["Authorization: Bearer " + client._token] if client._token else []
        try:
            self._socket = websocket.create_connection(
                address, timeout=timeout, header=headers, subprotocols=["wakesurf.v1"], suppress_origin=True,
                http_no_proxy=["127.0.0.1", "localhost"], sslopt={"context": client._tls} if client._tls else None)
        except websocket.WebSocketBadStatusException as refusal:
            kind = Unauthenticated if refusal.status_code == 401 else WakesurfError
            raise kind(f"the server refused the WebSocket with status {refusal.status_code}") from None
        except (OSError, websocket.WebSocketException) as problem:
            raise Unreachable(f"no WebSocket at {address}: {problem}") from None
        self._ids = itertools.count(1)
        self._frames: Deque[bytes] = collections.deque()
        self._notifications: Deque[Notification] = collections.deque()
        self.api = Methods(self.call)

    def __enter__(self) -> Connection:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Ends the connection; a thread that waits for a message gets Unreachable."""
        self._socket.close()

    def hang_up(self) -> None:
        """Ends the connection from another thread than the one that waits for messages."""
        self._socket.abort()

    def join(self, session: str, name: str) -> Joined:
        """Enters a session: its changes are reported from now on."""
        joined: Joined = self.call("session.join", session=session, name=name)
        return joined

    def call(self, method: str, _timeout: Optional[float] = None, /, **parameters: Any) -> Any:
        """Calls any method by its name. Notifications and frames in between are queued for `notification` and `frame`."""
        wanted = next(self._ids)
        self._send({"jsonrpc": "2.0", "id": wanted, "method": method, "params": given(parameters)})
        while True:
            answer = self._receive()
            if isinstance(answer, dict) and answer.get("id") == wanted and "method" not in answer:
                if "error" in answer:
                    raise error_of(answer["error"])
                return answer["result"]

    def start(self, method: str, /, **parameters: Any) -> int:
        """Sends a call without waiting for its answer; its number is for `answer_or_notification`."""
        number = next(self._ids)
        self._send({"jsonrpc": "2.0", "id": number, "method": method, "params": given(parameters)})
        return number

    def answer_or_notification(self, number: int) -> Union[Json, Notification]:
        """Returns the next notification, or the answer to a call that was started: an object with `result`. Error:
        the call's."""
        while not self._notifications:
            message = self._receive()
            if isinstance(message, dict) and message.get("id") == number and "method" not in message:
                if "error" in message:
                    raise error_of(message["error"])
                return message
        return self._notifications.popleft()

    def notify(self, method: str, /, **parameters: Any) -> None:
        """Sends a call that has no answer."""
        self._send({"jsonrpc": "2.0", "method": method, "params": given(parameters)})

    def notification(self) -> Notification:
        """Returns the next notification. Mesh frames on the way are queued."""
        while not self._notifications:
            self._receive()
        return self._notifications.popleft()

    def frame(self) -> bytes:
        """Returns the next mesh frame. Notifications on the way are dropped."""
        while not self._frames:
            self._receive()
            self._notifications.clear()
        return self._frames.popleft()

    def _send(self, message: Json) -> None:
        try:
            self._socket.send(json.dumps(message))
        except (OSError, self._module.WebSocketException) as problem:
            raise Unreachable(f"the connection broke: {problem}") from None

    def _receive(self) -> Union[Json, bytes, None]:
        """Receives one message and queues it; answers and frames are returned too."""
        try:
            message = self._socket.recv()
        except self._module.WebSocketTimeoutException:
            raise WaitTimeout(f"nothing has come for {self._timeout} s") from None
        except (OSError, ValueError, self._module.WebSocketException) as problem:
            raise Unreachable(f"the connection broke: {problem}") from None
        if message == "" or message == b"":
            raise Unreachable("the server has closed the connection")
        if isinstance(message, bytes):
            self._frames.append(message)
            return message
        answer: Json = json.loads(message)
        if "method" in answer:
            self._notifications.append(notification_of(answer["method"], answer.get("params") or {}))
        return answer


def watch(connection: Connection) -> Generator[Notification, None, None]:
    """Yields the notifications of a connection, and closes it at the end."""
    with connection:
        while True:
            yield connection.notification()


async def watch_async(connect: Callable[[], Connection]) -> AsyncIterator[Notification]:
    """Listens in a thread, because the WebSocket package used here blocks; the thread ends with the loop."""
    loop = asyncio.get_running_loop()
    arrived: asyncio.Queue[Union[Notification, WakesurfError]] = asyncio.Queue()
    connection = await loop.run_in_executor(None, connect)

    def listen() -> None:
        try:
            while True:
                loop.call_soon_threadsafe(arrived.put_nowait, connection.notification())
        except WakesurfError as problem:
            end(problem)
        except RuntimeError:  # the loop has ended
            pass

    def end(problem: WakesurfError) -> None:
        try:
            loop.call_soon_threadsafe(arrived.put_nowait, problem)
        except RuntimeError:
            pass

    listener = threading.Thread(target=listen, name="wakesurf-watch", daemon=True)
    listener.start()
    try:
        while True:
            each = await arrived.get()
            if isinstance(each, WakesurfError):
                raise each
            yield each
    finally:
        connection.hang_up()
        await loop.run_in_executor(None, listener.join, 5)
