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
 "result": {
  "name": "result",
  "description": "Which time-steps are in memory, and how much of each.",
  "schema": {"$ref": "#/components/schemas/CacheStatus"}},
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
   "result": {"name": "result", "value": {"budget": 0, "bytes": 0, "bytesPerStep": 0, "dataset": "lamb-oseen", "held": [], "steps": []}}}]},
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
 "name": "family.make",
 "summary": "Carries a scalar along the streamlines of one time-step to all nodes of a dataset, and keeps it there as a scalar field: surfaces are coloured by it, files and probes have it. Answers once it is kept. $/cancelRequest, or a lost connection, ends the work, and nothing is kept.",
 "tags": [{"name": "family"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "dataset",
   "required": true,
   "description": "an id from dataset.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"}},
  {
   "name": "name",
   "required": true,
   "description": "name of the field, which no other field may have: letters, digits, and _ - .",
   "schema": {
    "type": "string",
    "minLength": 1,
    "maxLength": 64,
    "description": "name of the field, which no other field may have: letters, digits, and _ - ."}},
  {
   "name": "from",
   "required": true,
   "description": "where the scalar is given; inflow: on the boundary through which the flow enters; plane: on a plane; curve: it is the distance from a curve, in the plane of the curve, so that the level 0 is the stream surface through the curve",
   "schema": {
    "enum": ["inflow", "plane", "curve"],
    "description": "where the scalar is given; inflow: on the boundary through which the flow enters; plane: on a plane; curve: it is the distance from a curve, in the plane of the curve, so that the level 0 is the stream surface through the curve"}},
  {
   "name": "scalar",
   "required": false,
   "description": "of inflow and plane: x, y or z, or a scalar field of the dataset; empty: y",
   "schema": {
    "type": "string",
    "maxLength": 256,
    "default": "",
    "description": "of inflow and plane: x, y or z, or a scalar field of the dataset; empty: y"}},
  {
   "name": "point",
   "required": false,
   "description": "of a plane: a point of it",
   "schema": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "description": "of a plane: a point of it",
    "x-unit": "the dataset's unit of length",
    "items": {"type": "number"}}},
  {
   "name": "normal",
   "required": false,
   "description": "of a plane: its normal, of any length; the plane counts where the flow passes it the way that most of it does",
   "schema": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "description": "of a plane: its normal, of any length; the plane counts where the flow passes it the way that most of it does",
    "x-unit": "the dataset's unit of length",
    "items": {"type": "number"}}},
  {
   "name": "rakeKind",
   "required": false,
   "description": "of a curve: what the points are, as of a rake: a line, a polyline in one plane, or a circle",
   "schema": {
    "enum": ["line", "polyline", "circle", "points"],
    "description": "of a curve: what the points are, as of a rake: a line, a polyline in one plane, or a circle"}},
  {
   "name": "points",
   "required": false,
   "description": "of a curve: its points; the ends of a line or a polyline are continued straight",
   "schema": {
    "type": "array",
    "minItems": 2,
    "maxItems": 1024,
    "description": "of a curve: its points; the ends of a line or a polyline are continued straight",
    "items": {
     "type": "array",
     "minItems": 3,
     "maxItems": 3,
     "description": "[x, y, z], finite as 32-bit floats",
     "x-unit": "the dataset's unit of length",
     "items": {"type": "number"}}}},
  {
   "name": "time",
   "required": false,
   "description": "the nearest time-step is taken; if left out, the first one",
   "schema": {
    "type": "number",
    "minimum": -3.4028234663852886e+38,
    "maximum": 3.4028234663852886e+38,
    "description": "the nearest time-step is taken; if left out, the first one",
    "x-unit": "the dataset's unit of time"}},
  {
   "name": "accuracy",
   "required": false,
   "description": "how accurately particles are traced and vertices inserted",
   "schema": {
    "enum": ["fast", "balanced", "exact"],
    "default": "balanced",
    "description": "how accurately particles are traced and vertices inserted"}},
  {
   "name": "length",
   "required": false,
   "description": "how far a node is followed at most; if left out, ten diagonals of the domain",
   "schema": {
    "type": "number",
    "maximum": 1e+30,
    "exclusiveMinimum": 0,
    "description": "how far a node is followed at most; if left out, ten diagonals of the domain",
    "x-unit": "the dataset's unit of length"}},
  {
   "name": "workDoneToken",
   "required": false,
   "description": "on a WebSocket: $/progress reports the progress of the work with this token",
   "schema": {"type": ["string", "integer"], "description": "on a WebSocket: $/progress reports the progress of the work with this token"}}],
 "result": {
  "name": "result",
  "description": "A family of stream surfaces of a dataset, with what it was made from.",
  "schema": {"$ref": "#/components/schemas/Family"}},
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
 "x-leastRole": "editor",
 "x-websocketOnly": false,
 "examples": [
  {
   "name": "family.make",
   "params": [
    {"name": "dataset", "value": "sqcyl"},
    {"name": "name", "value": "psi"},
    {"name": "from", "value": "curve"},
    {"name": "rakeKind", "value": "line"},
    {"name": "points", "value": [[-2, 0.1, 1], [-2, 0.1, 2]]}],
   "result": {
    "name": "result",
    "value": {
     "name": "psi",
     "from": "curve",
     "rakeKind": "line",
     "points": [[-2, 0.1, 1], [-2, 0.1, 2]],
     "accuracy": "balanced",
     "length": 200,
     "version": "0.1.0",
     "steps": [{"index": 0, "time": 0, "nodes": 1000, "reached": 900, "atRest": 60, "obstacle": 20, "lost": 10, "outside": 10, "range": [-4, 4]}]}}}]},
{
 "name": "family.remove",
 "summary": "Removes a family, and its files. Surfaces that show it are shown without it.",
 "tags": [{"name": "family"}],
 "paramStructure": "by-name",
 "params": [
  {
   "name": "dataset",
   "required": true,
   "description": "an id from dataset.list",
   "schema": {"type": "string", "maxLength": 256, "description": "an id from dataset.list"}},
  {
   "name": "name",
   "required": true,
   "description": "name of the field: letters, digits, and _ - .",
   "schema": {"type": "string", "minLength": 1, "maxLength": 64, "description": "name of the field: letters, digits, and _ - ."}}],
 "result": {"name": "result", "description": "an empty object", "schema": {"$ref": "#/components/schemas/Empty"}},
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
   "name": "family.remove",
   "params": [{"name": "dataset", "value": "sqcyl"}, {"name": "name", "value": "psi"}],
   "result": {"name": "result", "value": {}}}]},
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
   "result": {"name": "result", "value": {"name": "wing tip", "remaining": 1022, "session": "session-1"}}}]})json";

} // namespace wakesurf::protocol::openrpc
