// Tests whether all values of a piece of a file are finite: if not, the domain has a gap.
#pragma once

#include "core/dataset/dataset_info.hpp"

#include <cstddef>
#include <span>

namespace wakesurf::store {

/// Returns whether floats or halves, as the file has them, are all finite.
bool all_finite(std::span<const std::byte> values, core::Precision precision);

} // namespace wakesurf::store
