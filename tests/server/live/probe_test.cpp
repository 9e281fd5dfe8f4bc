// What a probe says where the data have no velocity, at the time that it asks for.
#include "core/field/stored_flow.hpp"
#include "server/live/probe.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wakesurf::server::probe_test {
namespace {

using core::Vec3;

TEST(Probe, IsOutsideAndHasNoNumberWhereTheDataHaveNone) {
    OpenDataset dataset;
    dataset.info.velocity = "U";
    dataset.flow = core::make_stored_flow(std::make_shared<core::TimeStepCache>(
        std::make_shared<tests::SampledSource>(
            core::UniformGrid{{0, 0, 0}, Vec3(0.25), {9, 9, 9}}, std::vector{0.0, 1.0, 2.0},
            [](const Vec3& p, double t) {
                return p.z > (t > 1.5 ? 1.3 : 1.8) ? Vec3(std::numeric_limits<double>::quiet_NaN())
                                                   : Vec3(1.0, 0.3 * p.z, 0.2);
            }),
        core::TimeStepCache::Options{}));
    const ProbeRequest request{{{1, 1, 1.1}, {1, 1, 1.6}, {1, 1, 1.9}}, 1.0, {}};
    const auto found = probe(dataset, request, {});
    ASSERT_TRUE(found.has_value()) << found.error().message;
    EXPECT_EQ(found->inside, (std::vector{true, true, false}));
    EXPECT_NEAR(found->fields[0].vectors[1].y, 0.48, 1e-6);
    EXPECT_TRUE(std::isnan(found->fields[0].vectors[2].x));
    const auto later = probe(dataset, {request.points, 1.25, {}}, {});
    ASSERT_TRUE(later.has_value());
    EXPECT_EQ(later->inside, (std::vector{true, false, false}));
    EXPECT_TRUE(std::isnan(later->fields[0].vectors[1].x));
}

} // namespace
} // namespace wakesurf::server::probe_test
