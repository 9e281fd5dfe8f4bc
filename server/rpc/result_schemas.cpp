#include "server/rpc/result_schemas.hpp"

#include <nlohmann/json.hpp>

#include <string_view>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// `#Name` is a reference, `name?` a member that may be missing; see complete().
constexpr std::string_view shapes = R"json({
"Empty": {"type": "object", "properties": {}},
"Id": {"type": "string", "minLength": 1},
"Count": {"type": "integer", "minimum": 0},
"Vector": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
"Lattice": {
  "type": "object", "description": "node (i, j, k) lies at origin + step * (i, j, k)",
  "properties": {
    "origin": "#Vector", "step": {"type": "number", "exclusiveMinimum": 0},
    "bits": {"type": "integer", "minimum": 1, "maximum": 20}}},
"Problem": {
  "type": "object", "description": "an error as a value, where the call itself did not fail",
  "properties": {
    "code": {"type": "integer"}, "message": {"type": "string"}, "kind": {"type": "string"},
    "hint": {"type": "string"}, "limit?": {"type": "number", "minimum": 0}}},
"ErrorData": {
  "type": "object", "additionalProperties": true,
  "properties": {
    "kind": {"type": "string", "description": "a word for programs"},
    "hint": {"type": "string", "description": "a sentence for people: what to do"},
    "current?": {"type": "object", "description": "of stale: the record as it is now"},
    "by?": {"type": "string", "description": "of leased: the participant who holds the rake"},
    "until?": {"type": "string", "description": "of leased: when the lease ends unless renewed, in UTC"},
    "retryAfterMs?": "#Count", "limit?": {"type": "number", "minimum": 0, "description": "of overLimit: the most that is granted"}}},
"DatasetEntry": {
  "type": "object",
  "properties": {
    "dataset": "#Id", "name": {"type": "string"}, "state": {"enum": ["ready", "importing", "failed", "stopped", "incomplete"]},
    "steps": {"type": "object", "properties": {"ready": "#Count", "total": "#Count"}},
    "progress?": {"type": "number", "minimum": 0, "maximum": 1},
    "remaining?": {"type": "number", "minimum": 0, "description": "seconds"}, "error?": "#Problem"}},
"Field": {
  "type": "object",
  "properties": {
    "name": {"type": "string"}, "components": {"type": "integer", "minimum": 1},
    "source": {"enum": ["point", "cell"]},
    "range": {"type": "array", "items": {"type": ["number", "null"]}, "minItems": 2, "maxItems": 2},
    "unit?": {"type": "string"}}},
"Dataset": {
  "type": "object",
  "properties": {
    "dataset": "#Id", "name": {"type": "string"}, "reader": {"type": "string"},
    "grid": {"enum": ["uniform", "rectilinear", "curvilinear", "unstructured", "analytic"]},
    "bounds": {
      "type": "array", "items": {"type": "number"}, "minItems": 6, "maxItems": 6,
      "description": "x0, x1, y0, y1, z0, z1"},
    "points": "#Count", "cells": "#Count", "times": {"type": "array", "items": {"type": "number"}},
    "steady": {"type": "boolean"}, "fields": {"type": "array", "items": "#Field"},
    "velocity": {"type": "string"},
    "why": {"type": "string", "description": "this field is the velocity because"},
    "obstacle": {"type": "boolean"}, "bytesPerStep": "#Count", "finestSpacing": {"type": "number", "minimum": 0},
    "lattice": "#Lattice",
    "surfaceFields": {
      "type": "array", "items": {"type": "string"}, "description": "what `fields` of surface.set may name"}, "note?": {"type": "string"}, "precision?": {"enum": ["half"]},
    "dimensions?": {"type": "array", "items": {"type": "integer"}, "minItems": 3, "maxItems": 3},
    "spacing?": "#Vector"}},
