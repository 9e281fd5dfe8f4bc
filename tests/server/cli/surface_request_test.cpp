#include "server/cli/surface_request.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server {

namespace {

SurfaceOptions times(std::optional<double> from, std::optional<double> to) {
    SurfaceOptions options;
    options.from = from;
    options.to = to;
    return options;
}

core::SurfaceParameters chosen(const SurfaceOptions& options, const std::vector<double>& times) {
    core::SurfaceParameters parameters;
    EXPECT_TRUE(choose_times(parameters, options, times));
    return parameters;
}

} // namespace

TEST(SurfaceRequest, TakesOpenTimesFromTheData) {
    EXPECT_EQ(chosen({}, {8.5, 9, 16}).from, 8.5);
    EXPECT_EQ(chosen({}, {8.5, 9, 16}).to, 16);
    EXPECT_EQ(chosen(times(12.0, {}), {8.5, 9, 16}).to, 16);
    EXPECT_EQ(chosen(times(9.0, 9.5), {8.5, 9, 16}).to, 9.5);
}

TEST(SurfaceRequest, IntegratesForTenTimeUnitsWhereTheDataHasOneTime) {
    EXPECT_EQ(chosen({}, {}).to, 10);
    EXPECT_EQ(chosen({}, {3}).from, 3);
    EXPECT_EQ(chosen({}, {3}).to, 13);
    EXPECT_EQ(chosen(times(16.0, {}), {8.5, 16}).to, 26);
}

TEST(SurfaceRequest, RefusesTimesThatRunBackwards) {
    core::SurfaceParameters parameters;
    EXPECT_FALSE(choose_times(parameters, times(3.0, 3.0), {}));
    EXPECT_FALSE(choose_times(parameters, times({}, -1.0), {0, 1}));
}

TEST(SurfaceRequest, HasTheReleaseEndBetweenFromAndTo) {
    auto options = times(1.0, 4.0);
    EXPECT_FALSE(chosen(options, {}).release_until);
    for (const double until : {1.5, 4.0}) {
        options.release_until = until;
        EXPECT_EQ(chosen(options, {}).release_until, until);
    }
    for (const double until : {0.5, 1.0, 4.5}) {
        options.release_until = until;
        core::SurfaceParameters parameters;
        EXPECT_FALSE(choose_times(parameters, options, {})) << until;
    }
}

TEST(SurfaceRequest, CarriesEverythingTheEngineIsToKnow) {
    SurfaceOptions options = times(0.0, 1.0);
    options.kind = "time";
    options.rake = "0,0,0 1,0,0";
    options.rake2 = "0,1,0 1,1,0 2,1,0";
    options.seeds = 9;
    options.merge = 0.5;
    options.angle = 12;
    options.output = "out.vtp";
    const auto between = check_surface_options(options);
    ASSERT_TRUE(between) << between.error().message;
    EXPECT_EQ(between->parameters.kind, core::SurfaceKind::Time);
    EXPECT_EQ(between->parameters.rake2->points.size(), 3U);
    EXPECT_EQ(between->parameters.rake2->seeds, 9U);
    EXPECT_EQ(between->parameters.merge, 0.5);
    EXPECT_EQ(between->parameters.angle, 12.0);
    EXPECT_FALSE(between->parameters.sweep);
    options.rake2.clear();
    options.sweep = "0,-1,2.5";
    const auto swept = check_surface_options(options);
    ASSERT_TRUE(swept) << swept.error().message;
    EXPECT_EQ(swept->parameters.sweep, core::Vec3(0, -1, 2.5));
}

} // namespace wakesurf::server
