// Made by protocol/api/generate from errors.schema.json: do not edit.
// The codes of errors.
#pragma once

#include <string_view>

namespace wakesurf::protocol {

enum class RpcCode : int {
    ParseError =
        -32700, ///< the text is not JSON, is not UTF-8, or has a number beyond the range of a double
    InvalidRequest =
        -32600, ///< there is no request object, a member is there twice, the message is too long or too deep, or a WebSocket method was called over HTTP
    MethodNotFound = -32601, ///< there is no such method
    InvalidParameters =
        -32602, ///< a parameter is missing, unknown, malformed or out of range; with the kind `unsupported`: it was understood, but is not supported yet
    Internal = -32603,  ///< an error in the server; its log has the details
    Cancelled = -32800, ///< the work was replaced by a newer edit, or cancelled by $/cancelRequest
    Stale = -32801,     ///< `ifRev` is not the revision of the record; `data.current` is the record
    Unauthenticated =
        -32001, ///< the share link has expired or was revoked; over HTTP, with status 401 or 429, also: no token or a wrong one
    NotPermitted =
        -32003, ///< the method needs a higher role, or the share link is for another session; with status 403: a foreign host or origin
    NotFound =
        -32004, ///< there is no such session, record, participant, share link, dataset or subscription
    Leased =
        -32011, ///< someone else is dragging the rake: `data.by` says who, `data.untilMs` for how long
    OutsideDomain = -32012,    ///< outside the dataset's domain; the message says how far
    OutsideTimeRange = -32013, ///< outside the dataset's times
    OverLimit =
        -32014, ///< more than the server allows (see server.info), or than the call itself allows (`maxQuads`)
    DatasetError = -32015, ///< the data cannot be read or are damaged
};

/// The word for a code in error.data.kind: `notFound`, `outsideDomain`, ...
std::string_view kind_of(RpcCode code);

} // namespace wakesurf::protocol
