// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_3 = R"json({
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
     "trashLimit": 256}}}]},
{
 "name": "session.join",
 "summary": "Enters a session. From now on its changes are sent to this WebSocket.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list or session.create; if left out, the share link's session, or else `main`",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list or session.create; if left out, the share link's session, or else `main`"}},
  {
   "name": "name",
   "required": false,
   "description": "display name",
   "schema": {"type": "string", "maxLength": 120, "default": "", "description": "display name"}},
  {
   "name": "colour",
   "required": false,
   "description": "#rrggbb; if left out, a colour that few others have",
   "schema": {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$", "description": "#rrggbb; if left out, a colour that few others have"}},
  {
   "name": "resumeToken",
   "required": false,
   "description": "token of an earlier stay, to take up its place again",
   "schema": {"type": "string", "maxLength": 256, "description": "token of an earlier stay, to take up its place again"}},
  {
   "name": "lastSeq",
   "required": false,
   "description": "with `resumeToken`: the last `seq` seen; what was missed is returned instead of the snapshot",
   "schema": {
    "type": "integer",
    "minimum": 0,
    "maximum": 9007199254740992,
    "description": "with `resumeToken`: the last `seq` seen; what was missed is returned instead of the snapshot"}}],
 "result": {
  "name": "result",
  "description": "What session.join returns: either `snapshot` or `patches`.",
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
 "x-websocketOnly": true,
 "examples": [
  {
   "name": "session.join",
   "params": [{"name": "session", "value": "main"}, {"name": "name", "value": "Grace"}],
   "result": {
    "name": "result",
    "value": {
     "created": "2026-11-23T11:45:41Z",
     "participants": [
      {"colour": "#4477aa", "connected": true, "name": "Ada", "participant": "p1", "role": "host"},
      {"colour": "#0072b2", "connected": true, "name": "Grace", "participant": "p2", "role": "host"}],
     "resumeToken": "4129b22abbe8cbb4c9e014fc45317d9a",
     "resumed": false,
     "role": "host",
     "seq": 4,
     "snapshot": {
      "annotations": [{"annotation": "a1", "author": "Ada", "position": [0, 0, 0], "rev": 1, "surface": "s1", "text": "look"}],
      "bookmarks": [{"bookmark": "b1", "name": "here", "rev": 1, "time": 1.5, "view": {"camera": [1, 2]}}],
      "clock": {"from": null, "loop": false, "playing": false, "speed": 1, "time": null, "to": null},
      "name": "main",
      "rakes": [
       {
        "author": "Ada",
        "clipped": false,
        "colour": "#0072b2",
        "dragging": false,
        "kind": "line",
        "name": "r1",
        "points": [[0.2, 0, -1], [1, 0, -1]],
        "rake": "r1",
        "rev": 1,
        "seeds": 9}],
      "session": "main",
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
        "to": 2}]},
     "you": "p2"}}}]},
{
 "name": "session.leave",
 "summary": "Leaves the session. Its changes are no longer sent.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [],
 "result": {"name": "result", "description": "an empty object", "schema": {"$ref": "#/components/schemas/Empty"}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"}],
 "x-leastRole": "viewer",
 "x-websocketOnly": true,
 "examples": [{"name": "session.leave", "params": [], "result": {"name": "result", "value": {}}}]},
{
 "name": "session.state",
 "summary": "Returns all records of a session.",
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
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
    "name": {"type": "string", "description": "display name"},
    "units": {"$ref": "#/components/schemas/Units"},
    "rakes": {"type": "array", "description": "all rakes", "items": {"$ref": "#/components/schemas/Rake"}},
    "surfaces": {"type": "array", "description": "all surfaces", "items": {"$ref": "#/components/schemas/Surface"}},
    "bookmarks": {"type": "array", "description": "all bookmarks", "items": {"$ref": "#/components/schemas/Bookmark"}},
    "annotations": {"type": "array", "description": "all annotations", "items": {"$ref": "#/components/schemas/Annotation"}},
    "clock": {"$ref": "#/components/schemas/Clock"},
    "keptAside": {"$ref": "#/components/schemas/KeptAside"},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "`seq` of the session now"},
    "participants": {"type": "array", "description": "all participants", "items": {"$ref": "#/components/schemas/Participant"}}},
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
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.state",
   "params": [{"name": "session", "value": "main"}],
   "result": {
    "name": "result",
    "value": {
     "annotations": [{"annotation": "a1", "author": "Ada", "position": [0, 0, 0], "rev": 1, "surface": "s1", "text": "look"}],
     "bookmarks": [{"bookmark": "b1", "name": "here", "rev": 1, "time": 1.5, "view": {"camera": [1, 2]}}],
     "clock": {"from": null, "loop": false, "playing": false, "speed": 1, "time": null, "to": null},
     "name": "main",
     "participants": [
      {
       "camera": {"fov": 40, "position": [4, -6, 3], "target": [0, 0, 0], "up": [0, 0, 1]},
       "colour": "#4477aa",
       "connected": true,
       "name": "Ada",
       "participant": "p1",
       "pointer": [0.5, 0, 0.2],
       "role": "host",
       "selected": "r1"},
      {"colour": "#0072b2", "connected": true, "name": "Grace", "participant": "p2", "role": "host"}],
     "rakes": [
      {
       "author": "Ada",
       "clipped": false,
       "colour": "#0072b2",
       "dragging": false,
       "kind": "line",
       "name": "r1",
       "points": [[0.2, 0, -1], [1, 0, -1]],
       "rake": "r1",
       "rev": 1,
       "seeds": 9}],
     "seq": 4,
     "session": "main",
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
 "name": "session.rename",
 "summary": "Renames a session. Everyone in it is notified.",
 "tags": [{"name": "session"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "name",
   "required": true,
   "description": "display name",
   "schema": {"type": "string", "maxLength": 120, "description": "display name"}},
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
  "description": "The id and the name of a session, and its units.",
  "schema": {
   "type": "object",
   "description": "The id and the name of a session, and its units.",
   "properties": {
    "session": {"type": "string", "minLength": 1, "maxLength": 256, "description": "id of the session"},
    "name": {"type": "string", "description": "display name"},
    "units": {"$ref": "#/components/schemas/Units"},
    "durable": {"type": "boolean", "description": "true: the edit is on the server's disk; only present if the server runs with --state"},
    "hint": {"type": "string", "description": "why the edit is not on the disk"}},
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
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "session.rename",
   "params": [{"name": "name", "value": "tip vortex"}, {"name": "session", "value": "session-2"}],
   "result": {"name": "result", "value": {"name": "tip vortex", "session": "session-2"}}}]})json";

} // namespace wakesurf::protocol::openrpc
