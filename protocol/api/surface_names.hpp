// The words users and scripts write for what a surface is asked to be: `stream`, `forward`, `balanced` ...
#pragma once

#include "core/surface/surface_parameters.hpp"

#include <optional>
#include <string_view>

namespace wakesurf::protocol {

std::string_view name(core::SurfaceKind kind);
std::string_view name(core::Direction direction);
std::string_view name(core::Accuracy accuracy);

/// Nothing for any other word.
std::optional<core::SurfaceKind> surface_kind(std::string_view word);
std::optional<core::Direction> direction(std::string_view word);
std::optional<core::Accuracy> accuracy(std::string_view word);

} // namespace wakesurf::protocol
