// The level set 0 of a curve's family, and the stream surface that the engine builds from the same curve.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/family/family_trace.hpp"
#include "tests/support/level_set.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace wakesurf::core::family_twin_test {
namespace {

struct Twin {
    const char* flow;
    Box box; ///< of the nodes; the curve goes from one side of it to the other, or is closed
    Rake curve;
    double to = 25.0;
    Direction direction = Direction::Both;
    double jump =
        std::numeric_limits<double>::infinity(); ///< by which the value differs where a turn begins
};

std::vector<Twin> twins() {
    using Kind = Rake::Kind;
    const Box ten{Vec3(-10), Vec3(10)};
    return {
        {"uniform?u=1,v=0.5,w=0.25", ten, {Kind::Line, {{-8, -4, -10}, {-8, -4, 10}}}},
        {"shear?u=2,g=0.1",
         Box{{-10, -10, -10}, {10, 10, 10}},
         {Kind::Line, {{0, -10, -10}, {0, 10, 10}}}},
        {"rotation?omega=1,w=0.2",
         Box{{-7, -7, -3}, {7, 7, 3}},
         {Kind::Line, {{0.01, 0, -1}, {10, 0, -1}}},
         6.283,
         Direction::Forward,
         1.0}, // a turn, in which it changes by 1.26
        {"strain?a=0.5,b=-0.5,c=0", ten, {Kind::Line, {{-10, 8, -5}, {10, 8, 5}}}},
        {"cylinder?u=1,a=0.5,w=0.2",
         Box{{-4, -3, -3}, {6, 3, 3}},
         {Kind::Circle, {{-3, 0.3, 0}, {-3, 1.5, 0}, {-3, 0.3, 1}}}},
    };
}

TEST(FamilyTwin, TheLevelThroughACurveIsTheStreamSurfaceFromIt) {
    constexpr std::uint32_t each = 41;
    for (const Twin& twin : twins()) {
        SCOPED_TRACE(twin.flow);
        const auto flow = make_analytic_flow(twin.flow).value();
        const UniformGrid grid{
            twin.box.lo, twin.box.extent() / double(each - 1), {each, each, each}};
        const std::vector<Vec3> some{twin.curve.points.front(), twin.curve.points.back()};
        const double cell = std::max({grid.spacing.x, grid.spacing.y, grid.spacing.z});
        const auto plan = value_of(plan_family(*flow, {twin.curve}, 0.0, some, {}));
        const auto field = value_of(trace_family(*flow, grid, plan, {}, {}));
        SurfaceParameters parameters{
            .to = twin.to, .direction = twin.direction, .separation = 0.4 * cell};
        const auto surface = value_of(build_surface(*flow, twin.curve, parameters));
        const auto level = tests::level_points(grid, field.values, 0.0);
        const tests::NearPoints near_level(level, 2.0 * cell);
        const tests::NearPoints near_surface(surface.mesh.position, 2.0 * cell);
        double from_surface = 0.0;
        std::size_t looked = 0;
        for (const Vec3& p : surface.mesh.position)
            if (tests::all_known(grid, field.values, p, twin.jump)) {
                from_surface = std::max(from_surface, near_level.distance(p));
                ++looked;
            }
        double from_level = 0.0;
        for (const Vec3& p : level)
            if (twin.jump > 1e9 || tests::all_known(grid, field.values, p, twin.jump))
                from_level = std::max(from_level, near_surface.distance(p));
        EXPECT_GT(looked, 500u);
        EXPECT_GT(level.size(), 500u);
        EXPECT_LE(from_surface, cell);
        EXPECT_LE(from_level, cell);
    }
}

} // namespace
} // namespace wakesurf::core::family_twin_test
