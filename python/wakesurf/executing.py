"""Tasks on an executor that may lose its workers: so many at a time, what was lost done again, and what is lost each time given up."""
from __future__ import annotations

import os
from collections import deque
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, ThreadPoolExecutor, wait
from functools import partial
from typing import Any, Callable, Deque, Dict, Generator, Iterator, Optional, Tuple, Union

from .errors import WorkersLost
from .study_task import FATAL, Answer, Task

_AHEAD = 1000
_Sent = Tuple[int, Task, int]  # number, task, and how often it was lost
AnyExecutor = Union[Executor, Callable[[], Executor], None]


class _Pool:
    """An executor that was given, or one of our own, which is replaced when it breaks and shut down at the end."""

    def __init__(self, given: AnyExecutor) -> None:
        one: Any = given
        if hasattr(one, "get_executor"):  # a client of Dask, which has other futures
            one = one.get_executor()
        is_made = hasattr(one, "submit") and not isinstance(one, type)
        self._make: Optional[Callable[[], Executor]] = None if is_made else one or partial(ThreadPoolExecutor, os.cpu_count())
        self.executor: Executor = one if self._make is None else self._make()
        self.broken: Optional[BaseException] = None
        self.used = False

    def replace(self) -> None:
        """Error: WorkersLost, where no one has said how to make another one."""
        if self._make is None or not self.used:
            raise WorkersLost(f"the executor takes no more tasks: {self.broken}", hint="what is done is kept: study again in the same folder with a "
                              "new executor; or give a function that makes one, as executor=lambda: ProcessPoolExecutor(4)") from self.broken
        self.close()
        self.executor, self.broken, self.used = self._make(), None, False

    def close(self) -> None:
        if self._make is not None:
            self.executor.shutdown(wait=True)


def answers(tasks: Iterator[Tuple[int, Task]], do: Callable[[Task], Answer], executor: AnyExecutor, tries: int,
            ahead: Optional[int]) -> Generator[Tuple[int, Task, Answer], None, None]:
    """Yields the answers of `do`, which can be pickled, as they come. `executor`: one, or what makes one. A task that was lost is done again after
    all others; the last of its `tries` alone, so that one that kills workers takes none of the others with it. Error: WorkersLost, and what
    each task would fail with."""
    pool, again, alone = _Pool(executor), deque[_Sent](), deque[_Sent]()
    sent: Dict[Future[Answer], _Sent] = {}
    workers = getattr(pool.executor, "_max_workers", None)
    many = ahead or (2 * workers if workers else _AHEAD)

    def waiting() -> Optional[_Sent]:
        fresh = next(tasks, None)
        if fresh is not None:
            return (*fresh, 0)
        return again.popleft() if again else alone.popleft() if alone and not sent else None

    def queue_of(one: _Sent) -> Deque[_Sent]:
        return alone if one[2] and one[2] + 1 >= tries else again

    try:
        while True:
            while pool.broken is None and len(sent) < many:
                one = waiting()
                if one is None:
                    break
                try:
                    sent[pool.executor.submit(do, one[1])] = one
                    pool.used = True
                except RuntimeError as problem:  # it is broken, or shut down
                    queue_of(one).appendleft(one)
                    pool.broken = problem
            if not sent and pool.broken is None:
                return
            if not sent:
                pool.replace()
                continue
            for future in wait(sent, return_when=FIRST_COMPLETED).done:
                number, task, before = sent.pop(future)
                try:
                    answer = future.result()
                except FATAL:
                    raise
                except Exception as problem:  # whatever an executor says that has lost a worker, and a task whose server has died
                    if isinstance(problem, BrokenExecutor):
                        pool.broken = problem
                    if before + 1 < tries:
                        one = (number, task, before + 1)
                        queue_of(one).append(one)
                        continue
                    answer = Answer(error=f"given up after {tries} tries: {str(problem) or type(problem).__name__}")
                yield number, task, answer
    finally:
        for future in sent:
            future.cancel()
        pool.close()
