// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view schemas_3 = R"json("SurfaceSetResult": {
 "type": "object",
 "description": "What surface.set answers.",
 "properties": {
  "surface": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
  "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
  "epoch": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "counts the surfaces that a record has had; only grows"},
  "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"}},
 "required": ["surface", "rev", "epoch", "seq"],
 "additionalProperties": false},
"PassSeconds": {
 "type": "object",
 "description": "What the pass that made the newest state took.",
 "properties": {
  "queue": {"type": "number", "minimum": 0, "description": "from the edit, or the state before, until it began", "x-unit": "s"},
  "load": {"type": "number", "minimum": 0, "description": "waiting for time-steps of the velocity", "x-unit": "s"},
  "compute": {"type": "number", "minimum": 0, "description": "all else of building", "x-unit": "s"},
  "encode": {"type": "number", "minimum": 0, "description": "making frames", "x-unit": "s"}},
 "required": ["queue", "load", "compute", "encode"],
 "additionalProperties": false},
"Terminations": {
 "type": "object",
 "description": "Particles by what ended them.",
 "properties": {
  "domain": {"type": "integer", "minimum": 0, "description": "left the domain"},
  "time": {"type": "integer", "minimum": 0, "description": "reached the end of the time asked for"},
  "obstacle": {"type": "integer", "minimum": 0, "description": "came to an obstacle"},
  "stagnation": {"type": "integer", "minimum": 0, "description": "came to rest"},
  "budget": {"type": "integer", "minimum": 0, "description": "used up the steps allowed"}},
 "required": ["domain", "time", "obstacle", "stagnation", "budget"],
 "additionalProperties": false},
"BuildSeconds": {
 "type": "object",
 "description": "What building a surface took.",
 "properties": {
  "load": {"type": "number", "description": "waiting for time-steps", "x-unit": "s"},
  "advect": {"type": "number", "description": "moving particles", "x-unit": "s"},
  "refine": {"type": "number", "description": "putting in vertices and taking them out", "x-unit": "s"},
  "other": {"type": "number", "description": "all else", "x-unit": "s"},
  "total": {"type": "number", "description": "all of it", "x-unit": "s"}},
 "required": ["load", "advect", "refine", "other", "total"],
 "additionalProperties": false},
"Statistics": {
 "type": "object",
 "description": "What the newest state of a surface is and took, in the shape of `wakesurf surface --stats`.",
 "properties": {
  "surface": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
  "epoch": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "counts the surfaces that a record has had; only grows"},
  "complete": {"type": "boolean", "description": "it is the final surface of this epoch"},
  "kind": {
   "enum": ["stream", "path", "streak", "time"],
   "description": "stream: of the field frozen at `from`; path: particles released at `from`; streak: particles released from `from` on; time: a patch of particles released at `from`"},
  "quads": {"type": "integer", "minimum": 0, "description": "of the mesh"},
  "vertices": {"type": "integer", "minimum": 0, "description": "of the mesh"},
  "steps": {"type": "integer", "minimum": 0, "description": "of the surface, in time or along its curves"},
  "vertexSteps": {"type": "integer", "minimum": 0, "description": "of the integrator, all particles together"},
  "approximated": {"type": "integer", "minimum": 0, "description": "vertices that were interpolated, not traced from the rake"},
  "terminated": {"$ref": "#/components/schemas/Terminations"},
  "maxEdge": {"type": "number", "minimum": 0, "description": "the longest edge there is", "x-unit": "the dataset's unit of length"},
  "separation": {"type": "number", "minimum": 0, "description": "the longest edge asked for", "x-unit": "the dataset's unit of length"},
  "seconds": {"$ref": "#/components/schemas/BuildSeconds"},
  "pass": {"$ref": "#/components/schemas/PassSeconds"},
  "peakBytes": {"type": "integer", "minimum": 0, "description": "the most memory that building it took", "x-unit": "bytes"},
  "stopped": {"type": "string", "description": "why the surface ends early"},
  "stateSum": {
   "type": "integer",
   "minimum": 0,
   "maximum": 4294967295,
   "description": "checksum of what clients show, as in the frames (protocol/wire/FORMAT.md, State sum)"},
  "error": {"$ref": "#/components/schemas/Problem"}},
 "required": [
  "surface",
  "epoch",
  "complete",
  "kind",
  "quads",
  "vertices",
  "steps",
  "vertexSteps",
  "approximated",
  "terminated",
  "maxEdge",
  "separation",
  "seconds",
  "peakBytes",
  "stateSum"],
 "additionalProperties": false},
