#include "server/app/series_request.hpp"

#include "server/live/animation_file.hpp"

#include <fmt/format.h>

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

} // namespace

core::Result<std::optional<Series>> read_series(const std::string& output,
                                                const std::string& times) {
    const std::filesystem::path file(output);
    const bool animation = file.extension() == ".html";
    const bool numbers = file.extension() == ".csv";
    // The number stands in the name: a folder may be called anything.
    const std::size_t places = places_in(file.filename().string()).size();
    Series series{animation ? Series::Form::Animation
                  : numbers ? Series::Form::Numbers
                            : Series::Form::Files,
                  {}};
    if (!times.empty()) {
        auto read = read_times(times, "--times");
        if (!read)
            return tl::unexpected(read.error());
        series.times = *read;
    }
    if (animation || numbers)
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
    if (!series.times && series.form == Series::Form::Numbers)
        return std::vector<double>{p.to};
    if (!series.times)
        return even_times(p, animation_steps);
    return times_in(*series.times, p, series.form == Series::Form::Files ? most_files : most_steps,
                    "--times");
}

std::filesystem::path name_in(const std::string& pattern, std::size_t number) {
    const std::filesystem::path file(pattern);
    const std::string name = file.filename().string();
    const Place place = places_in(name).front();
    return file.parent_path() / fmt::format("{}{:0{}d}{}", name.substr(0, place.begin), number,
                                            place.width, name.substr(place.end));
}

} // namespace wakesurf::server
