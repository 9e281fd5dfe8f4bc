#include "server/import/time_selection.hpp"

#include "server/import/sources/files/file_names.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace wakesurf::server {

using core::Error;

core::Result<TimeSelection> parse_times(const std::string& text) {
    std::vector<double> parts;
    bool sound = true;
    for (std::string_view rest = text; sound;) {
        const auto colon = rest.find(':');
        const auto part = finite_number(rest.substr(0, colon));
        sound = part.has_value();
        parts.push_back(part.value_or(0.0));
        if (colon == std::string_view::npos)
            break;
        rest.remove_prefix(colon + 1);
    }
    if (parts.size() == 2)
        parts.push_back(1.0);
    if (!sound || parts.size() != 3 || parts[1] < parts[0] || parts[2] < 1 || parts[2] > 1e9 ||
        parts[2] != std::floor(parts[2]))
        return core::fail(Error::Code::InvalidArgument,
                          "--times " + text + " is not T0:T1 or T0:T1:EVERY",
                          "for example --times 8.5:16:2");
    return TimeSelection{parts[0], parts[1], static_cast<std::size_t>(parts[2])};
}

core::Result<std::vector<std::size_t>> select_times(std::span<const double> times,
                                                    const std::optional<TimeSelection>& selection) {
    std::vector<std::size_t> chosen;
    std::size_t within = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (selection) {
            const double slack =
                1e-9 * std::max(std::abs(selection->from), std::abs(selection->to));
            if (times[i] < selection->from - slack || times[i] > selection->to + slack ||
                within++ % selection->every != 0)
                continue;
        }
        chosen.push_back(i);
    }
    if (chosen.empty())
        return core::fail(Error::Code::OutOfTime, "no time-step lies in --times; there is " +
                                                      std::to_string(times.front()) + " to " +
                                                      std::to_string(times.back()));
    return chosen;
}

} // namespace wakesurf::server
