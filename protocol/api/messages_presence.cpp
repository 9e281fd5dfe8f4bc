#include "protocol/api/messages_presence.hpp"

#include "protocol/api/base/point_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using nlohmann::json;

unsigned said(const Presence& presence) {
    return (presence.pointer ? member::pointer : 0u) | (presence.camera ? member::camera : 0u) |
           (presence.dragging ? member::dragging : 0u) |
           (presence.selected ? member::selected : 0u);
}

PresenceChange change_of(const PresenceUpdate& update) {
    PresenceChange change;
    change.values = {update.pointer.value, update.camera.value, update.dragging.value,
                     update.selected.value};
    change.given = (update.pointer.given ? member::pointer : 0u) |
                   (update.camera.given ? member::camera : 0u) |
                   (update.dragging.given ? member::dragging : 0u) |
                   (update.selected.given ? member::selected : 0u);
    return change;
}

json participant_json(const ParticipantRecord& record, unsigned members) {
    const Presence& presence = record.presence;
    json out{{"participant", record.participant}};
    if ((members & member::name) != 0)
        out["name"] = record.name;
    if ((members & member::colour) != 0)
        out["colour"] = record.colour;
    if ((members & member::role) != 0)
        out["role"] = record.role;
    if ((members & member::connected) != 0)
        out["connected"] = record.connected;
    if ((members & member::pointer) != 0)
        out["pointer"] = presence.pointer ? point_json(*presence.pointer) : json(nullptr);
    if ((members & member::camera) != 0)
        out["camera"] = presence.camera ? camera_json(*presence.camera) : json(nullptr);
    if ((members & member::dragging) != 0)
        out["dragging"] = presence.dragging ? dragged_rake_json(*presence.dragging) : json(nullptr);
    if ((members & member::selected) != 0)
        out["selected"] = presence.selected ? json(*presence.selected) : json(nullptr);
    return out;
}

std::string participant_text(const ParticipantRecord& record, unsigned members) {
    return participant_json(record, members).dump();
}

std::string presence_patched(const std::string& session,
                             std::span<const std::string> participants,
                             std::span<const std::string> left) {
    std::string text = R"({"jsonrpc":"2.0","method":"presence.patched","params":{"session":)" +
                       json(session).dump() + R"(,"participants":[)";
    for (std::size_t i = 0; i < participants.size(); ++i)
        text.append(i == 0 ? "" : ",").append(participants[i]);
    return text + R"(],"left":)" + json(left).dump() + "}}";
}

std::string membership_text(const MembershipRecord& record) {
    json out{{"name", record.name},   {"colour", record.colour}, {"role", record.role},
             {"grant", record.grant}, {"sha256", record.digest}, {"roleSet", record.role_set}};
    if (record.left)
        out["left"] = *record.left;
    if (!record.former.empty())
        out["formerSha256"] = record.former;
    return out.dump();
}

core::Result<MembershipRecord> read_membership(std::string_view text) {
    const json kept = json::parse(text, nullptr, false);
    const auto corrupt = core::fail(core::Error::Code::Corrupt, "a saved participant is damaged",
                                    "join the session again");
    for (const char* name : {"name", "colour", "role", "grant", "sha256"})
        if (!kept.is_object() || !kept.contains(name) || !kept[name].is_string())
            return corrupt;
    MembershipRecord record{kept["name"], kept["colour"], kept["role"], kept["grant"],
                            kept["sha256"]};
    if (kept.contains("roleSet")) { // before that only those were kept whose role was set
        if (!kept["roleSet"].is_boolean())
            return corrupt;
        record.role_set = kept["roleSet"];
    }
    if (kept.contains("formerSha256")) {
        if (!kept["formerSha256"].is_string())
            return corrupt;
        record.former = kept["formerSha256"];
    }
    if (kept.contains("left")) {
        if (!kept["left"].is_number_integer())
            return corrupt;
        record.left = kept["left"].get<std::int64_t>();
    }
    return record;
}

} // namespace wakesurf::protocol
