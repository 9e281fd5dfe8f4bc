// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_9 = R"json({
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
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
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
  "description": "What every edit returns.",
  "schema": {
   "type": "object",
   "description": "What every edit returns.",
   "properties": {
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
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
 "summary": "Lists the bookmarks of a session.",
 "tags": [{"name": "bookmark"}],
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
   "properties": {"bookmarks": {"type": "array", "description": "all bookmarks", "items": {"$ref": "#/components/schemas/Bookmark"}}},
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
   "result": {"name": "result", "value": {"bookmarks": [{"bookmark": "b1", "name": "here", "rev": 1, "time": 1.5, "view": {"camera": [1, 2]}}]}}}]},
{
 "name": "annotation.set",
 "summary": "Creates an annotation, or replaces one as a whole. It keeps the name of the one who made it.",
 "tags": [{"name": "annotation"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "text",
   "required": true,
   "description": "text of one or more lines",
   "schema": {"type": "string", "maxLength": 4096, "description": "text of one or more lines"}},
  {
   "name": "position",
   "required": true,
   "description": "the point that it refers to",
   "schema": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "description": "the point that it refers to",
    "x-unit": "the dataset's unit of length",
    "items": {"type": "number"}}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
  {
   "name": "annotation",
   "required": false,
   "description": "id of the annotation to replace; if left out, a new one is created",
   "schema": {"type": "string", "maxLength": 256, "description": "id of the annotation to replace; if left out, a new one is created"}},
  {
   "name": "surface",
   "required": false,
   "description": "id of the surface that it refers to, which may have been deleted since",
   "schema": {"type": "string", "maxLength": 256, "description": "id of the surface that it refers to, which may have been deleted since"}},
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
    "annotation": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the annotation"},
    "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
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
   "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link"}},
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
  "description": "What every edit returns.",
  "schema": {
   "type": "object",
   "description": "What every edit returns.",
   "properties": {
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session after the edit"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
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
 "summary": "Lists the annotations of a session.",
 "tags": [{"name": "annotation"}],
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
   "properties": {"annotations": {"type": "array", "description": "all annotations", "items": {"$ref": "#/components/schemas/Annotation"}}},
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
    "value": {"annotations": [{"annotation": "a1", "author": "host", "position": [0, 0, 0], "rev": 1, "surface": "s1", "text": "look"}]}}}]})json";

} // namespace wakesurf::protocol::openrpc
