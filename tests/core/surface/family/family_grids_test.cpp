// The same family on every kind of grid: a uniform flow across the unit cube.
#include "core/field/stored_flow.hpp"
#include "core/surface/family/family_trace.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::core::family_grids_test {
namespace {

const Vec3 velocity(1.0, 0.5, 0.25);

struct Named {
    const char* name;
    Grid grid;
};

std::vector<Named> grids() {
    using Kind = tests::TwoToOne::Kind;
    RectilinearGrid axes;
    axes.coordinates = {std::vector{0.0, 0.1, 0.3, 0.35, 0.8, 1.0}, std::vector{0.0, 0.5, 0.6, 1.0},
                        std::vector{0.0, 0.2, 0.7, 0.75, 1.0}};
    const auto fine = [](const Vec3& u) { return u.x < 0.5 ? Kind::Fine : Kind::Coarse; };
    return {{"uniform", UniformGrid{Vec3(0), Vec3(0.125), {9, 9, 9}}},
            {"rectilinear", axes},
            {"hexahedra", tests::block({6, 5, 4}, tests::wavy)},
            {"polyhedra", tests::TwoToOne(4, fine, tests::wavy).take()}};
}

Result<FamilyField> carried(const Grid& grid, const FamilyRequest& request) {
    const auto source = std::make_shared<tests::SampledSource>(
        grid, std::vector{0.0}, [](const Vec3&, double) { return velocity; });
    const auto flow =
        make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
    const std::vector<Vec3> some{Vec3(0.5)};
    return plan_family(*flow, request, 0.0, some, {}).and_then([&](const FamilyPlan& plan) {
        return trace_family(*flow, source->grid(), plan, {}, {});
    });
}

TEST(FamilyGrids, CarryTheScalarOfTheInflowToEveryNode) {
    for (const auto& [name, grid] : grids()) {
        SCOPED_TRACE(name);
        const auto field = carried(grid, {FamilyInflow{}, "y"});
        ASSERT_TRUE(field) << field.error().message;
        const FamilyCounts& n = field->counts;
        EXPECT_EQ(n.reached, n.nodes)
            << n.at_rest << ' ' << n.obstacle << ' ' << n.lost << ' ' << n.outside;
        for (std::size_t i = 0; i < node_count(grid); ++i) {
            const Vec3 p = node_position(grid, i);
            const Vec3 back = p / velocity;
            EXPECT_NEAR(field->values[i], p.y - 0.5 * std::min({back.x, back.y, back.z}), 1e-5)
                << p.x << ' ' << p.y << ' ' << p.z;
        }
    }
}

TEST(FamilyGrids, CarryTheScalarOfAPlaneUpstreamAndDownstream) {
    for (const auto& [name, grid] : grids()) {
        SCOPED_TRACE(name);
        const auto field = carried(grid, {FamilyPlane{{0.5, 0, 0}, {1, 0, 0}}, "z"});
        ASSERT_TRUE(field) << field.error().message;
        std::size_t reached = 0;
        for (std::size_t i = 0; i < node_count(grid); ++i) {
            const Vec3 p = node_position(grid, i);
            const Vec3 met = p + velocity * (0.5 - p.x);
            const double inside = std::min({met.y, 1.0 - met.y, met.z, 1.0 - met.z});
            if (std::abs(inside) < 1e-6) // where it meets the plane's border, either is right
                continue;
            reached += inside > 0.0 ? 1 : 0;
            EXPECT_EQ(std::isfinite(field->values[i]), inside > 0.0)
                << p.x << ' ' << p.y << ' ' << p.z;
            if (inside > 0.0) {
                EXPECT_NEAR(field->values[i], met.z, 1e-5);
            }
        }
        EXPECT_GT(reached, node_count(grid) / 4);
    }
}

} // namespace
} // namespace wakesurf::core::family_grids_test
