// The number in an id such as "s7" or "session-12": a restored session continues from it, so that no id is
// used twice.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace wakesurf::server {

/// Returns empty unless `id` is `start` and a number as to_string() writes it, of at most 53 bits, so that
/// the next one can be computed.
std::optional<std::uint64_t> number_of(std::string_view id, std::string_view start);

} // namespace wakesurf::server
