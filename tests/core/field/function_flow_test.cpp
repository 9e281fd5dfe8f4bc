#include "core/field/function_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::core::function_flow_test {

namespace {

const Box box{Vec3(-2.0), Vec3(2.0)};

Vec3 along_x(const Vec3&, double) {
    return {1.0, 0.0, 0.0};
}

Result<Surface> stream(const Flow& flow) {
    SurfaceParameters asked{.to = 3.0, .separation = 0.1};
    return build_surface(flow, {Rake::Kind::Line, {{-1.5, -1.0, 0.0}, {-1.5, 1.0, 0.0}}, 21},
                         asked);
}

} // namespace

TEST(FunctionFlow, IsKnownInItsBoxAtAllTimesWithoutAnObstacle) {
    const auto flow = make_function_flow(along_x, box);
    EXPECT_FALSE(flow->time_range());
    EXPECT_EQ(flow->domain().lo, box.lo);
    EXPECT_EQ(flow->domain().hi, box.hi);
    EXPECT_FALSE(flow->obstacle());
    EXPECT_TRUE(flow->walls().triangles.empty());
    EXPECT_EQ(flow->status(Vec3(0.0)), PointStatus::Inside);
    EXPECT_EQ(flow->status(Vec3(3.0, 0.0, 0.0)), PointStatus::OutsideDomain);
    EXPECT_DOUBLE_EQ(flow->finest_spacing(), 0.04);
}

TEST(FunctionFlow, IsSampledAtThePlaceAndTimeThatIsAskedFor) {
    const auto flow =
        make_function_flow([](const Vec3& p, double t) { return Vec3(p.y, 2.0 * p.x, t); }, box);
    const Vec3 place(0.5, -1.0, 0.25);
    const double time = 7.0;
    Vec3 velocity;
    ASSERT_TRUE(flow->sample({&place, 1}, {&time, 1}, {&velocity, 1}, {}));
    EXPECT_EQ(velocity, Vec3(-1.0, 1.0, 7.0));
}

TEST(FunctionFlow, EndsParticlesInABodyThatNeedsNoWallToLookAt) {
    const auto solid = [](const Vec3& p) { return p.x > 0.5 && std::abs(p.y) < 0.5; };
    const auto flow = make_function_flow(along_x, box, {solid});
    EXPECT_TRUE(flow->obstacle());
    EXPECT_EQ(flow->status(Vec3(1.0, 0.0, 0.0)), PointStatus::InObstacle);
    const auto surface = stream(*flow);
    ASSERT_TRUE(surface);
    EXPECT_GT(surface->statistics.terminated.obstacle, 0u);
    for (const Vec3& p : surface->mesh.position)
        EXPECT_FALSE(p.x > 0.5 + 1e-6 && std::abs(p.y) < 0.4) << p.x << ", " << p.y;
    EXPECT_EQ(stream(*make_function_flow(along_x, box))->statistics.terminated.obstacle, 0u);
}

} // namespace wakesurf::core::function_flow_test
