// A slice's raster as bytes, and back: the answer to slice.bin. protocol/wire/FORMAT.md, Slice file. Twin:
// web-client/src/protocol/sliceFile.ts.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/slice/slice_raster.hpp"
#include "protocol/wire/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace wakesurf::protocol {

inline constexpr std::size_t slice_header_bytes = 112;
inline constexpr std::uint16_t no_slice_value = 65535; ///< the code of a sample without a value
inline constexpr double slice_codes = 65534.0;         ///< the code of the largest value

/// Returns how many bytes a raster of that size takes.
std::size_t slice_file_bytes(std::size_t columns, std::size_t rows);

/// Rounds each value to one of 65,535 in the raster's range: finer than any colour, and half the bytes of floats.
/// @param time  at which the values hold
std::string slice_file(const core::SliceRaster& raster, double time);

struct SliceFile {
    core::SliceRaster raster;
    double time = 0.0;
};

/// Error: Corrupt.
core::Result<SliceFile> read_slice_file(std::span<const std::byte> bytes);

} // namespace wakesurf::protocol
