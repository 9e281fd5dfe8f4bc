#include "core/surface/measures/error_spread.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

/// Vertices at which the divergence is sampled.
constexpr std::size_t most_samples = 2000;

std::uint64_t side_key(VertexId a, VertexId b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// Returns the sides that only one cell has.
std::unordered_set<std::uint64_t> border_of(const QuadComplex& mesh) {
    std::vector<std::uint64_t> sides;
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        for (std::uint32_t i = 0; i < outline.count; ++i)
            sides.push_back(side_key(outline.vertex[i], outline.vertex[(i + 1) % outline.count]));
    }
    std::ranges::sort(sides);
    std::unordered_set<std::uint64_t> border;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t same = i;
        while (same < sides.size() && sides[same] == sides[i])
            ++same;
        if (same == i + 1)
            border.insert(sides[i]);
        i = same;
    }
    return border;
}

/// Twice the mean curvature: the gradient of the area by a vertex's place, per area round it. None on the border.
std::vector<double> curvature_of(const QuadComplex& mesh,
                                 const std::unordered_set<std::uint64_t>& border) {
    std::vector<Vec3> gradient(mesh.vertices(), Vec3(0.0));
    std::vector<double> area(mesh.vertices(), 0.0);
    for (const Cell& cell : mesh.cells)
        visit_triangles(cell, [&](const std::array<VertexId, 3>& corner) {
            const auto& p = mesh.position;
            const Vec3 normal =
                glm::cross(p[corner[1]] - p[corner[0]], p[corner[2]] - p[corner[0]]);
            const double twice = glm::length(normal);
            if (!(twice > 0.0))
                return;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 opposite = p[corner[(i + 2) % 3]] - p[corner[(i + 1) % 3]];
                gradient[corner[i]] += 0.5 * glm::cross(normal / twice, opposite);
                area[corner[i]] += twice / 6.0;
            }
        });
    std::vector<double> out(mesh.vertices(), 0.0);
    for (std::size_t v = 0; v < out.size(); ++v)
        if (area[v] > 0.0)
            out[v] = glm::length(gradient[v]) / area[v];
    for (const std::uint64_t side : border)
        out[side >> 32] = out[side & 0xffffffffU] = 0.0;
    return out;
}

/// Returns the mean magnitude of the divergence at vertices, by central differences over the finest spacing.
Result<double> divergence_on(const SurfacePlan& plan,
                             const QuadComplex& mesh,
                             std::span<const double> times,
                             const std::stop_token& stop) {
    const Flow& flow = *plan.flow;
    const double step = 0.5 * flow.finest_spacing();
    const std::size_t stride = std::max<std::size_t>(1, mesh.vertices() / most_samples);
    std::vector<Vec3> places;
    std::vector<double> when;
    for (std::size_t v = 0; v < mesh.vertices(); v += stride) {
        std::array<Vec3, 6> round;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 offset(0.0);
            offset[axis] = step;
            round[2 * axis] = mesh.position[v] + offset;
            round[2 * axis + 1] = mesh.position[v] - offset;
        }
        if (!std::ranges::all_of(
                round, [&](const Vec3& p) { return flow.status(p) == PointStatus::Inside; }))
            continue;
        places.insert(places.end(), round.begin(), round.end());
        when.insert(when.end(), 6, times[v]);
    }
    if (places.empty())
        return 0.0;
    std::vector<Vec3> velocity(places.size());
    if (auto sampled = flow.sample(places, when, velocity, stop,
                                   plan.parameters.interpolation == Interpolation::Smooth);
        !sampled)
        return tl::unexpected(sampled.error());
    double sum = 0.0;
    for (std::size_t i = 0; i < velocity.size(); i += 6)
        sum += std::abs(velocity[i].x - velocity[i + 1].x + velocity[i + 2].y - velocity[i + 3].y +
                        velocity[i + 4].z - velocity[i + 5].z) /
               (2.0 * step);
    return sum / (static_cast<double>(velocity.size()) / 6.0);
}

} // namespace

Result<ErrorSpreader> ErrorSpreader::of(const SurfacePlan& plan,
                                        const QuadComplex& mesh,
                                        std::span<const double> times,
                                        const std::stop_token& stop) {
    const auto divergence = divergence_on(plan, mesh, times, stop);
    if (!divergence)
        return tl::unexpected(divergence.error());
    ErrorSpreader out;
    out.border_ = border_of(mesh);
    out.curvature_ = curvature_of(mesh, out.border_);
    out.divergence_ = *divergence;
    return out;
}

bool ErrorSpreader::on_border(VertexId a, VertexId b) const {
    return border_.contains(side_key(a, b));
}

ErrorSpread ErrorSpreader::spread(const QuadComplex& mesh,
                                  std::span<const VertexFunction> bounds,
                                  std::span<const double> errors) const {
    ErrorSpread out;
    visit_parts(mesh, bounds, [&](const SurfacePart& part) {
        const double area = glm::length(part.normal);
        Vec3 error = part.at_vertices(errors);
        for (int i = 0; i < 3; ++i)
            if (!std::isfinite(error[i])) {
                out.left_out += area * part.moment[i];
                error[i] = 0.0;
            }
        out.area += area * glm::dot(part.moment, error * part.at_vertices(curvature_));
        out.flux += area * divergence_ * glm::dot(part.moment, error);
        for (const PartSide& side : part.sides) {
            if (side.bound < 0) {
                const auto k = static_cast<std::size_t>(-1 - side.bound);
                if (!on_border(part.vertex[k], part.vertex[(k + 1) % 3]))
                    continue;
            }
            const Vec3 middle = 0.5 * (side.begin + side.end), change = side.end - side.begin;
            const double here = glm::dot(middle, error);
            Vec3 along(0.0), velocity(0.0);
            for (int i = 0; i < 3; ++i) {
                along += change[i] * mesh.position[part.vertex[i]];
                velocity += middle[i] * Vec3(mesh.velocity[part.vertex[i]]);
            }
            out.area += here * glm::length(along);
            out.flux += here * glm::length(glm::cross(velocity, along));
        }
    });
    return out;
}

} // namespace wakesurf::core
