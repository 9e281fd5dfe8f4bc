// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_6 = R"json({
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
   "result": {"name": "result", "value": {"clipped": false, "points": [[0.2, 0, -1], [1, 0, -1]], "rake": "r1", "rev": 1, "seq": 1, "surfaces": []}}}]},
{
 "name": "rake.delete",
 "summary": "Deletes a rake and its surfaces.",
 "tags": [{"name": "rake"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "rake",
   "required": true,
   "description": "an id from rake.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from rake.list"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "force",
   "required": false,
   "description": "true: lets a host delete the rake although someone else holds the lease",
   "schema": {"type": "boolean", "default": false, "description": "true: lets a host delete the rake although someone else holds the lease"}},
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
  {"$ref": "#/components/errors/leased"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "rake.delete",
   "params": [{"name": "rake", "value": "r1"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"seq": 18}}}]},
{
 "name": "rake.list",
 "summary": "Lists the rakes of a session.",
 "tags": [{"name": "rake"}],
 "paramStructure": "by-name",
 "params": [
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
   "properties": {"rakes": {"type": "array", "description": "all rakes", "items": {"$ref": "#/components/schemas/Rake"}}},
   "required": ["rakes"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "rake.list",
   "params": [{"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {
     "rakes": [
      {
       "author": "Ada",
       "clipped": false,
       "colour": "#0072b2",
       "dragging": false,
       "kind": "line",
       "name": "r1",
       "points": [[0.2, 0, -1], [1, 0, -1]],
       "rake": "r1",
       "rev": 1,
       "seeds": 9}]}}}]})json";

} // namespace wakesurf::protocol::openrpc
