#include "importer/time_selection.hpp"

#include "core/base/rounding.hpp"
#include "importer/sources/files/file_names.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

std::optional<TimeSelection> parse_range(std::string_view text) {
    std::vector<double> parts;
    for (std::string_view rest = text;;) {
        const auto colon = rest.find(':');
        const auto part = finite_number(rest.substr(0, colon));
        if (!part)
            return std::nullopt;
        parts.push_back(*part);
        if (colon == std::string_view::npos)
            break;
        rest.remove_prefix(colon + 1);
    }
    if (parts.size() == 2)
        parts.push_back(1.0);
    if (parts.size() != 3 || parts[1] < parts[0] || parts[2] < 1 || parts[2] > 1e9 ||
        parts[2] != std::floor(parts[2]))
        return std::nullopt;
    return TimeSelection{parts[0], parts[1], static_cast<std::size_t>(parts[2])};
}

} // namespace

core::Result<std::vector<TimeSelection>> parse_times(const std::string& text) {
    std::vector<TimeSelection> out;
    for (std::string_view rest = text;;) {
        const auto comma = rest.find(',');
        const auto range = parse_range(rest.substr(0, comma));
        if (!range)
            return core::fail(Error::Code::InvalidArgument,
                              "--times " + text +
                                  " is not T0:T1 or T0:T1:EVERY, or several of them with commas",
                              "for example --times 8.5:16:2");
        out.push_back(*range);
        if (comma == std::string_view::npos)
            return out;
        rest.remove_prefix(comma + 1);
    }
}

core::Result<std::vector<std::size_t>> select_times(std::span<const double> times,
                                                    const std::vector<TimeSelection>& ranges) {
    std::vector<std::size_t> chosen;
    std::vector<std::size_t> within(ranges.size(), 0);
    for (std::size_t i = 0; i < times.size(); ++i) {
        bool wanted = ranges.empty();
        for (std::size_t r = 0; r < ranges.size(); ++r) {
            const auto& [from, to, every] = ranges[r];
            if (core::within_rounding(times[i], from, to))
                wanted = within[r]++ % every == 0 || wanted;
        }
        if (wanted)
            chosen.push_back(i);
    }
    if (chosen.empty())
        return core::fail(Error::Code::OutOfTime, "no time-step lies in --times; there is " +
                                                      std::to_string(times.front()) + " to " +
                                                      std::to_string(times.back()));
    return chosen;
}

} // namespace wakesurf::importer
