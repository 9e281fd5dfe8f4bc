#include "core/field/analytic_flow.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "server/app/name_mapping.hpp"
#include "server/app/surface_request.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::surface_request_test {

namespace {

SurfaceRequest times(std::optional<double> from, std::optional<double> to) {
    SurfaceRequest request;
    request.parameters.kind = core::SurfaceKind::Streak;
    request.from = from;
    request.to = to;
    return request;
}

core::Error refusal(SurfaceRequest request) {
    choose_times(request, {});
    const std::shared_ptr<const core::Flow> flow = core::make_analytic_flow("uniform").value();
    const core::Rake rake{core::Rake::Kind::Line, {{0, -0.1, 0}, {0, 0.1, 0}}, 9};
    const auto plan = core::plan_surface(flow, rake, request.parameters);
    return plan ? core::Error{} : with_options(plan.error());
}

core::SurfaceParameters chosen(SurfaceRequest request, const std::vector<double>& times) {
    choose_times(request, times);
    return request.parameters;
}

} // namespace

TEST(SurfaceRequest, TakesOpenTimesFromTheData) {
    EXPECT_EQ(chosen(times({}, {}), {8.5, 9, 16}).from, 8.5);
    EXPECT_EQ(chosen(times({}, {}), {8.5, 9, 16}).to, 16);
    EXPECT_EQ(chosen(times(12.0, {}), {8.5, 9, 16}).to, 16);
    EXPECT_EQ(chosen(times(9.0, 9.5), {8.5, 9, 16}).to, 9.5);
}

TEST(SurfaceRequest, IntegratesForTenTimeUnitsWhereTheDataHasOneTime) {
    EXPECT_EQ(chosen(times({}, {}), {}).to, 10);
    EXPECT_EQ(chosen(times({}, {}), {3}).from, 3);
    EXPECT_EQ(chosen(times({}, {}), {3}).to, 13);
    EXPECT_EQ(chosen(times(16.0, {}), {8.5, 16}).to, 26);
}

TEST(SurfaceRequest, GoesBackInTimeWhereToIsEarlierThanFrom) {
    EXPECT_EQ(chosen(times(15.0, 10.0), {8.5, 9, 16}).to, 10);
    auto open = times({}, {});
    open.parameters.direction = core::Direction::Backward;
    EXPECT_EQ(chosen(open, {8.5, 9, 16}).from, 16);
    EXPECT_EQ(chosen(open, {8.5, 9, 16}).to, 8.5);
    EXPECT_EQ(chosen(open, {3}).to, -7);
    open.from = 12.0;
    EXPECT_EQ(chosen(open, {8.5, 9, 16}).to, 8.5);
}

TEST(SurfaceRequest, RefusesADirectionThatContradictsTheTimesAndNamesTheRightSpelling) {
    EXPECT_EQ(refusal(times(3.0, 3.0)).message, "--from and --to must be finite and differ");
    auto request = times(15.0, 20.0);
    request.parameters.direction = core::Direction::Backward;
    const core::Error refused = refusal(request);
    EXPECT_EQ(refused.message, "--direction is backward, but --to 20 is after --from 15");
    EXPECT_TRUE(holds(refused.hint, "--from 15 and --to 10"));
}

TEST(SurfaceRequest, HasTheReleaseEndBetweenFromAndTo) {
    auto request = times(1.0, 4.0);
    EXPECT_FALSE(chosen(request, {}).release_until);
    for (const double until : {1.5, 4.0}) {
        request.parameters.release_until = until;
        EXPECT_EQ(chosen(request, {}).release_until, until);
    }
    for (const double until : {0.5, 1.0, 4.5}) {
        request.parameters.release_until = until;
        const std::string message = refusal(request).message;
        EXPECT_TRUE(message.starts_with("--release-until")) << until << ": " << message;
    }
}

TEST(SurfaceRequest, CarriesEverythingTheEngineIsToKnow) {
    SurfaceOptions options;
    options.asked = {{"from", "0"}, {"to", "+1e0"}, {"kind", "time"}};
    options.rake = "0,0,0 1,0,0";
    options.asked["rake2"] = "0,1,0 1,1,0 2,1,0";
    options.seeds = 9;
    options.asked["merge"] = "0.5";
    options.asked["angle"] = "12";
    options.asked["life"] = "0.75";
    options.output = "out.vtp";
    const auto between = value_of(check_surface_options(options));
    EXPECT_EQ(between.parameters.kind, core::SurfaceKind::Time);
    EXPECT_EQ(between.parameters.rake2->points.size(), 3U);
    EXPECT_EQ(between.parameters.rake2->seeds, 9U);
    EXPECT_EQ(between.parameters.merge, 0.5);
    EXPECT_EQ(between.parameters.angle, 12.0);
    EXPECT_EQ(between.parameters.life, 0.75);
    EXPECT_FALSE(between.parameters.sweep);
    EXPECT_EQ(between.from, 0.0);
    EXPECT_EQ(between.to, 1.0);
    options.asked["rake2"].clear();
    options.asked["sweep"] = "0,-1,2.5";
    const auto swept = value_of(check_surface_options(options));
    EXPECT_EQ(swept.parameters.sweep, core::Vec3(0, -1, 2.5));
}

TEST(SurfaceRequest, RefusesWhatSurfaceSetRefusesUnderTheNameOfTheOption) {
    SurfaceOptions options;
    options.rake = "0,0,0 1,0,0";
    options.output = "out.vtp";
    const auto complaint = [&](const char* parameter, const char* text) {
        SurfaceOptions asked = options;
        asked.asked = {{"kind", "stream"}};
        asked.asked[parameter] = text;
        const auto request = check_surface_options(asked).map_error(with_options);
        return request ? std::string() : request.error().message;
    };
    EXPECT_EQ(complaint("angle", "0"), "--angle must be a number greater than 0");
    EXPECT_EQ(complaint("angle", "0.5"), "");
    EXPECT_EQ(complaint("angle", "181"), "--angle must be a number between 0 and 180");
    EXPECT_EQ(complaint("merge", "0.6"), "--merge must be a number between 0 and 0.5");
    EXPECT_EQ(complaint("merge", "much"), "--merge: 'much' is not a number");
    EXPECT_EQ(complaint("separation", "0"), "--separation must be a number greater than 0");
    EXPECT_EQ(complaint("separation", "-1"), "--separation must be a number greater than 0");
    EXPECT_EQ(complaint("kind", "sheet"), "--kind must be stream, path, streak, time or level");
    EXPECT_EQ(complaint("sweep", "0,1,0"), "--sweep belongs to time surfaces");
    EXPECT_EQ(complaint("releaseUntil", "1"), "--release-until belongs to streak surfaces");
    EXPECT_EQ(complaint("life", "1"), "--life belongs to path, streak or time surfaces");
    EXPECT_EQ(complaint("life", "0"), "--life must be a number greater than 0");
    EXPECT_EQ(complaint("kind", "time"), "a time surface takes one of --rake2 and --sweep");
}

TEST(SurfaceRequest, OfALevelSurfaceTakesNoRake) {
    SurfaceOptions asked;
    asked.output = "out.vtp";
    asked.asked = {{"kind", "level"}, {"field", "p"}, {"level", "0.3"}};
    EXPECT_TRUE(check_surface_options(asked));
    asked.rake = "0,0,0 1,1,1";
    EXPECT_EQ(check_surface_options(asked).error().message, "a level surface has no rake");
}

} // namespace wakesurf::server::surface_request_test
