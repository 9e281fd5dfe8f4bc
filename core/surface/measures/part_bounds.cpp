#include "core/surface/measures/part_bounds.hpp"

#include <utility>
#include <variant>

namespace wakesurf::core {

std::vector<VertexFunction> age_bound(const std::vector<double>& ages, double age) {
    VertexFunction younger;
    for (const double each : ages)
        younger.push_back(age - each);
    return {std::move(younger)};
}

void add_bounds(std::vector<VertexFunction>& bounds,
                const QuadComplex& mesh,
                const Region& region) {
    const auto add = [&](const auto& function) {
        VertexFunction values;
        for (const Vec3& p : mesh.position)
            values.push_back(function(p));
        bounds.push_back(std::move(values));
    };
    if (const auto* plane = std::get_if<Plane>(&region)) {
        add([&](const Vec3& p) { return plane->height(p); });
        return;
    }
    const Box& box = std::get<Box>(region);
    for (int axis = 0; axis < 3; ++axis) {
        add([&](const Vec3& p) { return p[axis] - box.lo[axis]; });
        add([&](const Vec3& p) { return box.hi[axis] - p[axis]; });
    }
}

} // namespace wakesurf::core
