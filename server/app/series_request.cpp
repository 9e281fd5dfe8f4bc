#include "server/app/series_request.hpp"

#include "core/base/rounding.hpp"
#include "core/surface/time_direction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace wakesurf::server {

namespace {

using Code = core::Error::Code;

constexpr const char* pattern_hint =
    "name the files like frame_%03d.glb, with one %d or %03d for the number";

/// The place of a number in a pattern: %d, or %0Nd with N from 1 to 9.
struct Place {
    std::size_t begin = 0;
    std::size_t end = 0;
    int width = 0;
};

std::vector<Place> places_in(const std::string& pattern) {
    std::vector<Place> out;
    for (std::size_t at = pattern.find('%'); at != std::string::npos;
         at = pattern.find('%', at + 1)) {
        const std::string_view rest = std::string_view(pattern).substr(at + 1);
        if (rest.starts_with('d'))
            out.push_back({at, at + 2, 0});
        else if (rest.size() > 2 && rest[0] == '0' && rest[1] >= '1' && rest[1] <= '9' &&
                 rest[2] == 'd')
            out.push_back({at, at + 4, rest[1] - '0'});
    }
    return out;
}

core::Result<SeriesTimes> read_times(const std::string& text) {
    std::array<double, 3> numbers{};
    std::string_view rest = text;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [end, error] =
            std::from_chars(rest.data(), rest.data() + rest.size(), numbers[k]);
        const bool more = end != rest.data() + rest.size();
        if (error != std::errc() || !std::isfinite(numbers[k]) || more != (k < 2) ||
            (more && *end != ':'))
            return core::fail(Code::InvalidArgument,
                              fmt::format("--times: '{}' is not FIRST:LAST:EVERY", text),
                              "write three numbers, for example 0:20:0.1");
        if (more)
            rest = rest.substr(static_cast<std::size_t>(end - rest.data()) + 1);
    }
    if (!(numbers[2] > 0.0))
        return core::fail(Code::InvalidArgument,
                          fmt::format("--times: EVERY is {}, and must be above 0", numbers[2]),
                          "where time runs backward FIRST is the later one");
    return SeriesTimes{numbers[0], numbers[1], numbers[2]};
}

} // namespace

core::Result<std::optional<Series>> read_series(const std::string& output,
                                                const std::string& times) {
    const std::filesystem::path file(output);
    const bool animation = file.extension() == ".html";
    // The number stands in the name: a folder may be called anything.
    const std::size_t places = places_in(file.filename().string()).size();
    Series series{animation, {}};
    if (!times.empty()) {
        auto read = read_times(times);
        if (!read)
            return tl::unexpected(read.error());
        series.times = *read;
    }
    if (animation)
        return series;
    if (file.extension() == ".png" && (places > 0 || series.times))
        return core::fail(Code::InvalidArgument, "pictures of several times are a film",
                          "write .html, or use the page's film under Export");
    if (places > 1)
        return core::fail(Code::InvalidArgument,
                          fmt::format("-o: '{}' has {} places for the number", output, places),
                          pattern_hint);
    if (places == 1 && !series.times)
        return core::fail(
            Code::InvalidArgument,
            fmt::format("-o: '{}' names a series of files, and --times is missing", output),
            "add --times FIRST:LAST:EVERY");
    if (places == 0 && series.times)
        return core::fail(
            Code::InvalidArgument,
            fmt::format("--times: '{}' has no place for the number of a file", output),
            pattern_hint);
    return places == 1 ? std::optional(series) : std::nullopt;
}

core::Result<std::vector<double>> times_of(const Series& series, const core::SurfaceParameters& p) {
    const double sign = core::time_sign(p);
    std::vector<double> out;
    if (!series.times) {
        for (std::size_t k = 0; k < animation_steps; ++k)
            out.push_back(p.from + (p.to - p.from) * static_cast<double>(k) /
                                       static_cast<double>(animation_steps - 1));
        return out;
    }
    const auto [first, last, every] = *series.times;
    const double low = std::min(p.from, p.to);
    const double high = std::max(p.from, p.to);
    for (const double time : {first, last})
        if (!core::within_rounding(time, low, high))
            return core::fail(
                Code::InvalidArgument,
                fmt::format("--times: {} is outside the times of the surface, {} to {}",
                            core::time_text(time), core::time_text(p.from), core::time_text(p.to)),
                "choose times inside them, or other --from and --to");
    const double length = sign * (last - first);
    if (length < 0.0)
        return core::fail(Code::InvalidArgument,
                          fmt::format("--times: the surface moves from {} to {}, and the times run "
                                      "the other way",
                                      core::time_text(p.from), core::time_text(p.to)),
                          "exchange FIRST and LAST");
    const std::size_t most = series.animation ? most_steps : most_files;
    const double intervals = std::floor(length / every * (1.0 + 1e-12) + 1e-9);
    if (intervals + 1.0 > static_cast<double>(most))
        return core::fail(
            Code::InvalidArgument,
            fmt::format("--times: that are {:.0f} times, and at most {} can be written",
                        intervals + 1.0, most),
            "make EVERY larger");
    const auto count = static_cast<std::size_t>(intervals) + 1;
    for (std::size_t k = 0; k < count; ++k)
        out.push_back(std::clamp(first + sign * every * static_cast<double>(k), low, high));
    return out;
}

std::filesystem::path name_in(const std::string& pattern, std::size_t number) {
    const std::filesystem::path file(pattern);
    const std::string name = file.filename().string();
    const Place place = places_in(name).front();
    return file.parent_path() / fmt::format("{}{:0{}d}{}", name.substr(0, place.begin), number,
                                            place.width, name.substr(place.end));
}

} // namespace wakesurf::server
