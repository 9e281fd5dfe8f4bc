#include "protocol/messages_grant.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using nlohmann::json;

std::string grant_text(const GrantRecord& record) {
    json out{{"role", record.role}, {"sha256", record.digest}};
    if (record.expires)
        out["expires"] = *record.expires;
    return out.dump();
}

core::Result<GrantRecord> read_grant(std::string_view text) {
    const json kept = json::parse(text, nullptr, false);
    const auto is_text = [&](const char* name) {
        return kept.contains(name) && kept[name].is_string();
    };
    const bool expires = kept.is_object() && kept.contains("expires");
    if (!kept.is_object() || !is_text("role") || !is_text("sha256") ||
        (expires && !kept["expires"].is_number_integer()))
        return core::fail(core::Error::Code::Corrupt, "a share link that was kept is not one",
                          "make a new one with session.share");
    GrantRecord record{kept["role"], kept["sha256"], {}};
    if (expires)
        record.expires = kept["expires"].get<std::int64_t>();
    return record;
}

} // namespace wakesurf::protocol
