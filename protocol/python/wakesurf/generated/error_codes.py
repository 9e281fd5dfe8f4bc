"""Which exception each code of an error is.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from typing import Dict, Type

from ..errors import (Cancelled, DatasetError, InvalidParameters, InvalidRequest, Leased, MethodNotFound, NotFound,
                      NotPermitted, OutsideDomain, OutsideTimeRange, OverLimit, ServerFault, Stale, Unauthenticated,
                      WakesurfError)

BY_CODE: Dict[int, Type[WakesurfError]] = {-32700: InvalidRequest, -32600: InvalidRequest, -32601: MethodNotFound,
                                           -32602: InvalidParameters, -32603: ServerFault, -32800: Cancelled,
                                           -32801: Stale, -32001: Unauthenticated, -32003: NotPermitted,
                                           -32004: NotFound, -32011: Leased, -32012: OutsideDomain,
                                           -32013: OutsideTimeRange, -32014: OverLimit, -32015: DatasetError}
