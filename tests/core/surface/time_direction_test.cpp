#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/request/surface_values.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/time_direction.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace wakesurf::core::time_direction_test {

namespace {

const Rake rake{Rake::Kind::Line, {{4, 1, 1}, {4, 2, 1}}, 5};

SurfaceParameters asked(SurfaceKind kind, double from, double to) {
    SurfaceParameters p{.kind = kind, .from = from, .to = to, .separation = 0.25};
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0, 0, 1);
    return p;
}

SurfaceParameters in(Direction direction, SurfaceParameters p) {
    p.direction = direction;
    return p;
}

/// Uniform flow of speed 1 along x, known from time 2 to 8.
std::unique_ptr<Flow> data() {
    auto source = std::make_shared<tests::SampledSource>(
        UniformGrid{{0, 0, 0}, {0.5, 0.5, 0.5}, {21, 7, 7}}, std::vector<double>{2, 5, 8},
        [](const Vec3&, double) { return Vec3(1, 0, 0); });
    return make_stored_flow(std::make_shared<TimeStepCache>(
        std::move(source), TimeStepCache::Options{std::size_t{1} << 26, 1}));
}

std::array<double, 2> reach(const Surface& surface) {
    double low = 1e9, high = -1e9;
    for (const Vec3& x : surface.mesh.position) {
        low = std::min(low, x.x);
        high = std::max(high, x.x);
    }
    return {low, high};
}

} // namespace

TEST(TimeDirection, FollowsFromWhereASurfaceStartsAndEnds) {
    EXPECT_EQ(direction_of(asked(SurfaceKind::Path, 3, 6)), Direction::Forward);
    EXPECT_EQ(direction_of(asked(SurfaceKind::Path, 15, 10)), Direction::Backward);
    for (const auto kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        EXPECT_TRUE(check_direction(asked(kind, 15, 10)));
        EXPECT_TRUE(check_direction(in(Direction::Backward, asked(kind, 15, 10))));
        EXPECT_TRUE(check_direction(in(Direction::Forward, asked(kind, 10, 15))));
    }
}

TEST(TimeDirection, ThatContradictsTheTimesIsRefusedWithTheRightSpelling) {
    const auto backward = check_direction(in(Direction::Backward, asked(SurfaceKind::Path, 5, 8)));
    ASSERT_FALSE(backward);
    EXPECT_EQ(backward.error().message, "`direction` is backward, but `to` 8 is after `from` 5");
    EXPECT_EQ(backward.error().hint, "for as long backward give `from` 5 and `to` 2, and to go to "
                                     "8 leave `direction` out");
    const auto epoch = check_direction(
        in(Direction::Backward, asked(SurfaceKind::Path, 1700000000.1, 1700000300.2)));
    ASSERT_FALSE(epoch);
    EXPECT_NE(epoch.error().hint.find("`to` 1699999700,"), std::string::npos) << epoch.error().hint;
    const auto forward = check_direction(in(Direction::Forward, asked(SurfaceKind::Path, 5, 2)));
    ASSERT_FALSE(forward);
    EXPECT_EQ(forward.error().message, "`direction` is forward, but `to` 2 is before `from` 5");
    const auto both = check_direction(in(Direction::Both, asked(SurfaceKind::Path, 5, 2)));
    ASSERT_FALSE(both);
    EXPECT_NE(both.error().hint.find("`to` 8"), std::string::npos) << both.error().hint;
}

TEST(TimeDirection, BothIsRefusedForSurfacesThatAreThereAtOneTime) {
    for (const auto kind : {SurfaceKind::Streak, SurfaceKind::Time}) {
        const auto flow = data();
        const auto refused = build_surface(*flow, rake, in(Direction::Both, asked(kind, 5, 6)));
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, Error::Code::InvalidArgument);
        EXPECT_NE(refused.error().message.find("stream and path surfaces"), std::string::npos);
        EXPECT_EQ(refused.error().hint, "make two surfaces, one in each direction");
    }
}

