// Made by protocol/api/generate from rake.schema.json: do not edit.
// Rakes: what methods take, and the record. Readers leave what is wrong in `in`.
#pragma once

#include "core/surface/rake.hpp"
#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/generated/shared.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// A rake as the session keeps it.
struct RakeRecord {
    /// id of the rake
    std::string rake;
    /// counts the edits of a record
    std::uint64_t rev = 0;
    /// kind, points, seeds
    core::Rake shape;
    /// display name
    std::string name;
    /// #rrggbb
    std::string colour;
    /// name of the one who made it
    std::string author;
    /// true: a part was outside the domain and was cut off; a circle's points stay
    bool clipped = false;
    /// true: someone holds the lease at the moment
    bool dragging = false;
    /// id of the participant who holds the lease; only present while someone does
    std::string leased_by;

    bool operator==(const RakeRecord&) const = default;
};

void read(CheckedJson& in, RakeRecord& out);

nlohmann::json record_json(const RakeRecord& record);

/// Returns it as it is kept: what read() reads.
nlohmann::json kept_json(const RakeRecord& record);

/// Holds the parameters of rake.set.
struct RakeSetting : InSession {
    static constexpr std::string_view method = "rake.set";

    /// id of the rake to replace; if left out, a new one is created
    std::optional<std::string> rake;
    /// kind, points, seeds
    core::Rake shape;
    /// display name
    std::string name;
    /// #rrggbb; if left out, a rake keeps its colour, and a new rake gets one that few others have
    std::optional<std::string> colour;
    /// true: no one else may edit the rake for 5 s from now; false: others may edit it again; if
    /// left out, nothing changes
    std::optional<bool> dragging;
    /// true: lets a host edit the rake although someone else holds the lease
    bool force = false;
    /// true: make the record only if no one has edited the session and it has no such record yet;
    /// this does not count as an edit, and undo does not take it back
    bool default_scene = false;
    /// a name for what the user is doing; consecutive edits with the same name are one step of undo
    std::optional<std::string> gesture;
    /// the edit is refused if the record is at another revision
    std::optional<std::uint64_t> if_rev;
};

/// Holds the parameters of rake.delete.
struct RakeDelete : InSession {
    static constexpr std::string_view method = "rake.delete";

    /// an id from rake.list
    std::string rake;
    /// true: lets a host delete the rake although someone else holds the lease
    bool force = false;
    /// a name for what the user is doing; consecutive edits with the same name are one step of undo
    std::optional<std::string> gesture;
    /// the edit is refused if the record is at another revision
    std::optional<std::uint64_t> if_rev;
};

/// Holds the parameters of rake.list.
struct RakeList : InSession {
    static constexpr std::string_view method = "rake.list";
};

void read(CheckedJson& in, RakeSetting& out);
void read(CheckedJson& in, RakeDelete& out);

} // namespace wakesurf::protocol
