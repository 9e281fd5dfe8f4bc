// What a probe says where the data have no velocity, at the time that it asks for, and of what is made of the velocity.
#include "core/field/stored_flow.hpp"
#include "server/data/probe.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wakesurf::server::probe_test {
namespace {

using core::Vec3;

TEST(Probe, IsOutsideAndHasNoNumberWhereTheDataHaveNone) {
    core::DatasetInfo info;
    info.velocity = "U";
    const auto flow = core::make_stored_flow(std::make_shared<core::TimeStepCache>(
        std::make_shared<tests::SampledSource>(
            core::UniformGrid{{0, 0, 0}, Vec3(0.25), {9, 9, 9}}, std::vector{0.0, 1.0, 2.0},
            [](const Vec3& p, double t) {
                return p.z > (t > 1.5 ? 1.3 : 1.8) ? Vec3(std::numeric_limits<double>::quiet_NaN())
                                                   : Vec3(1.0, 0.3 * p.z, 0.2);
            }),
        core::TimeStepCache::Options{}));
    const ProbeRequest request{{{1, 1, 1.1}, {1, 1, 1.6}, {1, 1, 1.9}}, 1.0, {}};
    const auto found = probe({info, *flow, nullptr}, request, {});
    ASSERT_TRUE(found.has_value()) << found.error().message;
    EXPECT_EQ(found->inside, (std::vector{true, true, false}));
    EXPECT_NEAR(found->fields[0].vectors[1].y, 0.48, 1e-6);
    EXPECT_TRUE(std::isnan(found->fields[0].vectors[2].x));
    const auto later = probe({info, *flow, nullptr}, {request.points, 1.25, {}}, {});
    ASSERT_TRUE(later.has_value());
    EXPECT_EQ(later->inside, (std::vector{true, false, false}));
    EXPECT_TRUE(std::isnan(later->fields[0].vectors[1].x));
}

TEST(Probe, HasWhatIsMadeOfTheVelocityAsOfAnyField) {
    core::DatasetInfo info;
    info.velocity = "U";
    // A rigid rotation at 3 about z, which rises at 2: vorticity 6, Q 9.
    const auto flow = core::make_stored_flow(std::make_shared<core::TimeStepCache>(
        std::make_shared<tests::SampledSource>(
            core::UniformGrid{{-1, -1, -1}, Vec3(0.25), {9, 9, 9}}, std::vector{0.0, 1.0},
            [](const Vec3& p, double) { return Vec3(-3.0 * p.y, 3.0 * p.x, 2.0); }),
        core::TimeStepCache::Options{}));
    const std::vector<Vec3> points{{9, 9, 9}, {0.3, -0.1, 0.2}};
    const auto found =
        probe({info, *flow, nullptr},
              {points, 0.5, {"vorticity_z", "q_criterion", "velocity_z", "vorticity_x"}}, {});
    ASSERT_TRUE(found.has_value()) << found.error().message;
    EXPECT_EQ(found->inside, (std::vector{false, true}));
    const std::vector expected{6.0F, 9.0F, 2.0F, 0.0F};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_TRUE(std::isnan(found->fields[i].scalars[0]));
        EXPECT_NEAR(found->fields[i].scalars[1], expected[i], 1e-4);
    }
    const auto nowhere = probe({info, *flow, nullptr}, {{{9, 9, 9}}, 0.5, {"U", "vorticity"}}, {});
    ASSERT_TRUE(nowhere.has_value());
    EXPECT_TRUE(std::isnan(nowhere->fields[0].vectors.at(0).x));
    EXPECT_TRUE(std::isnan(nowhere->fields[1].scalars.at(0)));
    const auto none = probe({info, *flow, nullptr}, {points, 0.5, {"pressure"}}, {});
    ASSERT_FALSE(none.has_value());
    EXPECT_EQ(none.error().code, core::Error::Code::NotFound);
}

} // namespace
} // namespace wakesurf::server::probe_test
