// Made by protocol/api/generate from *.schema.json: do not edit.
#include "protocol/api/base/methods.hpp"

#include <algorithm>
#include <array>

namespace wakesurf::protocol {

namespace {

using Names = std::string_view;

constexpr Names of_cancel_request[]{"id"};
constexpr Names of_dataset_describe[]{"dataset"};
constexpr Names of_dataset_open[]{"dataset", "timeoutMs", "velocity", "workDoneToken"};
constexpr Names of_dataset_suggest[]{"dataset"};
constexpr Names of_cache_status[]{"dataset"};
constexpr Names of_probe_sample[]{"dataset", "points", "time", "fields"};
constexpr Names of_family_make[]{"dataset", "name",     "from",     "scalar",
                                 "point",   "normal",   "rakeKind", "points",
                                 "time",    "accuracy", "length",   "workDoneToken"};
constexpr Names of_family_remove[]{"dataset", "name"};
constexpr Names of_session_create[]{"name"};
constexpr Names of_session_fork[]{"session", "name"};
constexpr Names of_session_list[]{"trash"};
constexpr Names of_session_join[]{"session", "name", "colour", "resumeToken", "lastSeq"};
constexpr Names of_session_state[]{"session"};
constexpr Names of_session_rename[]{"session", "name"};
constexpr Names of_session_set_units[]{"session", "length", "time"};
constexpr Names of_session_delete[]{"session", "forever"};
constexpr Names of_session_restore[]{"session"};
constexpr Names of_session_export[]{"session"};
constexpr Names of_session_import[]{"file", "name"};
constexpr Names of_session_thumbnail[]{"session", "image"};
constexpr Names of_session_share[]{"session", "role", "expiresIn"};
constexpr Names of_session_shares[]{"session"};
constexpr Names of_session_unshare[]{"session", "grant", "children"};
constexpr Names of_session_set_role[]{"session", "participant", "role"};
constexpr Names of_session_kick[]{"session", "participant"};
constexpr Names of_presence_update[]{"session", "pointer", "camera", "dragging", "selected"};
constexpr Names of_rake_set[]{"session", "rake",     "kind",  "points",  "seeds",   "name",
                              "colour",  "dragging", "force", "default", "gesture", "ifRev"};
constexpr Names of_rake_delete[]{"session", "rake", "force", "gesture", "ifRev"};
constexpr Names of_rake_list[]{"session"};
constexpr Names of_surface_set[]{"session",      "surface",    "rake",          "rake2",
                                 "dataset",      "kind",       "from",          "to",
                                 "direction",    "accuracy",   "interpolation", "refine",
                                 "releaseUntil", "life",       "sweep",         "field",
                                 "level",        "merge",      "angle",         "stagnationSpeed",
                                 "maxQuads",     "separation", "fields",        "default",
                                 "gesture",      "ifRev"};
constexpr Names of_surface_delete[]{"session", "surface", "gesture", "ifRev"};
constexpr Names of_surface_stop[]{"session", "surface"};
constexpr Names of_surface_list[]{"session"};
constexpr Names of_surface_stats[]{"session", "surface"};
constexpr Names of_surface_wait[]{"session", "surface", "epoch", "timeoutMs", "workDoneToken"};
constexpr Names of_surface_subscribe[]{"session", "surface", "from"};
constexpr Names of_surface_unsubscribe[]{"session", "subscription", "surface"};
constexpr Names of_frame_ack[]{"subscription", "epoch", "seq"};
constexpr Names of_bookmark_set[]{"session", "bookmark", "name", "view",
                                  "time",    "gesture",  "ifRev"};
constexpr Names of_bookmark_delete[]{"session", "bookmark", "gesture", "ifRev"};
constexpr Names of_bookmark_list[]{"session"};
constexpr Names of_annotation_set[]{"session", "annotation", "text", "position",
                                    "surface", "gesture",    "ifRev"};
constexpr Names of_annotation_delete[]{"session", "annotation", "gesture", "ifRev"};
constexpr Names of_annotation_list[]{"session"};
constexpr Names of_history_undo[]{"session"};
constexpr Names of_history_redo[]{"session"};
constexpr Names of_time_set[]{"session", "time"};
constexpr Names of_time_play[]{"session", "speed", "loop", "from", "to"};
constexpr Names of_time_pause[]{"session"};

constexpr MethodDescription described[]{
    {"rpc.discover", "viewer", false, false, false, false, {}},
    {"server.info", "viewer", false, false, false, false, {}},
    {"server.ping", "viewer", false, false, false, false, {}},
    {"server.stats", "viewer", false, false, false, false, {}},
    {"$/cancelRequest", "viewer", true, false, false, false, of_cancel_request},
    {"dataset.list", "viewer", false, false, false, false, {}},
    {"dataset.describe", "viewer", false, false, false, false, of_dataset_describe},
    {"dataset.open", "viewer", false, false, false, false, of_dataset_open},
    {"dataset.suggest", "viewer", false, false, false, false, of_dataset_suggest},
    {"cache.status", "viewer", false, false, false, false, of_cache_status},
    {"probe.sample", "viewer", false, false, false, false, of_probe_sample},
    {"family.make", "editor", false, false, false, false, of_family_make},
    {"family.remove", "editor", false, false, true, false, of_family_remove},
    {"session.create", "editor", false, true, true, false, of_session_create},
    {"session.fork", "viewer", false, true, false, false, of_session_fork},
    {"session.list", "viewer", false, false, false, false, of_session_list},
    {"session.join", "viewer", true, false, false, false, of_session_join},
    {"session.leave", "viewer", true, false, false, false, {}},
    {"session.state", "viewer", false, false, false, false, of_session_state},
    {"session.rename", "host", false, true, false, false, of_session_rename},
    {"session.setUnits", "editor", false, true, false, false, of_session_set_units},
    {"session.delete", "host", false, true, false, true, of_session_delete},
    {"session.restore", "editor", false, true, true, false, of_session_restore},
    {"session.export", "viewer", false, false, false, false, of_session_export},
    {"session.import", "editor", false, true, true, false, of_session_import},
    {"session.thumbnail", "editor", false, true, false, false, of_session_thumbnail},
    {"session.share", "host", false, true, false, false, of_session_share},
    {"session.shares", "host", false, false, false, false, of_session_shares},
    {"session.unshare", "host", false, true, false, false, of_session_unshare},
    {"session.setRole", "host", false, true, false, false, of_session_set_role},
    {"session.kick", "host", false, true, false, false, of_session_kick},
    {"presence.update", "viewer", true, false, false, false, of_presence_update},
    {"rake.set", "editor", false, true, false, false, of_rake_set},
    {"rake.delete", "editor", false, true, false, false, of_rake_delete},
    {"rake.list", "viewer", false, false, false, false, of_rake_list},
    {"surface.set", "editor", false, true, false, false, of_surface_set},
    {"surface.delete", "editor", false, true, false, false, of_surface_delete},
    {"surface.stop", "editor", false, false, false, false, of_surface_stop},
    {"surface.list", "viewer", false, false, false, false, of_surface_list},
    {"surface.stats", "viewer", false, false, false, false, of_surface_stats},
    {"surface.wait", "viewer", false, false, false, false, of_surface_wait},
    {"surface.subscribe", "viewer", true, false, false, false, of_surface_subscribe},
    {"surface.unsubscribe", "viewer", true, false, false, false, of_surface_unsubscribe},
    {"frame.ack", "viewer", true, false, false, false, of_frame_ack},
    {"bookmark.set", "editor", false, true, false, false, of_bookmark_set},
    {"bookmark.delete", "editor", false, true, false, false, of_bookmark_delete},
    {"bookmark.list", "viewer", false, false, false, false, of_bookmark_list},
    {"annotation.set", "editor", false, true, false, false, of_annotation_set},
    {"annotation.delete", "editor", false, true, false, false, of_annotation_delete},
    {"annotation.list", "viewer", false, false, false, false, of_annotation_list},
    {"history.undo", "editor", false, true, false, false, of_history_undo},
    {"history.redo", "editor", false, true, false, false, of_history_redo},
    {"time.set", "editor", false, false, false, false, of_time_set},
    {"time.play", "editor", false, false, false, false, of_time_play},
    {"time.pause", "editor", false, false, false, false, of_time_pause},
};

} // namespace

std::span<const MethodDescription> described_methods() {
    return described;
}

const MethodDescription* described_method(std::string_view name) {
    const auto found = std::ranges::find(described, name, &MethodDescription::name);
    return found == std::end(described) ? nullptr : &*found;
}

} // namespace wakesurf::protocol
