// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view schemas_3 = R"json("Surface": {
 "type": "object",
 "description": "A surface as the session keeps it: its parameters, not its mesh.",
 "properties": {
  "surface": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the surface"},
  "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
  "epoch": {
   "type": "integer",
   "minimum": 0,
   "maximum": 4294967295,
   "description": "counts the surfaces that have been built for the record; it never decreases"},
  "rake": {"type": "string", "maxLength": 256, "description": "an id from rake.list; the particles start from this rake"},
  "rake2": {"type": "string", "maxLength": 256, "description": "the patch lies between the rake and this second rake", "x-only-for": ["time"]},
  "dataset": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"},
  "kind": {
   "enum": ["stream", "path", "streak", "time"],
   "description": "stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak: particles released continuously from `from` on; time: a patch of particles released at `from`"},
  "accuracy": {"enum": ["fast", "balanced", "exact"], "default": "balanced", "description": "how accurately particles are traced and vertices inserted"},
  "interpolation": {
   "enum": ["linear", "smooth"],
   "default": "linear",
   "description": "of stored velocity. linear: between the nodes of a cell and in time, as ParaView shows it; smooth: cubic in space and time, for uniform grids only, see `smooth` of dataset.describe"},
  "refine": {
   "enum": ["on", "off"],
   "default": "on",
   "description": "whether quads are cut, joined and reconnected, and torn at obstacles. off: the grid that the rake begins with stays as it is, with a column a seed, as in smoke surfaces; `merge` and `angle` then count for nothing, and `separation` only along the flow. Quads with a particle that has ended are left out"},
  "to": {
   "type": "number",
   "minimum": -3.4028234663852886e+38,
   "maximum": 3.4028234663852886e+38,
   "description": "where the surface ends: before `from`, time runs backward. A stream surface is followed for `to` - `from`, and `to` need not lie in the data; for the others it must",
   "x-unit": "the dataset's unit of time"},
  "releaseUntil": {
   "type": "number",
   "minimum": -3.4028234663852886e+38,
   "maximum": 3.4028234663852886e+38,
   "description": "time at which the release stops; if left out, `to`",
   "x-unit": "the dataset's unit of time",
   "x-only-for": ["streak"]},
  "life": {
   "type": "number",
   "exclusiveMinimum": 0,
   "description": "longest age of a particle: it ends so long after its release; if left out, it lives as long as the surface",
   "x-unit": "the dataset's unit of time",
   "x-only-for": ["path", "streak", "time"]},
  "sweep": {
   "type": "array",
   "minItems": 3,
   "maxItems": 3,
   "description": "the patch is the rake swept along this vector",
   "x-unit": "the dataset's unit of length",
   "x-only-for": ["time"],
   "items": {"type": "number"}},
  "merge": {
   "type": "number",
   "minimum": 0,
   "maximum": 0.5,
   "default": 0.35,
   "description": "quads smaller than this are joined; 0: never",
   "x-unit": "part of the separation"},
  "angle": {
   "type": "number",
   "maximum": 180,
   "exclusiveMinimum": 0,
   "default": 20,
   "description": "neighbouring quads at a larger angle are refined, as far as the separation and `maxQuads` allow; 180: never",
   "x-unit": "degrees"},
  "stagnationSpeed": {
   "type": "number",
   "minimum": 0,
   "maximum": 0.1,
   "default": 1e-06,
   "description": "a slower particle counts as at rest and ends; 0: only a particle that does not move at all",
   "x-unit": "part of the largest speed"},
  "maxQuads": {"type": "integer", "minimum": 1, "maximum": 4000000, "default": 1000000, "description": "maximum number of quads"},
  "from": {
   "type": "number",
   "minimum": -3.4028234663852886e+38,
   "maximum": 3.4028234663852886e+38,
   "description": "where the surface starts: the (first) release; for stream surfaces, the time at which the field is frozen",
   "x-unit": "the dataset's unit of time"},
  "direction": {"enum": ["forward", "backward", "both"], "description": "which way particles are followed in time"},
  "separation": {"type": "number", "minimum": 0, "description": "longest edge allowed", "x-unit": "the dataset's unit of length"},
  "fields": {
   "type": "array",
   "maxItems": 16,
   "description": "additional attributes of the vertices, in frames and exports: scalar fields of the dataset, its velocity (the magnitude), `deformation`, `approximated`, `error`, `vorticity` (its magnitude), `vorticity_x`, `vorticity_y`, `vorticity_z`, `q_criterion`, `velocity_x`, `velocity_y`, `velocity_z`",
   "items": {"type": "string"}}},
 "required": [
  "surface",
  "rev",
  "epoch",
  "rake",
  "dataset",
  "kind",
  "accuracy",
  "interpolation",
  "refine",
  "to",
  "merge",
  "angle",
  "stagnationSpeed",
  "maxQuads",
  "from",
  "direction",
  "separation",
  "fields"],
 "additionalProperties": false},
