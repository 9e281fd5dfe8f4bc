#include "protocol/api/messages_session.hpp"

#include "protocol/api/base/json_text.hpp"
#include "protocol/api/utc_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

bool is_time(const json& value) {
    return value.is_number_integer() && value >= 0 && value <= last_utc_second;
}

bool is_person(const json& value) {
    for (const char* name : {"participant", "name", "colour"})
        if (!value.is_object() || !value.contains(name) || !value[name].is_string())
            return false;
    return true;
}

bool is_profile(const json& value) {
    if (!value.is_object())
        return false;
    for (const char* name : {"created", "deleted"})
        if (value.contains(name) && !is_time(value[name]))
            return false;
    for (const char* name : {"edited", "onPurpose"})
        if (!value.contains(name) || !value[name].is_boolean())
            return false;
    if (!value.contains("lastUsed") || !is_time(value["lastUsed"]) || !value.contains("people") ||
        !value["people"].is_array() || value["people"].size() > most_session_people)
        return false;
    for (const json& each : value["people"])
        if (!is_person(each))
            return false;
    for (const char* name : {"copyOf", "copyName"})
        if (value.contains(name) && !value[name].is_string())
            return false;
    if (!value.contains("data"))
        return true;
    const json& data = value["data"];
    return data.is_object() && data.size() <= most_session_datasets &&
           std::all_of(data.begin(), data.end(), [](const json& each) { return each.is_string(); });
}

} // namespace

std::string profile_text(const SessionProfile& profile) {
    json people = json::array();
    for (const SessionPerson& each : profile.people)
        people.push_back(
            {{"participant", each.participant}, {"name", each.name}, {"colour", each.colour}});
    json out{{"lastUsed", profile.last_used},
             {"edited", profile.edited},
             {"onPurpose", profile.on_purpose},
             {"people", std::move(people)}};
    if (!profile.data.empty())
        out["data"] = profile.data;
    if (!profile.copy_of.empty()) {
        out["copyOf"] = profile.copy_of;
        out["copyName"] = profile.copy_name;
    }
    if (profile.created)
        out["created"] = *profile.created;
    if (profile.deleted)
        out["deleted"] = *profile.deleted;
    return json_text(out);
}

core::Result<SessionProfile> read_profile(std::string_view text) {
    constexpr JsonLimits limits{std::size_t{32} << 10, 8};
    const auto kept = parse_json(text, limits);
    if (!kept || !is_profile(*kept))
        return core::fail(core::Error::Code::Corrupt,
                          "what was kept of when and by whom a session was used cannot be read");
    SessionProfile out;
    out.last_used = (*kept)["lastUsed"];
    out.edited = (*kept)["edited"];
    out.on_purpose = (*kept)["onPurpose"];
    for (const json& each : (*kept)["people"])
        out.people.push_back({each["participant"], each["name"], each["colour"]});
    if (kept->contains("data"))
        out.data = (*kept)["data"].get<std::map<std::string, std::string>>();
    out.copy_of = kept->value("copyOf", std::string());
    out.copy_name = kept->value("copyName", std::string());
    if (kept->contains("created"))
        out.created = (*kept)["created"].get<std::int64_t>();
    if (kept->contains("deleted"))
        out.deleted = (*kept)["deleted"].get<std::int64_t>();
    return out;
}

} // namespace wakesurf::protocol
