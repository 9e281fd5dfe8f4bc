// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view schemas_2 = R"json("FamilyStep": {
 "type": "object",
 "description": "What came of a family at one time-step.",
 "properties": {
  "index": {"type": "integer", "minimum": 0, "description": "index of the time-step"},
  "time": {"type": "number", "description": "its time", "x-unit": "the dataset's unit of time"},
  "nodes": {"type": "integer", "minimum": 0, "description": "number of nodes"},
  "reached": {"type": "integer", "minimum": 0, "description": "nodes whose way leads to the source: only these have a value"},
  "atRest": {"type": "integer", "minimum": 0, "description": "nodes that are at rest, or come to rest"},
  "obstacle": {"type": "integer", "minimum": 0, "description": "nodes in an obstacle, or whose way ends at one"},
  "lost": {
   "type": "integer",
   "minimum": 0,
   "description": "nodes that were followed for `length` without an end, as where the flow turns in circles"},
  "outside": {"type": "integer", "minimum": 0, "description": "nodes whose way leaves the domain beside the source, and nodes without a velocity"},
  "range": {"type": "array", "minItems": 2, "maxItems": 2, "description": "smallest and largest value", "items": {"type": "number"}}},
 "required": ["index", "time", "nodes", "reached", "atRest", "obstacle", "lost", "outside", "range"],
 "additionalProperties": false},
"Family": {
 "type": "object",
 "description": "A family of stream surfaces of a dataset, with what it was made from.",
 "properties": {
  "name": {"type": "string", "minLength": 1, "maxLength": 64, "description": "name of the field: letters, digits, and _ - ."},
  "from": {
   "enum": ["inflow", "plane", "curve"],
   "description": "where the scalar is given; inflow: on the boundary through which the flow enters; plane: on a plane; curve: it is the distance from a curve, in the plane of the curve, so that the level 0 is the stream surface through the curve"},
  "scalar": {"type": "string", "description": "of inflow and plane: x, y, z or the field that was taken there"},
  "point": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "of a plane: a point of it",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "normal": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "of a plane: its normal",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "rakeKind": {
   "enum": ["line", "polyline", "circle", "points"],
   "description": "of a curve: what the points are, as of a rake: a line, a polyline in one plane, or a circle"},
  "points": {
   "type": "array",
   "minItems": 2,
   "maxItems": 1024,
   "description": "of a curve: its points; the ends of a line or a polyline are continued straight",
   "items": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "description": "[x, y, z], finite as 32-bit floats",
    "x-unit": "the dataset's unit of length",
    "items": {"type": "number"}}},
  "accuracy": {"enum": ["fast", "balanced", "exact"], "description": "how accurately particles are traced and vertices inserted"},
  "length": {"type": "number", "exclusiveMinimum": 0, "description": "how far nodes were followed at most", "x-unit": "the dataset's unit of length"},
  "version": {"type": "string", "description": "version of the program that made it"},
  "steps": {
   "type": "array",
   "minItems": 1,
   "description": "the time-steps it was made for; at others it has no value",
   "items": {"$ref": "#/components/schemas/FamilyStep"}}},
 "required": ["name", "from", "accuracy", "length", "version", "steps"],
 "additionalProperties": false},
"AsideRecord": {
 "type": "object",
 "description": "A record that could not be used when the server started.",
 "properties": {
  "type": {"type": "string", "description": "kind of record: rake, surface, bookmark or annotation"},
  "id": {"type": "string", "description": "id of the record"},
  "why": {"type": "string", "description": "why it could not be used"},
  "since": {"type": "integer", "description": "when it was put aside", "x-unit": "s since 1970"}},
 "required": ["type", "id", "why", "since"],
 "additionalProperties": false},
"KeptAside": {
 "type": "object",
 "description": "Records that could not be used when the server started. None of them is deleted.",
 "properties": {
  "count": {"type": "integer", "minimum": 0, "description": "number of all such records"},
  "records": {"type": "array", "description": "the newest 50 of them", "items": {"$ref": "#/components/schemas/AsideRecord"}}},
 "required": ["count", "records"],
 "additionalProperties": false},
"Units": {
 "type": "object",
 "description": "The units that the people of a session have typed.",
 "properties": {
  "length": {"type": "string", "description": "unit of lengths; empty: as in dataset.describe"},
  "time": {"type": "string", "description": "unit of times; empty: as in dataset.describe"}},
 "required": ["length", "time"],
 "additionalProperties": false},
