// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_1 = R"json({
 "name": "rpc.discover",
 "summary": "This description as an OpenRPC document: every method with its parameters.",
 "tags": [{"name": "rpc"}],
 "paramStructure": "by-name",
 "params": [],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {"openrpc": {"type": "string", "description": "the version of OpenRPC"}},
   "required": ["openrpc"],
   "additionalProperties": true}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false},
{
 "name": "server.info",
 "summary": "What this server is, what it offers, and what it grants.",
 "tags": [{"name": "server"}],
 "paramStructure": "by-name",
 "params": [],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "name": {"type": "string", "description": "wakesurf"},
    "version": {"type": "string", "description": "of the program"},
    "apiLevel": {"type": "integer", "minimum": 1, "description": "raised when a client of before could misunderstand the server"},
    "capabilities": {"type": "array", "description": "what a client may look for before it relies on it", "items": {"type": "string"}},
    "limits": {"$ref": "#/components/schemas/Limits"}},
   "required": ["name", "version", "apiLevel", "capabilities", "limits"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false},
{
 "name": "server.ping",
 "summary": "Answers at once: a client's heartbeat.",
 "tags": [{"name": "server"}],
 "paramStructure": "by-name",
 "params": [],
 "result": {"name": "result", "description": "nothing", "schema": {"$ref": "#/components/schemas/Empty"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false,
 "examples": [{"name": "server.ping", "params": [], "result": {"name": "result", "value": {}}}]},
{
 "name": "server.stats",
 "summary": "How long each stage from an edit to the socket took in the last minute, and how the server stands; with a share link only how its session does: participants, surfaces, stages and firstFrame.",
 "tags": [{"name": "server"}],
 "paramStructure": "by-name",
 "params": [],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "uptime": {"type": "number", "minimum": 0, "description": "since the start", "x-unit": "s"},
    "connections": {"type": "integer", "minimum": 0, "description": "open ones"},
    "clients": {"type": "integer", "minimum": 0, "description": "WebSockets"},
    "sessions": {"type": "integer", "minimum": 0, "description": "that the server keeps"},
    "participants": {"type": "integer", "minimum": 0, "description": "here now"},
    "surfaces": {"type": "integer", "minimum": 0, "description": "of all sessions, or of the link's"},
    "stages": {"$ref": "#/components/schemas/Stages"},
    "firstFrame": {"$ref": "#/components/schemas/Quantiles"},
    "cache": {"type": "array", "description": "one entry a dataset", "items": {"$ref": "#/components/schemas/CacheStanding"}},
    "memory": {"$ref": "#/components/schemas/MemoryStanding"},
    "messages": {"type": "integer", "minimum": 0, "description": "sent"},
    "frames": {"type": "integer", "minimum": 0, "description": "sent"},
    "bytes": {"type": "integer", "minimum": 0, "description": "sent", "x-unit": "bytes"},
    "keyframes": {"type": "integer", "minimum": 0, "description": "made for clients that were behind"},
    "dropped": {"type": "integer", "minimum": 0, "description": "updates that were left out"}},
   "required": ["participants", "surfaces", "stages", "firstFrame"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false},
{
 "name": "$/cancelRequest",
 "summary": "A notification: answers an open call of this WebSocket with -32800 at once and stops its work. What an edit has changed stays changed.",
 "tags": [{"name": "$"}],
 "paramStructure": "by-name",
 "params": [{"name": "id", "required": true, "description": "of the call", "schema": {"type": ["string", "number"], "description": "of the call"}}],
 "result": {"name": "result", "description": "nothing", "schema": {"$ref": "#/components/schemas/Empty"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true},
{
 "name": "dataset.list",
 "summary": "The datasets this server serves.",
 "tags": [{"name": "dataset"}],
 "paramStructure": "by-name",
 "params": [],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {"datasets": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/DatasetEntry"}}},
   "required": ["datasets"],
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
   "name": "dataset.list",
   "params": [],
   "result": {
    "name": "result",
    "value": {
     "datasets": [
      {"dataset": "lamb-oseen", "name": "lamb-oseen", "state": "ready", "steps": {"ready": 1, "total": 1}},
      {"dataset": "double-gyre", "name": "double-gyre", "state": "ready", "steps": {"ready": 21, "total": 21}}]}}}]},
{
 "name": "dataset.describe",
 "summary": "Grid, times, fields and lattice of one dataset, in the shape of `wakesurf info --json`, and what `fields` of surface.set may name.",
 "tags": [{"name": "dataset"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "dataset",
   "required": true,
   "description": "an id from dataset.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"}}],
 "result": {"name": "result", "description": "What a dataset is.", "schema": {"$ref": "#/components/schemas/Dataset"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false},
{
 "name": "dataset.open",
 "summary": "Answers once a dataset is imported; an import that was stopped goes on where it ended. $/cancelRequest ends the waiting, and the import with it when no one else waits; a connection that is lost ends no import. The state is importing when timeoutMs ran out, and incomplete where the import ended before the last time-step.",
 "tags": [{"name": "dataset"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "dataset",
   "required": true,
   "description": "an id from dataset.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"}},
  {
   "name": "timeoutMs",
   "required": false,
   "description": "patience; 0: no waiting",
   "schema": {"type": "integer", "minimum": 0, "maximum": 600000, "default": 600000, "description": "patience; 0: no waiting", "x-unit": "ms"}},
  {
   "name": "workDoneToken",
   "required": false,
   "description": "on a WebSocket: $/progress with this token tells how far the work is",
   "schema": {"type": ["string", "integer"], "description": "on a WebSocket: $/progress with this token tells how far the work is"}}],
 "result": {"name": "result", "description": "A dataset in a list.", "schema": {"$ref": "#/components/schemas/DatasetEntry"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/overLimit"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "dataset.open",
   "params": [{"name": "dataset", "value": "lamb-oseen"}, {"name": "timeoutMs", "value": 60000}],
   "result": {"name": "result", "value": {"dataset": "lamb-oseen", "name": "lamb-oseen", "state": "ready", "steps": {"ready": 1, "total": 1}}}}]},
{
 "name": "cache.status",
 "summary": "Which time-steps of a dataset are in memory.",
 "tags": [{"name": "cache"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "dataset",
   "required": true,
   "description": "an id from dataset.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"}}],
 "result": {"name": "result", "description": "Which time-steps are in memory.", "schema": {"$ref": "#/components/schemas/CacheStatus"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "cache.status",
   "params": [{"name": "dataset", "value": "lamb-oseen"}],
   "result": {"name": "result", "value": {"budget": 0, "bytes": 0, "dataset": "lamb-oseen", "steps": []}}}]},
{
 "name": "probe.sample",
 "summary": "Fields at points and one time, interpolated as the surfaces' vertices are.",
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
   "description": "where",
   "schema": {
    "type": "array",
    "maxItems": 4096,
    "description": "where",
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
   "description": "in the dataset's range",
   "schema": {"type": "number", "description": "in the dataset's range", "x-unit": "the dataset's unit of time"}},
  {
   "name": "fields",
   "required": false,
   "description": "the velocity's name or scalars; left out: the velocity",
   "schema": {"type": "array", "maxItems": 64, "description": "the velocity's name or scalars; left out: the velocity", "items": {"type": "string"}}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "values": {
     "type": "object",
     "description": "by the name of a field, one a point; null: none there",
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
    "inside": {"type": "array", "description": "which points are in the fluid", "items": {"type": "boolean"}}},
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
 "summary": "Makes a new, empty session. One without a name that no one edits, shares or is in goes again when there are too many; no other does.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "name",
   "required": false,
   "description": "for people",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "for people"}}],
 "result": {
  "name": "result",
  "description": "A new session.",
  "schema": {
   "type": "object",
   "description": "A new session.",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "name": {"type": "string", "description": "for people"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "x-websocketOnly": false},
{
 "name": "session.fork",
 "summary": "Makes a new session with the records of another, but none of its people, links and history. Not for share links.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "name",
   "required": false,
   "description": "for people",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "for people"}}],
 "result": {
  "name": "result",
  "description": "A new session.",
  "schema": {
   "type": "object",
   "description": "A new session.",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "name": {"type": "string", "description": "for people"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "x-websocketOnly": false})json";

} // namespace wakesurf::protocol::openrpc
