// Sizes of memory as people write them: 4GiB, 1.5 GiB, 800MB, 1073741824.
#pragma once

#include "core/base/result.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string_view>

namespace wakesurf::command {

/// Returns a size in bytes. k, M, G and T (with or without b) count by 1000, Ki, Mi, Gi and Ti by 1024, in
/// any case. Error: InvalidArgument for anything else, and for less than a byte or more than 64 bits hold.
core::Result<std::uint64_t> parse_memory_size(std::string_view text);

/// Returns a transform of CLI11 that replaces such a size by its number of bytes.
CLI::Validator as_memory_size();

} // namespace wakesurf::command
