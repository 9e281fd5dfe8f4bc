// Surfaces that leave the domain end at its border, and do not make and unmake cells there.
#include "core/field/analytic_flow.hpp"
#include "tests/support/moving_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace wakesurf::core::outflow_test {

namespace {

using namespace tests;

constexpr double at_face = 2e-6; ///< of the separation
/// The same of a vertex in the middle of an odd triangle's side, between two such places: interpolated.
constexpr double between_places = 1e-5;
constexpr double most_births = 3.3; ///< a step, of the seeds of a row
constexpr double most_births_at_once = 6.0;

/// How far inside the domain a point is.
double inside(const Box& box, const Vec3& p) {
    double least = 1e300;
    for (int axis = 0; axis < 3; ++axis)
        least = std::min({least, p[axis] - box.lo[axis], box.hi[axis] - p[axis]});
    return least;
}

/// What leaves by two sides of the domain at once is cut straight across the corner between them.
bool in_corner(const Box& box, const Vec3& p, double reach) {
    int near = 0;
    for (int axis = 0; axis < 3; ++axis)
        near += std::min(p[axis] - box.lo[axis], box.hi[axis] - p[axis]) < reach;
    return near > 1;
}

/// How far inside the domain the vertices are that end the surface where it leaves: on the border, but neither
/// on the rake nor on the sides that begin at its ends.
std::vector<double> depths(const KeyedMesh& shown, const Box& box, double separation) {
    const QuadComplex& mesh = shown.mesh;
    std::vector<double> all;
    for (const auto& [a, b] : border_edges(mesh))
        for (const VertexId v : {a, b})
            if (mesh.s[v] > 0.0 && mesh.s[v] < 1.0 && mesh.t[v] < shown.time &&
                !in_corner(box, mesh.position[v], 0.75 * separation))
                all.push_back(inside(box, mesh.position[v]));
    return all;
}

/// A streak surface of which everything released before has left at the time `constant`.
struct Leaving {
    const char* flow;
    Rake rake;
    double separation, constant, to;
    double growth =
        1.0; ///< area that leaves in a time, of what is released in it: no mesh can do with fewer births
};

const std::vector<Leaving>& leaving_surfaces() {
    static const std::vector<Leaving> all = {
        {"uniform", line_rake({8, -1, 0}, {8, 1, 0.3}), 0.1, 3, 5},
        {"uniform?u=1,v=0.3", line_rake({7, -1, 0}, {7.4, 1, 0.3}), 0.1, 4, 6},
        {"uniform?u=-1,v=0.2,w=-0.4", line_rake({-7, -1, 0}, {-7.4, 1, 0.3}), 0.13, 4, 6},
        {"stagnation", line_rake({-3, 3, 1}, {3, 3.2, 1.2}), 0.2, 1, 2.5, 2.3},
        {"stagnation", line_rake({-3, 2, 2}, {3, 2.3, 2.1}), 0.25, 2, 3.5, 2.6},
        {"strain?a=0.5,b=-0.5,c=0", line_rake({4, -3, 0}, {4, 3, 0.4}), 0.2, 2.5, 4},
    };
    return all;
}

MovingRun run_of(const Leaving& each) {
    return {*make_analytic_flow(each.flow), each.rake, streak(each.to, each.separation), each.flow};
}

} // namespace

TEST(Outflow, ASurfaceThatLeavesEndsAtTheFace) {
    for (const Leaving& each : leaving_surfaces()) {
        const MovingRun asked = run_of(each);
        const Box box = asked.flow->domain();
        std::vector<double> all;
        std::size_t looks = 0;
        follow(asked, 10, [&](const MovingSurface& surface, const KeyedMesh& shown) {
            for (const Vec3& p : shown.mesh.position)
                ASSERT_GE(inside(box, p), -at_face * each.separation) << each.flow;
            if (surface.time() >= each.constant) {
                const std::vector<double> now = depths(shown, box, each.separation);
                all.insert(all.end(), now.begin(), now.end());
                ++looks;
            }
        });
        EXPECT_GE(looks, 4u) << each.flow;
        std::sort(all.begin(), all.end());
        EXPECT_LE(all.back() / each.separation, between_places) << each.flow;
        EXPECT_LE(all[all.size() * 98 / 100] / each.separation, at_face) << each.flow;
    }
}

TEST(Outflow, AUniformFlowsSheetReachesTheFace) {
    const MovingRun asked = run_of(leaving_surfaces()[0]);
    follow(asked, 5, [&](const MovingSurface& surface, const KeyedMesh& shown) {
        if (surface.time() < 2.5)
            return;
        double farthest = 0.0;
        for (const Vec3& p : shown.mesh.position)
            farthest = std::max(farthest, p.x);
        EXPECT_NEAR(farthest, 10.0, at_face * asked.parameters.separation);
        // Two long, and as wide as the rake: nothing is missing and nothing is doubled.
        double area = 0.0;
        for (const Cell& cell : shown.mesh.cells)
            area += glm::length(CellOutline(shown.mesh, cell).area);
        EXPECT_NEAR(area, 2.0 * std::hypot(2.0, 0.3), 1e-6);
    });
}

TEST(Outflow, ATimeSurfaceIsCutOffAtTheFaceAndGoesWhole) {
    const MovingRun asked{*make_analytic_flow("uniform?u=1,v=0.25"),
                          line_rake({8, -1, 0}, {9, -0.9, 0.2}), swept({0.1, 2, 0}, 2.2, 0.1),
                          "uniform"};
    double last = 1e300;
    follow(asked, 22, [&](const MovingSurface& surface, const KeyedMesh& shown) {
        double area = 0.0;
        for (const Cell& cell : shown.mesh.cells)
            area += glm::length(CellOutline(shown.mesh, cell).area);
        EXPECT_LE(area, last + 1e-9);
        last = area;
        const bool leaving = surface.time() > 1.05 && surface.time() < 1.8;
        if (leaving && !shown.mesh.cells.empty()) {
            double farthest = 0.0;
            for (const Vec3& p : shown.mesh.position)
                farthest = std::max(farthest, p.x);
            EXPECT_NEAR(farthest, 10.0, at_face * asked.parameters.separation)
                << "at " << surface.time();
        }
    });
    EXPECT_EQ(last, 0.0);
}

/// Released rows are births as well, one row in most steps.
TEST(Outflow, BirthsAStepAreAFewRowsOnceTheSurfaceHasConstantSize) {
    for (const Leaving& each : leaving_surfaces()) {
        std::vector<std::uint32_t> before;
        double seeds = 0.0, births = 0.0, most = 0.0, steps = 0.0;
        follow(run_of(each), 0, [&](const MovingSurface& surface, const KeyedMesh& shown) {
            if (surface.time() > each.constant && !before.empty()) {
                const auto now = static_cast<double>(born(before, shown.vertex_id));
                births += now;
                most = std::max(most, now);
                ++steps;
            }
            before = shown.vertex_id;
            seeds = static_cast<double>(
                std::count(shown.mesh.t.begin(), shown.mesh.t.end(), shown.time));
        });
        ASSERT_GT(steps, 5.0) << each.flow;
        ASSERT_GT(seeds, 10.0) << each.flow;
        const double mean = births / steps / seeds;
        EXPECT_TRUE(mean <= most_births * each.growth &&
                    most / seeds <= most_births_at_once * each.growth)
            << each.flow << ": " << mean << " of " << seeds << " seeds, at most " << most / seeds;
    }
}

} // namespace wakesurf::core::outflow_test
