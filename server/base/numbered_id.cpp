#include "server/base/numbered_id.hpp"

#include "protocol/api/base/json_members.hpp"

#include <charconv>

namespace wakesurf::server {

std::optional<std::uint64_t> number_of(std::string_view id, std::string_view start) {
    if (!id.starts_with(start))
        return std::nullopt;
    const std::string_view digits = id.substr(start.size());
    std::uint64_t number = 0;
    const auto [stop, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool whole = error == std::errc{} && stop == digits.data() + digits.size();
    if (!whole || number >= protocol::most_whole || (digits.size() > 1 && digits[0] == '0'))
        return std::nullopt;
    return number;
}

} // namespace wakesurf::server
