#include "server/app/rake_text.hpp"

#include "core/surface/rake.hpp"
#include "protocol/api/generated/names.hpp"
#include "server/data/import_process.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string>

namespace wakesurf::server {

namespace {

constexpr auto invalid = core::Error::Code::InvalidArgument;
constexpr std::string_view blanks = " \t\n";

std::optional<core::Vec3> point_of(std::string_view word) {
    std::array<double, 3> xyz{};
    const char* at = word.data();
    const char* const end = at + word.size();
    for (std::size_t i = 0; i < xyz.size(); ++i) {
        if (i > 0 && (at == end || *at++ != ','))
            return std::nullopt;
        const auto [rest, fault] = std::from_chars(at, end, xyz[i]);
        if (fault != std::errc{})
            return std::nullopt;
        at = rest;
    }
    if (at != end)
        return std::nullopt;
    return core::Vec3(xyz[0], xyz[1], xyz[2]);
}

/// Tells the name of a file from points: 1.e5 has an extension, but only one letter in it.
bool names_file(std::string_view text) {
    const std::string extension = std::filesystem::path(text).extension().string();
    return std::ranges::count_if(extension, [](unsigned char c) { return std::isalpha(c) != 0; }) >
           1;
}

core::Result<std::vector<core::Vec3>> parse_points(std::string_view text,
                                                   const std::string& option) {
    std::vector<core::Vec3> points;
    for (auto start = text.find_first_not_of(blanks); start != std::string_view::npos;) {
        const auto stop = std::min(text.find_first_of(blanks, start), text.size());
        const auto point = parse_vector(text.substr(start, stop - start), option);
        if (!point)
            return tl::unexpected(point.error());
        points.push_back(*point);
        start = text.find_first_not_of(blanks, stop);
    }
    return points;
}

} // namespace

core::Result<core::Vec3> parse_vector(std::string_view text, const std::string& option) {
    const auto point = point_of(text);
    if (!point)
        return core::fail(invalid, option + ": '" + std::string(text) + "' is not a point",
                          "write points as x,y,z and separate them by spaces");
    if (!core::finite(*point))
        return core::fail(invalid, option + ": '" + std::string(text) + "' is not finite");
    return *point;
}

core::Result<core::Rake> parse_rake(std::string_view text,
                                    std::uint32_t seeds,
                                    const std::string& option,
                                    std::string_view kind) {
    auto points = names_file(text) ? read_rake_with_import_process(text, kind == "points")
                                         .map_error([&](core::Error error) {
                                             error.message = option + ": " + error.message;
                                             return error;
                                         })
                                   : parse_points(text, option);
    if (!points)
        return tl::unexpected(points.error());
    core::Rake rake{.kind = core::Rake::Kind::Line, .points = std::move(*points), .seeds = seeds};
    if (rake.points.size() < 2)
        return core::fail(invalid, option + ": fewer than two points",
                          "as in " + option + " \"0,0,0 0,0,1\"");
    if (kind.empty()) {
        if (rake.points.size() > 2)
            rake.kind = core::Rake::Kind::Polyline;
        return rake;
    }
    const auto known = protocol::value_of<core::Rake::Kind>(kind);
    if (!known)
        return core::fail(invalid, option + "-kind must be line, polyline, circle or points");
    rake.kind = *known;
    if (auto sound = core::check_rake(rake); !sound)
        return core::fail(invalid, option + ": " + sound.error().message, sound.error().hint);
    return rake;
}

} // namespace wakesurf::server