"Rake": {
  "type": "object",
  "properties": {
    "rake": "#Id", "rev": "#Count", "kind": {"enum": ["line", "polyline", "circle", "points"]},
    "points": {"type": "array", "items": "#Vector", "description": "as clipped to the domain"},
    "seeds": "#Count", "name": {"type": "string"}, "colour": {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$"},
    "author": {"type": "string", "description": "name of who made it"},
    "clipped": {"type": "boolean", "description": "a part was outside the domain"},
    "dragging": {"type": "boolean"},
    "leasedBy?": {"type": "string", "description": "the participant who drags it"}}},
"Surface": {
  "type": "object",
  "properties": {
    "surface": "#Id", "rev": "#Count", "epoch": "#Count", "rake": "#Id",
    "kind": {"enum": ["stream", "path", "streak", "time"]}, "dataset": "#Id", "from": {"type": "number"},
    "to": {"type": "number"}, "direction": {"enum": ["forward", "backward", "both"]},
    "separation": {"type": "number", "minimum": 0}, "accuracy": {"enum": ["fast", "balanced", "exact"]},
    "merge": {"type": "number"}, "angle": {"type": "number"}, "maxQuads": "#Count",
    "fields": {"type": "array", "items": {"type": "string"}}, "releaseUntil?": {"type": "number"},
    "sweep?": "#Vector", "rake2?": "#Id"}},
"PassSeconds": {
  "type": "object", "description": "what the pass that made the newest state took; queue: until it began",
  "properties": {
    "queue": {"type": "number", "minimum": 0}, "load": {"type": "number", "minimum": 0},
    "compute": {"type": "number", "minimum": 0}, "encode": {"type": "number", "minimum": 0}}},
"Statistics": {
  "type": "object",
  "properties": {
    "kind": {"enum": ["stream", "path", "streak", "time"]}, "quads": "#Count", "vertices": "#Count",
    "steps": "#Count", "vertexSteps": "#Count", "approximated": "#Count",
    "terminated": {
      "type": "object", "description": "particles by what ended them",
      "properties": {"domain": "#Count", "time": "#Count", "obstacle": "#Count", "stagnation": "#Count", "budget": "#Count"}},
    "maxEdge": {"type": "number", "minimum": 0}, "separation": {"type": "number", "minimum": 0},
    "seconds": {
      "type": "object",
      "properties": {
        "load": {"type": "number"}, "advect": {"type": "number"}, "refine": {"type": "number"},
        "other": {"type": "number"}, "total": {"type": "number"}}},
    "pass?": "#PassSeconds", "peakBytes": "#Count", "stopped?": {"type": "string", "description": "why the surface ends early"},
    "surface": "#Id", "epoch": "#Count",
    "complete": {"type": "boolean", "description": "the final surface of this epoch"},
    "crc": {"type": "integer", "minimum": 0, "description": "CRC-32C of the newest state, see State checksum"},
    "error?": "#Problem"}},
"Participant": {
  "type": "object",
  "properties": {
    "participant": "#Id", "name": {"type": "string"}, "colour": {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$"},
    "role": "#Role", "connected": {"type": "boolean"},
    "pointer?": "#Vector",
    "camera?": {
      "type": "object",
      "properties": {"position": "#Vector", "target": "#Vector", "up": "#Vector", "fov?": {"type": "number"}}},
    "dragging?": {
      "type": "object", "properties": {"rake": {"type": "string"}, "points": {"type": "array", "items": "#Vector"}}},
    "selected?": {"type": "string"}}},
"Quantiles": {
  "type": "object", "description": "in seconds, of the last minute",
  "properties": {"p50": {"type": "number"}, "p95": {"type": "number"}, "p99": {"type": "number"}, "count": "#Count"}},
"Role": {"enum": ["viewer", "editor", "host"]},
"Share": {
  "type": "object",
  "properties": {
    "grant": "#Id", "role": "#Role", "expires?": {"type": "number", "description": "seconds since 1970; left out: never"},
    "newcomers?": {"enum": ["viewer", "editor"], "description":
      "where a host gave someone who came by it a lesser role: what those are who come by it from then on"},
    "madeBy": {"type": "object", "properties": {
      "grant?": {"type": "string", "description": "the link its maker came by; left out: the server's own token"},
      "name": {"type": "string", "description": "of the participant; empty: a script"}}},
    "children": {"type": "integer", "minimum": 0, "description": "links in force that were made by it, or by those it made"}}},
"Bookmark": {
  "type": "object",
  "properties": {
    "bookmark": "#Id", "rev": "#Count", "name": {"type": "string"},
    "view": {"type": "object", "description": "as the client that made it likes"}, "time?": {"type": "number"}}},
"Annotation": {
  "type": "object",
  "properties": {
    "annotation": "#Id", "rev": "#Count", "text": {"type": "string"}, "position": "#Vector",
    "author": {"type": "string"}, "surface?": "#Id"}},
"Clock": {
  "type": "object",
  "properties": {
    "time": {"type": ["number", "null"], "description": "simulation time as the answer is written; null: never set"},
    "playing": {"type": "boolean"}, "speed": {"type": "number", "exclusiveMinimum": 0}, "loop": {"type": "boolean"},
    "from": {"type": ["number", "null"]}, "to": {"type": ["number", "null"]}}},
"KeptAside": {
  "type": "object", "description": "records that could not be used when the server started; nothing of them is deleted",
  "properties": {
    "count": "#Count",
    "records": {
      "type": "array", "description": "the newest of them",
      "items": {
        "type": "object",
        "properties": {
          "type": {"type": "string"}, "id": {"type": "string"}, "why": {"type": "string"},
          "since": {"type": "integer", "description": "seconds since 1970"}}}}}},
"Snapshot": {
  "type": "object",
  "properties": {
    "session": "#Id", "name": {"type": "string"}, "rakes": {"type": "array", "items": "#Rake"},
    "surfaces": {"type": "array", "items": "#Surface"}, "bookmarks": {"type": "array", "items": "#Bookmark"},
    "annotations": {"type": "array", "items": "#Annotation"}, "clock": "#Clock", "keptAside?": "#KeptAside"}},
"SessionName": {"type": "object", "properties": {"session": "#Id", "name": {"type": "string"}}},
"SessionFile": {
  "type": "object",
  "properties": {
    "wakesurfSession": {"enum": [1]}, "name": {"type": "string"},
    "exported": {"type": "string", "description": "UTC"},
    "wakesurf": {"type": "string", "description": "version"},
    "records": {
      "type": "object", "description": "as in a snapshot, without rev and epoch",
      "properties": {
        "rakes": {"type": "array", "items": {"type": "object", "additionalProperties": true}},
        "surfaces": {"type": "array", "items": {"type": "object", "additionalProperties": true}},
        "bookmarks": {"type": "array", "items": {"type": "object", "additionalProperties": true}},
        "annotations": {"type": "array", "items": {"type": "object", "additionalProperties": true}},
        "clock": "#Clock"}},
    "datasets": {
      "type": "array", "description": "that surfaces name; only the id of one that cannot be used just now",
      "items": {
        "type": "object",
        "properties": {
          "dataset": "#Id", "name?": {"type": "string"}, "fingerprint?": {"type": "string"},
          "times?": {
            "type": "object",
            "properties": {"count": "#Count", "first": {"type": "number"}, "last": {"type": "number"}}},
          "bounds?": {"type": "array", "items": {"type": "number"}, "minItems": 6, "maxItems": 6}}}}}},
"SessionEntry": {
  "type": "object",
  "properties": {
    "session": "#Id", "name": {"type": "string"},
    "participants": {"type": "integer", "minimum": 0, "description": "here now"},
    "people": {
      "type": "array", "description": "who was here; who came last comes first",
      "items": {"type": "object", "properties": {"name": {"type": "string"}, "colour": {"type": "string"}}}},
    "created?": {"type": "string", "description": "UTC; missing where the session is older than this was noted"},
    "lastUsed": {"type": "string", "description": "UTC"},
    "edited": {"type": "boolean", "description": "by anyone, beyond the page's default scene"},
    "rakes": "#Count", "surfaces": "#Count", "bookmarks": "#Count", "annotations": "#Count",
    "thumbnail": {"type": "boolean", "description": "there is a picture of it"},
    "deletedAt?": {"type": "string", "description": "UTC"},
    "deletedUntil?": {"type": "string", "description": "UTC; gone for good then"}}},
"Patch": {
  "type": "object",
  "properties": {
    "op": {"enum": ["put", "delete"]},
    "type": {"enum": ["rake", "surface", "bookmark", "annotation", "clock", "session"]},
    "id": "#Id",
    "record?": {"anyOf": ["#Rake", "#Surface", "#Bookmark", "#Annotation", "#Clock", "#SessionName"]}}},
"Changes": {
  "type": ["array", "null"],
  "items": {
    "type": "object",
    "properties": {
      "op": {"enum": ["put", "delete"]}, "type": {"type": "string"}, "id": "#Id", "rev?": "#Count"}}},
"Skipped": {
  "type": "array",
  "items": {
    "type": "object",
    "properties": {"type": {"type": "string"}, "id": "#Id", "why": {"type": "string"}}}}
})json";

