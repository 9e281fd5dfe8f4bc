// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_4 = R"json({
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
   "result": {"name": "result", "value": {}}}]},
{
 "name": "session.share",
 "summary": "Makes a link that lets people into this session, in a role, until it expires or is revoked. The key is returned only this once; it works wherever the token does.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "role",
   "required": true,
   "description": "viewers look, editors edit, hosts also decide who may be here",
   "schema": {"enum": ["viewer", "editor", "host"], "description": "viewers look, editors edit, hosts also decide who may be here"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "expiresIn",
   "required": false,
   "description": "how long the link is valid; if left out, 7 days, or as long as the link you came by; null: until it is revoked",
   "schema": {
    "type": ["integer", "null"],
    "minimum": 1,
    "maximum": 316224000,
    "description": "how long the link is valid; if left out, 7 days, or as long as the link you came by; null: until it is revoked",
    "x-unit": "s"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "grant": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the link"},
    "role": {"enum": ["viewer", "editor", "host"], "description": "role of those who come by it"},
    "expires": {"type": "number", "description": "when the link expires; if left out, never", "x-unit": "s since 1970"},
    "newcomers": {
     "enum": ["viewer", "editor"],
     "description": "role of those who come by it from now on; present if a host has given someone who came by it a lower role"},
    "madeBy": {"$ref": "#/components/schemas/ShareMaker"},
    "children": {"type": "integer", "minimum": 0, "description": "number of valid links that were made through this one, directly or indirectly"},
    "key": {"type": "string", "description": "secret key of the link"},
    "link": {"type": "string", "description": "what to append to the address of the page"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["grant", "role", "madeBy", "children", "key", "link"],
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
   "name": "session.share",
   "params": [{"name": "role", "value": "viewer"}, {"name": "session", "value": "main"}, {"name": "expiresIn", "value": 3600}],
   "result": {
    "name": "result",
    "value": {
     "children": 0,
     "expires": 1795437942,
     "grant": "g1",
     "key": "943db84bd03195fd1eb227dc8e5e2429133ab28b4926ba2ce02f5400bad5b390",
     "link": "#session=main&token=943db84bd03195fd1eb227dc8e5e2429133ab28b4926ba2ce02f5400bad5b390",
     "madeBy": {"name": "Ada"},
     "role": "viewer"}}}]},
{
 "name": "session.shares",
 "summary": "Lists the valid links into this session, without their keys.",
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
   "properties": {"shares": {"type": "array", "description": "all valid links", "items": {"$ref": "#/components/schemas/Share"}}},
   "required": ["shares"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"}],
 "x-leastRole": "host",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.shares",
   "params": [{"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {"shares": [{"children": 0, "expires": 1795437942, "grant": "g1", "madeBy": {"name": "Ada"}, "role": "viewer"}]}}}]},
{
 "name": "session.unshare",
 "summary": "Revokes a link. Everyone who came by it is disconnected. Links that were made through it stay valid, unless `children` is true.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "grant",
   "required": true,
   "description": "an id from session.shares",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.shares"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "children",
   "required": false,
   "description": "true: also revoke the links that were made through it, directly or indirectly",
   "schema": {"type": "boolean", "default": false, "description": "true: also revoke the links that were made through it, directly or indirectly"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "children": {"type": "array", "description": "links made through it that are still valid", "items": {"$ref": "#/components/schemas/Share"}},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["children"],
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
   "name": "session.unshare",
   "params": [{"name": "grant", "value": "g1"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"children": []}}}]},
{
 "name": "session.setRole",
 "summary": "Sets what a participant may do here, from their next message on. A role below that of the link they came by also applies to their other places, to calls without a place, and to everyone else who comes by that link from now on.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "participant",
   "required": true,
   "description": "an id from session.state",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.state"}},
  {
   "name": "role",
   "required": true,
   "description": "viewers look, editors edit, hosts also decide who may be here",
   "schema": {"enum": ["viewer", "editor", "host"], "description": "viewers look, editors edit, hosts also decide who may be here"}},
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
    "participant": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the participant"},
    "role": {"enum": ["viewer", "editor", "host"], "description": "the role they have now"},
    "also": {"type": "array", "description": "ids of the same person's other places, which get the role too", "items": {"type": "string"}},
    "newcomers": {"enum": ["viewer", "editor"], "description": "role of those who come by that link from now on"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
   "required": ["participant", "role", "also"],
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
   "name": "session.setRole",
   "params": [{"name": "participant", "value": "p2"}, {"name": "role", "value": "viewer"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"also": [], "participant": "p2", "role": "viewer"}}}]},
{
 "name": "session.kick",
 "summary": "Disconnects a participant, who loses their place. The link they came by stays valid; revoke it as well to keep them out.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "participant",
   "required": true,
   "description": "an id from session.state",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.state"}},
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
 "x-leastRole": "host",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.kick",
   "params": [{"name": "participant", "value": "p2"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {}}}]})json";

} // namespace wakesurf::protocol::openrpc
