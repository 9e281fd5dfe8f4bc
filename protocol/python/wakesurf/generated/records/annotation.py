"""Annotations: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, TypedDict


class AnnotationRecord(TypedDict, total=False):
    """An annotation as the session keeps it."""

    annotation: str  # id of the annotation
    rev: int  # counts the edits of a record
    text: str  # text of one or more lines
    position: List[float]  # the point that it refers to (the dataset's unit of length)
    author: str  # name of the one who made it
    surface: str  # id of the surface that it refers to, which may have been deleted since; may be missing


class AnnotationSetResult(TypedDict, total=False):
    """What annotation.set answers."""

    annotation: str  # id of the annotation
    rev: int  # counts the edits of a record
    seq: int  # `seq` of the session after the edit


class AnnotationListResult(TypedDict, total=False):
    """What annotation.list answers."""

    annotations: List[AnnotationRecord]  # all annotations