constexpr std::string_view results = R"json({
"rpc.discover": {"type": "object", "additionalProperties": true, "properties": {"openrpc": {"type": "string"}}},
"server.info": {
  "type": "object",
  "properties": {
    "name": {"type": "string"}, "version": {"type": "string"}, "apiLevel": {"type": "integer", "minimum": 1},
    "capabilities": {"type": "array", "items": {"type": "string"}},
    "limits": {"type": "object", "additionalProperties": "#Count"}}},
"server.ping": "#Empty",
"server.stats": {
  "type": "object",
  "properties": {
    "uptime?": {"type": "number", "minimum": 0}, "connections?": "#Count", "clients?": "#Count", "sessions?": "#Count",
    "participants": "#Count", "surfaces": "#Count",
    "stages": {
      "type": "object",
      "properties": {
        "queue": "#Quantiles", "load": "#Quantiles", "advect": "#Quantiles", "refine": "#Quantiles",
        "encode": "#Quantiles", "send": "#Quantiles"}},
    "firstFrame": "#Quantiles",
    "cache?": {
      "type": "array",
      "items": {
        "type": "object",
        "properties": {
          "dataset": "#Id", "hits": "#Count", "loads": "#Count", "bytes": "#Count", "budget": "#Count"}}},
    "memory?": {"type": "object", "properties": {
        "rss": "#Count", "peak": "#Count", "budget": "#Count", "used": "#Count", "refused": "#Count",
        "byUse": {"type": "object", "additionalProperties": "#Count"}}},
    "messages?": "#Count", "frames?": "#Count", "bytes?": "#Count", "keyframes?": "#Count", "dropped?": "#Count"}},
