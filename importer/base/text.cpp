#include "importer/base/text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace wakesurf::importer {

std::string lower_extension(const std::filesystem::path& path) {
    return lower_case(path.extension().string());
}

std::optional<double> finite_number(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const auto first = text.find_first_not_of(blank);
    if (first == std::string_view::npos)
        return std::nullopt;
    text = text.substr(first, text.find_last_not_of(blank) - first + 1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string tidy_name(std::string_view name) {
    const auto last = name.find_last_not_of("_-. ");
    return std::string(last == std::string_view::npos ? name : name.substr(0, last + 1));
}

} // namespace wakesurf::importer
