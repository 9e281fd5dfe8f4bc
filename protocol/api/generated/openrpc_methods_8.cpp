// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_8 = R"json({
 "name": "time.pause",
 "summary": "Stops the clock where it is.",
 "tags": [{"name": "time"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}}],
 "result": {"name": "result", "description": "The clock after the call.", "schema": {"$ref": "#/components/schemas/ClockAnswer"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "time.pause",
   "params": [{"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"clock": {"from": 0, "loop": true, "playing": false, "speed": 2, "time": 1.00126, "to": 2}}}}]})json";

} // namespace wakesurf::protocol::openrpc
