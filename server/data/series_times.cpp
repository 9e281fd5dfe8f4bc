#include "server/data/series_times.hpp"

#include "core/base/rounding.hpp"
#include "core/surface/time_direction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace wakesurf::server {

core::Result<SeriesTimes> read_times(const std::string& text, const std::string& option) {
    std::array<double, 3> numbers{};
    std::string_view rest = text;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [end, error] =
            std::from_chars(rest.data(), rest.data() + rest.size(), numbers[k]);
        const bool more = end != rest.data() + rest.size();
        if (error != std::errc() || !std::isfinite(numbers[k]) || more != (k < 2) ||
            (more && *end != ':'))
            return core::fail(core::Error::Code::InvalidArgument,
                              fmt::format("{}: '{}' is not FIRST:LAST:EVERY", option, text),
                              "write three numbers, for example 0:20:0.1");
        if (more)
            rest = rest.substr(static_cast<std::size_t>(end - rest.data()) + 1);
    }
    if (!(numbers[2] > 0.0))
        return core::fail(core::Error::Code::InvalidArgument,
                          fmt::format("{}: EVERY is {}, and must be above 0", option, numbers[2]),
                          "where time runs backward FIRST is the later one");
    return SeriesTimes{numbers[0], numbers[1], numbers[2]};
}

core::Result<std::vector<double>> times_in(const SeriesTimes& times,
                                           const core::SurfaceParameters& p,
                                           std::size_t most,
                                           const std::string& option) {
    const double sign = core::time_sign(p);
    std::vector<double> out;
    const auto [first, last, every] = times;
    const double low = std::min(p.from, p.to);
    const double high = std::max(p.from, p.to);
    for (const double time : {first, last})
        if (!core::within_rounding(time, low, high))
            return core::fail(core::Error::Code::InvalidArgument,
                              fmt::format("{}: {} is outside {} to {}, the times that there are",
                                          option, core::time_text(time), core::time_text(p.from),
                                          core::time_text(p.to)),
                              "choose times inside them");
    const double length = sign * (last - first);
    if (length < 0.0)
        return core::fail(core::Error::Code::InvalidArgument,
                          fmt::format("{}: time goes from {} to {} here, and the times run "
                                      "the other way",
                                      option, core::time_text(p.from), core::time_text(p.to)),
                          "exchange FIRST and LAST");
    const double intervals = std::floor(length / every * (1.0 + 1e-12) + 1e-9);
    if (intervals + 1.0 > static_cast<double>(most))
        return core::fail(core::Error::Code::InvalidArgument,
                          fmt::format("{}: that are {:.0f} times, and at most {} can be written",
                                      option, intervals + 1.0, most),
                          "make EVERY larger");
    const auto count = static_cast<std::size_t>(intervals) + 1;
    for (std::size_t k = 0; k < count; ++k)
        out.push_back(std::clamp(first + sign * every * static_cast<double>(k), low, high));
    return out;
}

std::vector<double> even_times(const core::SurfaceParameters& p, std::size_t count) {
    std::vector<double> out;
    for (std::size_t k = 0; k < count; ++k)
        out.push_back(p.from +
                      (p.to - p.from) * static_cast<double>(k) / static_cast<double>(count - 1));
    return out;
}

} // namespace wakesurf::server
