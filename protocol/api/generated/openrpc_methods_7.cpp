// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_7 = R"json({
 "name": "surface.stats",
 "summary": "Returns statistics of the newest state of a surface.",
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
  "description": "Statistics of the newest state of a surface, in the shape of `wakesurf surface --stats`.",
  "schema": {"$ref": "#/components/schemas/Statistics"}},
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
   "name": "surface.stats",
   "params": [{"name": "surface", "value": "s1"}, {"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {
     "approximated": 0,
     "complete": true,
     "epoch": 1,
     "kind": "stream",
     "maxEdge": 0.0997601,
     "requestedSeparation": 0.1,
     "coarsened": false,
     "pass": {"compute": 0.00434984, "encode": 0.00205174, "load": 8.7092e-05, "queue": 0.000258593},
     "peakBytes": 704000,
     "quads": 1263,
     "seconds": {"advect": 0.00235064, "load": 8.7092e-05, "other": 0.000975248, "refine": 0.00101074, "total": 0.00442372},
     "separation": 0.1,
     "stateSum": 2318211189,
     "steps": 48,
     "surface": "s1",
     "terminated": {"budget": 0, "domain": 0, "obstacle": 0, "stagnation": 0, "time": 104},
     "vertexSteps": 2669,
     "vertices": 1502}}}]},
{
 "name": "surface.wait",
 "summary": "Returns once the surface is complete; `complete` is false if the time ran out.",
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
   "description": "how long to wait, at most",
   "schema": {"type": "integer", "minimum": 0, "maximum": 600000, "description": "how long to wait, at most", "x-unit": "ms"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "epoch",
   "required": false,
   "description": "epoch to wait for: this one or a later one; if left out, the current one",
   "schema": {
    "type": "integer",
    "minimum": 0,
    "maximum": 4294967295,
    "description": "epoch to wait for: this one or a later one; if left out, the current one"}},
  {
   "name": "workDoneToken",
   "required": false,
   "description": "on a WebSocket: $/progress reports the progress of the work with this token",
   "schema": {"type": ["string", "integer"], "description": "on a WebSocket: $/progress reports the progress of the work with this token"}}],
 "result": {
  "name": "result",
  "description": "Statistics of the newest state of a surface, in the shape of `wakesurf surface --stats`.",
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
     "epoch": 1,
     "kind": "stream",
     "maxEdge": 0.0997601,
     "requestedSeparation": 0.1,
     "coarsened": false,
     "pass": {"compute": 0.00434984, "encode": 0.00205174, "load": 8.7092e-05, "queue": 0.000258593},
     "peakBytes": 704000,
     "quads": 1263,
     "seconds": {"advect": 0.00235064, "load": 8.7092e-05, "other": 0.000975248, "refine": 0.00101074, "total": 0.00442372},
     "separation": 0.1,
     "stateSum": 2318211189,
     "steps": 48,
     "surface": "s1",
     "terminated": {"budget": 0, "domain": 0, "obstacle": 0, "stagnation": 0, "time": 104},
     "vertexSteps": 2669,
     "vertices": 1502}}}]},
{
 "name": "surface.subscribe",
 "summary": "Sends the mesh of a surface as binary frames, now and after every change. It cannot be part of a batch.",
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
   "name": "from",
   "required": false,
   "description": "the last update that was applied before a connection was lost; the server goes on after it if possible",
   "schema": {
    "type": "object",
    "description": "the last update that was applied before a connection was lost; the server goes on after it if possible",
    "properties": {
     "epoch": {
      "type": "integer",
      "minimum": 0,
      "maximum": 4294967295,
      "description": "counts the surfaces that have been built for the record; it never decreases"},
     "seq": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "number of the update in its epoch"}},
    "required": ["epoch", "seq"],
    "additionalProperties": false}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "subscription": {"type": "integer", "minimum": 0, "description": "number of the subscription, as in the frames' headers"},
    "lattice": {"$ref": "#/components/schemas/Lattice"},
    "attributes": {"type": "array", "description": "names of the vertices' attributes, in the frames' order", "items": {"type": "string"}},
    "epoch": {
     "type": "integer",
     "minimum": 0,
     "maximum": 4294967295,
     "description": "counts the surfaces that have been built for the record; it never decreases"},
    "resumed": {"type": "boolean", "description": "true: the updates after `from` follow, and no keyframe"}},
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
 "summary": "Ends a subscription. A surface that someone had subscribed to, and that no one shows or waits for two seconds later, is not computed any further: until someone subscribes to it or waits for it.",
 "tags": [{"name": "surface"}],
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
   "name": "subscription",
   "required": false,
   "description": "number of the subscription; or give `surface` instead",
   "schema": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "number of the subscription; or give `surface` instead"}},
  {
   "name": "surface",
   "required": false,
   "description": "id of the surface, instead of the number",
   "schema": {"type": "string", "maxLength": 256, "description": "id of the surface, instead of the number"}}],
 "result": {"name": "result", "description": "an empty object", "schema": {"$ref": "#/components/schemas/Empty"}},
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
 "summary": "Reports the last update of a subscription that the client has applied. The server then sends at most eight updates beyond the reported one. Best sent as a notification.",
 "tags": [{"name": "frame"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "subscription",
   "required": true,
   "description": "number of the subscription",
   "schema": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "number of the subscription"}},
  {
   "name": "seq",
   "required": true,
   "description": "number of the update in its epoch",
   "schema": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "number of the update in its epoch"}},
  {
   "name": "epoch",
   "required": false,
   "description": "epoch of the update; if left out, the surface's current one",
   "schema": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "epoch of the update; if left out, the surface's current one"}}],
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
   "name": "frame.ack",
   "params": [{"name": "subscription", "value": 1}, {"name": "seq", "value": 0}, {"name": "epoch", "value": 1}],
   "result": {"name": "result", "value": {}}}]},
{
 "name": "bookmark.set",
 "summary": "Creates a bookmark, or replaces one as a whole.",
 "tags": [{"name": "bookmark"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "view",
   "required": true,
   "description": "camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text",
   "schema": {
    "type": "object",
    "description": "camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text",
    "additionalProperties": true}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "bookmark",
   "required": false,
   "description": "id of the bookmark to replace; if left out, a new one is created",
   "schema": {"type": "string", "maxLength": 256, "description": "id of the bookmark to replace; if left out, a new one is created"}},
  {
   "name": "name",
   "required": false,
   "description": "display name",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "display name"}},
  {
   "name": "time",
   "required": false,
   "description": "the session's time that belongs to the view",
   "schema": {
    "type": "number",
    "minimum": -3.4028234663852886e+38,
    "maximum": 3.4028234663852886e+38,
    "description": "the session's time that belongs to the view",
    "x-unit": "the dataset's unit of time"}},
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
    "bookmark": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the bookmark"},
    "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
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
   "result": {"name": "result", "value": {"bookmark": "b1", "rev": 1, "seq": 11}}}]})json";

} // namespace wakesurf::protocol::openrpc
