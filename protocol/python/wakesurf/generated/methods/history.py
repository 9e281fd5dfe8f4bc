"""Undo: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Optional

from ...api_call import Noun
from ...names import named
from ..records import HistoryRedoResult, HistoryUndoResult


class HistoryMethods(Noun):
    """Undo."""

    @named
    def undo(self, *, session: Optional[str] = None) -> HistoryUndoResult:
        """Takes back the caller's newest edit, or a whole gesture (or drag) at once. It never undoes the work of
        others: an edit is skipped if someone else has changed its records since.

        Error: NotFound, OverLimit. For editors.

        For example:

            api.history.undo(session='main')
        """
        answer: HistoryUndoResult = self._call("history.undo", {"session": session})
        return answer

    @named
    def redo(self, *, session: Optional[str] = None) -> HistoryRedoResult:
        """Repeats the caller's newest edit that was taken back.

        Error: NotFound, OverLimit. For editors.

        For example:

            api.history.redo(session='main')
        """
        answer: HistoryRedoResult = self._call("history.redo", {"session": session})
        return answer
