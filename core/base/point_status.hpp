// Where a point is: the three answers every field returns before anything is sampled there.
#pragma once

#include <cstdint>

namespace wakesurf::core {

enum class PointStatus : std::uint8_t { Inside, OutsideDomain, InObstacle };

} // namespace wakesurf::core
