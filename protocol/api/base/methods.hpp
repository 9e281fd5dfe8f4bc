// Every method of the API as it is described, beside its parameters: who may call it, and from where.
#pragma once

#include <span>
#include <string_view>

namespace wakesurf::protocol {

/// All views have static storage.
struct MethodDescription {
    std::string_view name;
    std::string_view least_role; ///< viewer, editor or host
    bool websocket_only;
    bool edits;        ///< changes records that are kept
    bool whole_server; ///< not for share links, which are for one session
    bool shared;       ///< about what all sessions share: see server/net/methods/caller
    bool copier;       ///< in a copy also for who made it by a share link, whatever their role
    std::span<const std::string_view> parameters;
};

/// Returns all, in the order of the documents.
std::span<const MethodDescription> described_methods();

/// Returns null where there is none of this name.
const MethodDescription* described_method(std::string_view name);

} // namespace wakesurf::protocol
