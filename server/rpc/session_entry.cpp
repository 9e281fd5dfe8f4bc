#include "server/rpc/session_entry.hpp"

#include "protocol/api/utc_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace wakesurf::server {

using nlohmann::json;

namespace {

json profile_json(const protocol::SessionProfile& profile) {
    json people = json::array();
    for (const auto& each : profile.people)
        people.push_back({{"name", each.name}, {"colour", each.colour}});
    json out{{"people", std::move(people)},
             {"lastUsed", protocol::utc_text(profile.last_used)},
             {"edited", profile.edited}};
    if (profile.created)
        out["created"] = protocol::utc_text(*profile.created);
    return out;
}

void add_counts(json& out, const std::array<std::size_t, record_types.size()>& records) {
    for (const RecordType type : record_types)
        out[std::string(name(type)) + "s"] = records[static_cast<std::size_t>(type)];
}

} // namespace

json session_entry(const Session& session, std::int64_t now) {
    const std::size_t here = session.participants().present().size();
    protocol::SessionProfile profile = session.profile();
    if (here > 0)
        profile.last_used = std::clamp<std::int64_t>(now, 0, protocol::last_utc_second);
    json out = profile_json(profile);
    std::array<std::size_t, record_types.size()> records{};
    for (const RecordType type : record_types)
        records[static_cast<std::size_t>(type)] = session.records().count(type);
    add_counts(out, records);
    out["session"] = session.id();
    out["name"] = session.name();
    out["participants"] = here;
    out["thumbnail"] = !session.thumbnail().empty();
    return out;
}

json session_entry(const TrashedSession& session) {
    json out = profile_json(session.profile);
    add_counts(out, session.records);
    out["session"] = session.id;
    out["name"] = session.name;
    out["participants"] = 0;
    out["thumbnail"] = session.thumbnail;
    out["deletedAt"] = protocol::utc_text(session.profile.deleted.value_or(0));
    out["deletedUntil"] = protocol::utc_text(deleted_until(session.profile));
    return out;
}

} // namespace wakesurf::server
