// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view schemas_4 = R"json("ValueRange": {
 "type": "object",
 "description": "What the values of an attribute range over, for colours.",
 "properties": {
  "attribute": {
   "type": "string",
   "description": "name of the attribute, as in the frames; `t` stands for the age: of a streak surface the time since the release"},
  "low": {
   "type": "number",
   "description": "lower end, without the last per cent of the surface's area where there are values below zero and it would take more than a fifth of the range"},
  "high": {
   "type": "number",
   "description": "upper end, without the last per cent of the surface's area where it would take more than a fifth of the range"},
  "least": {"type": "number", "description": "the least of all values"},
  "greatest": {"type": "number", "description": "the greatest of all values"}},
 "required": ["attribute", "low", "high", "least", "greatest"],
 "additionalProperties": false},
"BookmarkFields": {
 "type": "object",
 "description": "The content of a bookmark.",
 "properties": {
  "view": {
   "type": "object",
   "description": "camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text",
   "additionalProperties": true},
  "time": {
   "type": "number",
   "minimum": -3.4028234663852886e+38,
   "maximum": 3.4028234663852886e+38,
   "description": "the session's time that belongs to the view",
   "x-unit": "the dataset's unit of time"}},
 "required": ["view"],
 "additionalProperties": false},
"Bookmark": {
 "type": "object",
 "description": "A bookmark as the session keeps it.",
 "properties": {
  "bookmark": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the bookmark"},
  "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
  "name": {"type": "string", "maxLength": 120, "description": "display name"},
  "view": {
   "type": "object",
   "description": "camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text",
   "additionalProperties": true},
  "time": {
   "type": "number",
   "minimum": -3.4028234663852886e+38,
   "maximum": 3.4028234663852886e+38,
   "description": "the session's time that belongs to the view",
   "x-unit": "the dataset's unit of time"}},
 "required": ["bookmark", "rev", "name", "view"],
 "additionalProperties": false},
"AnnotationFields": {
 "type": "object",
 "description": "The content of an annotation.",
 "properties": {
  "text": {"type": "string", "maxLength": 4096, "description": "text of one or more lines"},
  "position": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "the point that it refers to",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "surface": {"type": "string", "maxLength": 256, "description": "id of the surface that it refers to, which may have been deleted since"}},
 "required": ["text", "position"],
 "additionalProperties": false},
"Annotation": {
 "type": "object",
 "description": "An annotation as the session keeps it.",
 "properties": {
  "annotation": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the annotation"},
  "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
  "text": {"type": "string", "maxLength": 4096, "description": "text of one or more lines"},
  "position": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "the point that it refers to",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "author": {"type": "string", "maxLength": 120, "description": "name of the one who made it"},
  "surface": {"type": "string", "maxLength": 256, "description": "id of the surface that it refers to, which may have been deleted since"}},
 "required": ["annotation", "rev", "text", "position", "author"],
 "additionalProperties": false},
"Change": {
 "type": "object",
 "description": "A record that was changed.",
 "properties": {
  "op": {"enum": ["put", "delete"], "description": "what happened to the record"},
  "type": {"type": "string", "description": "kind of record: rake, surface, bookmark or annotation"},
  "id": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the record"},
  "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"}},
 "required": ["op", "type", "id"],
 "additionalProperties": false},
"Skip": {
 "type": "object",
 "description": "A record that was skipped because someone else has changed it since.",
 "properties": {
  "type": {"type": "string", "description": "kind of record: rake, surface, bookmark or annotation"},
  "id": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the record"},
  "why": {"type": "string", "description": "why it was skipped, for people"}},
 "required": ["type", "id", "why"],
 "additionalProperties": false},
"HistoryDepth": {
 "type": "object",
 "description": "What can be undone and redone.",
 "properties": {
  "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
  "skipped": {
   "type": "array",
   "description": "records that were skipped; their edits are forgotten for good",
   "items": {"$ref": "#/components/schemas/Skip"}},
  "undo": {"type": "integer", "minimum": 0, "description": "number of edits that can still be taken back"},
  "redo": {"type": "integer", "minimum": 0, "description": "number of edits that can be repeated"}},
 "required": ["seq", "skipped", "undo", "redo"],
 "additionalProperties": false},
"Clock": {
 "type": "object",
 "description": "The clock of a session. `time` is its time when the message was written. While it is `playing`, it advances by `speed` up to `to`, and there it stops or goes on at `from` (`loop`).",
 "properties": {
  "time": {
   "type": ["number", "null"],
   "minimum": -1e+30,
   "maximum": 1e+30,
   "description": "simulation time; null: it was never set, and surfaces are shown at their end",
   "x-unit": "the dataset's unit of time"},
  "playing": {"type": "boolean", "description": "true: the clock runs"},
  "speed": {"type": "number", "minimum": 1e-09, "maximum": 1000000, "description": "how fast the clock runs", "x-unit": "simulation time a second"},
  "loop": {"type": "boolean", "description": "true: the clock goes on at `from` when it reaches `to`"},
  "from": {
   "type": ["number", "null"],
   "minimum": -1e+30,
   "maximum": 1e+30,
   "description": "time at which playing starts; null before the clock was first played",
   "x-unit": "the dataset's unit of time"},
  "to": {
   "type": ["number", "null"],
   "minimum": -1e+30,
   "maximum": 1e+30,
   "description": "time at which playing ends; null before the clock was first played",
   "x-unit": "the dataset's unit of time"}},
 "required": ["time", "playing", "speed", "loop", "from", "to"],
 "additionalProperties": false},
"ClockAnswer": {
 "type": "object",
 "description": "The clock after the call.",
 "properties": {"clock": {"$ref": "#/components/schemas/Clock"}},
 "required": ["clock"],
 "additionalProperties": false})json";

} // namespace wakesurf::protocol::openrpc
