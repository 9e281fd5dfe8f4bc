// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_2 = R"json({
 "name": "dataset.suggest",
 "summary": "Returns a rake and the parameters of a surface of each kind to begin with, found in the data: the rake stands ahead of a body that the flow meets, else where the flow turns, else where it enters. All surfaces are shown at the same time. Reads one or two time-steps.",
 "tags": [{"name": "dataset"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "dataset",
   "required": true,
   "description": "an id from dataset.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "rake": {"$ref": "#/components/schemas/SuggestedRake"},
    "surfaces": {
     "type": "array",
     "description": "one of each kind that the data allow: a single time-step of an unsteady flow allows stream surfaces only",
     "items": {"$ref": "#/components/schemas/SuggestedSurface"}},
    "why": {"type": "string", "description": "what was chosen and why, for people"}},
   "required": ["rake", "surfaces", "why"],
   "additionalProperties": false}},
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
   "name": "dataset.suggest",
   "params": [{"name": "dataset", "value": "sphere"}],
   "result": {
    "name": "result",
    "value": {
     "rake": {"kind": "line", "points": [[-1.5, 0.05, -0.75], [-1.5, 0.05, 0.75]], "seeds": 32},
     "surfaces": [{"kind": "stream", "from": 0, "to": 14, "separation": 0.1}],
     "why": "The rake is ahead of a body, across the flow that meets it."}}}]},
{
 "name": "cache.status",
 "summary": "Reports which time-steps of a dataset are in memory.",
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
 "summary": "Makes a new session with the records of another and the time it shows, but without its people, links and history. With a share link, of any role, it copies the link's session only, and `key` lets you into the copy as an editor, for as long as your link is valid.",
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
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
    "name": {"type": "string", "description": "display name"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"},
    "key": {"type": "string", "description": "with a share link: secret key of a link into the copy; it is returned only this once"},
    "link": {"type": "string", "description": "with a share link: what to append to the address of the page"},
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
 "x-leastRole": "viewer",
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
     "trashLimit": 256}}}]})json";

} // namespace wakesurf::protocol::openrpc
