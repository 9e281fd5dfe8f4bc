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

} // namespace wakesurf::server
