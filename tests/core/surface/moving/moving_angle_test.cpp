// SurfaceParameters::angle on streak and time surfaces: fewer neighbouring cells meet at a large angle, as
// far as the quad limit allows.
#include "core/field/analytic_flow.hpp"
#include "tests/support/moving_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wakesurf::core::moving_angle_test {

namespace {

using namespace tests;

struct Turns {
    std::size_t quads = 0;
    double over = 0.0; ///< share of the neighbours that meet at more than 20 degrees
    double separation = 0.0;
};

Turns turns_of(MovingRun request, double angle, std::uint64_t most = 1'000'000) {
    request.parameters.angle = angle;
    request.parameters.max_quads = most;
    Turns turns;
    follow(request, 1, [&](const MovingSurface& surface, const KeyedMesh& shown) {
        const DirectedEdges edges(shown.mesh);
        std::size_t all = 0, over = 0;
        for (const auto& edge : edges.all())
            if (const auto* back = edges.find(edge.to, edge.from); back && edge.from < edge.to) {
                const Vec3 here = CellOutline(shown.mesh, shown.mesh.cells[edge.cell]).area;
                const Vec3 there = CellOutline(shown.mesh, shown.mesh.cells[back->cell]).area;
                ++all;
                over += glm::dot(here, there) < std::cos(20.0 * std::numbers::pi / 180.0) *
                                                    glm::length(here) * glm::length(there);
            }
        turns = {shown.mesh.cells.size(), static_cast<double>(over) / static_cast<double>(all),
                 surface.state().separation};
    });
    return turns;
}

std::vector<MovingRun> bent() {
    const auto run = [](const char* flow, const Rake& rake, const SurfaceParameters& p) {
        return MovingRun{*make_analytic_flow(flow), rake, p, flow};
    };
    return {run("abc?C=1", line_rake({0, 0, 0}, {2, 0.3, 1}), streak(6, 0.3)),
            run("abc", line_rake({0, 0, 0}, {2, 0.3, 1}), streak(5, 0.25)),
            run("abc", line_rake({-1, 0, 0}, {1, 0, 0.5}), swept({0, 1, 1}, 3, 0.2)),
            run("abc", line_rake({-1, 0, 0}, {1, 0, 0.5}), swept({0, 1, 1}, 4, 0.1))};
}

} // namespace

TEST(MovingAngle, FewerNeighboursMeetAtMoreThanTwentyDegreesThanWithoutIt) {
    for (const MovingRun& request : bent()) {
        const Turns any = turns_of(request, 180.0);
        EXPECT_GT(any.over, 0.01) << request.name;
        for (const double angle : {20.0, 12.0}) {
            const Turns few = turns_of(request, angle);
            EXPECT_LE(few.over, 0.6 * any.over) << request.name << " " << angle;
            EXPECT_GT(few.quads, any.quads) << request.name << " " << angle;
        }
    }
}

TEST(MovingAngle, IsKeptWithinTheQuadLimitAtALargerSeparation) {
    for (const MovingRun& request : bent()) {
        const std::uint64_t most = turns_of(request, 12.0).quads / 2;
        const Turns few = turns_of(request, 12.0, most);
        EXPECT_LE(few.quads, most) << request.name;
        EXPECT_GT(few.separation, request.parameters.separation) << request.name;
    }
}

} // namespace wakesurf::core::moving_angle_test
