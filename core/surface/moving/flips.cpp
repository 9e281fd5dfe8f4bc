#include "core/surface/moving/flips.hpp"

#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/split_criteria.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <cmath>

namespace wakesurf::core {

namespace {

/// Cosine of the angle at which two new triangles may meet, unless the old ones met at a larger one.
constexpr double least_flat = 0.766; // 40 degrees
constexpr double sliver = 0.1;       ///< quality

/// Returns the cotangent of an angle by squared lengths: of the two sides at it, and of the third.
double cotangent(double p, double q, double across) {
    const double twice_dot = p + q - across;
    return twice_dot /
           std::sqrt(std::max(4.0 * p * q - twice_dot * twice_dot, 1e-12 * p * q + 1e-300));
}

} // namespace

bool should_flip(const RefinementContext& context, TriangleId t, unsigned k) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    const TriangleId u = here.across[k];
    if (u == no_triangle)
        return false;
    const VertexId a = here.begin(k), b = here.end(k), c = here.opposite(k);
    const VertexId d = mesh.triangles.opposite_beyond(t, k);
    if (c == d)
        return false;
    const double ab = squared_length(mesh, a, b);
    const double ac = squared_length(mesh, a, c), bc = squared_length(mesh, b, c);
    const double ad = squared_length(mesh, a, d), bd = squared_length(mesh, b, d);
    const double cd = squared_length(mesh, c, d);
    const int webs_before = is_web(mesh, a, b, c) + is_web(mesh, b, a, d);
    const int webs_after = is_web(mesh, a, d, c) + is_web(mesh, d, b, c);
    if (webs_after > webs_before)
        return false;
    const Vec3 old_t = area_vector(mesh, a, b, c), old_u = area_vector(mesh, b, a, d);
    const Vec3 new_t = area_vector(mesh, a, d, c), new_u = area_vector(mesh, d, b, c);
    const double before = std::min(quality_of(squared(old_t), ab + bc + ac),
                                   quality_of(squared(old_u), ab + ad + bd));
    const double after = std::min(quality_of(squared(new_t), ad + cd + ac),
                                  quality_of(squared(new_u), bd + bc + cd));
    if (webs_after == webs_before) {
        if (!(cotangent(ac, bc, ab) + cotangent(ad, bd, ab) < -1e-3)) // Delaunay already
            return false;
        if (!(after > before)) // on an uneven surface it might go on for ever
            return false;
        if (cd > context.squared_separation() && cd > ab * (1.0 - 1e-9))
            return false;
    }
    if (!(material_area(mesh, a, d, c) > least_material) ||
        !(material_area(mesh, d, b, c) > least_material))
        return false;
    const double flat_before = cosine_between(old_t, old_u, 0.0);
    const double flat_after = cosine_between(new_t, new_u, -1.0);
    if (webs_after == webs_before && flat_after < std::min(least_flat, flat_before) &&
        !(before < sliver && flat_after > 0.0))
        return false;
    if (mesh.lattice.closed && std::abs(mesh.parameter_step(c, d).s) > 0.3)
        return false; // the short way round would not be the surface's
    // It would be cut again, and joined again, in every step.
    if (webs_after == webs_before && bulges(context, c, d, 0.8) &&
        squared(edge_bend(mesh, c, d)) > squared(edge_bend(mesh, a, b)))
        return false;
    return mesh.triangles.find(c, d).triangle == no_triangle &&
           mesh.triangles.find(d, c).triangle == no_triangle &&
           !crosses_obstacle(context, c, d, cd);
}

void flip_all(const RefinementContext& context, std::vector<TriangleId>& queue) {
    MaterialTriangles& triangles = context.mesh.triangles;
    const std::size_t most = queue.size() * 20 + 1000;
    for (std::size_t i = 0; i < queue.size() && i < most && !context.stop.stop_requested(); ++i) {
        const TriangleId t = queue[i];
        if (!triangles[t].live)
            continue;
        for (unsigned k = 0; k < 3; ++k)
            if (should_flip(context, t, k)) {
                queue.push_back(t);
                queue.push_back(triangles[t].across[k]);
                triangles.flip(t, k);
                break;
            }
    }
    queue.clear();
}

} // namespace wakesurf::core
