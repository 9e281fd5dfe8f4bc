// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_4 = R"json({
 "name": "session.setUnits",
 "summary": "Sets the units in which lengths and times are read. They only name what the numbers of the data mean: no number changes. Everyone in the session is notified.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "length",
   "required": true,
   "description": "unit of lengths; empty: as in dataset.describe",
   "schema": {"type": "string", "maxLength": 32, "description": "unit of lengths; empty: as in dataset.describe"}},
  {
   "name": "time",
   "required": true,
   "description": "unit of times; empty: as in dataset.describe",
   "schema": {"type": "string", "maxLength": 32, "description": "unit of times; empty: as in dataset.describe"}},
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
  "description": "The id and the name of a session, and its units.",
  "schema": {
   "type": "object",
   "description": "The id and the name of a session, and its units.",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
    "name": {"type": "string", "description": "display name"},
    "units": {"$ref": "#/components/schemas/Units"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["session", "name"],
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
   "name": "session.setUnits",
   "params": [{"name": "length", "value": "mm"}, {"name": "time", "value": "s"}, {"name": "session", "value": "session-2"}],
   "result": {"name": "result", "value": {"name": "tip vortex", "session": "session-2", "units": {"length": "mm", "time": "s"}}}}]},
{
 "name": "session.delete",
 "summary": "Moves a session to the trash, from which session.restore can bring it back for 30 days. The people in it are notified, and meanwhile its share links let no one in. `main` cannot be deleted. Who copied a session by a share link may delete the copy as long as no one has edited, named or shared it and no one else is in it; it is gone for good then.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": true,
   "description": "an id from session.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.list"}},
  {
   "name": "forever",
   "required": false,
   "description": "true: permanently deletes a session that is in the trash",
   "schema": {"type": "boolean", "default": false, "description": "true: permanently deletes a session that is in the trash"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
    "deletedUntil": {"type": "string", "description": "until when the session can be restored, in UTC"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["session"],
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
   "name": "session.delete",
   "params": [{"name": "session", "value": "session-2"}],
   "result": {"name": "result", "value": {"deletedUntil": "2026-12-23T11:45:42Z", "session": "session-2"}}}]},
{
 "name": "session.restore",
 "summary": "Brings a session back from the trash as it was, with its share links.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": true,
   "description": "an id from session.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.list"}}],
 "result": {
  "name": "result",
  "description": "The id and the name of a session, and its units.",
  "schema": {
   "type": "object",
   "description": "The id and the name of a session, and its units.",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
    "name": {"type": "string", "description": "display name"},
    "units": {"$ref": "#/components/schemas/Units"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["session", "name"],
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
   "name": "session.restore",
   "params": [{"name": "session", "value": "session-2"}],
   "result": {"name": "result", "value": {"name": "tip vortex", "session": "session-2"}}}]},
{
 "name": "session.export",
 "summary": "Returns a session as one document: its records, and the names and fingerprints of their datasets. A large session is refused here; GET /api/v1/sessions/SESSION/session.json returns sessions of any size.",
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
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {"file": {"$ref": "#/components/schemas/SessionFile"}},
   "required": ["file"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.export",
   "params": [{"name": "session", "value": "session-2"}],
   "result": {
    "name": "result",
    "value": {
     "file": {
      "datasets": [
       {
        "bounds": [-10, 10, -10, 10, -10, 10],
        "dataset": "lamb-oseen",
        "fingerprint": "0ad4b1a18c3ba722d822772ded1fe63aa4cf9b3853ced52ae51b69a1e31c7c7d",
        "name": "lamb-oseen",
        "times": {"count": 1, "first": 0, "last": 0}}],
      "exported": "2026-11-23T11:45:42Z",
      "name": "tip vortex",
      "records": {
       "annotations": [{"annotation": "a1", "author": "Ada", "position": [0, 0, 0], "surface": "s1", "text": "look"}],
       "bookmarks": [{"bookmark": "b1", "name": "here", "time": 1.5, "view": {"camera": [1, 2]}}],
       "clock": {"from": null, "loop": false, "playing": false, "speed": 1, "time": null, "to": null},
       "rakes": [
        {
         "author": "Ada",
         "clipped": false,
         "colour": "#0072b2",
         "kind": "line",
         "name": "r1",
         "points": [[0.2, 0, -1], [1, 0, -1]],
         "rake": "r1",
         "seeds": 9}],
       "surfaces": [
        {
         "accuracy": "balanced",
         "angle": 20,
         "dataset": "lamb-oseen",
         "direction": "forward",
         "fields": [],
         "from": 0,
         "interpolation": "linear",
         "kind": "stream",
         "maxQuads": 1000000,
         "merge": 0.35,
         "rake": "r1",
         "refine": "on",
         "separation": 0.1,
         "stagnationSpeed": 1e-06,
         "surface": "s1",
         "to": 2}]},
      "wakesurf": "0.1.0",
      "wakesurfSession": 1}}}}]},
{
 "name": "session.import",
 "summary": "Makes a new session from a document of session.export. POST /api/v1/sessions takes documents that are too large for a message.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "file",
   "required": true,
   "description": "the `file` that session.export returned",
   "schema": {"type": "object", "description": "the `file` that session.export returned", "additionalProperties": true}},
  {
   "name": "name",
   "required": false,
   "description": "name of the new session; if left out, the name in the document",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "name of the new session; if left out, the name in the document"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
    "name": {"type": "string", "description": "display name"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"},
    "notes": {
     "type": "array",
     "description": "for people: which datasets this server does not have, or which differ here",
     "items": {"type": "string"}},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["session", "name", "remaining", "notes"],
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
   "name": "session.import",
   "params": [
    {
     "name": "file",
     "value": {
      "datasets": [],
      "exported": "2026-11-23T11:45:42Z",
      "name": "wing tip",
      "records": {
       "annotations": [],
       "bookmarks": [],
       "clock": {"from": null, "loop": false, "playing": false, "speed": 1, "time": null, "to": null},
       "rakes": [
        {
         "author": "a script",
         "clipped": false,
         "colour": "#0072b2",
         "kind": "line",
         "name": "r1",
         "points": [[0.2, 0, -1], [1, 0, -1]],
         "rake": "r1",
         "seeds": 9}],
       "surfaces": []},
      "wakesurf": "0.1.0",
      "wakesurfSession": 1}},
    {"name": "name", "value": "twin"}],
   "result": {"name": "result", "value": {"name": "twin", "notes": [], "remaining": 1020, "session": "session-3"}}}]},
{
 "name": "session.thumbnail",
 "summary": "Stores a small picture of the session for lists; it replaces the one before. GET /api/v1/sessions/SESSION/thumbnail returns it.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "image",
   "required": true,
   "description": "a PNG, JPEG or WebP picture of at most 24 KiB, in base64",
   "schema": {"type": "string", "maxLength": 65536, "description": "a PNG, JPEG or WebP picture of at most 24 KiB, in base64"}},
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
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.thumbnail",
   "params": [
    {"name": "image", "value": "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="},
    {"name": "session", "value": "session-2"}],
   "result": {"name": "result", "value": {}}}]})json";

} // namespace wakesurf::protocol::openrpc
