// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_7 = R"json({
 "name": "annotation.set",
 "summary": "Creates an annotation, or replaces one as a whole; it keeps the name of the one who made it.",
 "tags": [{"name": "annotation"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "text",
   "required": true,
   "description": "of one line or several",
   "schema": {"type": "string", "maxLength": 4096, "description": "of one line or several"}},
  {
   "name": "position",
   "required": true,
   "description": "where it points to",
   "schema": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "description": "where it points to",
    "x-unit": "the dataset's unit of length",
    "items": {"type": "number"}}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "annotation",
   "required": false,
   "description": "left out: create one",
   "schema": {"type": "string", "maxLength": 256, "description": "left out: create one"}},
  {
   "name": "surface",
   "required": false,
   "description": "the surface it speaks of, which may be gone since",
   "schema": {"type": "string", "maxLength": 256, "description": "the surface it speaks of, which may be gone since"}},
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
    "annotation": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
   "required": ["annotation", "rev", "seq"],
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
   "name": "annotation.set",
   "params": [
    {"name": "text", "value": "look"},
    {"name": "position", "value": [0, 0, 0]},
    {"name": "session", "value": "main"},
    {"name": "surface", "value": "s1"}],
   "result": {"name": "result", "value": {"annotation": "a1", "rev": 1, "seq": 12}}}]},
{
 "name": "annotation.delete",
 "summary": "Deletes an annotation.",
 "tags": [{"name": "annotation"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "annotation",
   "required": true,
   "description": "an id from annotation.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from annotation.list"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
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
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "annotation.delete",
   "params": [{"name": "annotation", "value": "a1"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"seq": 16}}}]},
{
 "name": "annotation.list",
 "summary": "The annotations of a session.",
 "tags": [{"name": "annotation"}],
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
   "properties": {"annotations": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Annotation"}}},
   "required": ["annotations"],
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
   "name": "annotation.list",
   "params": [{"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {"annotations": [{"annotation": "a1", "author": "host", "position": [0, 0, 0], "rev": 1, "surface": "s1", "text": "look"}]}}}]},
{
 "name": "history.undo",
 "summary": "Takes back the caller's newest edit, a whole gesture (or drag) at once. Never undoes others' work: an edit whose records someone else has changed since is skipped.",
 "tags": [{"name": "history"}],
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
   "properties": {
    "undone": {"type": ["array", "null"], "description": "what has changed; null: nothing", "items": {"$ref": "#/components/schemas/Change"}},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"},
    "skipped": {"type": "array", "description": "edits that are forgotten, once and for all", "items": {"$ref": "#/components/schemas/Skip"}},
    "undo": {"type": "integer", "minimum": 0, "description": "edits that can still be taken back"},
    "redo": {"type": "integer", "minimum": 0, "description": "edits that can be made again"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "summary": "Makes the caller's newest undone edit again.",
 "tags": [{"name": "history"}],
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
   "properties": {
    "redone": {"type": ["array", "null"], "description": "what has changed; null: nothing", "items": {"$ref": "#/components/schemas/Change"}},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"},
    "skipped": {"type": "array", "description": "edits that are forgotten, once and for all", "items": {"$ref": "#/components/schemas/Skip"}},
    "undo": {"type": "integer", "minimum": 0, "description": "edits that can still be taken back"},
    "redo": {"type": "integer", "minimum": 0, "description": "edits that can be made again"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "summary": "Jumps to a time: path, streak and time surfaces are shown as they are then, within their own `from` and `to`.",
 "tags": [{"name": "time"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "time",
   "required": true,
   "description": "simulation time; null: no time, surfaces are shown at their end",
   "schema": {
    "type": ["number", "null"],
    "minimum": -1e+30,
    "maximum": 1e+30,
    "description": "simulation time; null: no time, surfaces are shown at their end",
    "x-unit": "the dataset's unit of time"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}}],
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
 "summary": "Lets the clock run, from where it stands or from the start.",
 "tags": [{"name": "time"}],
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
   "name": "speed",
   "required": false,
   "description": "how fast it runs; left out: as before, at first 1",
   "schema": {
    "type": "number",
    "minimum": 1e-09,
    "maximum": 1000000,
    "description": "how fast it runs; left out: as before, at first 1",
    "x-unit": "simulation time a second"}},
  {
   "name": "loop",
   "required": false,
   "description": "begin again at the end; left out: as before, at first not",
   "schema": {"type": "boolean", "description": "begin again at the end; left out: as before, at first not"}},
  {
   "name": "from",
   "required": false,
   "description": "left out: as before, at first where the first surface begins",
   "schema": {
    "type": "number",
    "minimum": -1e+30,
    "maximum": 1e+30,
    "description": "left out: as before, at first where the first surface begins",
    "x-unit": "the dataset's unit of time"}},
  {
   "name": "to",
   "required": false,
   "description": "left out: as before, at first where the last surface ends",
   "schema": {
    "type": "number",
    "minimum": -1e+30,
    "maximum": 1e+30,
    "description": "left out: as before, at first where the last surface ends",
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
   "result": {"name": "result", "value": {"clock": {"from": 0, "loop": true, "playing": true, "speed": 2, "time": 1.00005, "to": 2}}}}]})json";

} // namespace wakesurf::protocol::openrpc
