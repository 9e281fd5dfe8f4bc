"""Bookmarks: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Any, Mapping, Optional

from ...api_call import Noun
from ...names import named
from ...plain import Json
from ..records import BookmarkListResult, BookmarkSetResult


class BookmarkMethods(Noun):
    """Bookmarks."""

    @named
    def set(self, *, view: Mapping[str, Any], bookmark: Optional[str] = None, name: Optional[str] = None,
            time: Optional[float] = None, gesture: Optional[str] = None, if_rev: Optional[int] = None,
            session: Optional[str] = None) -> BookmarkSetResult:
        """Creates a bookmark, or replaces one as a whole.

        `view`: camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text.
        `bookmark`: id of the bookmark to replace; if left out, a new one is created.
        `name`: display name.
        `time`: the session's time that belongs to the view (the dataset's unit of time).
        `gesture`: a name for what the user is doing; consecutive edits with the same name are one step of undo.
        `if_rev`: the edit is refused if the record is at another revision; 0 or more.

        Error: Stale, NotFound, OutsideTimeRange, OverLimit. For editors.

        For example:

            api.bookmark.set(session='main', name='here', view={'camera': [1, 2]}, time=1.5)
        """
        answer: BookmarkSetResult = self._call("bookmark.set", {"session": session, "view": view, "bookmark": bookmark,
                                                                "name": name, "time": time, "gesture": gesture,
                                                                "ifRev": if_rev})
        return answer

    @named
    def delete(self, *, bookmark: str, gesture: Optional[str] = None, if_rev: Optional[int] = None,
               session: Optional[str] = None) -> Json:
        """Deletes a bookmark.

        `bookmark`: an id from bookmark.list.
        `gesture`: a name for what the user is doing; consecutive edits with the same name are one step of undo.
        `if_rev`: the edit is refused if the record is at another revision; 0 or more.

        Error: Stale, NotFound, OverLimit. For editors.

        For example:

            api.bookmark.delete(session='main', bookmark='b1')
        """
        answer: Json = self._call("bookmark.delete", {"session": session, "bookmark": bookmark, "gesture": gesture,
                                                      "ifRev": if_rev})
        return answer

    @named
    def list(self, *, session: Optional[str] = None) -> BookmarkListResult:
        """Lists the bookmarks of a session.

        Error: NotFound.

        For example:

            api.bookmark.list(session='main')
        """
        answer: BookmarkListResult = self._call("bookmark.list", {"session": session})
        return answer