TEST(TimeDirection, BackwardSurfacesOfEveryKindGoToWhereTheySay) {
    const auto flow = data();
    for (const auto kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        const auto surface = build_surface(*flow, rake, asked(kind, 7, 5));
        ASSERT_TRUE(surface) << surface.error().message;
        EXPECT_NEAR(reach(*surface)[0], 2.0, 1e-6) << static_cast<int>(kind);
        if (kind == SurfaceKind::Streak || kind == SurfaceKind::Time) {
            for (const double time : vertex_times(*surface, asked(kind, 7, 5)))
                EXPECT_EQ(time, 5.0);
        }
    }
}

TEST(TimeDirection, TimesLieInTheDataButForTheEndOfAStreamSurface) {
    const auto flow = data();
    for (const auto kind : {SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        for (const auto& [from, to] : {std::pair{5.0, 9.0}, {5.0, 1.0}, {1.0, 5.0}, {9.0, 5.0}}) {
            const auto refused = build_surface(*flow, rake, asked(kind, from, to));
            ASSERT_FALSE(refused) << from << " " << to;
            EXPECT_EQ(refused.error().code, Error::Code::OutOfTime);
            EXPECT_NE(refused.error().message.find(from == 5.0 ? "`to`" : "`from`"),
                      std::string::npos)
                << refused.error().message;
            EXPECT_NE(refused.error().message.find("2 to 8"), std::string::npos);
        }
    EXPECT_TRUE(build_surface(*flow, rake, asked(SurfaceKind::Stream, 8, 11)));
    EXPECT_TRUE(build_surface(*flow, rake, asked(SurfaceKind::Stream, 2, -1)));
    EXPECT_FALSE(build_surface(*flow, rake, asked(SurfaceKind::Stream, 9, 11)));
}

TEST(TimeDirection, APathSurfaceOfBothDirectionsGoesAsLongBackAsForwardAsFarAsThereAreData) {
    const auto flow = data();
    const auto built = [&](double from, double to) {
        return build_surface(*flow, rake, in(Direction::Both, asked(SurfaceKind::Path, from, to)));
    };
    const auto even = built(5, 7);
    ASSERT_TRUE(even) << even.error().message;
    EXPECT_NEAR(reach(*even)[0], 2.0, 1e-6);
    EXPECT_NEAR(reach(*even)[1], 6.0, 1e-6);
    EXPECT_FALSE(even->statistics.data_end);
    const auto uneven = built(3, 7);
    ASSERT_TRUE(uneven) << uneven.error().message;
    EXPECT_NEAR(reach(*uneven)[0], 3.0, 1e-6);
    EXPECT_NEAR(reach(*uneven)[1], 8.0, 1e-6);
    EXPECT_EQ(uneven->statistics.data_end, 2.0);
    const auto forward = built(2, 7);
    ASSERT_TRUE(forward) << forward.error().message;
    EXPECT_NEAR(reach(*forward)[0], 4.0, 1e-6);
    EXPECT_EQ(forward->statistics.data_end, 2.0);
    EXPECT_FALSE(built(5, 9)) << "the end that is named lies in the data";
}

TEST(TimeDirection, AStreamSurfaceOfBothDirectionsKnowsNoEndOfTheData) {
    const auto flow = data();
    const auto p = in(Direction::Both, asked(SurfaceKind::Stream, 2, 5));
    const auto surface = build_surface(*flow, rake, p);
    ASSERT_TRUE(surface) << surface.error().message;
    EXPECT_NEAR(reach(*surface)[0], 1.0, 1e-6);
    EXPECT_NEAR(reach(*surface)[1], 7.0, 1e-6);
    EXPECT_FALSE(surface->statistics.data_end);
}

TEST(TimeDirection, TheReleaseEndsOnTheWayFromFromToTo) {
    auto p = asked(SurfaceKind::Streak, 15, 10);
    for (const double until : {14.0, 10.0}) {
        p.release_until = until;
        EXPECT_TRUE(check_values(p)) << until;
    }
    for (const double until : {15.0, 16.0, 20.0, 9.0}) {
        p.release_until = until;
        EXPECT_FALSE(check_values(p)) << until;
    }
}

} // namespace wakesurf::core::time_direction_test