"$/cancelRequest": "#Empty",
"dataset.list": {"type": "object", "properties": {"datasets": {"type": "array", "items": "#DatasetEntry"}}},
"dataset.describe": "#Dataset",
"dataset.open": "#DatasetEntry",
"cache.status": {
  "type": "object",
  "properties": {
    "dataset": "#Id", "steps": {"type": "array", "items": {"enum": ["resident", "loading", "cold"]}},
    "bytes": "#Count", "budget": "#Count"}},
"probe.sample": {
  "type": "object",
  "properties": {
    "values": {
      "type": "object",
      "additionalProperties": {"type": "array", "items": {"anyOf": [{"type": ["number", "null"]}, "#Vector"]}}},
    "inside": {"type": "array", "items": {"type": "boolean"}}}},
"session.create": {
  "type": "object",
  "properties": {
    "session": "#Id", "name": {"type": "string"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"}}},
"session.fork": {
  "type": "object",
  "properties": {
    "session": "#Id", "name": {"type": "string"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"}}},
"session.list": {
  "type": "object",
  "properties": {
    "sessions": {"type": "array", "items": "#SessionEntry"}, "limit": "#Count", "trashLimit": "#Count"}},
"session.rename": {"type": "object", "properties": {"session": "#Id", "name": {"type": "string"}}},
"session.delete": {"type": "object", "properties": {"session": "#Id", "deletedUntil?": {"type": "string"}}},
"session.restore": {"type": "object", "properties": {"session": "#Id", "name": {"type": "string"}}},
"session.export": {"type": "object", "properties": {"file": "#SessionFile"}},
"session.import": {
  "type": "object",
  "properties": {
    "session": "#Id", "name": {"type": "string"},
    "remaining": {"type": "integer", "minimum": 0, "description": "how many more sessions can be made"},
    "notes": {"type": "array", "items": {"type": "string"}, "description": "about datasets, for people"}}},
"session.thumbnail": {"type": "object", "properties": {}},
"session.join": {
  "type": "object",
  "properties": {
    "resumed": {"type": "boolean"}, "snapshot?": "#Snapshot", "patches?": {"type": "array", "items": "#Patch"},
    "seq": "#Count", "participants": {"type": "array", "items": "#Participant"}, "you": "#Id", "role": "#Role",
    "resumeToken": {"type": "string"},
    "created?": {"type": "string", "description": "UTC, as in session.list"}}},
"session.leave": "#Empty",
"session.state": {
  "type": "object",
  "properties": {
    "session": "#Id", "name": {"type": "string"}, "seq": "#Count", "rakes": {"type": "array", "items": "#Rake"},
    "surfaces": {"type": "array", "items": "#Surface"}, "bookmarks": {"type": "array", "items": "#Bookmark"},
    "annotations": {"type": "array", "items": "#Annotation"}, "clock": "#Clock", "keptAside?": "#KeptAside",
    "participants": {"type": "array", "items": "#Participant"}}},
"session.share": {
  "type": "object",
  "properties": {
    "grant": "#Id", "role": "#Role", "expires?": {"type": "number"}, "newcomers?": {"enum": ["viewer", "editor"]},
    "madeBy": {"type": "object", "properties": {"grant?": {"type": "string"}, "name": {"type": "string"}}},
    "children": {"type": "integer", "minimum": 0}, "key": {"type": "string"}, "link": {"type": "string"}}},
"session.shares": {"type": "object", "properties": {"shares": {"type": "array", "items": "#Share"}}},
"session.unshare": {"type": "object", "properties": {"children": {"type": "array", "items": "#Share"}}},
"session.setRole": {
  "type": "object",
  "properties": {
    "participant": "#Id", "role": "#Role", "also": {"type": "array", "items": {"type": "string"}},
    "newcomers?": {"enum": ["viewer", "editor"]}}},
"session.kick": {"type": "object", "properties": {}},
"presence.update": "#Empty",
"rake.set": {
  "type": "object",
  "properties": {
    "rake": "#Id", "rev": "#Count", "seq": "#Count", "clipped": {"type": "boolean"},
    "points": {"type": "array", "items": "#Vector"},
    "surfaces": {"type": "array", "items": {"type": "object", "properties": {"surface": "#Id", "epoch": "#Count"}}}}},
"rake.delete": {"type": "object", "properties": {"seq": "#Count"}},
"rake.list": {"type": "object", "properties": {"rakes": {"type": "array", "items": "#Rake"}}},
"bookmark.set": {"type": "object", "properties": {"bookmark": "#Id", "rev": "#Count", "seq": "#Count"}},
"bookmark.delete": {"type": "object", "properties": {"seq": "#Count"}},
"bookmark.list": {"type": "object", "properties": {"bookmarks": {"type": "array", "items": "#Bookmark"}}},
"annotation.set": {"type": "object", "properties": {"annotation": "#Id", "rev": "#Count", "seq": "#Count"}},
"annotation.delete": {"type": "object", "properties": {"seq": "#Count"}},
"annotation.list": {"type": "object", "properties": {"annotations": {"type": "array", "items": "#Annotation"}}},
"history.undo": {
  "type": "object",
  "properties": {"undone": "#Changes", "skipped": "#Skipped", "undo": "#Count", "redo": "#Count", "seq": "#Count"}},
"history.redo": {
  "type": "object",
  "properties": {"redone": "#Changes", "skipped": "#Skipped", "undo": "#Count", "redo": "#Count", "seq": "#Count"}},
"surface.set": {
  "type": "object", "properties": {"surface": "#Id", "rev": "#Count", "epoch": "#Count", "seq": "#Count"}},
"surface.stop": {"type": "object", "properties": {"epoch": "#Count", "stopped": {"type": "boolean"}}},
"surface.delete": {"type": "object", "properties": {"seq": "#Count"}},
"surface.list": {"type": "object", "properties": {"surfaces": {"type": "array", "items": "#Surface"}}},
"surface.stats": "#Statistics",
"surface.wait": "#Statistics",
"surface.subscribe": {
  "type": "object",
  "properties": {
    "subscription": "#Count", "lattice": "#Lattice",
    "attributes": {"type": "array", "items": {"type": "string"}}, "epoch": "#Count",
    "resumed": {"type": "boolean", "description": "what follows `from` comes, and no keyframe"}}},
"surface.unsubscribe": "#Empty",
"frame.ack": "#Empty",
"time.set": {"type": "object", "properties": {"clock": "#Clock"}},
"time.play": {"type": "object", "properties": {"clock": "#Clock"}},
"time.pause": {"type": "object", "properties": {"clock": "#Clock"}}
})json";

/// Writes out what the texts above leave to be understood: references; and that an object has the members it names, those
/// with a `?` perhaps, and no others.
void complete(json& schema) {
    if (schema.is_string() && schema.get_ref<const std::string&>().starts_with('#')) {
        schema = {{"$ref", "#/components/schemas/" + schema.get<std::string>().substr(1)}};
        return;
    }
    if (!schema.is_structured())
        return;
    for (json& each : schema)
        complete(each);
    if (!schema.is_object() || !schema.contains("properties"))
        return;
    json members = json::object();
    json required = json::array();
    for (const auto& [name, value] : schema["properties"].items()) {
        const bool optional = name.ends_with('?');
        members[name.substr(0, name.size() - (optional ? 1 : 0))] = value;
        if (!optional)
            required.push_back(name);
    }
    schema["properties"] = std::move(members);
    schema["required"] = std::move(required);
    if (!schema.contains("additionalProperties"))
        schema["additionalProperties"] = false;
}

json completed(std::string_view text) {
    json all = json::parse(text);
    for (json& schema : all)
        complete(schema);
    return all;
}

} // namespace

json shared_schemas() {
    return completed(shapes);
}

json result_schema(const Method& method) {
    static const json known = completed(results);
    const std::string_view own = method.traits.result_schema;
    const auto found = known.find(method.name);
    const bool generic = own == MethodTraits{}.result_schema;
    json schema = generic && found != known.end() ? *found : json::parse(own);
    if (!generic)
        complete(schema);
    if (method.traits.edits && schema.contains("properties")) { // see held_answer
        schema["properties"]["durable"] = {
            {"type", "boolean"},
            {"description", "kept on the server's disk; only there with --state"}};
        schema["properties"]["hint"] = {{"type", "string"}, {"description", "why it is not"}};
    }
    return schema;
}

} // namespace wakesurf::server