"Snapshot": {
 "type": "object",
 "description": "All records of a session.",
 "properties": {
  "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
  "name": {"type": "string", "description": "display name"},
  "units": {"$ref": "#/components/schemas/Units"},
  "rakes": {"type": "array", "description": "all rakes", "items": {"$ref": "#/components/schemas/Rake"}},
  "surfaces": {"type": "array", "description": "all surfaces", "items": {"$ref": "#/components/schemas/Surface"}},
  "bookmarks": {"type": "array", "description": "all bookmarks", "items": {"$ref": "#/components/schemas/Bookmark"}},
  "annotations": {"type": "array", "description": "all annotations", "items": {"$ref": "#/components/schemas/Annotation"}},
  "clock": {"$ref": "#/components/schemas/Clock"},
  "keptAside": {"$ref": "#/components/schemas/KeptAside"}},
 "required": ["session", "name", "rakes", "surfaces", "bookmarks", "annotations", "clock"],
 "additionalProperties": false},
"SessionName": {
 "type": "object",
 "description": "The id and the name of a session, and its units.",
 "properties": {
  "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
  "name": {"type": "string", "description": "display name"},
  "units": {"$ref": "#/components/schemas/Units"}},
 "required": ["session", "name"],
 "additionalProperties": false},
"SessionMade": {
 "type": "object",
 "description": "A new session.",
 "properties": {
  "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
  "name": {"type": "string", "description": "display name"},
  "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"}},
 "required": ["session", "name", "remaining"],
 "additionalProperties": false},
"TimesOfDataset": {
 "type": "object",
 "description": "The time-steps of a dataset.",
 "properties": {
  "count": {"type": "integer", "minimum": 0, "description": "number of time-steps"},
  "first": {"type": "number", "description": "time of the first time-step", "x-unit": "the dataset's unit of time"},
  "last": {"type": "number", "description": "time of the last time-step", "x-unit": "the dataset's unit of time"}},
 "required": ["count", "first", "last"],
 "additionalProperties": false},
"NamedDataset": {
 "type": "object",
 "description": "A dataset that surfaces of a document use. Only the id is present if the dataset could not be used when the document was written.",
 "properties": {
  "dataset": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the dataset"},
  "name": {"type": "string", "description": "display name"},
  "fingerprint": {"type": "string", "description": "fingerprint of the mesh and of the names of the fields; it stays the same when time-steps are added"},
  "times": {"$ref": "#/components/schemas/TimesOfDataset"},
  "bounds": {
   "type": "array",
   "minItems": 6,
   "maxItems": 6,
   "description": "bounding box: x0, x1, y0, y1, z0, z1",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}}},
 "required": ["dataset"],
 "additionalProperties": false},
"FileRecords": {
 "type": "object",
 "description": "The records of a session as in a snapshot, with their ids, but without `rev` and `epoch`.",
 "properties": {
  "rakes": {"type": "array", "description": "all rakes", "items": {"type": "object", "properties": {}, "additionalProperties": true}},
  "surfaces": {"type": "array", "description": "all surfaces", "items": {"type": "object", "properties": {}, "additionalProperties": true}},
  "bookmarks": {"type": "array", "description": "all bookmarks", "items": {"type": "object", "properties": {}, "additionalProperties": true}},
  "annotations": {"type": "array", "description": "all annotations", "items": {"type": "object", "properties": {}, "additionalProperties": true}},
  "clock": {"$ref": "#/components/schemas/Clock"}},
 "required": ["rakes", "surfaces", "bookmarks", "annotations", "clock"],
 "additionalProperties": false},
"SessionFile": {
 "type": "object",
 "description": "A session as one document. Any wakesurf server can import it; it is checked like edits, and imported as a whole or not at all.",
 "properties": {
  "wakesurfSession": {"enum": [1], "description": "version of the format"},
  "name": {"type": "string", "description": "display name"},
  "exported": {"type": "string", "description": "when the document was written, in UTC"},
  "wakesurf": {"type": "string", "description": "version of the program that wrote it"},
  "records": {"$ref": "#/components/schemas/FileRecords"},
  "datasets": {"type": "array", "description": "datasets that the surfaces use", "items": {"$ref": "#/components/schemas/NamedDataset"}},
  "units": {"$ref": "#/components/schemas/Units"}},
 "required": ["wakesurfSession", "name", "exported", "wakesurf", "records", "datasets"],
 "additionalProperties": false},
