// The number in an id such as "s7" or "session-12": what a restored session counts on from, so that no id is
// given twice.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace wakesurf::server {

/// Returns nothing unless `id` is `start` and a number as to_string() writes it, of at most 53 bits: the
/// next one is one more.
std::optional<std::uint64_t> number_of(std::string_view id, std::string_view start);

} // namespace wakesurf::server
