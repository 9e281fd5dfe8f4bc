// Where people ask what reaches it: a plane or a box.
#pragma once

#include "core/base/box.hpp"
#include "core/base/plane.hpp"

#include <variant>

namespace wakesurf::core {

/// What a surface is cut with.
using Region = std::variant<Plane, Box>;

} // namespace wakesurf::core
