// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_10 = R"json({
 "name": "history.undo",
 "summary": "Takes back the caller's newest edit, or a whole gesture (or drag) at once. It never undoes the work of others: an edit is skipped if someone else has changed its records since.",
 "tags": [{"name": "history"}],
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
   "properties": {
    "undone": {"type": ["array", "null"], "description": "what has changed; null: nothing", "items": {"$ref": "#/components/schemas/Change"}},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
    "skipped": {
     "type": "array",
     "description": "records that were skipped; their edits are forgotten for good",
     "items": {"$ref": "#/components/schemas/Skip"}},
    "undo": {"type": "integer", "minimum": 0, "description": "number of edits that can still be taken back"},
    "redo": {"type": "integer", "minimum": 0, "description": "number of edits that can be repeated"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["undone", "seq", "skipped", "undo", "redo"],
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
   "name": "history.undo",
   "params": [{"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {"redo": 1, "seq": 13, "skipped": [], "undo": 6, "undone": [{"id": "a1", "op": "delete", "type": "annotation"}]}}}]},
{
 "name": "history.redo",
 "summary": "Repeats the caller's newest edit that was taken back.",
 "tags": [{"name": "history"}],
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
   "properties": {
    "redone": {"type": ["array", "null"], "description": "what has changed; null: nothing", "items": {"$ref": "#/components/schemas/Change"}},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
    "skipped": {
     "type": "array",
     "description": "records that were skipped; their edits are forgotten for good",
     "items": {"$ref": "#/components/schemas/Skip"}},
    "undo": {"type": "integer", "minimum": 0, "description": "number of edits that can still be taken back"},
    "redo": {"type": "integer", "minimum": 0, "description": "number of edits that can be repeated"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["redone", "seq", "skipped", "undo", "redo"],
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
   "name": "history.redo",
   "params": [{"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {"redo": 0, "redone": [{"id": "a1", "op": "put", "rev": 2, "type": "annotation"}], "seq": 14, "skipped": [], "undo": 7}}}]},
{
 "name": "time.set",
 "summary": "Jumps to a time of the data. Path, streak and time surfaces are shown as they are at this time, within their own `from` and `to`. A time that neither the data of the session's surfaces nor a surface has is refused; any will do where a surface is of a flow that is steady or a formula.",
 "tags": [{"name": "time"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "time",
   "required": true,
   "description": "simulation time; null: no time, and surfaces are shown at their end",
   "schema": {
    "type": ["number", "null"],
    "minimum": -1e+30,
    "maximum": 1e+30,
    "description": "simulation time; null: no time, and surfaces are shown at their end",
    "x-unit": "the dataset's unit of time"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}}],
 "result": {"name": "result", "description": "The clock after the call.", "schema": {"$ref": "#/components/schemas/ClockAnswer"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/outsideTimeRange"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "time.set",
   "params": [{"name": "time", "value": 1}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"clock": {"from": null, "loop": false, "playing": false, "speed": 1, "time": 1, "to": null}}}}]},
{
 "name": "time.play",
 "summary": "Starts the clock, from where it stands or from the beginning. `from` and `to` are times of the data, as in `time.set`.",
 "tags": [{"name": "time"}],
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
   "name": "speed",
   "required": false,
   "description": "how fast the clock runs; if left out, as before, at first 1",
   "schema": {
    "type": "number",
    "minimum": 1e-09,
    "maximum": 1000000,
    "description": "how fast the clock runs; if left out, as before, at first 1",
    "x-unit": "simulation time a second"}},
  {
   "name": "loop",
   "required": false,
   "description": "true: go on at `from` when the clock reaches `to`; if left out, as before, at first false",
   "schema": {"type": "boolean", "description": "true: go on at `from` when the clock reaches `to`; if left out, as before, at first false"}},
  {
   "name": "from",
   "required": false,
   "description": "time at which playing starts; if left out, as before, at first where the first surface begins",
   "schema": {
    "type": "number",
    "minimum": -1e+30,
    "maximum": 1e+30,
    "description": "time at which playing starts; if left out, as before, at first where the first surface begins",
    "x-unit": "the dataset's unit of time"}},
  {
   "name": "to",
   "required": false,
   "description": "time at which playing ends; if left out, as before, at first where the last surface ends",
   "schema": {
    "type": "number",
    "minimum": -1e+30,
    "maximum": 1e+30,
    "description": "time at which playing ends; if left out, as before, at first where the last surface ends",
    "x-unit": "the dataset's unit of time"}}],
 "result": {"name": "result", "description": "The clock after the call.", "schema": {"$ref": "#/components/schemas/ClockAnswer"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/outsideTimeRange"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "time.play",
   "params": [
    {"name": "session", "value": "main"},
    {"name": "speed", "value": 2},
    {"name": "loop", "value": true},
    {"name": "from", "value": 0},
    {"name": "to", "value": 2}],
   "result": {"name": "result", "value": {"clock": {"from": 0, "loop": true, "playing": true, "speed": 2, "time": 1.00005, "to": 2}}}}]},
{
 "name": "time.pause",
 "summary": "Stops the clock where it is.",
 "tags": [{"name": "time"}],
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
 "result": {"name": "result", "description": "The clock after the call.", "schema": {"$ref": "#/components/schemas/ClockAnswer"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "time.pause",
   "params": [{"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"clock": {"from": 0, "loop": true, "playing": false, "speed": 2, "time": 1.00126, "to": 2}}}}]})json";

} // namespace wakesurf::protocol::openrpc
