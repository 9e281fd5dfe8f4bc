#include "server/app/surface_passes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace wakesurf::server::surface_passes_test {

namespace {

/// Of the separation asked for.
BuiltSurface surface_of(const core::SurfaceParameters& p) {
    BuiltSurface built;
    built.surface.statistics.requested_separation = p.separation;
    built.surface.statistics.separation = p.separation;
    return built;
}

core::SurfaceParameters asked(double separation) {
    core::SurfaceParameters p;
    p.separation = separation;
    return p;
}

/// A limit whose time is over.
struct Over {
    TimeLimit limit{1e-6, {}};

    Over() {
        while (!limit.over())
            std::this_thread::yield();
    }
};

tl::unexpected<core::Error> cancelled() {
    return core::fail(core::Error::Code::Cancelled, "the surface was cancelled");
}

} // namespace

TEST(SurfacePasses, WithoutALimitThereIsOnePass) {
    const TimeLimit none(0.0, {});
    int passes = 0;
    const auto built = build_within(none, asked(0.1), 10.0, [&](const auto& p) {
        ++passes;
        return core::Result<BuiltSurface>(surface_of(p));
    });
    ASSERT_TRUE(built);
    EXPECT_EQ(passes, 1);
    EXPECT_EQ(built->surface.statistics.separation, 0.1);
}

TEST(SurfacePasses, EndWithTheSurfaceAskedFor) {
    const TimeLimit limit(3600.0, {});
    std::vector<double> separations;
    const auto built = build_within(limit, asked(0.1), 1.0, [&](const auto& p) {
        separations.push_back(p.separation);
        return core::Result<BuiltSurface>(surface_of(p));
    });
    ASSERT_TRUE(built);
    ASSERT_EQ(separations.size(), 3u);
    EXPECT_NEAR(separations[0], 0.625, 1e-12);
    EXPECT_NEAR(separations[1], 0.25, 1e-12);
    EXPECT_EQ(separations[2], 0.1);
    EXPECT_FALSE(built->cut_short);
    EXPECT_EQ(built->surface.statistics.stopped, "");
}

TEST(SurfacePasses, ASurfaceAskedForCoarseIsBuiltOnce) {
    const TimeLimit limit(3600.0, {});
    int passes = 0;
    ASSERT_TRUE(build_within(limit, asked(2.0), 1.0, [&](const auto& p) {
        ++passes;
        return core::Result<BuiltSurface>(surface_of(p));
    }));
    EXPECT_EQ(passes, 1);
}

TEST(SurfacePasses, GiveWhatIsThereWhenTheTimeIsOverAndSaySo) {
    const TimeLimit limit(0.05, {});
    int passes = 0;
    const auto built = build_within(limit, asked(0.1), 1.0, [&](const auto& p) {
        if (++passes == 1)
            return core::Result<BuiltSurface>(surface_of(p));
        while (!limit.token().stop_requested())
            std::this_thread::yield();
        return core::Result<BuiltSurface>(cancelled());
    });
    ASSERT_TRUE(built) << built.error().message;
    EXPECT_LE(passes, 2);
    EXPECT_TRUE(built->cut_short);
    EXPECT_EQ(built->surface.statistics.requested_separation, 0.1);
    EXPECT_EQ(built->surface.statistics.stopped,
              "the time limit of 0.05 s was reached, so its separation is 0.625 instead of 0.1");
}

TEST(SurfacePasses, AnEmptyCoarseOneIsNothingToWrite) {
    const TimeLimit limit(0.05, {});
    int passes = 0;
    const auto built = build_within(limit, asked(0.1), 1.0, [&](const auto& p) {
        if (++passes == 1) {
            BuiltSurface nothing = surface_of(p);
            nothing.surface.statistics.empty.emplace();
            return core::Result<BuiltSurface>(nothing);
        }
        while (!limit.token().stop_requested())
            std::this_thread::yield();
        return core::Result<BuiltSurface>(cancelled());
    });
    ASSERT_FALSE(built);
    EXPECT_EQ(built.error().message, "--seconds: nothing was there yet after 0.05 s");
}

TEST(SurfacePasses, NothingThereYetIsAnError) {
    const Over over;
    const auto built = build_within(over.limit, asked(0.1), 1.0, [&](const auto&) {
        return core::Result<BuiltSurface>(cancelled());
    });
    ASSERT_FALSE(built);
    EXPECT_EQ(built.error().code, core::Error::Code::Cancelled);
    EXPECT_EQ(built.error().message, "--seconds: nothing was there yet after 1e-06 s");
}

TEST(SurfacePasses, AFaultEndsThemAndIsToldAsItIs) {
    const TimeLimit limit(3600.0, {});
    const auto built = build_within(limit, asked(0.1), 1.0, [&](const auto&) {
        return core::Result<BuiltSurface>(
            core::fail(core::Error::Code::OutOfTime, "there are no such data"));
    });
    ASSERT_FALSE(built);
    EXPECT_EQ(built.error().message, "there are no such data");
}

TEST(TimeLimit, FiresWithTheOtherTokenAndIsNotOverThen) {
    std::stop_source user;
    const TimeLimit limit(3600.0, user.get_token());
    EXPECT_FALSE(limit.token().stop_requested());
    user.request_stop();
    EXPECT_TRUE(limit.token().stop_requested());
    EXPECT_FALSE(limit.over());
}

} // namespace wakesurf::server::surface_passes_test
