// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_5 = R"json({
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
    "copy": {"type": "string", "minLength": 1, "maxLength": 256, "description": "for a link into a copy that session.fork has made: id of the copy"},
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
   "result": {"name": "result", "value": {}}}]},
{
 "name": "presence.update",
 "summary": "Shows the others what the caller points at, looks at, drags and has selected. What is left out stays as it is; null removes it. Best sent as a notification.",
 "tags": [{"name": "presence"}],
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
   "name": "pointer",
   "required": false,
   "description": "the point they point at",
   "schema": {
    "type": ["array", "null"],
    "minItems": 3,
    "maxItems": 3,
    "description": "the point they point at",
    "x-unit": "the dataset's unit of length",
    "items": {"type": "number"}}},
  {
   "name": "camera",
   "required": false,
   "description": "where they look from",
   "schema": {"anyOf": [{"$ref": "#/components/schemas/Camera"}, {"type": "null"}]}},
  {
   "name": "dragging",
   "required": false,
   "description": "the rake they drag",
   "schema": {"anyOf": [{"$ref": "#/components/schemas/DraggedRake"}, {"type": "null"}]}},
  {
   "name": "selected",
   "required": false,
   "description": "id of the record they have selected",
   "schema": {"type": ["string", "null"], "maxLength": 64, "description": "id of the record they have selected"}}],
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
   "name": "presence.update",
   "params": [
    {"name": "pointer", "value": [0.5, 0, 0.2]},
    {"name": "camera", "value": {"position": [4, -6, 3], "target": [0, 0, 0], "up": [0, 0, 1], "fov": 40}},
    {"name": "selected", "value": "r1"}],
   "result": {"name": "result", "value": {}}}]})json";

} // namespace wakesurf::protocol::openrpc
