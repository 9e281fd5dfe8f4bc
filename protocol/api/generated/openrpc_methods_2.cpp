// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_2 = R"json({
 "name": "probe.sample",
 "summary": "Returns the values of fields at points and one time, interpolated as at the vertices of surfaces.",
 "tags": [{"name": "probe"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "dataset",
   "required": true,
   "description": "an id from dataset.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"}},
  {
   "name": "points",
   "required": true,
   "description": "points to sample",
   "schema": {
    "type": "array",
    "maxItems": 4096,
    "description": "points to sample",
    "x-unit": "the dataset's unit of length",
    "items": {
     "type": "array",
     "minItems": 3,
     "maxItems": 3,
     "description": "[x, y, z], finite as 32-bit floats",
     "x-unit": "the dataset's unit of length",
     "items": {"type": "number"}}}},
  {
   "name": "time",
   "required": true,
   "description": "simulation time, in the dataset's range",
   "schema": {"type": "number", "description": "simulation time, in the dataset's range", "x-unit": "the dataset's unit of time"}},
  {
   "name": "fields",
   "required": false,
   "description": "name of the velocity, or names of scalar fields; if left out, the velocity",
   "schema": {
    "type": "array",
    "maxItems": 64,
    "description": "name of the velocity, or names of scalar fields; if left out, the velocity",
    "items": {"type": "string"}}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "values": {
     "type": "object",
     "description": "for each field, by its name, one value for each point; null: there is no value at that point",
     "properties": {},
     "additionalProperties": {
      "type": "array",
      "items": {
       "anyOf": [
        {"type": ["number", "null"]},
        {
         "type": "array",
         "minItems": 3,
         "maxItems": 3,
         "description": "[x, y, z], finite as 32-bit floats",
         "x-unit": "the dataset's unit of length",
         "items": {"type": "number"}}]}}},
    "inside": {"type": "array", "description": "for each point, whether it is in the fluid", "items": {"type": "boolean"}}},
   "required": ["values", "inside"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/outsideDomain"},
  {"$ref": "#/components/errors/outsideTimeRange"},
  {"$ref": "#/components/errors/overLimit"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "probe.sample",
   "params": [{"name": "dataset", "value": "lamb-oseen"}, {"name": "points", "value": [[0, 0, 0], [50, 0, 0]]}, {"name": "time", "value": 0}],
   "result": {"name": "result", "value": {"inside": [true, false], "values": {"velocity": [[0, 0, 0.5], null]}}}}]},
{
 "name": "session.create",
 "summary": "Makes a new, empty session. When there are too many sessions, one without a name that no one has edited or shared and no one is in is removed; no other session ever is.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "name",
   "required": false,
   "description": "display name",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "display name"}}],
 "result": {
  "name": "result",
  "description": "A new session.",
  "schema": {
   "type": "object",
   "description": "A new session.",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
    "name": {"type": "string", "description": "display name"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["session", "name", "remaining"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.create",
   "params": [{"name": "name", "value": "wing tip"}],
   "result": {"name": "result", "value": {"name": "wing tip", "remaining": 1022, "session": "session-1"}}}]},
{
 "name": "session.fork",
 "summary": "Makes a new session with the records of another, but without its people, links and history. Not available with a share link.",
 "tags": [{"name": "session"}],
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
   "name": "name",
   "required": false,
   "description": "display name",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "display name"}}],
 "result": {
  "name": "result",
  "description": "A new session.",
  "schema": {
   "type": "object",
   "description": "A new session.",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
    "name": {"type": "string", "description": "display name"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["session", "name", "remaining"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.fork",
   "params": [{"name": "session", "value": "main"}, {"name": "name", "value": "copy"}],
   "result": {"name": "result", "value": {"name": "copy", "remaining": 1021, "session": "session-2"}}}]},
{
 "name": "session.list",
 "summary": "Lists the sessions of this server. With a share link, only the session of the link is listed.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "trash",
   "required": false,
   "description": "true: list the deleted sessions instead",
   "schema": {"type": "boolean", "default": false, "description": "true: list the deleted sessions instead"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "sessions": {"type": "array", "description": "all sessions", "items": {"$ref": "#/components/schemas/SessionEntry"}},
    "limit": {"type": "integer", "minimum": 0, "description": "how many sessions the server keeps"},
    "trashLimit": {"type": "integer", "minimum": 0, "description": "how many deleted sessions the server keeps"}},
   "required": ["sessions", "limit", "trashLimit"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.list",
   "params": [],
   "result": {
    "name": "result",
    "value": {
     "limit": 1024,
     "sessions": [
      {
       "annotations": 1,
       "bookmarks": 1,
       "created": "2026-11-23T11:45:41Z",
       "edited": true,
       "lastUsed": "2026-11-23T11:45:42Z",
       "name": "main",
       "participants": 2,
       "people": [{"colour": "#0072b2", "name": "Grace"}, {"colour": "#4477aa", "name": "Ada"}],
       "rakes": 1,
       "session": "main",
       "surfaces": 1,
       "thumbnail": false},
      {
       "annotations": 0,
       "bookmarks": 0,
       "created": "2026-11-23T11:45:42Z",
       "edited": false,
       "lastUsed": "2026-11-23T11:45:42Z",
       "name": "wing tip",
       "participants": 0,
       "people": [],
       "rakes": 0,
       "session": "session-1",
       "surfaces": 0,
       "thumbnail": false}],
     "trashLimit": 256}}}]},
{
 "name": "session.join",
 "summary": "Enters a session. From now on its changes are sent to this WebSocket.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list or session.create; if left out, the share link's session, or else `main`",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list or session.create; if left out, the share link's session, or else `main`"}},
  {
   "name": "name",
   "required": false,
   "description": "display name",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "display name"}},
  {
   "name": "colour",
   "required": false,
   "description": "#rrggbb; if left out, a colour that few others have",
   "schema": {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$", "description": "#rrggbb; if left out, a colour that few others have"}},
  {
   "name": "resumeToken",
   "required": false,
   "description": "token of an earlier stay, to take up its place again",
   "schema": {"type": "string", "maxLength": 256, "description": "token of an earlier stay, to take up its place again"}},
  {
   "name": "lastSeq",
   "required": false,
   "description": "with `resumeToken`: the last `seq` seen; what was missed is returned instead of the snapshot",
   "schema": {
    "type": "integer",
    "minimum": 0,
    "maximum": 9007199254740992,
    "description": "with `resumeToken`: the last `seq` seen; what was missed is returned instead of the snapshot"}}],
 "result": {
  "name": "result",
  "description": "What session.join returns: either `snapshot` or `patches`.",
  "schema": {"$ref": "#/components/schemas/Joined"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true,
 "examples": [
  {
   "name": "session.join",
   "params": [{"name": "session", "value": "main"}, {"name": "name", "value": "Grace"}],
   "result": {
    "name": "result",
    "value": {
     "created": "2026-11-23T11:45:41Z",
     "participants": [
      {"colour": "#4477aa", "connected": true, "name": "Ada", "participant": "p1", "role": "host"},
      {"colour": "#0072b2", "connected": true, "name": "Grace", "participant": "p2", "role": "host"}],
     "resumeToken": "4129b22abbe8cbb4c9e014fc45317d9a",
     "resumed": false,
     "role": "host",
     "seq": 4,
     "snapshot": {
      "annotations": [{"annotation": "a1", "author": "Ada", "position": [0, 0, 0], "rev": 1, "surface": "s1", "text": "look"}],
      "bookmarks": [{"bookmark": "b1", "name": "here", "rev": 1, "time": 1.5, "view": {"camera": [1, 2]}}],
      "clock": {"from": null, "loop": false, "playing": false, "speed": 1, "time": null, "to": null},
      "name": "main",
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
        "seeds": 9}],
      "session": "main",
      "surfaces": [
       {
        "accuracy": "balanced",
        "angle": 20,
        "dataset": "lamb-oseen",
        "direction": "forward",
        "epoch": 1,
        "fields": [],
        "from": 0,
        "interpolation": "linear",
        "kind": "stream",
        "maxQuads": 1000000,
        "merge": 0.35,
        "rake": "r1",
        "rev": 1,
        "separation": 0.1,
        "stagnationSpeed": 1e-06,
        "surface": "s1",
        "to": 2}]},
     "you": "p2"}}}]},
{
 "name": "session.leave",
 "summary": "Leaves the session. Its changes are no longer sent.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [],
 "result": {"name": "result", "description": "an empty object", "schema": {"$ref": "#/components/schemas/Empty"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true,
 "examples": [{"name": "session.leave", "params": [], "result": {"name": "result", "value": {}}}]})json";

} // namespace wakesurf::protocol::openrpc
