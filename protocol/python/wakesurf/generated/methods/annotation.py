"""Annotations: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Optional

from ...api_call import Noun
from ...names import named
from ...plain import Json, Point
from ..records import AnnotationListResult, AnnotationSetResult


class AnnotationMethods(Noun):
    """Annotations."""

    @named
    def set(self, *, text: str, position: Point, annotation: Optional[str] = None, surface: Optional[str] = None,
            gesture: Optional[str] = None, if_rev: Optional[int] = None,
            session: Optional[str] = None) -> AnnotationSetResult:
        """Creates an annotation, or replaces one as a whole. It keeps the name of the one who made it.

        `text`: text of one or more lines.
        `position`: the point that it refers to (the dataset's unit of length).
        `annotation`: id of the annotation to replace; if left out, a new one is created.
        `surface`: id of the surface that it refers to, which may have been deleted since.
        `gesture`: a name for what the user is doing; consecutive edits with the same name are one step of undo.
        `if_rev`: the edit is refused if the record is at another revision; 0 or more.

        Error: Stale, NotFound, OverLimit, DatasetError. For editors.

        For example:

            api.annotation.set(session='main', text='look', position=[0, 0, 0], surface='s1')
        """
        answer: AnnotationSetResult = self._call("annotation.set", {"session": session, "text": text,
                                                                    "position": position, "annotation": annotation,
                                                                    "surface": surface, "gesture": gesture,
                                                                    "ifRev": if_rev})
        return answer

    @named
    def delete(self, *, annotation: str, gesture: Optional[str] = None, if_rev: Optional[int] = None,
               session: Optional[str] = None) -> Json:
        """Deletes an annotation.

        `annotation`: an id from annotation.list.
        `gesture`: a name for what the user is doing; consecutive edits with the same name are one step of undo.
        `if_rev`: the edit is refused if the record is at another revision; 0 or more.

        Error: Stale, NotFound, OverLimit. For editors.

        For example:

            api.annotation.delete(session='main', annotation='a1')
        """
        answer: Json = self._call("annotation.delete", {"session": session, "annotation": annotation,
                                                        "gesture": gesture, "ifRev": if_rev})
        return answer

    @named
    def list(self, *, session: Optional[str] = None) -> AnnotationListResult:
        """Lists the annotations of a session.

        Error: NotFound.

        For example:

            api.annotation.list(session='main')
        """
        answer: AnnotationListResult = self._call("annotation.list", {"session": session})
        return answer
