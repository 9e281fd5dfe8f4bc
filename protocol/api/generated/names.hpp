// Made by protocol/api/generate from *.schema.json: do not edit.
// The words users and scripts write for the engine's enumerations: `stream`, `forward`, `balanced` ...
#pragma once

#include "core/surface/surface_parameters.hpp"
#include "core/surface/surface_statistics.hpp"

#include <optional>
#include <string_view>

namespace wakesurf::protocol {

std::string_view name(core::Rake::Kind value);
std::string_view name(core::SurfaceKind value);
std::string_view name(core::Direction value);
std::string_view name(core::Accuracy value);
std::string_view name(core::Interpolation value);
std::string_view name(core::Refine value);
std::string_view name(core::Emptiness::Reason value);

// Nothing for any other word.
std::optional<core::Rake::Kind> rake_kind(std::string_view word);
std::optional<core::SurfaceKind> surface_kind(std::string_view word);
std::optional<core::Direction> direction(std::string_view word);
std::optional<core::Accuracy> accuracy(std::string_view word);
std::optional<core::Interpolation> interpolation(std::string_view word);
std::optional<core::Refine> refine(std::string_view word);
std::optional<core::Emptiness::Reason> empty_reason(std::string_view word);

} // namespace wakesurf::protocol
