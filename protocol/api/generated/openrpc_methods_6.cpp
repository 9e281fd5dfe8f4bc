// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_6 = R"json({
 "name": "surface.wait",
 "summary": "Answers once the surface is complete; `complete` is false when the time ran out.",
 "tags": [{"name": "surface"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "surface",
   "required": true,
   "description": "an id from surface.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from surface.list"}},
  {
   "name": "timeoutMs",
   "required": true,
   "description": "patience",
   "schema": {"type": "integer", "minimum": 0, "maximum": 600000, "description": "patience", "x-unit": "ms"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "epoch",
   "required": false,
   "description": "this one or a later one; left out: the current",
   "schema": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "this one or a later one; left out: the current"}},
  {
   "name": "workDoneToken",
   "required": false,
   "description": "on a WebSocket: $/progress with this token tells how far the work is",
   "schema": {"type": ["string", "integer"], "description": "on a WebSocket: $/progress with this token tells how far the work is"}}],
 "result": {
  "name": "result",
  "description": "What the newest state of a surface is and took, in the shape of `wakesurf surface --stats`.",
  "schema": {"$ref": "#/components/schemas/Statistics"}},
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
   "name": "surface.wait",
   "params": [{"name": "surface", "value": "s1"}, {"name": "timeoutMs", "value": 60000}, {"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {
     "approximated": 0,
     "complete": true,
     "stateSum": 1157798037,
     "epoch": 1,
     "kind": "stream",
     "maxEdge": 0.0997601,
     "pass": {"compute": 0.00289537, "encode": 0.000951646, "load": 2.1352e-05, "queue": 0.0264928},
     "peakBytes": 704000,
     "quads": 1263,
     "seconds": {"advect": 0.00154239, "load": 2.1352e-05, "other": 0.000781874, "refine": 0.000532572, "total": 0.00287818},
     "separation": 0.1,
     "steps": 48,
     "surface": "s1",
     "terminated": {"budget": 0, "domain": 0, "obstacle": 0, "stagnation": 0, "time": 104},
     "vertexSteps": 2669,
     "vertices": 1502}}}]},
{
 "name": "surface.subscribe",
 "summary": "Sends the mesh of a surface, now and after every change, as binary frames. Cannot be part of a batch.",
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
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "from",
   "required": false,
   "description": "the newest update folded before a lost connection: go on after it if possible",
   "schema": {
    "type": "object",
    "description": "the newest update folded before a lost connection: go on after it if possible",
    "properties": {
     "epoch": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "counts the surfaces that a record has had; only grows"},
     "seq": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "of the update in its epoch"}},
    "required": ["epoch", "seq"],
    "additionalProperties": false}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "subscription": {"type": "integer", "minimum": 0, "description": "the number in the frames' headers"},
    "lattice": {"$ref": "#/components/schemas/Lattice"},
    "attributes": {"type": "array", "description": "of the vertices, in the frames' order", "items": {"type": "string"}},
    "epoch": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "counts the surfaces that a record has had; only grows"},
    "resumed": {"type": "boolean", "description": "what follows `from` comes, and no keyframe"}},
   "required": ["subscription", "lattice", "attributes", "epoch", "resumed"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/outsideTimeRange"},
  {"$ref": "#/components/errors/overLimit"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true,
 "examples": [
  {
   "name": "surface.subscribe",
   "params": [{"name": "surface", "value": "s1"}, {"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {
     "attributes": ["speed", "s", "t"],
     "epoch": 1,
     "lattice": {"bits": 16, "origin": [-10.1, -10.1, -10.1], "step": 0.000308232},
     "resumed": false,
     "subscription": 1}}}]},
{
 "name": "surface.unsubscribe",
 "summary": "Ends a subscription.",
 "tags": [{"name": "surface"}],
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
   "name": "subscription",
   "required": false,
   "description": "the number, or name the surface",
   "schema": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "the number, or name the surface"}},
  {
   "name": "surface",
   "required": false,
   "description": "instead of the number",
   "schema": {"type": "string", "maxLength": 256, "description": "instead of the number"}}],
 "result": {"name": "result", "description": "nothing", "schema": {"$ref": "#/components/schemas/Empty"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true,
 "examples": [{"name": "surface.unsubscribe", "params": [{"name": "subscription", "value": 1}], "result": {"name": "result", "value": {}}}]},
{
 "name": "frame.ack",
 "summary": "Says up to which update a subscription's frames have been folded. A client that does so is sent at most eight updates more than that; meant as a notification.",
 "tags": [{"name": "frame"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "subscription",
   "required": true,
   "description": "the number",
   "schema": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "the number"}},
  {
   "name": "seq",
   "required": true,
   "description": "of the update in its epoch",
   "schema": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "of the update in its epoch"}},
  {
   "name": "epoch",
   "required": false,
   "description": "left out: the surface's current one",
   "schema": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "left out: the surface's current one"}}],
 "result": {"name": "result", "description": "nothing", "schema": {"$ref": "#/components/schemas/Empty"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true},
{
 "name": "bookmark.set",
 "summary": "Creates a bookmark, or replaces one as a whole.",
 "tags": [{"name": "bookmark"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "view",
   "required": true,
   "description": "camera, colours and the like, as the client that made it likes; at most 4 KiB as JSON text",
   "schema": {
    "type": "object",
    "description": "camera, colours and the like, as the client that made it likes; at most 4 KiB as JSON text",
    "additionalProperties": true}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "bookmark",
   "required": false,
   "description": "left out: create one",
   "schema": {"type": "string", "maxLength": 256, "description": "left out: create one"}},
  {
   "name": "name",
   "required": false,
   "description": "for people",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "for people"}},
  {
   "name": "time",
   "required": false,
   "description": "the session's time the view belongs to",
   "schema": {
    "type": "number",
    "minimum": -3.4028234663852886e+38,
    "maximum": 3.4028234663852886e+38,
    "description": "the session's time the view belongs to",
    "x-unit": "the dataset's unit of time"}},
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
    "bookmark": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
   "required": ["bookmark", "rev", "seq"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/stale"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/outsideTimeRange"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "bookmark.set",
   "params": [
    {"name": "view", "value": {"camera": [1, 2]}},
    {"name": "session", "value": "main"},
    {"name": "name", "value": "here"},
    {"name": "time", "value": 1.5}],
   "result": {"name": "result", "value": {"bookmark": "b1", "rev": 1, "seq": 11}}}]},
{
 "name": "bookmark.delete",
 "summary": "Deletes a bookmark.",
 "tags": [{"name": "bookmark"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "bookmark",
   "required": true,
   "description": "an id from bookmark.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from bookmark.list"}},
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
   "name": "bookmark.delete",
   "params": [{"name": "bookmark", "value": "b1"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"seq": 15}}}]},
{
 "name": "bookmark.list",
 "summary": "The bookmarks of a session.",
 "tags": [{"name": "bookmark"}],
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
   "properties": {"bookmarks": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Bookmark"}}},
   "required": ["bookmarks"],
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
   "name": "bookmark.list",
   "params": [{"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"bookmarks": [{"bookmark": "b1", "name": "here", "rev": 1, "time": 1.5, "view": {"camera": [1, 2]}}]}}}]})json";

} // namespace wakesurf::protocol::openrpc
