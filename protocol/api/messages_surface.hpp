// Surfaces in messages: what surface.set asks for, and the record everybody in the session sees and the server keeps.
// Twin: web-client/src/protocol/messages.ts.
#pragma once

#include "core/surface/surface_parameters.hpp"
#include "protocol/api/checked_json.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::protocol {

struct SurfaceLimits {
    std::uint64_t quads_default = 1'000'000;
    std::uint64_t quads_most = 4'000'000;
    std::size_t fields = 4;
};

struct SurfaceSetting {
    std::optional<std::string> surface; ///< nothing: create one
    std::string rake;
    std::optional<std::string> rake2; ///< of the session as well
    std::string dataset;
    core::SurfaceParameters parameters; ///< its rake2 is left to the session
    std::vector<std::string> fields;
    std::optional<std::uint64_t> if_rev;
};

/// Reads the parameters of surface.set; faults stay in `in`.
SurfaceSetting read_surface_setting(CheckedJson& in, const SurfaceLimits& limits);

struct SurfaceRecord {
    std::string surface;
    std::uint64_t rev = 0;
    std::uint32_t epoch = 0;
    std::string rake;
    std::optional<std::string> rake2;
    std::string dataset;
    core::SurfaceParameters parameters; ///< without the shape of rake2
    std::vector<std::string> fields;

    bool hangs_on(const std::string& id) const { return rake == id || rake2 == id; }

    bool operator==(const SurfaceRecord&) const = default;
};

nlohmann::json surface_json(const SurfaceRecord& record);

/// Reads what surface_json returned, even with more fields than a client may ask for; faults stay in `in`.
SurfaceRecord read_surface_record(CheckedJson& in, const SurfaceLimits& limits);

} // namespace wakesurf::protocol
