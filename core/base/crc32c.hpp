// CRC-32C (Castagnoli), the checksum of a store's files, and part of the ETag of what the server sends as a
// file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::core {

/// Returns the checksum of everything summed so far followed by `bytes`: crc32c(b, crc32c(a)) == crc32c(a +
/// b). Cost: above 10 GB/s with SSE 4.2, else above 1 GB/s.
std::uint32_t crc32c(std::span<const std::byte> bytes, std::uint32_t so_far = 0);

/// Returns the same sum without special instructions, on any processor.
std::uint32_t crc32c_portable(std::span<const std::byte> bytes, std::uint32_t so_far = 0);

} // namespace wakesurf::core
