// The bytes of a chunk's object -> the bytes of its numbers, as server/service/zarr/zarr_array.hpp says that they are packed. Strangers' bytes: lengths and
// what the packers say of themselves are checked.
#pragma once

#include "core/base/result.hpp"
#include "server/service/zarr/zarr_array.hpp"

#include <span>

namespace wakesurf::server {

/// Bytes that the object of a chunk may have: what cannot be packed takes a little more than its numbers.
std::size_t most_stored_bytes(const ZarrArray& array);

/// Memory while a chunk is read and unpacked, its numbers among it.
std::size_t chunk_reading_bytes(const ZarrArray& array);

/// As many bytes as the numbers of a chunk have. Error: Corrupt for another length, for what its packer refuses, and for another checksum.
core::Result<std::vector<std::byte>> unpack_chunk(const ZarrArray& array,
                                                  std::vector<std::byte> stored);

/// Numbers of a chunk -> values. `from` has one number every `from_stride` bytes, `to` gets one every `to_stride` floats. What means that
/// there is no value, and what single precision cannot hold, becomes NaN or infinite.
/// @return false where some value is not finite
bool read_values(const ZarrArray& array,
                 const std::byte* from,
                 std::size_t from_stride,
                 float* to,
                 std::size_t to_stride,
                 std::size_t count);

/// The same in double precision, of numbers one after the other.
std::vector<double> read_numbers(const ZarrArray& array, std::span<const std::byte> from);

/// What a chunk that is not there holds. REQUIRES: array.fill.
double filled_value(const ZarrArray& array);

} // namespace wakesurf::server
