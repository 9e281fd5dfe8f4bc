"""Shared shapes: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, TypedDict


class Lattice(TypedDict, total=False):
    """The integer grid of a dataset's frames: node (i, j, k) lies at origin + step * (i, j, k)."""

    origin: List[float]  # position of node (0, 0, 0) (the dataset's unit of length)
    step: float  # distance between neighbouring nodes (the dataset's unit of length)
    bits: int  # there are 2^bits nodes along each side


class Problem(TypedDict, total=False):
    """An error that is part of a result, where the call itself did not fail."""

    code: int  # code of the error
    message: str  # what is wrong
    kind: str  # a word for programs
    hint: str  # a sentence for people: what to do about it; may be empty
    limit: float  # for overLimit: the most that is allowed; may be missing
