// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_9 = R"json({
 "name": "time.set",
 "summary": "Jumps to a time. Path, streak and time surfaces are shown as they are at this time, within their own `from` and `to`.",
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
 "summary": "Starts the clock, from where it stands or from the beginning.",
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
