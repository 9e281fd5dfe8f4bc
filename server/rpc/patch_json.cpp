#include "server/rpc/patch_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

json patch_json(const protocol::RakeRecord& record) {
    return {{"op", "put"},
            {"type", "rake"},
            {"id", record.rake},
            {"record", protocol::rake_json(record)}};
}

json patch_json(const protocol::SurfaceRecord& record) {
    return {{"op", "put"},
            {"type", "surface"},
            {"id", record.surface},
            {"record", protocol::surface_json(record)}};
}

json patch_json(const protocol::BookmarkRecord& record) {
    return {{"op", "put"},
            {"type", "bookmark"},
            {"id", record.bookmark},
            {"record", protocol::bookmark_json(record)}};
}

json patch_json(const protocol::AnnotationRecord& record) {
    return {{"op", "put"},
            {"type", "annotation"},
            {"id", record.annotation},
            {"record", protocol::annotation_json(record)}};
}

json patch_json(const protocol::ClockRecord& record) {
    return {{"op", "put"},
            {"type", "clock"},
            {"id", "clock"},
            {"record", protocol::clock_json(record)}};
}

json patch_json(const SessionName& session) {
    json record{{"session", session.session}, {"name", session.name}};
    if (!session.units.empty())
        record["units"] = protocol::units_json(session.units);
    return {
        {"op", "put"}, {"type", "session"}, {"id", session.session}, {"record", std::move(record)}};
}

json patch_json(const DeletedRecord& record) {
    return {{"op", "delete"}, {"type", record.type}, {"id", record.id}};
}

} // namespace

json patches_json(std::span<const Patch> patches) {
    json list = json::array();
    for (const Patch& patch : patches)
        list.push_back(std::visit([](const auto& each) { return patch_json(each); }, patch));
    return list;
}

} // namespace wakesurf::server
