// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_2 = R"json({
 "name": "session.list",
 "summary": "The sessions of this server; with a share link, its own.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "trash",
   "required": false,
   "description": "true: those that were deleted instead",
   "schema": {"type": "boolean", "default": false, "description": "true: those that were deleted instead"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "sessions": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/SessionEntry"}},
    "limit": {"type": "integer", "minimum": 0, "description": "how many sessions the server keeps"},
    "trashLimit": {"type": "integer", "minimum": 0, "description": "and how many deleted ones"}},
   "required": ["sessions", "limit", "trashLimit"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false},
{
 "name": "session.join",
 "summary": "Enters a session: its changes are told to this WebSocket from now on.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list or session.create; left out: the share link's, else `main`",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.list or session.create; left out: the share link's, else `main`"}},
  {
   "name": "name",
   "required": false,
   "description": "for people",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "for people"}},
  {
   "name": "colour",
   "required": false,
   "description": "#rrggbb; left out: one that few others have",
   "schema": {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$", "description": "#rrggbb; left out: one that few others have"}},
  {
   "name": "resumeToken",
   "required": false,
   "description": "of an earlier stay, to take up its place again",
   "schema": {"type": "string", "maxLength": 256, "description": "of an earlier stay, to take up its place again"}},
  {
   "name": "lastSeq",
   "required": false,
   "description": "with resumeToken: the last seq seen; what was missed comes instead of the snapshot",
   "schema": {
    "type": "integer",
    "minimum": 0,
    "maximum": 9007199254740992,
    "description": "with resumeToken: the last seq seen; what was missed comes instead of the snapshot"}}],
 "result": {
  "name": "result",
  "description": "What session.join answers: either `snapshot` or `patches`.",
  "schema": {"$ref": "#/components/schemas/Joined"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/overLimit"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true},
{
 "name": "session.leave",
 "summary": "Leaves the session joined; its changes are not told any more.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [],
 "result": {"name": "result", "description": "nothing", "schema": {"$ref": "#/components/schemas/Empty"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true},
{
 "name": "session.state",
 "summary": "Every record of a session.",
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
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "name": {"type": "string", "description": "for people"},
    "rakes": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Rake"}},
    "surfaces": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Surface"}},
    "bookmarks": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Bookmark"}},
    "annotations": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Annotation"}},
    "clock": {"$ref": "#/components/schemas/Clock"},
    "keptAside": {"$ref": "#/components/schemas/KeptAside"},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session now"},
    "participants": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Participant"}}},
   "required": ["session", "name", "rakes", "surfaces", "bookmarks", "annotations", "clock", "seq", "participants"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": false},
{
 "name": "session.rename",
 "summary": "Gives a session another name; everyone in it is told.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "name",
   "required": true,
   "description": "for people",
   "schema": {"type": "string", "maxLength": 120, "description": "for people"}},
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
  "description": "A session and what it is called.",
  "schema": {
   "type": "object",
   "description": "A session and what it is called.",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "name": {"type": "string", "description": "for people"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
   "required": ["session", "name"],
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
 "name": "session.delete",
 "summary": "Moves a session to the trash, from where session.restore brings it back for 30 days; its people are told, its share links let no one in meanwhile. `main` cannot be deleted.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": true,
   "description": "an id from session.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.list"}},
  {
   "name": "forever",
   "required": false,
   "description": "true: removes a session that is in the trash for good",
   "schema": {"type": "boolean", "default": false, "description": "true: removes a session that is in the trash for good"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "deletedUntil": {"type": "string", "description": "in UTC; it can be restored until then"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
   "required": ["session"],
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
 "name": "session.restore",
 "summary": "Brings a session back from the trash as it was, with its share links.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": true,
   "description": "an id from session.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from session.list"}}],
 "result": {
  "name": "result",
  "description": "A session and what it is called.",
  "schema": {
   "type": "object",
   "description": "A session and what it is called.",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "name": {"type": "string", "description": "for people"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
   "required": ["session", "name"],
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
 "x-websocketOnly": false},
{
 "name": "session.export",
 "summary": "A session as one document: its records, and the names and fingerprints of their datasets. A large one is refused here: GET /api/v1/sessions/SESSION/session.json answers with any.",
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
   "properties": {"file": {"$ref": "#/components/schemas/SessionFile"}},
   "required": ["file"],
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
 "x-websocketOnly": false},
{
 "name": "session.import",
 "summary": "Makes a new session of such a document. POST /api/v1/sessions takes larger documents than a message may be.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "file",
   "required": true,
   "description": "what session.export answered",
   "schema": {"type": "object", "description": "what session.export answered", "additionalProperties": true}},
  {
   "name": "name",
   "required": false,
   "description": "left out: the document's",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "left out: the document's"}}],
 "result": {
  "name": "result",
  "description": "what it answers",
  "schema": {
   "type": "object",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "name": {"type": "string", "description": "for people"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"},
    "notes": {"type": "array", "description": "for people: which datasets are not here, or are other ones", "items": {"type": "string"}},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
 "x-websocketOnly": false},
{
 "name": "session.thumbnail",
 "summary": "Keeps a small picture of the session for lists: the newest one sent. GET /api/v1/sessions/SESSION/thumbnail answers with it.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "image",
   "required": true,
   "description": "base64 of a PNG, JPEG or WebP picture of at most 24 KiB",
   "schema": {"type": "string", "maxLength": 65536, "description": "base64 of a PNG, JPEG or WebP picture of at most 24 KiB"}},
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
 "x-leastRole": "editor",
 "x-websocketOnly": false})json";

} // namespace wakesurf::protocol::openrpc
