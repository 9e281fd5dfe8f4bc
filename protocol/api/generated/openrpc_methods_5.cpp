// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_5 = R"json({
 "name": "session.unshare",
 "summary": "Revokes a link. Everyone who came by it is disconnected. Links that were made through it stay valid, unless `children` is true.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "grant",
   "required": true,
   "description": "an id from session.shares",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.shares"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "children",
   "required": false,
   "description": "true: also revoke the links that were made through it, directly or indirectly",
   "schema": {"type": "boolean", "default": false, "description": "true: also revoke the links that were made through it, directly or indirectly"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "children": {"type": "array", "description": "links made through it that are still valid", "items": {"$ref": "#/components/schemas/Share"}},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["children"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "host",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.unshare",
   "params": [{"name": "grant", "value": "g1"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"children": []}}}]},
{
 "name": "session.setRole",
 "summary": "Sets what a participant may do here, from their next message on. A role below that of the link they came by also applies to their other places, to calls without a place, and to everyone else who comes by that link from now on.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "participant",
   "required": true,
   "description": "an id from session.state",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.state"}},
  {
   "name": "role",
   "required": true,
   "description": "viewers look, editors edit, hosts also decide who may be here",
   "schema": {"enum": ["viewer", "editor", "host"], "description": "viewers look, editors edit, hosts also decide who may be here"}},
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
    "participant": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the participant"},
    "role": {"enum": ["viewer", "editor", "host"], "description": "the role they have now"},
    "also": {"type": "array", "description": "ids of the same person's other places, which get the role too", "items": {"type": "string"}},
    "newcomers": {"enum": ["viewer", "editor"], "description": "role of those who come by that link from now on"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["participant", "role", "also"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "host",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.setRole",
   "params": [{"name": "participant", "value": "p2"}, {"name": "role", "value": "viewer"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"also": [], "participant": "p2", "role": "viewer"}}}]},
{
 "name": "session.kick",
 "summary": "Disconnects a participant, who loses their place. The link they came by stays valid; revoke it as well to keep them out.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "participant",
   "required": true,
   "description": "an id from session.state",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.state"}},
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
  "description": "an empty object",
  "schema": {
   "type": "object",
   "description": "an empty object",
   "properties": {
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "host",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.kick",
   "params": [{"name": "participant", "value": "p2"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {}}}]},
{
 "name": "presence.update",
 "summary": "Shows the others what the caller points at, looks at, drags and has selected. What is left out stays as it is; null removes it. Best sent as a notification.",
 "tags": [{"name": "presence"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "pointer",
   "required": false,
   "description": "the point they point at",
   "schema": {
    "type": ["array", "null"],
    "minItems": 3,
    "maxItems": 3,
    "description": "the point they point at",
    "x-unit": "the dataset's unit of length",
    "items": {"type": "number"}}},
  {
   "name": "camera",
   "required": false,
   "description": "where they look from",
   "schema": {"anyOf": [{"$ref": "#/components/schemas/Camera"}, {"type": "null"}]}},
  {
   "name": "dragging",
   "required": false,
   "description": "the rake they drag",
   "schema": {"anyOf": [{"$ref": "#/components/schemas/DraggedRake"}, {"type": "null"}]}},
  {
   "name": "selected",
   "required": false,
   "description": "id of the record they have selected",
   "schema": {"type": ["string", "null"], "maxLength": 64, "description": "id of the record they have selected"}}],
 "result": {"name": "result", "description": "an empty object", "schema": {"$ref": "#/components/schemas/Empty"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true,
 "examples": [
  {
   "name": "presence.update",
   "params": [
    {"name": "pointer", "value": [0.5, 0, 0.2]},
    {"name": "camera", "value": {"position": [4, -6, 3], "target": [0, 0, 0], "up": [0, 0, 1], "fov": 40}},
    {"name": "selected", "value": "r1"}],
   "result": {"name": "result", "value": {}}}]},
{
 "name": "rake.set",
 "summary": "Creates a rake, or replaces one as a whole. The surfaces of the rake are rebuilt at once, unless only its name or colour changes.",
 "tags": [{"name": "rake"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "kind",
   "required": true,
   "description": "what the points are; line: 2 points; polyline and points: 2 or more; circle: the centre and two points on the rim",
   "schema": {
    "enum": ["line", "polyline", "circle", "points"],
    "description": "what the points are; line: 2 points; polyline and points: 2 or more; circle: the centre and two points on the rim"}},
  {
   "name": "points",
   "required": true,
   "description": "where the rake lies; parts outside the domain are cut off, and a circle releases from its longest arc inside",
   "schema": {
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
     "items": {"type": "number"}}}},
  {
   "name": "seeds",
   "required": true,
   "description": "number of seeds on the rake",
   "schema": {"type": "integer", "minimum": 2, "maximum": 4096, "description": "number of seeds on the rake"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "rake",
   "required": false,
   "description": "id of the rake to replace; if left out, a new one is created",
   "schema": {"type": "string", "maxLength": 256, "description": "id of the rake to replace; if left out, a new one is created"}},
  {
   "name": "name",
   "required": false,
   "description": "display name",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "display name"}},
  {
   "name": "colour",
   "required": false,
   "description": "#rrggbb; if left out, a rake keeps its colour, and a new rake gets one that few others have",
   "schema": {
    "type": "string",
    "pattern": "^#[0-9a-fA-F]{6}$",
    "description": "#rrggbb; if left out, a rake keeps its colour, and a new rake gets one that few others have"}},
  {
   "name": "dragging",
   "required": false,
   "description": "true: no one else may edit the rake for 5 s from now; false: others may edit it again; if left out, nothing changes",
   "schema": {
    "type": "boolean",
    "description": "true: no one else may edit the rake for 5 s from now; false: others may edit it again; if left out, nothing changes"}},
  {
   "name": "force",
   "required": false,
   "description": "true: lets a host edit the rake although someone else holds the lease",
   "schema": {"type": "boolean", "default": false, "description": "true: lets a host edit the rake although someone else holds the lease"}},
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
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "rake": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the rake"},
    "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
    "clipped": {"type": "boolean", "description": "true: a part was outside the domain and was cut off; a circle's points stay"},
    "points": {
     "type": "array",
     "description": "the points, clipped to the domain",
     "items": {
      "type": "array",
      "minItems": 3,
      "maxItems": 3,
      "description": "[x, y, z], finite as 32-bit floats",
      "x-unit": "the dataset's unit of length",
      "items": {"type": "number"}}},
    "surfaces": {
     "type": "array",
     "description": "surfaces of the rake that are being built again",
     "items": {"$ref": "#/components/schemas/SurfaceEpoch"}},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["rake", "rev", "seq", "clipped", "points", "surfaces"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/stale"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/leased"},
  {"$ref": "#/components/errors/outsideDomain"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "rake.set",
   "params": [
    {"name": "kind", "value": "line"},
    {"name": "points", "value": [[0.2, 0, -1], [1, 0, -1]]},
    {"name": "seeds", "value": 9},
    {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"clipped": false, "points": [[0.2, 0, -1], [1, 0, -1]], "rake": "r1", "rev": 1, "seq": 1, "surfaces": []}}}]})json";

} // namespace wakesurf::protocol::openrpc
