"""Bookmarks: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, TypedDict

from ...plain import Json


class BookmarkRecord(TypedDict, total=False):
    """A bookmark as the session keeps it."""

    bookmark: str  # id of the bookmark
    rev: int  # counts the edits of a record
    name: str  # display name
    view: Json  # camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text
    time: float  # the session's time that belongs to the view (the dataset's unit of time); may be missing


class BookmarkSetResult(TypedDict, total=False):
    """What bookmark.set answers."""

    bookmark: str  # id of the bookmark
    rev: int  # counts the edits of a record
    seq: int  # `seq` of the session after the edit


class BookmarkListResult(TypedDict, total=False):
    """What bookmark.list answers."""

    bookmarks: List[BookmarkRecord]  # all bookmarks
