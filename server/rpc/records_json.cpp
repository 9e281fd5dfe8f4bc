#include "server/rpc/records_json.hpp"

#include "server/rpc/aside_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

template <class R>
json list(const Session& session, json (*write)(const R&)) {
    json out = json::array();
    for (const auto& [id, record] : session.records().all<R>())
        out.push_back(write(record));
    return out;
}

} // namespace

json rakes_json(const Session& session) {
    return list(session, protocol::rake_json);
}

json surfaces_json(const Session& session) {
    return list(session, protocol::surface_json);
}

json bookmarks_json(const Session& session) {
    return list(session, protocol::bookmark_json);
}

json annotations_json(const Session& session) {
    return list(session, protocol::annotation_json);
}

json records_json(const Session& session) {
    json out{{"session", session.id()},
             {"name", session.name()},
             {"rakes", rakes_json(session)},
             {"surfaces", surfaces_json(session)},
             {"bookmarks", bookmarks_json(session)},
             {"annotations", annotations_json(session)},
             {"clock", protocol::clock_json(session.clock().record())}};
    if (!session.units().empty())
        out["units"] = protocol::units_json(session.units());
    if (!session.kept_aside().empty())
        out["keptAside"] = kept_aside_json(session);
    return out;
}

} // namespace wakesurf::server
