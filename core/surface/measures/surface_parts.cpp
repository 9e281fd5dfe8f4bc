#include "core/surface/measures/surface_parts.hpp"

#include <algorithm>

namespace wakesurf::core {

const SurfacePart* PartCutter::cut(const QuadComplex& mesh,
                                   const std::array<VertexId, 3>& triangle,
                                   std::span<const VertexFunction> bounds) {
    part_.vertex = triangle;
    const Vec3& p = mesh.position[triangle[0]];
    part_.normal = 0.5 * glm::cross(mesh.position[triangle[1]] - p, mesh.position[triangle[2]] - p);
    constexpr std::array<Vec3, 3> corner{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    part_.sides = {
        {corner[0], corner[1], -1}, {corner[1], corner[2], -2}, {corner[2], corner[0], -3}};
    for (std::size_t k = 0; k < bounds.size() && !part_.sides.empty(); ++k)
        keep(part_.at_vertices(bounds[k]), static_cast<int>(k));
    if (part_.sides.empty())
        return nullptr;
    part_.moment = Vec3(0.0);
    const Vec3& fan = part_.sides.front().begin;
    for (const PartSide& side : part_.sides) {
        const Vec3 a = side.begin - fan, b = side.end - fan;
        const double share = a.y * b.z - a.z * b.y; // of the triangle's area
        part_.moment += share / 3.0 * (fan + side.begin + side.end);
    }
    return &part_;
}

void PartCutter::keep(const Vec3& values, int bound) {
    if (std::min({values.x, values.y, values.z}) >= 0.0)
        return;
    std::swap(part_.sides, before_);
    part_.sides.clear();
    Vec3 left(0.0); // where the outline went out
    bool out = false, open = false;
    Vec3 first(0.0); // where it came in, if it began outside
    const auto cut_side = [&](const Vec3& from, const Vec3& to) {
        part_.sides.push_back({from, to, bound});
    };
    for (const PartSide& side : before_) {
        const double at_begin = glm::dot(side.begin, values), at_end = glm::dot(side.end, values);
        const bool begins_in = at_begin >= 0.0, ends_in = at_end >= 0.0;
        if (begins_in && ends_in) {
            part_.sides.push_back(side);
            continue;
        }
        if (!begins_in && !ends_in)
            continue;
        const Vec3 crossing = side.begin + at_begin / (at_begin - at_end) * (side.end - side.begin);
        if (begins_in) {
            part_.sides.push_back({side.begin, crossing, side.bound});
            left = crossing;
            out = true;
        } else {
            if (out)
                cut_side(left, crossing);
            else {
                first = crossing;
                open = true;
            }
            out = false;
            part_.sides.push_back({crossing, side.end, side.bound});
        }
    }
    if (out && open)
        cut_side(left, first);
}

} // namespace wakesurf::core
