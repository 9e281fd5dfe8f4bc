// The memory of the machine, and the part that this process may have before an allocation fails or the kernel
// kills it.
#pragma once

#include <cstdint>
#include <filesystem>

namespace wakesurf::core {

/// Bytes; 0 where the system does not say.
std::uint64_t machine_memory();

/// The least of machine_memory() and the limits of the control groups that this process is in, version 1 or
/// 2, nested ones too. Bytes; 0 where the system does not say.
/// @param root  where /proc and /sys are, for tests
std::uint64_t granted_memory(const std::filesystem::path& root = "/");

/// Returns the bytes of memory that this process has resident; 0 where the system does not say. Cost: some 3
/// microseconds.
std::uint64_t resident_memory();

/// Returns the largest resident_memory() so far, in bytes; 0 where the system does not say.
std::uint64_t peak_resident_memory();

} // namespace wakesurf::core
