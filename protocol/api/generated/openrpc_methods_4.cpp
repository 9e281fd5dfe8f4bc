// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_4 = R"json({
 "name": "rake.set",
 "summary": "Creates a rake, or replaces one as a whole; the surfaces that hang on it are rebuilt at once, unless only its name or colour changes.",
 "tags": [{"name": "rake"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "kind",
   "required": true,
   "description": "what the points are: line: 2; polyline and points: 2 or more; circle: the centre and two points of the rim",
   "schema": {
    "enum": ["line", "polyline", "circle", "points"],
    "description": "what the points are: line: 2; polyline and points: 2 or more; circle: the centre and two points of the rim"}},
  {
   "name": "points",
   "required": true,
   "description": "where it lies; a part outside of the domain is cut away",
   "schema": {
    "type": "array",
    "maxItems": 1024,
    "description": "where it lies; a part outside of the domain is cut away",
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
   "description": "how many seeds lie on it",
   "schema": {"type": "integer", "minimum": 2, "maximum": 4096, "description": "how many seeds lie on it"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "rake",
   "required": false,
   "description": "left out: create one",
   "schema": {"type": "string", "maxLength": 256, "description": "left out: create one"}},
  {
   "name": "name",
   "required": false,
   "description": "for people",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "for people"}},
  {
   "name": "colour",
   "required": false,
   "description": "#rrggbb; left out: as it was, of a new rake one that few others have",
   "schema": {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$", "description": "#rrggbb; left out: as it was, of a new rake one that few others have"}},
  {
   "name": "dragging",
   "required": false,
   "description": "true: no one else may edit the rake for 5 s from now; false: they may again; left out: as it was",
   "schema": {"type": "boolean", "description": "true: no one else may edit the rake for 5 s from now; false: they may again; left out: as it was"}},
  {
   "name": "force",
   "required": false,
   "description": "a host's edit goes before someone else's lease",
   "schema": {"type": "boolean", "default": false, "description": "a host's edit goes before someone else's lease"}},
  {
   "name": "default",
   "required": false,
   "description": "true: only if no one has edited the session and there is no such record yet; it counts as no edit, so undo does not turn it",
   "schema": {
    "type": "boolean",
    "default": false,
    "description": "true: only if no one has edited the session and there is no such record yet; it counts as no edit, so undo does not turn it"}},
  {
   "name": "gesture",
   "required": false,
   "description": "a name for what the user does; edits that follow each other with the same one are one step of undo",
   "schema": {
    "type": "string",
    "minLength": 1,
    "maxLength": 64,
    "description": "a name for what the user does; edits that follow each other with the same one are one step of undo"}},
  {
   "name": "ifRev",
   "required": false,
   "description": "refuse the edit if the record is at another revision",
   "schema": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "refuse the edit if the record is at another revision"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "rake": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"},
    "clipped": {"type": "boolean", "description": "a part was outside the domain and is cut away"},
    "points": {
     "type": "array",
     "description": "as clipped to the domain",
     "items": {
      "type": "array",
      "minItems": 3,
      "maxItems": 3,
      "description": "[x, y, z], finite as 32-bit floats",
      "x-unit": "the dataset's unit of length",
      "items": {"type": "number"}}},
    "surfaces": {"type": "array", "description": "those that hang on it and are built again", "items": {"$ref": "#/components/schemas/SurfaceEpoch"}},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "summary": "Deletes a rake and the surfaces that hang on it.",
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
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "force",
   "required": false,
   "description": "although someone else drags it; for hosts",
   "schema": {"type": "boolean", "default": false, "description": "although someone else drags it; for hosts"}},
  {
   "name": "gesture",
   "required": false,
   "description": "a name for what the user does; edits that follow each other with the same one are one step of undo",
   "schema": {
    "type": "string",
    "minLength": 1,
    "maxLength": 64,
    "description": "a name for what the user does; edits that follow each other with the same one are one step of undo"}},
  {
   "name": "ifRev",
   "required": false,
   "description": "refuse the edit if the record is at another revision",
   "schema": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "refuse the edit if the record is at another revision"}}],
 "result": {
  "name": "result",
  "description": "Of the answer to an edit.",
  "schema": {
   "type": "object",
   "description": "Of the answer to an edit.",
   "properties": {
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "summary": "The rakes of a session.",
 "tags": [{"name": "rake"}],
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
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {"rakes": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Rake"}}},
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
 "examples": [{"name": "rake.list", "params": [{"name": "session", "value": "main"}], "result": {"name": "result", "value": {"rakes": []}}}]})json";

} // namespace wakesurf::protocol::openrpc
