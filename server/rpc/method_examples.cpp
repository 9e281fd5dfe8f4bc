#include "server/rpc/method_examples.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

nlohmann::json method_examples() {
    return nlohmann::json::parse(R"json({
"server.ping": {
    "params": {},
    "result": {}},
"dataset.list": {
    "params": {},
    "result": {"datasets": [{"dataset": "lamb-oseen", "name": "lamb-oseen", "state": "ready", "steps": {"ready": 1, "total": 1}}, {"dataset": "double-gyre", "name": "double-gyre", "state": "ready", "steps": {"ready": 21, "total": 21}}]}},
"dataset.open": {
    "params": {"dataset": "lamb-oseen", "timeoutMs": 60000},
    "result": {"dataset": "lamb-oseen", "name": "lamb-oseen", "state": "ready", "steps": {"ready": 1, "total": 1}}},
"cache.status": {
    "params": {"dataset": "lamb-oseen"},
    "result": {"budget": 0, "bytes": 0, "dataset": "lamb-oseen", "steps": []}},
"probe.sample": {
    "params": {"dataset": "lamb-oseen", "points": [[0, 0, 0], [50, 0, 0]], "time": 0},
    "result": {"inside": [true, false], "values": {"velocity": [[0, 0, 0.5], null]}}},
"rake.set": {
    "params": {"session": "main", "kind": "line", "points": [[0.2, 0, -1], [1, 0, -1]], "seeds": 9},
    "result": {"clipped": false, "points": [[0.2, 0, -1], [1, 0, -1]], "rake": "r1", "rev": 1, "seq": 1, "surfaces": []}},
"surface.set": {
    "params": {"session": "main", "rake": "r1", "kind": "stream", "dataset": "lamb-oseen", "to": 2, "separation": 0.1, "from": 0},
    "result": {"epoch": 1, "rev": 1, "seq": 5, "surface": "s1"}},
"surface.wait": {
    "params": {"session": "main", "surface": "s1", "timeoutMs": 60000},
    "result": {"approximated": 0, "complete": true, "crc": 1157798037, "epoch": 1, "kind": "stream", "maxEdge": 0.0997601, "pass": {"compute": 0.00289537, "encode": 0.000951646, "load": 2.1352e-05, "queue": 0.0264928}, "peakBytes": 704000, "quads": 1263, "seconds": {"advect": 0.00154239, "load": 2.1352e-05, "other": 0.000781874, "refine": 0.000532572, "total": 0.00287818}, "separation": 0.1, "steps": 48, "surface": "s1", "terminated": {"budget": 0, "domain": 0, "obstacle": 0, "stagnation": 0, "time": 104}, "vertexSteps": 2669, "vertices": 1502}},
"surface.stop": {
    "params": {"session": "main", "surface": "s2"},
    "result": {"epoch": 1, "stopped": false}},
"surface.subscribe": {
    "params": {"session": "main", "surface": "s1"},
    "result": {"attributes": ["speed", "s", "t"], "epoch": 1, "lattice": {"bits": 16, "origin": [-10.1, -10.1, -10.1], "step": 0.000308232}, "resumed": false, "subscription": 1}},
"surface.unsubscribe": {
    "params": {"subscription": 1},
    "result": {}},
"time.set": {
    "params": {"session": "main", "time": 1},
    "result": {"clock": {"from": null, "loop": false, "playing": false, "speed": 1, "time": 1, "to": null}}},
"time.play": {
    "params": {"session": "main", "speed": 2, "loop": true, "from": 0, "to": 2},
    "result": {"clock": {"from": 0, "loop": true, "playing": true, "speed": 2, "time": 1.00005, "to": 2}}},
"time.pause": {
    "params": {"session": "main"},
    "result": {"clock": {"from": 0, "loop": true, "playing": false, "speed": 2, "time": 1.00126, "to": 2}}},
"bookmark.set": {
    "params": {"session": "main", "name": "here", "view": {"camera": [1, 2]}, "time": 1.5},
    "result": {"bookmark": "b1", "rev": 1, "seq": 11}},
"annotation.set": {
    "params": {"session": "main", "text": "look", "position": [0, 0, 0], "surface": "s1"},
    "result": {"annotation": "a1", "rev": 1, "seq": 12}},
"bookmark.list": {
    "params": {"session": "main"},
    "result": {"bookmarks": [{"bookmark": "b1", "name": "here", "rev": 1, "time": 1.5, "view": {"camera": [1, 2]}}]}},
"annotation.list": {
    "params": {"session": "main"},
    "result": {"annotations": [{"annotation": "a1", "author": "host", "position": [0, 0, 0], "rev": 1, "surface": "s1", "text": "look"}]}},
"history.undo": {
    "params": {"session": "main"},
    "result": {"redo": 1, "seq": 13, "skipped": [], "undo": 6, "undone": [{"id": "a1", "op": "delete", "type": "annotation"}]}},
"history.redo": {
    "params": {"session": "main"},
    "result": {"redo": 0, "redone": [{"id": "a1", "op": "put", "rev": 2, "type": "annotation"}], "seq": 14, "skipped": [], "undo": 7}},
"bookmark.delete": {
    "params": {"session": "main", "bookmark": "b1"},
    "result": {"seq": 15}},
"annotation.delete": {
    "params": {"session": "main", "annotation": "a1"},
    "result": {"seq": 16}},
"surface.delete": {
    "params": {"session": "main", "surface": "s2"},
    "result": {"seq": 17}},
"rake.delete": {
    "params": {"session": "main", "rake": "r1"},
    "result": {"seq": 18}}
})json");
}

} // namespace wakesurf::server
