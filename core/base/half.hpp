// IEEE 754 half precision (binary16) <-> float: 11 significant bits, a relative error of at most 2^-11
// between 6.1e-5 and 65504.
#pragma once

#include <cstdint>
#include <span>

namespace wakesurf::core {

/// Rounds to nearest, ties to even; what is too large becomes infinite, NaN stays NaN. Both spans have the
/// same size.
void to_half(std::span<const float> values, std::span<std::uint16_t> halves);

/// Converts exactly.
void from_half(std::span<const std::uint16_t> halves, std::span<float> values);

/// Computes the same bits on any processor.
void to_half_portable(std::span<const float> values, std::span<std::uint16_t> halves);
void from_half_portable(std::span<const std::uint16_t> halves, std::span<float> values);

} // namespace wakesurf::core
