#include "core/surface/moving/step_length.hpp"

#include "core/surface/moving/moving_plan.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr double growth_a_step =
    0.5; // of an edge's length: Hermite interpolation wants edges cut before they double
constexpr double least_of_row =
    1.0 / 16.0; // of the time between rows: one violent cell must not stop the others

/// Returns the larger of `most` and the fastest relative growth of a triangle's edges, of those longer than
/// `shortest`. Roots are taken only of what may exceed `most`.
double fastest_growth(const MovingMesh& mesh, const Triangle& t, double shortest, double most) {
    for (unsigned k = 0; k < 3; ++k) {
        const VertexId a = t.begin(k), b = t.end(k);
        const Vec3 edge = mesh.edge(a, b);
        const Vec3 apart(mesh.vertices.velocity[b] - mesh.vertices.velocity[a]);
        const double length2 = glm::dot(edge, edge);
        const double apart2 = glm::dot(apart, apart);
        if (apart2 < most * most * length2 * (1.0 - 1e-9))
            continue;
        if (const double length = std::sqrt(length2); length > shortest)
            most = std::max(most, std::sqrt(apart2) / length);
    }
    return most;
}

} // namespace

double
step_length(const MovingMesh& mesh, double to, double separation, bool releasing, bool refines) {
    const MaterialVertices& v = mesh.vertices;
    double rake_speed = 0.0;
    double speed = 0.0;
    for (VertexId i = 0; i < v.slots(); ++i) {
        if (v.role[i] == VertexRole::Unused || v.dead(i))
            continue;
        const double here = glm::length(v.velocity[i]);
        speed = std::max(speed, here);
        if (v.role[i] == VertexRole::Attached)
            rake_speed = std::max(rake_speed, here);
    }
    const double left = std::abs(to - mesh.time);
    const double driving = releasing && rake_speed > 0.0 ? rake_speed : speed;
    if (!(driving > 0.0))
        return left;
    const double row = row_spacing * separation / driving;
    if (!refines) // nothing is interpolated between what has moved
        return std::min(left, row);
    const auto slots = mesh.triangles.slots();
    const double shortest = 0.1 * separation;
    const double growth = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, slots.size(), 4096), 0.0,
        [&](const auto& range, double most) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                if (slots[i].live)
                    most = fastest_growth(mesh, slots[i], shortest, most);
            return most;
        },
        [](double a, double b) { return std::max(a, b); });
    const double safe = growth > 0.0 ? growth_a_step / growth : row;
    return std::min(left, std::clamp(safe, least_of_row * row, row));
}

} // namespace wakesurf::core