"Visitor": {
 "type": "object",
 "description": "Someone who was in a session.",
 "properties": {"name": {"type": "string", "description": "the name they had"}, "colour": {"type": "string", "description": "their colour, #rrggbb"}},
 "required": ["name", "colour"],
 "additionalProperties": false},
"SessionEntry": {
 "type": "object",
 "description": "A session as a list shows it.",
 "properties": {
  "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
  "name": {"type": "string", "description": "display name"},
  "participants": {"type": "integer", "minimum": 0, "description": "number of participants who are in the session now"},
  "people": {
   "type": "array",
   "maxItems": 8,
   "description": "people who have been in the session; the last to join is the first in the list",
   "items": {"$ref": "#/components/schemas/Visitor"}},
  "created": {"type": "string", "description": "when the session was made, in UTC; not recorded for old sessions"},
  "lastUsed": {"type": "string", "description": "when the session was last used, in UTC"},
  "edited": {"type": "boolean", "description": "true: someone has edited it, beyond the first rake and surface that a page makes"},
  "rakes": {"type": "integer", "minimum": 0, "description": "number of rakes"},
  "surfaces": {"type": "integer", "minimum": 0, "description": "number of surfaces"},
  "bookmarks": {"type": "integer", "minimum": 0, "description": "number of bookmarks"},
  "annotations": {"type": "integer", "minimum": 0, "description": "number of annotations"},
  "thumbnail": {"type": "boolean", "description": "true: there is a picture of it"},
  "deletedAt": {"type": "string", "description": "for a session in the trash: when it was deleted, in UTC"},
  "deletedUntil": {"type": "string", "description": "for a session in the trash: until when it can be restored, in UTC"}},
 "required": ["session", "name", "participants", "people", "lastUsed", "edited", "rakes", "surfaces", "bookmarks", "annotations", "thumbnail"],
 "additionalProperties": false},
"Patch": {
 "type": "object",
 "description": "A change of a record: the record as it is now, or that it was deleted. For the type `session`: the name of the session and its units.",
 "properties": {
  "op": {"enum": ["put", "delete"], "description": "what happened to the record"},
  "type": {"enum": ["rake", "surface", "bookmark", "annotation", "clock", "session"], "description": "kind of record"},
  "id": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the record"},
  "record": {
   "description": "for put: the record as it is now",
   "anyOf": [
    {"$ref": "#/components/schemas/Rake"},
    {"$ref": "#/components/schemas/Surface"},
    {"$ref": "#/components/schemas/Bookmark"},
    {"$ref": "#/components/schemas/Annotation"},
    {"$ref": "#/components/schemas/Clock"},
    {"$ref": "#/components/schemas/SessionName"}]}},
 "required": ["op", "type", "id"],
 "additionalProperties": false},
"Joined": {
 "type": "object",
 "description": "What session.join returns: either `snapshot` or `patches`.",
 "properties": {
  "you": {"type": "string", "minLength": 1, "maxLength": 256, "description": "your id as a participant"},
  "role": {"enum": ["viewer", "editor", "host"], "description": "your role in the session"},
  "resumeToken": {
   "type": "string",
   "description": "token with which you can come back; if it differs from the one you sent, nothing from before is valid: no epoch, `seq` or subscription"},
  "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session now"},
  "participants": {"type": "array", "description": "all participants", "items": {"$ref": "#/components/schemas/Participant"}},
  "created": {"type": "string", "description": "when the session was made, in UTC, as in session.list"},
  "copyOf": {"$ref": "#/components/schemas/SessionName"},
  "resumed": {"type": "boolean", "description": "true: `patches` is present; false: `snapshot` is present"},
  "snapshot": {"$ref": "#/components/schemas/Snapshot"},
  "patches": {
   "type": "array",
   "description": "what changed after `lastSeq`; for each record only the newest change",
   "items": {"$ref": "#/components/schemas/Patch"}}},
 "required": ["you", "role", "resumeToken", "seq", "participants", "resumed"],
 "additionalProperties": false},
"ShareMaker": {
 "type": "object",
 "description": "Who made a link.",
 "properties": {
  "grant": {"type": "string", "description": "id of the link by which they came; if left out, they had the server's own token"},
  "name": {"type": "string", "description": "name of the participant; empty: a script"}},
 "required": ["name"],
 "additionalProperties": false},
