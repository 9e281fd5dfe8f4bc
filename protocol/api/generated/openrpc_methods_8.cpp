// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_8 = R"json({
 "name": "surface.list",
 "summary": "Lists the surfaces of a session.",
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
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {"surfaces": {"type": "array", "description": "all surfaces", "items": {"$ref": "#/components/schemas/Surface"}}},
   "required": ["surfaces"],
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
   "name": "surface.list",
   "params": [{"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {
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
       "refine": "on",
       "rev": 1,
       "separation": 0.1,
       "stagnationSpeed": 1e-06,
       "surface": "s1",
       "to": 2}]}}}]},
{
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
    "resumed": {"type": "boolean", "description": "true: the updates after `from` follow, and no keyframe"},
    "ranges": {
     "type": "array",
     "description": "what the values range over, of all states since the surface began to play: moving the clock, or the time at which the field of a stream surface is frozen, only widens them; another edit of the surface or its rake begins them anew",
     "items": {"$ref": "#/components/schemas/ValueRange"}}},
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
     "ranges": [{"attribute": "speed", "greatest": 1.5, "high": 1.5, "least": 0.2, "low": 0.2}],
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
   "result": {"name": "result", "value": {}}}]})json";

} // namespace wakesurf::protocol::openrpc