"SurfaceSetResult": {
 "type": "object",
 "description": "What surface.set returns.",
 "properties": {
  "surface": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the surface"},
  "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
  "epoch": {
   "type": "integer",
   "minimum": 0,
   "maximum": 4294967295,
   "description": "counts the surfaces that have been built for the record; it never decreases"},
  "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"}},
 "required": ["surface", "rev", "epoch", "seq"],
 "additionalProperties": false},
"PassSeconds": {
 "type": "object",
 "description": "How long the pass that made the newest state took.",
 "properties": {
  "queue": {"type": "number", "minimum": 0, "description": "from the edit, or the state before, until the pass began", "x-unit": "s"},
  "load": {"type": "number", "minimum": 0, "description": "waiting for time-steps of the velocity", "x-unit": "s"},
  "compute": {"type": "number", "minimum": 0, "description": "everything else in building the surface", "x-unit": "s"},
  "encode": {"type": "number", "minimum": 0, "description": "encoding frames", "x-unit": "s"}},
 "required": ["queue", "load", "compute", "encode"],
 "additionalProperties": false},
"Terminations": {
 "type": "object",
 "description": "Numbers of particles, by what ended them.",
 "properties": {
  "domain": {"type": "integer", "minimum": 0, "description": "particles that left the domain"},
  "time": {"type": "integer", "minimum": 0, "description": "particles that reached the end of the requested time"},
  "obstacle": {"type": "integer", "minimum": 0, "description": "particles that reached an obstacle"},
  "stagnation": {"type": "integer", "minimum": 0, "description": "particles that came to rest"},
  "budget": {"type": "integer", "minimum": 0, "description": "particles that used up the steps allowed"}},
 "required": ["domain", "time", "obstacle", "stagnation", "budget"],
 "additionalProperties": false},
"BuildSeconds": {
 "type": "object",
 "description": "How long it took to build a surface.",
 "properties": {
  "load": {"type": "number", "description": "waiting for time-steps", "x-unit": "s"},
  "advect": {"type": "number", "description": "moving particles", "x-unit": "s"},
  "refine": {"type": "number", "description": "inserting and removing vertices", "x-unit": "s"},
  "other": {"type": "number", "description": "everything else", "x-unit": "s"},
  "total": {"type": "number", "description": "the whole build", "x-unit": "s"},
  "processor": {"type": "number", "description": "of all processors together, for the whole build; only in `wakesurf surface --stats`", "x-unit": "s"}},
 "required": ["load", "advect", "refine", "other", "total"],
 "additionalProperties": false},