"Share": {
 "type": "object",
 "description": "A valid share link, without its key.",
 "properties": {
  "grant": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the link"},
  "role": {"enum": ["viewer", "editor", "host"], "description": "role of those who come by it"},
  "expires": {"type": "number", "description": "when the link expires; if left out, never", "x-unit": "s since 1970"},
  "newcomers": {
   "enum": ["viewer", "editor"],
   "description": "role of those who come by it from now on; present if a host has given someone who came by it a lower role"},
  "madeBy": {"$ref": "#/components/schemas/ShareMaker"},
  "copy": {"type": "string", "minLength": 1, "maxLength": 256, "description": "for a link into a copy that session.fork has made: id of the copy"},
  "children": {"type": "integer", "minimum": 0, "description": "number of valid links that were made through this one, directly or indirectly"}},
 "required": ["grant", "role", "madeBy", "children"],
 "additionalProperties": false},
"Camera": {
 "type": "object",
 "description": "Where someone looks from.",
 "properties": {
  "position": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "position of the eye",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "target": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "the point in the middle of the picture",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "up": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "direction that points up in the picture",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "fov": {
   "type": "number",
   "minimum": 1,
   "maximum": 179,
   "description": "field of view from top to bottom; if left out, the view is orthographic or unknown",
   "x-unit": "degrees"}},
 "required": ["position", "target", "up"],
 "additionalProperties": false},
"DraggedRake": {
 "type": "object",
 "description": "A rake while it is dragged.",
 "properties": {
  "rake": {"type": "string", "maxLength": 64, "description": "id of the rake"},
  "points": {
   "type": "array",
   "maxItems": 64,
   "description": "where the rake is now",
   "items": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "description": "[x, y, z], finite as 32-bit floats",
    "x-unit": "the dataset's unit of length",
    "items": {"type": "number"}}}},
 "required": ["rake"],
 "additionalProperties": false},
"Presence": {
 "type": "object",
 "description": "What someone is doing at the moment.",
 "properties": {
  "pointer": {
   "type": ["array", "null"],
   "minItems": 3,
   "maxItems": 3,
   "description": "the point they point at",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "camera": {"anyOf": [{"$ref": "#/components/schemas/Camera"}, {"type": "null"}]},
  "dragging": {"anyOf": [{"$ref": "#/components/schemas/DraggedRake"}, {"type": "null"}]},
  "selected": {"type": ["string", "null"], "maxLength": 64, "description": "id of the record they have selected"}},
 "additionalProperties": false},
"Participant": {
 "type": "object",
 "description": "Someone in a session. A notification has only what changed; null: no longer there.",
 "properties": {
  "participant": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the participant"},
  "name": {"type": "string", "description": "display name; two people in a session never have the same one"},
  "colour": {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$", "description": "their colour, #rrggbb"},
  "role": {"enum": ["viewer", "editor", "host"], "description": "what someone may do; each role includes the ones before it"},
  "connected": {"type": "boolean", "description": "false: the connection was lost less than 10 s ago"},
  "pointer": {
   "type": ["array", "null"],
   "minItems": 3,
   "maxItems": 3,
   "description": "the point they point at",
   "x-unit": "the dataset's unit of length",
   "items": {"type": "number"}},
  "camera": {"anyOf": [{"$ref": "#/components/schemas/Camera"}, {"type": "null"}]},
  "dragging": {"anyOf": [{"$ref": "#/components/schemas/DraggedRake"}, {"type": "null"}]},
  "selected": {"type": ["string", "null"], "maxLength": 64, "description": "id of the record they have selected"}},
 "required": ["participant", "name", "colour", "role", "connected"],
 "additionalProperties": false},
"RakeShape": {
 "type": "object",
 "description": "The shape of a rake.",
 "properties": {
  "kind": {
   "enum": ["line", "polyline", "circle", "points"],
   "description": "what the points are; line: 2 points; polyline and points: 2 or more; circle: the centre and two points on the rim"},
  "points": {
   "type": "array",
   "maxItems": 1024,
   "description": "where the rake lies; parts outside the domain are cut off, and a circle releases from its longest arc inside",
   "x-unit": "the dataset's unit of length",
   "items": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "description": "[x, y, z], finite as 32-bit floats",
    "x-unit": "the dataset's unit of length",
    "items": {"type": "number"}}},
  "seeds": {"type": "integer", "minimum": 2, "maximum": 4096, "description": "number of seeds on the rake"}},
 "required": ["kind", "points", "seeds"],
 "additionalProperties": false})json";

} // namespace wakesurf::protocol::openrpc
