"""Sessions and their people: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Any, Literal, Mapping, Optional, Union

from ...api_call import Noun, LEFT_OUT, LeftOut
from ...names import named
from ...plain import Json, NULL
from ..records import (Joined, SessionDeleteResult, SessionExportResult, SessionForkResult, SessionImportResult,
                       SessionListResult, SessionMade, SessionName, SessionSetRoleResult, SessionShareResult,
                       SessionSharesResult, SessionStateResult, SessionUnshareResult)


class SessionMethods(Noun):
    """Sessions and their people."""

    @named
    def create(self, *, name: Optional[str] = None) -> SessionMade:
        """Makes a new, empty session. When there are too many sessions, one without a name that no one has edited or
        shared and no one is in is removed; no other session ever is.

        `name`: display name.

        Error: OverLimit. For editors.

        For example:

            api.session.create(name='wing tip')
        """
        answer: SessionMade = self._call("session.create", {"name": name})
        return answer

    @named
    def fork(self, *, name: Optional[str] = None, session: Optional[str] = None) -> SessionForkResult:
        """Makes a new session with the records of another and the time it shows, but without its people, links and
        history. With a share link, of any role, it copies the link's session only, and `key` lets you into the copy
        as an editor, for as long as your link is valid.

        `name`: display name.

        Error: NotFound, OverLimit.

        For example:

            api.session.fork(session='main', name='copy')
        """
        answer: SessionForkResult = self._call("session.fork", {"session": session, "name": name})
        return answer

    @named
    def list(self, *, trash: Optional[bool] = None) -> SessionListResult:
        """Lists the sessions of this server. With a share link, only the session of the link is listed.

        `trash`: true: list the deleted sessions instead; default False.

        For example:

            api.session.list()
        """
        answer: SessionListResult = self._call("session.list", {"trash": trash})
        return answer

    @named
    def join(self, *, name: Optional[str] = None, colour: Optional[str] = None, resume_token: Optional[str] = None,
             last_seq: Optional[int] = None, session: Optional[str] = None) -> Joined:
        """Enters a session. From now on its changes are sent to this WebSocket.

        `name`: display name.
        `colour`: #rrggbb; if left out, a colour that few others have.
        `resume_token`: token of an earlier stay, to take up its place again.
        `last_seq`: with `resume_token`: the last `seq` seen; what was missed is returned instead of the snapshot; 0 or
            more.

        Error: NotFound, OverLimit. Only on a `Connection`.

        For example:

            api.session.join(session='main', name='Grace')
        """
        answer: Joined = self._call("session.join", {"session": session, "name": name, "colour": colour,
                                                     "resumeToken": resume_token, "lastSeq": last_seq})
        return answer

    @named
    def leave(self) -> Json:
        """Leaves the session. Its changes are no longer sent.

        Only on a `Connection`.

        For example:

            api.session.leave()
        """
        answer: Json = self._call("session.leave", {})
        return answer

    @named
    def state(self, *, session: Optional[str] = None) -> SessionStateResult:
        """Returns all records of a session.

        Error: NotFound.

        For example:

            api.session.state(session='main')
        """
        answer: SessionStateResult = self._call("session.state", {"session": session})
        return answer

    @named
    def rename(self, *, name: str, session: Optional[str] = None) -> SessionName:
        """Renames a session. Everyone in it is notified.

        `name`: display name.

        Error: NotFound, OverLimit. For hosts.

        For example:

            api.session.rename(session='session-2', name='tip vortex')
        """
        answer: SessionName = self._call("session.rename", {"session": session, "name": name})
        return answer

    @named
    def set_units(self, *, length: str, time: str, session: Optional[str] = None) -> SessionName:
        """Sets the units in which lengths and times are read. They only name what the numbers of the data mean: no
        number changes. Everyone in the session is notified.

        `length`: unit of lengths; empty: as in dataset.describe.
        `time`: unit of times; empty: as in dataset.describe.

        Error: NotFound, OverLimit. For editors.

        For example:

            api.session.set_units(session='session-2', length='mm', time='s')
        """
        answer: SessionName = self._call("session.setUnits", {"session": session, "length": length, "time": time})
        return answer

    @named
    def delete(self, *, forever: Optional[bool] = None, session: Optional[str] = None) -> SessionDeleteResult:
        """Moves a session to the trash, from which session.restore can bring it back for 30 days. The people in it
        are notified, and meanwhile its share links let no one in. `main` cannot be deleted. Who copied a session by
        a share link may delete the copy as long as no one has edited, named or shared it and no one else is in it;
        it is gone for good then.

        `forever`: true: permanently deletes a session that is in the trash; default False.

        Error: NotFound, OverLimit. For hosts.

        For example:

            api.session.delete(session='session-2')
        """
        answer: SessionDeleteResult = self._call("session.delete", {"session": session, "forever": forever})
        return answer

    @named
    def restore(self, *, session: Optional[str] = None) -> SessionName:
        """Brings a session back from the trash as it was, with its share links.

        Error: NotFound, OverLimit. For editors.

        For example:

            api.session.restore(session='session-2')
        """
        answer: SessionName = self._call("session.restore", {"session": session})
        return answer

    @named
    def export(self, *, session: Optional[str] = None) -> SessionExportResult:
        """Returns a session as one document: its records, and the names and fingerprints of their datasets. A large
        session is refused here; GET /api/v1/sessions/SESSION/session.json returns sessions of any size.

        Error: NotFound, OverLimit.

        For example:

            api.session.export(session='session-2')
        """
        answer: SessionExportResult = self._call("session.export", {"session": session})
        return answer

    @named
    def import_(self, *, file: Mapping[str, Any], name: Optional[str] = None) -> SessionImportResult:
        """Makes a new session from a document of session.export. POST /api/v1/sessions takes documents that are too
        large for a message.

        `file`: the `file` that session.export returned.
        `name`: name of the new session; if left out, the name in the document.

        Error: NotFound, OverLimit. For editors.
        """
        answer: SessionImportResult = self._call("session.import", {"file": file, "name": name})
        return answer

    @named
    def thumbnail(self, *, image: str, session: Optional[str] = None) -> Json:
        """Stores a small picture of the session for lists; it replaces the one before. GET
        /api/v1/sessions/SESSION/thumbnail returns it.

        `image`: a PNG, JPEG or WebP picture of at most 24 KiB, in base64.

        Error: NotFound, OverLimit. For editors.
        """
        answer: Json = self._call("session.thumbnail", {"session": session, "image": image})
        return answer

    @named
    def share(self, *, role: Literal["viewer", "editor", "host"], expires_in: Union[Optional[int], LeftOut] = LEFT_OUT,
              session: Optional[str] = None) -> SessionShareResult:
        """Makes a link that lets people into this session, in a role, until it expires or is revoked. The key is
        returned only this once; it works wherever the token does.

        `role`: viewers look, editors edit, hosts also decide who may be here.
        `expires_in`: how long the link is valid; if left out, 7 days, or as long as the link you came by; null: until
            it is revoked (s); 1 to 316,224,000.

        Error: NotFound, OverLimit. For hosts.

        For example:

            api.session.share(session='main', role='viewer', expires_in=3600)
        """
        answer: SessionShareResult = self._call("session.share", {"session": session, "role": role,
                                                                  "expiresIn": NULL if expires_in is None else expires_in})
        return answer

    @named
    def shares(self, *, session: Optional[str] = None) -> SessionSharesResult:
        """Lists the valid links into this session, without their keys.

        Error: NotFound. For hosts.

        For example:

            api.session.shares(session='main')
        """
        answer: SessionSharesResult = self._call("session.shares", {"session": session})
        return answer

    @named
    def unshare(self, *, grant: str, children: Optional[bool] = None,
                session: Optional[str] = None) -> SessionUnshareResult:
        """Revokes a link. Everyone who came by it is disconnected. Links that were made through it stay valid,
        unless `children` is true.

        `grant`: an id from session.shares.
        `children`: true: also revoke the links that were made through it, directly or indirectly; default False.

        Error: NotFound, OverLimit. For hosts.

        For example:

            api.session.unshare(session='main', grant='g1')
        """
        answer: SessionUnshareResult = self._call("session.unshare", {"session": session, "grant": grant,
                                                                      "children": children})
        return answer

    @named
    def set_role(self, *, participant: str, role: Literal["viewer", "editor", "host"],
                 session: Optional[str] = None) -> SessionSetRoleResult:
        """Sets what a participant may do here, from their next message on. A role below that of the link they came
        by also applies to their other places, to calls without a place, and to everyone else who comes by that link
        from now on.

        `participant`: an id from session.state.
        `role`: viewers look, editors edit, hosts also decide who may be here.

        Error: NotFound, OverLimit. For hosts.

        For example:

            api.session.set_role(session='main', participant='p2', role='viewer')
        """
        answer: SessionSetRoleResult = self._call("session.setRole", {"session": session, "participant": participant,
                                                                      "role": role})
        return answer

    @named
    def kick(self, *, participant: str, session: Optional[str] = None) -> Json:
        """Disconnects a participant, who loses their place. The link they came by stays valid; revoke it as well to
        keep them out.

        `participant`: an id from session.state.

        Error: NotFound, OverLimit. For hosts.

        For example:

            api.session.kick(session='main', participant='p2')
        """
        answer: Json = self._call("session.kick", {"session": session, "participant": participant})
        return answer
