// Names and times of what is written more than once.
#include "server/app/series_request.hpp"
#include "server/live/animation_file.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::series_request_test {

namespace {

core::SurfaceParameters from_to(double from, double to) {
    core::SurfaceParameters parameters;
    parameters.kind = core::SurfaceKind::Streak;
    parameters.from = from;
    parameters.to = to;
    return parameters;
}

std::string refusal(const std::string& output, const std::string& times) {
    const auto series = read_series(output, times);
    return series ? "" : series.error().message;
}

core::Result<std::vector<double>> times(const std::string& text, double from, double to) {
    return times_of(**read_series("a_%d.glb", text), from_to(from, to));
}

std::string times_refusal(const std::string& text, double from, double to) {
    const auto out = times(text, from, to);
    return out ? "" : out.error().message;
}

} // namespace

TEST(SeriesRequest, NumbersFilesByThePlaceInTheirName) {
    EXPECT_EQ(name_in("out/frame_%03d.glb", 7), "out/frame_007.glb");
    EXPECT_EQ(name_in("frame_%03d.glb", 1234), "frame_1234.glb");
    EXPECT_EQ(name_in("%d.vtp", 7), "7.vtp");
    EXPECT_EQ(name_in("50%/a%d.ply", 7), "50%/a7.ply");
}

TEST(SeriesRequest, LeavesOtherNamesOfOneFileAlone) {
    for (const char* one :
         {"a.glb", "100%.vtp", "50%x.ply", "%s.obj", "%3d.vtp", "folder_%d/a.vtp"})
        EXPECT_FALSE(value_of(read_series(one, ""))) << one;
    EXPECT_EQ(value_of(read_series("a.html", ""))->form, Series::Form::Animation);
    EXPECT_EQ(value_of(read_series("a.csv", ""))->form, Series::Form::Numbers);
}

TEST(SeriesRequest, RefusesNamesAndTimesThatDoNotGoTogether) {
    EXPECT_NE(refusal("a_%03d.glb", "").find("--times is missing"), std::string::npos);
    EXPECT_NE(refusal("a.glb", "0:1:0.1").find("no place for the number"), std::string::npos);
    EXPECT_NE(refusal("a_%d_%02d.glb", "0:1:0.1").find("2 places"), std::string::npos);
    EXPECT_NE(refusal("a_%d.png", "0:1:0.1").find("film"), std::string::npos);
    for (const char* wrong : {"0:1", "0:1:0.1:2", "0:1:x", "0:nan:1", "a", ":::", "0:1:0.1 "})
        EXPECT_NE(refusal("a_%d.glb", wrong).find("is not FIRST:LAST:EVERY"), std::string::npos)
            << wrong;
    for (const char* wrong : {"0:1:0", "0:1:-0.1"})
        EXPECT_NE(refusal("a_%d.glb", wrong).find("must be above 0"), std::string::npos) << wrong;
}

TEST(SeriesRequest, ReachesTheLastTimeWhereEveryLeadsToIt) {
    const auto all = value_of(times("0:20:0.1", 0, 20));
    ASSERT_EQ(all.size(), 201u);
    EXPECT_EQ(all.front(), 0.0);
    EXPECT_EQ(all.back(), 20.0);
    EXPECT_DOUBLE_EQ(all[1], 0.1);
    EXPECT_EQ(value_of(times("0:1:0.3", 0, 20)).size(), 4u);
    EXPECT_EQ(value_of(times("2:2:1", 0, 20)), std::vector<double>{2.0});
}

TEST(SeriesRequest, GoesBackInTimeWithTheSurface) {
    EXPECT_EQ(value_of(times("3:1:1", 3, 0)), (std::vector<double>{3, 2, 1}));
    EXPECT_NE(times_refusal("1:3:1", 3, 0).find("run the other way"), std::string::npos);
    EXPECT_NE(times_refusal("3:1:1", 0, 3).find("run the other way"), std::string::npos);
}

TEST(SeriesRequest, RefusesTimesOutsideTheSurfaceAndTooManyOfThem) {
    EXPECT_EQ(times_refusal("0:25:1", 0, 20),
              "--times: 25 is outside 0 to 20, the times that there are");
    EXPECT_EQ(times_refusal("-1:20:1", 0, 20),
              "--times: -1 is outside 0 to 20, the times that there are");
    EXPECT_NE(times_refusal("0:20:1e-9", 0, 20).find("at most 10000"), std::string::npos);
    EXPECT_NE(times_refusal("0:20:1e-300", 0, 20).find("at most 10000"), std::string::npos);
    EXPECT_EQ(value_of(times("0:1:0.0001000100010001", 0, 20)).size(), 10000u);
}

TEST(SeriesRequest, ShowsAnAnimationFromItsBeginToItsEndWithoutTimes) {
    const auto all = value_of(times_of(Series{Series::Form::Animation, {}}, from_to(16, 8.5)));
    ASSERT_EQ(all.size(), animation_steps);
    EXPECT_EQ(all.front(), 16.0);
    EXPECT_EQ(all.back(), 8.5);
}

} // namespace wakesurf::server::series_request_test
