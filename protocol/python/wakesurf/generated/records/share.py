"""Share links: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, Literal, TypedDict


class ShareMaker(TypedDict, total=False):
    """Who made a link."""

    grant: str  # id of the link by which they came; if left out, they had the server's own token; may be missing
    name: str  # name of the participant; empty: a script


class Share(TypedDict, total=False):
    """A valid share link, without its key."""

    grant: str  # id of the link
    role: Literal["viewer", "editor", "host"]  # role of those who come by it
    expires: float  # when the link expires; if left out, never (s since 1970); may be missing
    newcomers: Literal["viewer", "editor"]  # role of those who come by it from now on; present if a host has given ...
    madeBy: ShareMaker  # who made it
    copy: str  # for a link into a copy that session.fork has made: id of the copy; may be missing
    children: int  # number of valid links that were made through this one, directly or indirectly


class SessionShareResult(TypedDict, total=False):
    """What session.share answers."""

    grant: str  # id of the link
    role: Literal["viewer", "editor", "host"]  # role of those who come by it
    expires: float  # when the link expires; if left out, never (s since 1970); may be missing
    newcomers: Literal["viewer", "editor"]  # role of those who come by it from now on; present if a host has given ...
    madeBy: ShareMaker  # who made it
    copy: str  # for a link into a copy that session.fork has made: id of the copy; may be missing
    children: int  # number of valid links that were made through this one, directly or indirectly
    key: str  # secret key of the link
    link: str  # what to append to the address of the page


class SessionSharesResult(TypedDict, total=False):
    """What session.shares answers."""

    shares: List[Share]  # all valid links


class SessionUnshareResult(TypedDict, total=False):
    """What session.unshare answers."""

    children: List[Share]  # links made through it that are still valid


class SessionSetRoleResult(TypedDict, total=False):
    """What session.setRole answers."""

    participant: str  # id of the participant
    role: Literal["viewer", "editor", "host"]  # the role they have now
    also: List[str]  # ids of the same person's other places, which get the role too
    newcomers: Literal["viewer", "editor"]  # role of those who come by that link from now on; may be missing
