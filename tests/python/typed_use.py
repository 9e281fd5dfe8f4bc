"""A script as people write it, for mypy --strict (tests/lint/style mypy): its types are those of the client. It is not run."""
from __future__ import annotations

import asyncio
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from typing import List

import numpy as np
from typing_extensions import assert_type

import wakesurf
from wakesurf.notifications import Notification, SessionPatched
from wakesurf.records import Dataset, RakeRecord, Statistics


def study(session: wakesurf.Session) -> List[int]:
    rake = session.rake(line=np.array([[0.4, 0.4, 0.1], [0.6, 0.6, 0.1]]), seeds=12)
    assert_type(rake, wakesurf.Rake)
    surface = session.surface(rake, "streak", dataset=session.dataset, to=2, max_quads=9000, fields=["vorticity"])
    assert_type(surface, wakesurf.Surface)
    assert_type(surface.wait(progress=lambda progress: print(progress.share)), Statistics)
    assert_type(session.api.rake.list()["rakes"], List[RakeRecord])
    assert_type(session.client.api.dataset.describe(dataset="tornado"), Dataset)
    session.api.time.set(time=None)
    session.picture("a.png", size=(3000, 2000), view={"camera": {"position": (1, 1, 1), "target": (0, 0, 0)}, "look": {"map": "turbo"}})
    return [case.statistics["quads"] for case in session.study({"line": [(0, 0, 0), (1, 0, 0)]}, {"separation": [0.1, 0.05]},
                                                              kind="path", dataset="tornado", to=1)]


def many() -> wakesurf.Study:
    rakes = {f"{x:g}": [(x, 0.4, 0.1), (x, 0.6, 0.1)] for x in np.linspace(0.4, 0.6, 3)}
    found = wakesurf.study(rakes, ["flow:tornado"], {"kind": "stream", "to": 2}, "results", files=["vtp"],
                           executor=lambda: ProcessPoolExecutor(2), progress=lambda progress: print(progress.message))
    print(found, [row["error"] for row in found.failures])
    return wakesurf.study([np.zeros((2, 3)), {"circle": [(0, 0, 1)] * 3}], "case.foam", [{"kind": "path"}], executor=ThreadPoolExecutor(2))


async def listen(session: wakesurf.Session) -> None:
    async for notification in session.watch_async():
        assert_type(notification, Notification)
        if isinstance(notification, SessionPatched):
            print(notification.patches[0]["op"], notification.seq)


with wakesurf.serve("flow:tornado") as mine:
    print(study(mine))
    asyncio.run(listen(mine))
