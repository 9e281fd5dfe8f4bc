// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_3 = R"json({
 "name": "session.share",
 "summary": "Makes a link that lets people into this session, in a role, until it expires or is taken back. The key is told this once; it works wherever the token does.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "role",
   "required": true,
   "description": "viewers look, editors edit, hosts also say who may be here",
   "schema": {"enum": ["viewer", "editor", "host"], "description": "viewers look, editors edit, hosts also say who may be here"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "expiresIn",
   "required": false,
   "description": "from now; left out: 7 days, or as long as the link you came by; null: until it is taken back",
   "schema": {
    "type": ["integer", "null"],
    "minimum": 1,
    "maximum": 316224000,
    "description": "from now; left out: 7 days, or as long as the link you came by; null: until it is taken back",
    "x-unit": "s"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "grant": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "role": {"enum": ["viewer", "editor", "host"], "description": "what someone may do: each role includes the one before"},
    "expires": {"type": "number", "description": "left out: never", "x-unit": "s since 1970"},
    "newcomers": {
     "enum": ["viewer", "editor"],
     "description": "where a host gave someone who came by it a lesser role: what those are who come by it from then on"},
    "madeBy": {"$ref": "#/components/schemas/ShareMaker"},
    "children": {"type": "integer", "minimum": 0, "description": "links in force that were made by it, or by those it made"},
    "key": {"type": "string", "description": "the secret of the link"},
    "link": {"type": "string", "description": "goes behind the page's address"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "x-websocketOnly": false},
{
 "name": "session.shares",
 "summary": "The links into this session that are in force, without their keys.",
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
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {"shares": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Share"}}},
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
 "x-websocketOnly": false},
{
 "name": "session.unshare",
 "summary": "Takes a link back; all who came by it are disconnected. Links that were made by it stay, unless `children` says otherwise.",
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
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "children",
   "required": false,
   "description": "also those made by it, and by those it made",
   "schema": {"type": "boolean", "default": false, "description": "also those made by it, and by those it made"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "children": {"type": "array", "description": "the links made by it that are still in force", "items": {"$ref": "#/components/schemas/Share"}},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "x-websocketOnly": false},
{
 "name": "session.setRole",
 "summary": "Sets what a participant may do here, from its next message on. A lesser role than that of the link they came by also holds for their other places, for calls without a place, and for all others who come by that link from now on.",
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
   "description": "viewers look, editors edit, hosts also say who may be here",
   "schema": {"enum": ["viewer", "editor", "host"], "description": "viewers look, editors edit, hosts also say who may be here"}},
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
    "participant": {"type": "string", "minLength": 1, "maxLength": 256, "description": "their id"},
    "role": {"enum": ["viewer", "editor", "host"], "description": "what someone may do: each role includes the one before"},
    "also": {"type": "array", "description": "other places of that person, which get the role too", "items": {"type": "string"}},
    "newcomers": {"enum": ["viewer", "editor"], "description": "the role of the people who come by that link from now on"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "x-websocketOnly": false},
{
 "name": "session.kick",
 "summary": "Disconnects a participant, whose place is lost. A link it came by stays good: take that back as well.",
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
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}}],
 "result": {
  "name": "result",
  "description": "nothing",
  "schema": {
   "type": "object",
   "description": "nothing",
   "properties": {
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "x-websocketOnly": false},
{
 "name": "presence.update",
 "summary": "Tells the others what one points at, looks at, drags and has selected. What is left out stays; null takes it away. Best sent as a notification.",
 "tags": [{"name": "presence"}],
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
   "name": "pointer",
   "required": false,
   "description": "what they point at",
   "schema": {
    "type": ["array", "null"],
    "minItems": 3,
    "maxItems": 3,
    "description": "what they point at",
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
   "description": "what they drag",
   "schema": {"anyOf": [{"$ref": "#/components/schemas/DraggedRake"}, {"type": "null"}]}},
  {
   "name": "selected",
   "required": false,
   "description": "id of the record they have selected",
   "schema": {"type": ["string", "null"], "maxLength": 64, "description": "id of the record they have selected"}}],
 "result": {"name": "result", "description": "nothing", "schema": {"$ref": "#/components/schemas/Empty"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true})json";

} // namespace wakesurf::protocol::openrpc
