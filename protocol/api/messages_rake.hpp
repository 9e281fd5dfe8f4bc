// Rakes in messages: what rake.set asks for, and the record everybody in the session sees and the server keeps.
// Twin: web-client/src/protocol/messages.ts.
#pragma once

#include "core/surface/rake.hpp"
#include "protocol/api/checked_json.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// `line`, `polyline`, `circle`, `points`.
std::string_view name(core::Rake::Kind kind);

struct RakeLimits {
    std::uint64_t seeds_least = 2;
    std::uint64_t seeds_most = 4096;
    std::size_t points = 1024;
    std::size_t name_bytes = 120;
};

struct RakeSetting {
    std::optional<std::string> rake; ///< nothing: create one
    core::Rake shape;
    std::string name;
    std::optional<std::string> colour; ///< nothing: as it is; of a new one the session's choice
    std::optional<bool>
        dragging;       ///< true takes or renews the lease, false ends it, nothing leaves it
    bool force = false; ///< although somebody else has the lease
    std::optional<std::uint64_t> if_rev; ///< only if the record is still at this revision
};

/// Reads the parameters of rake.set; faults stay in `in`.
RakeSetting read_rake_setting(CheckedJson& in, const RakeLimits& limits);

struct RakeRecord {
    std::string rake;
    std::uint64_t rev = 0;
    core::Rake shape; ///< as clipped
    std::string name;
    std::string colour; ///< #rrggbb; empty in records from before rakes had one
    std::string author; ///< name of who made it
    bool clipped = false;
    bool dragging = false; ///< somebody holds it just now
    std::string leased_by; ///< who; empty where nobody does

    bool operator==(const RakeRecord&) const = default;
};

nlohmann::json rake_json(const RakeRecord& record);

/// What rake_json gave, without the lease; faults stay in `in`.
RakeRecord read_rake_record(CheckedJson& in, const RakeLimits& limits);

nlohmann::json points_json(const std::vector<core::Vec3>& points);

} // namespace wakesurf::protocol
