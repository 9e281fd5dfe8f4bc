// All of the bytes to a file or pipe, or all from it: interrupted and short calls go on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::store {

/// Returns false where it fails; errno says why.
bool write_whole(int file, std::span<const std::byte> bytes);

/// Writes at a place of a file.
bool write_whole_at(int file, std::uint64_t at, std::span<const std::byte> bytes);

/// False at the end of the file or where it fails.
bool read_whole(int file, std::span<std::byte> bytes);

} // namespace wakesurf::store
