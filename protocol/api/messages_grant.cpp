#include "protocol/api/messages_grant.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

bool all_texts(const json& list) {
    return std::all_of(list.begin(), list.end(), [](const json& each) { return each.is_string(); });
}

/// A member that may be left out, of the right shape where it is there.
bool fits(const json& kept, const char* name, bool (*good)(const json&)) {
    return !kept.contains(name) || good(kept[name]);
}

bool is_number(const json& value) {
    return value.is_number_integer();
}

bool is_text(const json& value) {
    return value.is_string();
}

bool is_list_of_texts(const json& value) {
    return value.is_array() && all_texts(value);
}

bool is_map_of_texts(const json& value) {
    return value.is_object() && all_texts(value);
}

} // namespace

std::string grant_text(const GrantRecord& record) {
    json out{{"role", record.role}, {"sha256", record.digest}};
    if (record.expires)
        out["expires"] = *record.expires;
    if (!record.maker.empty())
        out["maker"] = record.maker;
    if (!record.lineage.empty())
        out["lineage"] = record.lineage;
    if (!record.lowered.empty())
        out["lowered"] = record.lowered;
    if (!record.copier.empty())
        out["copier"] = record.copier;
    return out.dump();
}

core::Result<GrantRecord> read_grant(std::string_view text) {
    const json kept = json::parse(text, nullptr, false);
    if (!kept.is_object() || !kept.contains("role") || !kept.contains("sha256") ||
        !fits(kept, "role", is_text) || !fits(kept, "sha256", is_text) ||
        !fits(kept, "expires", is_number) || !fits(kept, "maker", is_text) ||
        !fits(kept, "copier", is_text) || !fits(kept, "lineage", is_list_of_texts) ||
        !fits(kept, "lowered", is_map_of_texts))
        return core::fail(core::Error::Code::Corrupt, "a saved share link is damaged",
                          "make a new one with `session.share`");
    GrantRecord record{kept["role"], kept["sha256"], {}, {}, {}, {}};
    if (kept.contains("expires"))
        record.expires = kept["expires"].get<std::int64_t>();
    record.maker = kept.value("maker", std::string());
    record.copier = kept.value("copier", std::string());
    record.lineage = kept.value("lineage", std::vector<std::string>());
    record.lowered = kept.value("lowered", std::map<std::string, std::string>());
    return record;
}

} // namespace wakesurf::protocol
