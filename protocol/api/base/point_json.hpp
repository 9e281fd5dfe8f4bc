// Points as lists of numbers.
#pragma once

#include "core/base/vec3.hpp"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace wakesurf::protocol {

/// [x, y, z]
nlohmann::json point_json(const core::Vec3& point);

/// [[x, y, z], ...]
nlohmann::json points_json(const std::vector<core::Vec3>& points);

} // namespace wakesurf::protocol
