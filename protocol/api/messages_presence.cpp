#include "protocol/api/messages_presence.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace wakesurf::protocol {

using nlohmann::json;

unsigned said(const Presence& presence) {
    return (presence.pointer ? member::pointer : 0u) | (presence.camera ? member::camera : 0u) |
           (presence.dragging ? member::dragging : 0u) |
           (presence.selected ? member::selected : 0u);
}

json participant_json(const ParticipantRecord& record, unsigned members) {
    const Presence& presence = record.presence;
    json out{{"participant", record.participant}};
    const auto tell = [&](unsigned member, const char* name, json value) {
        if ((members & member) != 0)
            out[name] = std::move(value);
    };
    tell(member::name, "name", record.name);
    tell(member::colour, "colour", record.colour);
    tell(member::role, "role", record.role);
    tell(member::connected, "connected", record.connected);
    tell(member::pointer, "pointer", written(presence.pointer));
    tell(member::camera, "camera", written(presence.camera));
    tell(member::dragging, "dragging", written(presence.dragging));
    tell(member::selected, "selected", written(presence.selected));
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

} // namespace wakesurf::protocol
