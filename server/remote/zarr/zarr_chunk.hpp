// The bytes of a chunk's object -> the bytes of its numbers, unpacked as server/remote/zarr/zarr_array.hpp
// says. The bytes are untrusted: lengths and headers of packers are checked.
#pragma once

#include "core/base/result.hpp"
#include "server/remote/zarr/zarr_array.hpp"

#include <span>

namespace wakesurf::server {

/// Returns the largest size of a chunk's object, in bytes: incompressible data take a little more than their
/// numbers.
std::size_t most_stored_bytes(const ZarrArray& array);

/// Returns the memory for reading and unpacking a chunk, its numbers included.
std::size_t chunk_reading_bytes(const ZarrArray& array);

/// Returns exactly the bytes of a chunk's numbers. Error: Corrupt for another length, another checksum, and
/// if unpacking fails.
core::Result<std::vector<std::byte>> unpack_chunk(const ZarrArray& array,
                                                  std::vector<std::byte> stored);

/// Converts numbers of a chunk to values. `from` has one number every `from_stride` bytes, `to` gets one
/// every `to_stride` floats. Missing values become NaN, values beyond single precision infinite.
/// @return false if some value is not finite
bool read_values(const ZarrArray& array,
                 const std::byte* from,
                 std::size_t from_stride,
                 float* to,
                 std::size_t to_stride,
                 std::size_t count);

/// Converts consecutive numbers to double precision.
std::vector<double> read_numbers(const ZarrArray& array, std::span<const std::byte> from);

/// Returns the value of missing chunks. REQUIRES: array.fill.
double filled_value(const ZarrArray& array);

} // namespace wakesurf::server
