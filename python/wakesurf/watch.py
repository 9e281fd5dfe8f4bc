"""Listening to a session: in a loop, or with asyncio."""
from __future__ import annotations

import asyncio
import threading
from typing import TYPE_CHECKING, AsyncIterator, Generator, Optional, Union

from .errors import WakesurfError
from .notification import Notification

if TYPE_CHECKING:
    from .connection import Connection
    from .session import Session


def watch(session: Session, name: str, timeout: Optional[float]) -> Generator[Notification, None, None]:
    """Joins at once, so that no notification before the loop begins is missed."""
    return _told(session.connect(name, timeout))


def _told(connection: Connection) -> Generator[Notification, None, None]:
    with connection:
        while True:
            yield connection.told()


async def watch_async(session: Session, name: str) -> AsyncIterator[Notification]:
    """Listens in a thread, because the WebSocket package used here blocks; the thread ends with the loop."""
    loop = asyncio.get_running_loop()
    news: asyncio.Queue[Union[Notification, WakesurfError]] = asyncio.Queue()
    connection = await loop.run_in_executor(None, session.connect, name, None)

    def listen() -> None:
        try:
            while True:
                loop.call_soon_threadsafe(news.put_nowait, connection.told())
        except WakesurfError as problem:
            end(problem)
        except RuntimeError:  # the loop has ended
            pass

    def end(problem: WakesurfError) -> None:
        try:
            loop.call_soon_threadsafe(news.put_nowait, problem)
        except RuntimeError:
            pass

    listener = threading.Thread(target=listen, name="wakesurf-watch", daemon=True)
    listener.start()
    try:
        while True:
            each = await news.get()
            if isinstance(each, WakesurfError):
                raise each
            yield each
    finally:
        connection.hang_up()
        await loop.run_in_executor(None, listener.join, 5)
