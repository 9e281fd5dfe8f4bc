#include "server/data/line_seeds_text.hpp"

#include "server/data/region_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace wakesurf::server {

namespace {

using Kind = core::LineSeeds::Kind;

struct KindOfSeeds {
    std::string_view word;
    std::size_t points;
    bool distance;
};

constexpr std::array<KindOfSeeds, 5> kinds_of_seeds{{{"line", 2, false},
                                                     {"plane", 3, false},
                                                     {"sphere", 1, true},
                                                     {"walls", 0, true},
                                                     {"along", 0, false}}};

std::optional<double> distance_of(std::string_view text) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    return read.ec == std::errc{} && read.ptr == end && std::isfinite(number)
               ? std::optional(number)
               : std::nullopt;
}

} // namespace

core::Result<core::LineSeeds> parse_line_seeds(const std::string& text, const std::string& option) {
    const auto wrong = core::fail(
        core::Error::Code::InvalidArgument,
        option + ": '" + text.substr(0, 200) +
            "' is neither line:x,y,z:x,y,z, plane:x,y,z:x,y,z:x,y,z, sphere:x,y,z:radius, "
            "walls:distance nor along",
        "as in line:0,0,0:1,0,0, plane:0,0,0:1,0,0:0,1,0 (a corner and those beside it), "
        "sphere:0,0,0:0.5, walls:0.1 or along (on the walls, which the lines follow)");
    std::vector<std::string_view> parts;
    for (std::string_view rest = text;;) {
        const auto end = rest.find(':');
        parts.push_back(rest.substr(0, end));
        if (end == std::string_view::npos)
            break;
        rest.remove_prefix(end + 1);
    }
    const auto* const kind =
        std::find_if(kinds_of_seeds.begin(), kinds_of_seeds.end(),
                     [&](const KindOfSeeds& each) { return each.word == parts.front(); });
    if (kind == kinds_of_seeds.end() || parts.size() != 1 + kind->points + (kind->distance ? 1 : 0))
        return wrong;
    core::LineSeeds seeds;
    seeds.kind = static_cast<Kind>(kind - kinds_of_seeds.begin());
    for (std::size_t i = 1; i <= kind->points; ++i) {
        const auto point = point_of(parts[i]);
        if (!point)
            return wrong;
        seeds.points.push_back(*point);
    }
    if (kind->distance) {
        const auto distance = distance_of(parts.back());
        if (!distance)
            return wrong;
        seeds.distance = *distance;
    }
    return seeds;
}

std::string line_seeds_text(const core::LineSeeds& seeds) {
    const KindOfSeeds& kind = kinds_of_seeds[static_cast<std::size_t>(seeds.kind)];
    std::string out(kind.word);
    for (const core::Vec3& each : seeds.points)
        out += fmt::format(":{},{},{}", each.x, each.y, each.z);
    return kind.distance ? fmt::format("{}:{}", out, seeds.distance) : out;
}

} // namespace wakesurf::server
