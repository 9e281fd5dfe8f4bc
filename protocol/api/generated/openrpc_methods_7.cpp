// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_7 = R"json({
 "name": "surface.set",
 "summary": "Creates a surface, or replaces its record as a whole, and starts to build it.",
 "tags": [{"name": "surface"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "rake",
   "required": true,
   "description": "an id from rake.list; the particles start from this rake. A level surface takes no more of it than its place in lists and its colour",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from rake.list; the particles start from this rake. A level surface takes no more of it than its place in lists and its colour"}},
  {
   "name": "dataset",
   "required": true,
   "description": "an id from dataset.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"}},
  {
   "name": "kind",
   "required": true,
   "description": "stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak: particles released continuously from `from` on; time: a patch of particles released at `from`; level: where `field` has the value `level`, at the time that is shown between `from` and `to`",
   "schema": {
    "enum": ["stream", "path", "streak", "time", "level"],
    "description": "stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak: particles released continuously from `from` on; time: a patch of particles released at `from`; level: where `field` has the value `level`, at the time that is shown between `from` and `to`"}},
  {
   "name": "to",
   "required": true,
   "description": "where the surface ends: before `from`, time runs backward. A stream surface is followed for `to` - `from`, and `to` need not lie in the data; for the others it must",
   "schema": {
    "type": "number",
    "minimum": -3.4028234663852886e+38,
    "maximum": 3.4028234663852886e+38,
    "description": "where the surface ends: before `from`, time runs backward. A stream surface is followed for `to` - `from`, and `to` need not lie in the data; for the others it must",
    "x-unit": "the dataset's unit of time"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "surface",
   "required": false,
   "description": "id of the surface to replace; if left out, a new one is created",
   "schema": {"type": "string", "maxLength": 256, "description": "id of the surface to replace; if left out, a new one is created"}},
  {
   "name": "rake2",
   "required": false,
   "description": "the patch lies between the rake and this second rake",
   "schema": {"type": "string", "maxLength": 256, "description": "the patch lies between the rake and this second rake", "x-only-for": ["time"]}},
  {
   "name": "from",
   "required": false,
   "description": "where the surface starts: the (first) release; for stream surfaces, the time at which the field is frozen; if left out, the first time of the data, or the last where `direction` is backward",
   "schema": {
    "type": "number",
    "minimum": -3.4028234663852886e+38,
    "maximum": 3.4028234663852886e+38,
    "description": "where the surface starts: the (first) release; for stream surfaces, the time at which the field is frozen; if left out, the first time of the data, or the last where `direction` is backward",
    "x-unit": "the dataset's unit of time"}},
  {
   "name": "direction",
   "required": false,
   "description": "if left out, forward or backward as `from` and `to` say; it must not contradict them. both: to the later time `to`, and as long before `from`, a path surface as far as there are data; only for stream and path surfaces",
   "schema": {
    "enum": ["forward", "backward", "both"],
    "description": "if left out, forward or backward as `from` and `to` say; it must not contradict them. both: to the later time `to`, and as long before `from`, a path surface as far as there are data; only for stream and path surfaces"}},
  {
   "name": "accuracy",
   "required": false,
   "description": "how accurately particles are traced and vertices inserted",
   "schema": {
    "enum": ["fast", "balanced", "exact"],
    "default": "balanced",
    "description": "how accurately particles are traced and vertices inserted"}},
  {
   "name": "interpolation",
   "required": false,
   "description": "of stored velocity. linear: between the nodes of a cell and in time, as ParaView shows it; smooth: cubic in space and time, for uniform grids only, see `smooth` of dataset.describe",
   "schema": {
    "enum": ["linear", "smooth"],
    "default": "linear",
    "description": "of stored velocity. linear: between the nodes of a cell and in time, as ParaView shows it; smooth: cubic in space and time, for uniform grids only, see `smooth` of dataset.describe"}},
  {
   "name": "refine",
   "required": false,
   "description": "whether quads are cut, joined and reconnected, and torn at obstacles. off: the grid that the rake begins with stays as it is, with a column a seed, as in smoke surfaces; `merge` and `angle` then count for nothing, and `separation` only along the flow. Quads with a particle that has ended are left out",
   "schema": {
    "enum": ["on", "off"],
    "default": "on",
    "description": "whether quads are cut, joined and reconnected, and torn at obstacles. off: the grid that the rake begins with stays as it is, with a column a seed, as in smoke surfaces; `merge` and `angle` then count for nothing, and `separation` only along the flow. Quads with a particle that has ended are left out"}},
  {
   "name": "releaseUntil",
   "required": false,
   "description": "time at which the release stops; if left out, `to`",
   "schema": {
    "type": "number",
    "minimum": -3.4028234663852886e+38,
    "maximum": 3.4028234663852886e+38,
    "description": "time at which the release stops; if left out, `to`",
    "x-unit": "the dataset's unit of time",
    "x-only-for": ["streak"]}},
  {
   "name": "life",
   "required": false,
   "description": "longest age of a particle: it ends so long after its release; if left out, it lives as long as the surface",
   "schema": {
    "type": "number",
    "exclusiveMinimum": 0,
    "description": "longest age of a particle: it ends so long after its release; if left out, it lives as long as the surface",
    "x-unit": "the dataset's unit of time",
    "x-only-for": ["path", "streak", "time"]}},
  {
   "name": "sweep",
   "required": false,
   "description": "the patch is the rake swept along this vector",
   "schema": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "description": "the patch is the rake swept along this vector",
    "x-unit": "the dataset's unit of length",
    "x-only-for": ["time"],
    "items": {"type": "number"}}},
  {
   "name": "field",
   "required": false,
   "description": "scalar field of the dataset, or derived from its velocity, of which the surface is a level set: its magnitude by the velocity's name, `vorticity`, `q_criterion`, `velocity_x` and the like",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "scalar field of the dataset, or derived from its velocity, of which the surface is a level set: its magnitude by the velocity's name, `vorticity`, `q_criterion`, `velocity_x` and the like",
    "x-only-for": ["level"],
    "x-needed-for": ["level"]}},
  {
   "name": "level",
   "required": false,
   "description": "value that the field has on the surface",
   "schema": {
    "type": "number",
    "description": "value that the field has on the surface",
    "x-unit": "the field's unit",
    "x-only-for": ["level"],
    "x-needed-for": ["level"]}},
  {
   "name": "merge",
   "required": false,
   "description": "quads smaller than this are joined; 0: never",
   "schema": {
    "type": "number",
    "minimum": 0,
    "maximum": 0.5,
    "default": 0.35,
    "description": "quads smaller than this are joined; 0: never",
    "x-unit": "part of the separation"}},
  {
   "name": "angle",
   "required": false,
   "description": "neighbouring quads at a larger angle are refined, as far as the separation and `maxQuads` allow; 180: never",
   "schema": {
    "type": "number",
    "maximum": 180,
    "exclusiveMinimum": 0,
    "default": 20,
    "description": "neighbouring quads at a larger angle are refined, as far as the separation and `maxQuads` allow; 180: never",
    "x-unit": "degrees"}},
  {
   "name": "stagnationSpeed",
   "required": false,
   "description": "a slower particle counts as at rest and ends; 0: only a particle that does not move at all",
   "schema": {
    "type": "number",
    "minimum": 0,
    "maximum": 0.1,
    "default": 1e-06,
    "description": "a slower particle counts as at rest and ends; 0: only a particle that does not move at all",
    "x-unit": "part of the largest speed"}},
  {
   "name": "maxQuads",
   "required": false,
   "description": "maximum number of quads",
   "schema": {"type": "integer", "minimum": 1, "maximum": 4000000, "default": 1000000, "description": "maximum number of quads"}},
  {
   "name": "separation",
   "required": false,
   "description": "longest edge allowed; if left out, the dataset's finest spacing",
   "schema": {
    "type": "number",
    "exclusiveMinimum": 0,
    "description": "longest edge allowed; if left out, the dataset's finest spacing",
    "x-unit": "the dataset's unit of length"}},
  {
   "name": "fields",
   "required": false,
   "description": "additional attributes of the vertices, in frames and exports: scalar fields of the dataset, its velocity (the magnitude), `deformation`, `approximated`, `error`, `vorticity` (its magnitude), `vorticity_x`, `vorticity_y`, `vorticity_z`, `q_criterion`, `velocity_x`, `velocity_y`, `velocity_z`, `normal_x`, `normal_y`, `normal_z` (of the surface)",
   "schema": {
    "type": "array",
    "maxItems": 5,
    "default": [],
    "description": "additional attributes of the vertices, in frames and exports: scalar fields of the dataset, its velocity (the magnitude), `deformation`, `approximated`, `error`, `vorticity` (its magnitude), `vorticity_x`, `vorticity_y`, `vorticity_z`, `q_criterion`, `velocity_x`, `velocity_y`, `velocity_z`, `normal_x`, `normal_y`, `normal_z` (of the surface)",
    "items": {"type": "string"}}},
  {
   "name": "default",
   "required": false,
   "description": "true: make the record only if no one has edited the session and it has no such record yet; this does not count as an edit, and undo does not take it back",
   "schema": {
    "type": "boolean",
    "default": false,
    "description": "true: make the record only if no one has edited the session and it has no such record yet; this does not count as an edit, and undo does not take it back"}},
  {
   "name": "gesture",
   "required": false,
   "description": "a name for what the user is doing; consecutive edits with the same name are one step of undo",
   "schema": {
    "type": "string",
    "minLength": 1,
    "maxLength": 64,
    "description": "a name for what the user is doing; consecutive edits with the same name are one step of undo"}},
  {
   "name": "ifRev",
   "required": false,
   "description": "the edit is refused if the record is at another revision",
   "schema": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "the edit is refused if the record is at another revision"}}],
 "result": {
  "name": "result",
  "description": "What surface.set returns.",
  "schema": {
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
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["surface", "rev", "epoch", "seq"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/stale"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/outsideDomain"},
  {"$ref": "#/components/errors/outsideTimeRange"},
  {"$ref": "#/components/errors/overLimit"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "surface.set",
   "params": [
    {"name": "rake", "value": "r1"},
    {"name": "dataset", "value": "lamb-oseen"},
    {"name": "kind", "value": "stream"},
    {"name": "to", "value": 2},
    {"name": "session", "value": "main"},
    {"name": "from", "value": 0},
    {"name": "separation", "value": 0.1}],
   "result": {"name": "result", "value": {"epoch": 1, "rev": 1, "seq": 5, "surface": "s1"}}}]},
{
 "name": "surface.delete",
 "summary": "Deletes a surface.",
 "tags": [{"name": "surface"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "surface",
   "required": true,
   "description": "an id from surface.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from surface.list"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "gesture",
   "required": false,
   "description": "a name for what the user is doing; consecutive edits with the same name are one step of undo",
   "schema": {
    "type": "string",
    "minLength": 1,
    "maxLength": 64,
    "description": "a name for what the user is doing; consecutive edits with the same name are one step of undo"}},
  {
   "name": "ifRev",
   "required": false,
   "description": "the edit is refused if the record is at another revision",
   "schema": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "the edit is refused if the record is at another revision"}}],
 "result": {
  "name": "result",
  "description": "What every edit returns.",
  "schema": {
   "type": "object",
   "description": "What every edit returns.",
   "properties": {
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["seq"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/stale"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/overLimit"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "surface.delete",
   "params": [{"name": "surface", "value": "s2"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"seq": 17}}}]},
{
 "name": "surface.stop",
 "summary": "Stops the computation of a surface, for everyone, within 50 ms. What has been computed stays; the surface's statistics and surface.done say who stopped it. The next edit of the surface or of its rake computes it again.",
 "tags": [{"name": "surface"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "surface",
   "required": true,
   "description": "an id from surface.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from surface.list"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "epoch": {
     "type": "integer",
     "minimum": 0,
     "maximum": 4294967295,
     "description": "counts the surfaces that have been built for the record; it never decreases"},
    "stopped": {"type": "boolean", "description": "false: nothing was being computed"}},
   "required": ["epoch", "stopped"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "surface.stop",
   "params": [{"name": "surface", "value": "s2"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"epoch": 1, "stopped": false}}}]})json";

} // namespace wakesurf::protocol::openrpc
