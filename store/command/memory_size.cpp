#include "store/command/memory_size.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

namespace wakesurf::command {

namespace {

// Returns 0 for an unknown unit.
double bytes_of_unit(std::string unit) {
    std::transform(unit.begin(), unit.end(), unit.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (unit.empty() || unit == "b")
        return 1.0;
    constexpr std::string_view prefixes = "kmgt";
    const auto power = prefixes.find(unit.front());
    if (power == std::string_view::npos)
        return 0.0;
    const auto exponent = static_cast<double>(power + 1);
    const std::string rest = unit.substr(1);
    if (rest.empty() || rest == "b")
        return std::pow(1000.0, exponent);
    return rest == "i" || rest == "ib" ? std::pow(1024.0, exponent) : 0.0;
}

} // namespace

core::Result<std::uint64_t> parse_memory_size(std::string_view text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    auto unit = text.substr(static_cast<std::size_t>(end - text.data()));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    const double bytes = number * bytes_of_unit(std::string(unit));
    if (error != std::errc() || !(bytes >= 1.0 && bytes < 0x1p64))
        return core::fail(core::Error::Code::InvalidArgument,
                          "'" + std::string(text) + "' is not a memory size",
                          "write it like 4GiB, 1.5GiB or 800MB");
    return static_cast<std::uint64_t>(bytes);
}

CLI::Validator as_memory_size() {
    return CLI::Validator(
        [](std::string& text) {
            const auto bytes = parse_memory_size(text);
            if (!bytes)
                return bytes.error().message + "; " + bytes.error().hint;
            text = std::to_string(*bytes);
            return std::string();
        },
        "SIZE");
}

} // namespace wakesurf::command
