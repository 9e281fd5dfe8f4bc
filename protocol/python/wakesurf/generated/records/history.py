"""Undo: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, Literal, Optional, TypedDict


class Change(TypedDict, total=False):
    """A record that was changed."""

    op: Literal["put", "delete"]  # what happened to the record
    type: str  # kind of record: rake, surface, bookmark or annotation
    id: str  # id of the record
    rev: int  # counts the edits of a record; may be missing


class Skip(TypedDict, total=False):
    """A record that was skipped because someone else has changed it since."""

    type: str  # kind of record: rake, surface, bookmark or annotation
    id: str  # id of the record
    why: str  # why it was skipped, for people


class HistoryDepth(TypedDict, total=False):
    """What can be undone and redone."""

    seq: int  # `seq` of the session after the edit
    skipped: List[Skip]  # records that were skipped; their edits are forgotten for good
    undo: int  # number of edits that can still be taken back
    redo: int  # number of edits that can be repeated


class HistoryUndoResult(TypedDict, total=False):
    """What history.undo answers."""

    undone: Optional[List[Change]]  # what has changed; null: nothing
    seq: int  # `seq` of the session after the edit
    skipped: List[Skip]  # records that were skipped; their edits are forgotten for good
    undo: int  # number of edits that can still be taken back
    redo: int  # number of edits that can be repeated


class HistoryRedoResult(TypedDict, total=False):
    """What history.redo answers."""

    redone: Optional[List[Change]]  # what has changed; null: nothing
    seq: int  # `seq` of the session after the edit
    skipped: List[Skip]  # records that were skipped; their edits are forgotten for good
    undo: int  # number of edits that can still be taken back
    redo: int  # number of edits that can be repeated
