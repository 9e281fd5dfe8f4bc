// Made by protocol/api/generate from errors.schema.json: do not edit.
// The codes of errors.
#pragma once

#include <string_view>

namespace wakesurf::protocol {

enum class RpcCode : int {
    ParseError = -32700, ///< not JSON, not UTF-8, or a number beyond double
    InvalidRequest =
        -32600, ///< no request object, a member that is there twice, a message that is too long or too deep, or a WebSocket method over HTTP
    MethodNotFound = -32601, ///< there is no such method
    InvalidParameters =
        -32602, ///< a parameter is missing, unknown, malformed or out of range; with the kind `unsupported`: understood, but not offered yet
    Internal = -32603,  ///< a fault of the server; its log has the details
    Cancelled = -32800, ///< the work was replaced by a newer edit, or cancelled by $/cancelRequest
    Stale = -32801,     ///< `ifRev` is not the record's revision; `data.current` is the record
    Unauthenticated =
        -32001, ///< the share link has ended; over HTTP, with status 401 or 429, also no token or a wrong one
    NotPermitted =
        -32003, ///< a lesser role than the method needs, or a share link for another session; with status 403: a foreign host or origin
    NotFound =
        -32004, ///< there is no such session, record, participant, share link, dataset or subscription
    Leased =
        -32011, ///< someone else is dragging the rake: `data.by` says who, `data.untilMs` for how long
    OutsideDomain = -32012,    ///< outside the dataset's domain; the message says by how much
    OutsideTimeRange = -32013, ///< outside the dataset's times
    OverLimit =
        -32014, ///< more than the server grants, see server.info, or than the call allows itself (`maxQuads`)
    DatasetError = -32015, ///< the data are unreadable or damaged
};

/// The word for a code in error.data.kind: `notFound`, `outsideDomain`, ...
std::string_view kind_of(RpcCode code);

} // namespace wakesurf::protocol
