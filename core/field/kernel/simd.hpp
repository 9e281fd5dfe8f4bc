// The vector instructions of a processor that the kernels may use.
#pragma once

#include <cstdint>

namespace wakesurf::core {

/// The kernels that carry particles through stored data. All give the same bits.
enum class Simd : std::uint8_t {
    Best,     ///< what the processor offers
    Avx2,     ///< that, but no more than AVX2
    Portable, ///< what every processor offers
};

} // namespace wakesurf::core
