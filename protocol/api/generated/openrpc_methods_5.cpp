// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/generated/openrpc_parts.hpp"

namespace wakesurf::protocol::openrpc {

const std::string_view methods_5 = R"json({
 "name": "surface.set",
 "summary": "Creates a surface, or replaces its record as a whole, and starts building it.",
 "tags": [{"name": "surface"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "rake",
   "required": true,
   "description": "an id from rake.list: the particles start there",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from rake.list: the particles start there"}},
  {
   "name": "dataset",
   "required": true,
   "description": "an id from dataset.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"}},
  {
   "name": "kind",
   "required": true,
   "description": "stream: of the field frozen at `from`; path: particles released at `from`; streak: particles released from `from` on; time: a patch of particles released at `from`",
   "schema": {
    "enum": ["stream", "path", "streak", "time"],
    "description": "stream: of the field frozen at `from`; path: particles released at `from`; streak: particles released from `from` on; time: a patch of particles released at `from`"}},
  {
   "name": "to",
   "required": true,
   "description": "the surface is shown until this time; the integration takes to - from",
   "schema": {
    "type": "number",
    "minimum": -3.4028234663852886e+38,
    "maximum": 3.4028234663852886e+38,
    "description": "the surface is shown until this time; the integration takes to - from",
    "x-unit": "the dataset's unit of time"}},
  {
   "name": "session",
   "required": false,
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "surface",
   "required": false,
   "description": "left out: create one",
   "schema": {"type": "string", "maxLength": 256, "description": "left out: create one"}},
  {
   "name": "rake2",
   "required": false,
   "description": "the patch lies between the rake and this one",
   "schema": {"type": "string", "maxLength": 256, "description": "the patch lies between the rake and this one", "x-only-for": ["time"]}},
  {
   "name": "from",
   "required": false,
   "description": "time of release; streak: of the first one; left out: the dataset's first time",
   "schema": {
    "type": "number",
    "minimum": -3.4028234663852886e+38,
    "maximum": 3.4028234663852886e+38,
    "description": "time of release; streak: of the first one; left out: the dataset's first time",
    "x-unit": "the dataset's unit of time"}},
  {
   "name": "direction",
   "required": false,
   "description": "which way in time particles go",
   "schema": {"enum": ["forward", "backward", "both"], "default": "forward", "description": "which way in time particles go"}},
  {
   "name": "accuracy",
   "required": false,
   "description": "of the integration, and of how vertices are put in",
   "schema": {"enum": ["fast", "balanced", "exact"], "default": "balanced", "description": "of the integration, and of how vertices are put in"}},
  {
   "name": "releaseUntil",
   "required": false,
   "description": "the release stops here; left out: at `to`",
   "schema": {
    "type": "number",
    "minimum": -3.4028234663852886e+38,
    "maximum": 3.4028234663852886e+38,
    "description": "the release stops here; left out: at `to`",
    "x-unit": "the dataset's unit of time",
    "x-only-for": ["streak"]}},
  {
   "name": "sweep",
   "required": false,
   "description": "the patch is the rake swept along this vector",
   "schema": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "description": "the patch is the rake swept along this vector",
    "x-unit": "the dataset's unit of length",
    "x-only-for": ["time"],
    "items": {"type": "number"}}},
  {
   "name": "merge",
   "required": false,
   "description": "cells smaller than this merge; 0: never",
   "schema": {
    "type": "number",
    "minimum": 0,
    "maximum": 0.5,
    "default": 0.35,
    "description": "cells smaller than this merge; 0: never",
    "x-unit": "part of the separation"}},
  {
   "name": "angle",
   "required": false,
   "description": "cells that meet at more than this are refined, as far as the separation and `maxQuads` allow; 180: never",
   "schema": {
    "type": "number",
    "maximum": 180,
    "exclusiveMinimum": 0,
    "default": 20,
    "description": "cells that meet at more than this are refined, as far as the separation and `maxQuads` allow; 180: never",
    "x-unit": "degrees"}},
  {
   "name": "stagnationSpeed",
   "required": false,
   "description": "a particle that is slower counts as at rest and ends; 0: only one that does not move at all",
   "schema": {
    "type": "number",
    "minimum": 0,
    "maximum": 0.1,
    "default": 1e-06,
    "description": "a particle that is slower counts as at rest and ends; 0: only one that does not move at all",
    "x-unit": "part of the largest speed"}},
  {
   "name": "maxQuads",
   "required": false,
   "description": "quads to build at most",
   "schema": {"type": "integer", "minimum": 1, "maximum": 4000000, "default": 1000000, "description": "quads to build at most"}},
  {
   "name": "separation",
   "required": false,
   "description": "the longest edge; left out: the dataset's finest spacing",
   "schema": {
    "type": "number",
    "exclusiveMinimum": 0,
    "description": "the longest edge; left out: the dataset's finest spacing",
    "x-unit": "the dataset's unit of length"}},
  {
   "name": "fields",
   "required": false,
   "description": "further attributes of the vertices, in frames and exports: scalar fields of the dataset, its velocity (the magnitude), `deformation`, `approximated`, `vorticity` (its magnitude), `q_criterion`",
   "schema": {
    "type": "array",
    "maxItems": 4,
    "default": [],
    "description": "further attributes of the vertices, in frames and exports: scalar fields of the dataset, its velocity (the magnitude), `deformation`, `approximated`, `vorticity` (its magnitude), `q_criterion`",
    "items": {"type": "string"}}},
  {
   "name": "default",
   "required": false,
   "description": "true: only if no one has edited the session and there is no such record yet; it counts as no edit, so undo does not turn it",
   "schema": {
    "type": "boolean",
    "default": false,
    "description": "true: only if no one has edited the session and there is no such record yet; it counts as no edit, so undo does not turn it"}},
  {
   "name": "gesture",
   "required": false,
   "description": "a name for what the user does; edits that follow each other with the same one are one step of undo",
   "schema": {
    "type": "string",
    "minLength": 1,
    "maxLength": 64,
    "description": "a name for what the user does; edits that follow each other with the same one are one step of undo"}},
  {
   "name": "ifRev",
   "required": false,
   "description": "refuse the edit if the record is at another revision",
   "schema": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "refuse the edit if the record is at another revision"}}],
 "result": {
  "name": "result",
  "description": "What surface.set answers.",
  "schema": {
   "type": "object",
   "description": "What surface.set answers.",
   "properties": {
    "surface": {"type": "string", "minLength": 1, "maxLength": 256, "description": "its id"},
    "rev": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "counts the edits of a record"},
    "epoch": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "counts the surfaces that a record has had; only grows"},
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
   "required": ["surface", "rev", "epoch", "seq"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/stale"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/outsideDomain"},
  {"$ref": "#/components/errors/outsideTimeRange"},
  {"$ref": "#/components/errors/overLimit"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "surface.set",
   "params": [
    {"name": "rake", "value": "r1"},
    {"name": "dataset", "value": "lamb-oseen"},
    {"name": "kind", "value": "stream"},
    {"name": "to", "value": 2},
    {"name": "session", "value": "main"},
    {"name": "from", "value": 0},
    {"name": "separation", "value": 0.1}],
   "result": {"name": "result", "value": {"epoch": 1, "rev": 1, "seq": 5, "surface": "s1"}}}]},
{
 "name": "surface.delete",
 "summary": "Deletes a surface.",
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
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}},
  {
   "name": "gesture",
   "required": false,
   "description": "a name for what the user does; edits that follow each other with the same one are one step of undo",
   "schema": {
    "type": "string",
    "minLength": 1,
    "maxLength": 64,
    "description": "a name for what the user does; edits that follow each other with the same one are one step of undo"}},
  {
   "name": "ifRev",
   "required": false,
   "description": "refuse the edit if the record is at another revision",
   "schema": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "refuse the edit if the record is at another revision"}}],
 "result": {
  "name": "result",
  "description": "Of the answer to an edit.",
  "schema": {
   "type": "object",
   "description": "Of the answer to an edit.",
   "properties": {
    "seq": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "of the session after the edit"},
    "durable": {"type": "boolean", "description": "the edit is on the server's disk; only there with --state"},
    "hint": {"type": "string", "description": "why it is not"}},
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
  {"$ref": "#/components/errors/overLimit"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "surface.delete",
   "params": [{"name": "surface", "value": "s2"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"seq": 17}}}]},
{
 "name": "surface.stop",
 "summary": "Stops computing a surface, for everyone, within 50 ms. What is there of it stays, and its statistics and surface.done say who stopped it; the next edit of it or its rake computes it again.",
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
    "epoch": {"type": "integer", "minimum": 0, "maximum": 4294967295, "description": "counts the surfaces that a record has had; only grows"},
    "stopped": {"type": "boolean", "description": "false: nothing was under way"}},
   "required": ["epoch", "stopped"],
   "additionalProperties": false}},
 "errors": [
  {"$ref": "#/components/errors/invalidParameters"},
  {"$ref": "#/components/errors/internal"},
  {"$ref": "#/components/errors/cancelled"},
  {"$ref": "#/components/errors/unauthenticated"},
  {"$ref": "#/components/errors/notPermitted"},
  {"$ref": "#/components/errors/notFound"},
  {"$ref": "#/components/errors/datasetError"}],
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "surface.stop",
   "params": [{"name": "surface", "value": "s2"}, {"name": "session", "value": "main"}],
   "result": {"name": "result", "value": {"epoch": 1, "stopped": false}}}]},
{
 "name": "surface.list",
 "summary": "The surfaces of a session.",
 "tags": [{"name": "surface"}],
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
   "properties": {"surfaces": {"type": "array", "description": "all of them", "items": {"$ref": "#/components/schemas/Surface"}}},
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
 "examples": [{"name": "surface.list", "params": [{"name": "session", "value": "main"}], "result": {"name": "result", "value": {"surfaces": []}}}]},
{
 "name": "surface.stats",
 "summary": "What the newest state of a surface is and took.",
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
   "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "description": "an id from session.list; may be left out on a WebSocket that has joined one, and with a share link"}}],
 "result": {
  "name": "result",
  "description": "What the newest state of a surface is and took, in the shape of `wakesurf surface --stats`.",
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
 "x-websocketOnly": false})json";

} // namespace wakesurf::protocol::openrpc
