"""Presence: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Optional, Union

from ...api_call import Noun, LEFT_OUT, LeftOut
from ...names import named
from ...plain import Json, NULL, Point
from ..records import Camera, DraggedRake


class PresenceMethods(Noun):
    """Presence."""

    @named
    def update(self, *, pointer: Union[Optional[Point], LeftOut] = LEFT_OUT,
               camera: Union[Optional[Camera], LeftOut] = LEFT_OUT,
               dragging: Union[Optional[DraggedRake], LeftOut] = LEFT_OUT,
               selected: Union[Optional[str], LeftOut] = LEFT_OUT, session: Optional[str] = None) -> Json:
        """Shows the others what the caller points at, looks at, drags and has selected. What is left out stays as it
        is; null removes it. Best sent as a notification.

        `pointer`: the point they point at (the dataset's unit of length).
        `camera`: where they look from.
        `dragging`: the rake they drag.
        `selected`: id of the record they have selected.

        Error: NotFound. Only on a `Connection`.

        For example:

            api.presence.update(pointer=[0.5, 0, 0.2], selected='r1',
                                camera={'position': [4, -6, 3], 'target': [0, 0, 0], 'up': [0, 0, 1], 'fov': 40})
        """
        answer: Json = self._call("presence.update", {"session": session,
                                                      "pointer": NULL if pointer is None else pointer,
                                                      "camera": NULL if camera is None else camera,
                                                      "dragging": NULL if dragging is None else dragging,
                                                      "selected": NULL if selected is None else selected})
        return answer
