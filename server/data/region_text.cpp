#include "server/data/region_text.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace wakesurf::server {

std::optional<core::Vec3> point_of(std::string_view text) {
    core::Vec3 out;
    for (int axis = 0; axis < 3; ++axis) {
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data(), end, out[axis]);
        const bool more = axis < 2;
        if (read.ec != std::errc{} || !std::isfinite(out[axis]) || (read.ptr != end) != more ||
            (more && *read.ptr != ','))
            return std::nullopt;
        text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()) + (more ? 1 : 0));
    }
    return out;
}

core::Result<core::Region> parse_region(const std::string& text, const std::string& option) {
    const auto wrong = [&](const std::string& what) {
        return core::fail(core::Error::Code::InvalidArgument, option + ": " + what,
                          "write plane:0,0,0:1,0,0 or box:0,0,0:1,1,1");
    };
    const auto first = text.find(':');
    const auto second = first == std::string::npos ? first : text.find(':', first + 1);
    const std::string kind = text.substr(0, first);
    if (second == std::string::npos || (kind != "plane" && kind != "box"))
        return wrong("'" + text + "' is neither plane:x,y,z:nx,ny,nz nor box:x,y,z:x,y,z");
    const auto a = point_of(std::string_view(text).substr(first + 1, second - first - 1));
    const auto b = point_of(std::string_view(text).substr(second + 1));
    if (!a || !b)
        return wrong("'" + text + "' is not a word and twice three finite numbers");
    if (kind == "plane") {
        // Normals as short or as long as numbers can be have no length that is one.
        const double largest = std::max({std::abs(b->x), std::abs(b->y), std::abs(b->z)});
        if (!(largest > 0.0))
            return wrong("the normal of the plane has no length");
        return core::Plane{*a, glm::normalize(*b / largest)};
    }
    const core::Box box{glm::min(*a, *b), glm::max(*a, *b)};
    const core::Vec3 extent = box.extent();
    if (!(extent.x > 0.0 && extent.y > 0.0 && extent.z > 0.0))
        return wrong("the box is flat: its corners have a coordinate in common");
    return box;
}

} // namespace wakesurf::server
