// Streak and time surfaces run step by step, and the invariants of every one of them.
#pragma once

#include "core/surface/moving/moving_surface.hpp"
#include "tests/support/mesh_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::tests {

struct MovingRun {
    std::shared_ptr<const core::Flow> flow;
    core::Rake rake;
    core::SurfaceParameters parameters;
    std::string name;
};

inline core::Rake line_rake(const core::Vec3& a, const core::Vec3& b, std::uint32_t seeds = 12) {
    return {core::Rake::Kind::Line, {a, b}, seeds};
}

inline core::SurfaceParameters streak(double to, double separation) {
    return {.kind = core::SurfaceKind::Streak, .to = to, .separation = separation};
}

inline core::SurfaceParameters swept(const core::Vec3& sweep, double to, double separation) {
    core::SurfaceParameters p = streak(to, separation);
    p.kind = core::SurfaceKind::Time;
    p.sweep = sweep;
    return p;
}

/// Fails the test if the mesh may not be shown. @return  whether it may
inline bool expect_sound(const core::MovingSurface& surface, const core::KeyedMesh& shown) {
    const core::QuadComplex& mesh = shown.mesh;
    const double longest = core::longest_edge(mesh);
    const double separation = surface.state().separation;
    EXPECT_LE(longest, separation * (1.0 + 1e-6)) << "at " << surface.time();
    const std::string wrong = mesh.validate();
    EXPECT_EQ(wrong, "") << "at " << surface.time();
    const bool rising = std::is_sorted(shown.cell_id.begin(), shown.cell_id.end()) &&
                        std::is_sorted(shown.vertex_id.begin(), shown.vertex_id.end());
    EXPECT_TRUE(rising) << "at " << surface.time();
    return longest <= separation * (1.0 + 1e-6) && wrong.empty() && rising;
}

/// Runs a surface to its end and shows its mesh to `visit(surface, keyed mesh)` `looks` times on the way,
/// evenly, the last time at the end. 0: after every step. Stops at the first mesh that is not sound.
template <class Visit>
void follow(const MovingRun& request, int looks, const Visit& visit) {
    static const core::SteadyClock clock;
    auto surface = core::MovingSurface::start(
        core::plan_surface(*request.flow, request.rake, request.parameters).value(), {}, clock);
    ASSERT_TRUE(surface) << request.name << ": " << surface.error().message;
    const double from = surface->time(), end = surface->end_time();
    int look = 0;
    while (surface->time() != end) {
        const double next = looks == 0 ? end : std::lerp(from, end, (look + 1.0) / looks);
        ++look;
        if (looks == 0)
            ASSERT_TRUE(surface->step(end, {})) << request.name;
        else
            ASSERT_TRUE(surface->advance_to(look == looks ? end : next, {})) << request.name;
        const core::KeyedMesh shown = surface->mesh();
        if (!expect_sound(*surface, shown)) {
            ADD_FAILURE() << request.name << ": the mesh is not sound";
            return;
        }
        visit(*surface, shown);
    }
}

/// Cells at the rake grow from nothing: they are not judged.
inline MeshShape shape_of(const core::MovingSurface& surface, const core::KeyedMesh& shown) {
    const bool streak =
        surface.state().plan->request.plan.parameters.kind == core::SurfaceKind::Streak;
    return shape_of(shown.mesh, [&](const core::Cell& cell) {
        return !streak || std::ranges::none_of(cell.corner, [&](core::VertexId v) {
            return shown.mesh.t[v] == shown.time;
        });
    });
}

/// Returns the shape at the end; without quads if the surface could not be made.
inline MeshShape final_shape(const MovingRun& request) {
    MeshShape shape;
    follow(request, 1, [&](const core::MovingSurface& surface, const core::KeyedMesh& shown) {
        shape = shape_of(surface, shown);
    });
    return shape;
}

inline std::ostream& operator<<(std::ostream& out, const MeshShape& shape) {
    return out << shape.quads << " quads, " << 100.0 * shape.slivers << " % slivers, angles "
               << shape.angle5 << " / " << shape.median << ", " << shape.components
               << " components, " << shape.specks << " specks, " << shape.loops << " loops";
}

/// Returns how many of the ids `now` are not among those `before`; both ascend.
inline std::size_t born(const std::vector<std::uint32_t>& before,
                        const std::vector<std::uint32_t>& now) {
    std::vector<std::uint32_t> fresh;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(),
                        std::back_inserter(fresh));
    return fresh.size();
}

} // namespace wakesurf::tests
