// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view errors_1 = R"json("invalidParameters": {
 "code": -32602,
 "message": "a parameter is missing, unknown, malformed or out of range; with the kind `unsupported`: it was understood, but is not supported yet",
 "data": {"kind": "invalidParameters", "hint": "what to do about it"}},
"internal": {"code": -32603, "message": "an error in the server; its log has the details", "data": {"kind": "internal", "hint": "what to do about it"}},
"cancelled": {
 "code": -32800,
 "message": "the work was replaced by a newer edit, or cancelled by $/cancelRequest",
 "data": {"kind": "cancelled", "hint": "what to do about it"}},
"stale": {
 "code": -32801,
 "message": "`ifRev` is not the revision of the record; `data.current` is the record",
 "data": {"kind": "stale", "hint": "what to do about it"}},
"unauthenticated": {
 "code": -32001,
 "message": "the share link has expired or was revoked; over HTTP, with status 401 or 429, also: no token or a wrong one",
 "data": {"kind": "unauthenticated", "hint": "what to do about it"}},
"notPermitted": {
 "code": -32003,
 "message": "the method needs a higher role, or the share link is for another session; with status 403: a foreign host or origin",
 "data": {"kind": "notPermitted", "hint": "what to do about it"}},
"notFound": {
 "code": -32004,
 "message": "there is no such session, record, participant, share link, dataset or subscription",
 "data": {"kind": "notFound", "hint": "what to do about it"}},
"leased": {
 "code": -32011,
 "message": "someone else is dragging the rake: `data.by` says who, `data.untilMs` for how long",
 "data": {"kind": "leased", "hint": "what to do about it"}},
"outsideDomain": {
 "code": -32012,
 "message": "outside the dataset's domain; the message says how far",
 "data": {"kind": "outsideDomain", "hint": "what to do about it"}},
"outsideTimeRange": {"code": -32013, "message": "outside the dataset's times", "data": {"kind": "outsideTimeRange", "hint": "what to do about it"}},
"overLimit": {
 "code": -32014,
 "message": "more than the server allows (see server.info), or than the call itself allows (`maxQuads`)",
 "data": {"kind": "overLimit", "hint": "what to do about it"}},
"datasetError": {"code": -32015, "message": "the data cannot be read or are damaged", "data": {"kind": "datasetError", "hint": "what to do about it"}})json";

} // namespace wakesurf::protocol::openrpc