"Emptiness": {
 "type": "object",
 "description": "Why there is nothing to see of a surface.",
 "properties": {
  "reason": {
   "enum": ["inBody", "outsideCells", "atRest", "notFinite", "sameRakes", "noArea", "nothingYet", "allLeft", "tooCoarse"],
   "description": "why a surface shows nothing. inBody, outsideCells: the whole rake lies there; atRest: the fluid does not move at the rake; notFinite: the velocities there are no numbers; sameRakes: both rakes of a time surface are the same; noArea: the rake lies along the flow; nothingYet: before the first release; allLeft: all particles have left the domain or reached the body; tooCoarse: no quad is left at this separation"},
  "message": {"type": "string", "description": "the reason, for people"},
  "hint": {"type": "string", "description": "what to do about it"}},
 "required": ["reason", "message", "hint"],
 "additionalProperties": false},
"Statistics": {
 "type": "object",
 "description": "Statistics of the newest state of a surface, in the shape of `wakesurf surface --stats`.",
 "properties": {
  "surface": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the surface"},
  "epoch": {
   "type": "integer",
   "minimum": 0,
   "maximum": 4294967295,
   "description": "counts the surfaces that have been built for the record; it never decreases"},
  "complete": {"type": "boolean", "description": "true: this is the final surface of its epoch"},
  "kind": {
   "enum": ["stream", "path", "streak", "time"],
   "description": "stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak: particles released continuously from `from` on; time: a patch of particles released at `from`"},
  "quads": {"type": "integer", "minimum": 0, "description": "number of quads"},
  "vertices": {"type": "integer", "minimum": 0, "description": "number of vertices"},
  "steps": {"type": "integer", "minimum": 0, "description": "number of steps of the surface, in time or along its curves"},
  "vertexSteps": {"type": "integer", "minimum": 0, "description": "number of steps of the integrator, for all particles together"},
  "approximated": {"type": "integer", "minimum": 0, "description": "number of vertices that were interpolated, not traced from the rake"},
  "error99": {
   "type": "number",
   "minimum": 0,
   "description": "99 % of the vertices that are not `uncertain` are estimated to be no farther than this from the surface as it truly is, across it: what has slid along the surface does not count; left out where there is no surface to see",
   "x-unit": "the dataset's unit of length"},
  "uncertain": {
   "type": "integer",
   "minimum": 0,
   "description": "number of vertices that may be farther than the separation from the surface as it truly is: they have passed close by a stagnation line, or the flow has stretched what was interpolated; left out where there is no surface to see"},
  "terminated": {"$ref": "#/components/schemas/Terminations"},
  "torn": {
   "type": "integer",
   "minimum": 0,
   "description": "number of cells that have been deleted amid living particles, which went apart or came together so much that no cells between them can follow: small holes, for instance where a mesh is folded; streak and time surfaces only"},
  "maxEdge": {"type": "number", "minimum": 0, "description": "length of the longest edge", "x-unit": "the dataset's unit of length"},
  "separation": {"type": "number", "minimum": 0, "description": "longest edge allowed in the end", "x-unit": "the dataset's unit of length"},
  "requestedSeparation": {"type": "number", "minimum": 0, "description": "longest edge that was asked for", "x-unit": "the dataset's unit of length"},
  "coarsened": {
   "type": "boolean",
   "description": "true: within `maxQuads` the separation asked for is not possible, so `separation` is larger; false until the surface is complete"},
  "seconds": {"$ref": "#/components/schemas/BuildSeconds"},
  "pass": {"$ref": "#/components/schemas/PassSeconds"},
  "peakBytes": {
   "type": "integer",
   "minimum": 0,
   "description": "the most memory that the process has held, for everything that it does",
   "x-unit": "bytes"},
  "dataEnd": {
   "type": "number",
   "description": "first time of the data, where it cuts the backward side of a path surface of both directions short",
   "x-unit": "the dataset's unit of time"},
  "stopped": {"type": "string", "description": "why the surface ends early"},
  "empty": {"$ref": "#/components/schemas/Emptiness"},
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
  "requestedSeparation",
  "coarsened",
  "seconds",
  "peakBytes",
  "stateSum"],
 "additionalProperties": false},
"ValueRange": {
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
