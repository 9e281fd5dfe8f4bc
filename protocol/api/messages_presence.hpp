// The people in a session, and what they point at, look at and drag just now. Presence passes by: it is never
// kept. Twin: web-client/src/protocol/generated/presence.ts.
#pragma once

#include "core/base/vec3.hpp"
#include "protocol/api/generated/presence.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::protocol {

struct Presence {
    std::optional<core::Vec3> pointer;
    std::optional<CameraPose> camera;
    std::optional<DraggedRake> dragging;
    std::optional<std::string> selected; ///< id of a record

    bool operator==(const Presence&) const = default;
};

/// Names the members of a participant, as bits: what a message is about.
namespace member {
inline constexpr unsigned name = 1u << 0;
inline constexpr unsigned colour = 1u << 1;
inline constexpr unsigned role = 1u << 2;
inline constexpr unsigned connected = 1u << 3;
inline constexpr unsigned pointer = 1u << 4;
inline constexpr unsigned camera = 1u << 5;
inline constexpr unsigned dragging = 1u << 6;
inline constexpr unsigned selected = 1u << 7;
inline constexpr unsigned person = name | colour | role | connected;
inline constexpr unsigned all = person | pointer | camera | dragging | selected;
} // namespace member

/// Returns the members of a presence that are not empty.
unsigned said(const Presence& presence);

struct ParticipantRecord {
    std::string participant;
    std::string name;
    std::string colour; ///< #rrggbb
    std::string role;
    bool connected = true; ///< false: the connection was lost a moment ago
    Presence presence;
};

/// Returns `participant`, and those members; what no one has said yet is null.
nlohmann::json participant_json(const ParticipantRecord& record, unsigned members);

/// Returns the same, as JSON text.
std::string participant_text(const ParticipantRecord& record, unsigned members);

/// Returns the notification presence.patched, of participants as JSON text.
std::string presence_patched(const std::string& session,
                             std::span<const std::string> participants,
                             std::span<const std::string> left);

} // namespace wakesurf::protocol