"BookmarkFields": {
 "type": "object",
 "description": "What a bookmark says.",
 "properties": {
  "view": {
   "type": "object",
   "description": "camera, colours and the like, as the client that made it likes; at most 4 KiB as JSON text",
   "additionalProperties": true},
  "time": {
   "type": "number",
   "minimum": -3.4028234663852886e+38,
   "maximum": 3.4028234663852886e+38,
   "description": "the session's time the view belongs to",
   "x-unit": "the dataset's unit of time"}},
 "required": ["view"],
 "additionalProperties": false},
"Bookmark": {
 "type": "object",
 "description": "A bookmark as the session keeps it.",
 "properties": {
  "bookmark": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
  "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
  "name": {"type": "string", "maxLength": 120, "description": "for people"},
  "view": {
   "type": "object",
   "description": "camera, colours and the like, as the client that made it likes; at most 4 KiB as JSON text",
   "additionalProperties": true},
  "time": {
   "type": "number",
   "minimum": -3.4028234663852886e+38,
   "maximum": 3.4028234663852886e+38,
   "description": "the session's time the view belongs to",
   "x-unit": "the dataset's unit of time"}},
 "required": ["bookmark", "rev", "name", "view"],
 "additionalProperties": false},
"AnnotationFields": {
 "type": "object",
 "description": "What an annotation says.",
 "properties": {
  "text": {"type": "string", "maxLength": 4096, "description": "of one line or several"},
  "position": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "where it points to",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "surface": {"type": "string", "maxLength": 256, "description": "the surface it speaks of, which may be gone since"}},
 "required": ["text", "position"],
 "additionalProperties": false},
"Annotation": {
 "type": "object",
 "description": "An annotation as the session keeps it.",
 "properties": {
  "annotation": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
  "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
  "text": {"type": "string", "maxLength": 4096, "description": "of one line or several"},
  "position": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "where it points to",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "author": {"type": "string", "maxLength": 120, "description": "the name of the one who made it"},
  "surface": {"type": "string", "maxLength": 256, "description": "the surface it speaks of, which may be gone since"}},
 "required": ["annotation", "rev", "text", "position", "author"],
 "additionalProperties": false},
"Change": {
 "type": "object",
 "description": "A record that was changed.",
 "properties": {
  "op": {"enum": ["put", "delete"], "description": "what became of it"},
  "type": {"type": "string", "description": "rake, surface, bookmark or annotation"},
  "id": {"type": "string", "minLength": 1, "maxLength": 256, "description": "of the record"},
  "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"}},
 "required": ["op", "type", "id"],
 "additionalProperties": false},
"Skip": {
 "type": "object",
 "description": "A record that someone else has changed since.",
 "properties": {
  "type": {"type": "string", "description": "rake, surface, bookmark or annotation"},
  "id": {"type": "string", "minLength": 1, "maxLength": 256, "description": "of the record"},
  "why": {"type": "string", "description": "it was skipped, for people"}},
 "required": ["type", "id", "why"],
 "additionalProperties": false},
"HistoryDepth": {
 "type": "object",
 "description": "What there is to undo and redo.",
 "properties": {
  "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"},
  "skipped": {"type": "array", "description": "edits that are forgotten, once and for all", "items": {"$ref": "#/components/schemas/Skip"}},
  "undo": {"type": "integer", "minimum": 0, "description": "edits that can still be taken back"},
  "redo": {"type": "integer", "minimum": 0, "description": "edits that can be made again"}},
 "required": ["seq", "skipped", "undo", "redo"],
 "additionalProperties": false},
"Clock": {
 "type": "object",
 "description": "A session's clock. `time` is as the message is written; it runs on by `speed` while `playing`, up to `to`, and there it stops or goes on at `from` (`loop`).",
 "properties": {
  "time": {
   "type": ["number", "null"],
   "minimum": -1e+30,
   "maximum": 1e+30,
   "description": "simulation time; null: never set, surfaces are shown at their end",
   "x-unit": "the dataset's unit of time"},
  "playing": {"type": "boolean", "description": "it runs"},
  "speed": {"type": "number", "minimum": 1e-09, "maximum": 1000000, "description": "how fast it runs", "x-unit": "simulation time a second"},
  "loop": {"type": "boolean", "description": "it begins again at the end"},
  "from": {
   "type": ["number", "null"],
   "minimum": -1e+30,
   "maximum": 1e+30,
   "description": "what is played begins here; null before it first was",
   "x-unit": "the dataset's unit of time"},
  "to": {"type": ["number", "null"], "minimum": -1e+30, "maximum": 1e+30, "description": "and ends here", "x-unit": "the dataset's unit of time"}},
 "required": ["time", "playing", "speed", "loop", "from", "to"],
 "additionalProperties": false},
"ClockAnswer": {
 "type": "object",
 "description": "The clock after the call.",
 "properties": {"clock": {"$ref": "#/components/schemas/Clock"}},
 "required": ["clock"],
 "additionalProperties": false})json";

} // namespace wakesurf::protocol::openrpc
