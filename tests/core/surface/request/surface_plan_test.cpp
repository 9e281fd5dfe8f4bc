#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::surface_plan_test {

namespace {

const std::shared_ptr<const Flow> abc = make_analytic_flow("abc").value();
const Rake second{Rake::Kind::Line, {{0, 1, 0}, {1, 1, 0}}, 9};

struct Asked {
    Rake rake{Rake::Kind::Line, {{0, 0, 0}, {1, 0, 0}}, 9};
    SurfaceParameters parameters{};
};

Asked of_kind(SurfaceKind kind) {
    Asked asked;
    asked.parameters.kind = kind;
    asked.parameters.from = 1.0;
    asked.parameters.to = 4.0;
    return asked;
}

Asked swept(const Vec3& sweep, SurfaceKind kind = SurfaceKind::Time) {
    Asked asked = of_kind(kind);
    asked.parameters.sweep = sweep;
    return asked;
}

Asked between(const Rake& rake2, SurfaceKind kind = SurfaceKind::Time) {
    Asked asked = of_kind(kind);
    asked.parameters.rake2 = rake2;
    return asked;
}

Asked released_until(double until, SurfaceKind kind = SurfaceKind::Streak) {
    Asked asked = of_kind(kind);
    asked.parameters.release_until = until;
    return asked;
}

SurfacePlan planned(const Asked& asked) {
    return plan_surface(abc, asked.rake, asked.parameters).value();
}

Error refusal(const Asked& asked) {
    const auto plan = plan_surface(abc, asked.rake, asked.parameters);
    return plan ? Error{} : plan.error();
}

/// Empty where a plan can be made.
std::string complaint(const Asked& asked) {
    const Error error = refusal(asked);
    if (!error.message.empty()) {
        EXPECT_EQ(error.code, Error::Code::InvalidArgument);
        EXPECT_FALSE(error.hint.empty());
    }
    return error.message;
}

} // namespace

TEST(SurfacePlan, HasTheDirectionThatTheTimesSayAndNoOther) {
    Asked asked = of_kind(SurfaceKind::Path);
    EXPECT_EQ(planned(asked).parameters.direction, Direction::Forward);
    asked.parameters.to = -2.0;
    EXPECT_EQ(planned(asked).parameters.direction, Direction::Backward);
    asked.parameters.direction = Direction::Forward;
    EXPECT_NE(complaint(asked), "");
    asked = of_kind(SurfaceKind::Streak);
    asked.parameters.direction = Direction::Both;
    EXPECT_TRUE(holds(complaint(asked), "stream and path"));
    asked.parameters.kind = SurfaceKind::Path;
    EXPECT_EQ(complaint(asked), "");
}

TEST(SurfacePlan, LetEveryKindBeAskedForWithWhatBelongsToIt) {
    EXPECT_EQ(complaint(of_kind(SurfaceKind::Stream)), "");
    EXPECT_EQ(complaint(of_kind(SurfaceKind::Path)), "");
    EXPECT_EQ(complaint(of_kind(SurfaceKind::Streak)), "");
    EXPECT_EQ(complaint(released_until(2.0)), "");
    EXPECT_EQ(complaint(released_until(4.0)), "");
    EXPECT_EQ(complaint(swept({0, 1, 0})), "");
    EXPECT_EQ(complaint(between(second)), "");
}

TEST(SurfacePlan, NameWhatDoesNotBelongToTheKind) {
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        EXPECT_TRUE(holds(complaint(swept({0, 1, 0}, kind)), "`sweep`"));
        EXPECT_TRUE(holds(complaint(between(second, kind)), "`rake2`"));
    }
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Time})
        EXPECT_TRUE(holds(complaint(released_until(2.0, kind)), "`releaseUntil`"));
}

TEST(SurfacePlan, AskForOneSecondCurveOfATimeSurface) {
    EXPECT_TRUE(holds(complaint(of_kind(SurfaceKind::Time)), "one of `rake2` and `sweep`"));
    auto both = swept({0, 1, 0});
    both.parameters.rake2 = second;
    EXPECT_TRUE(holds(complaint(both), "one of `rake2` and `sweep`"));
    EXPECT_TRUE(holds(complaint(swept({0, 0, 0})), "`sweep`"));
}

TEST(SurfacePlan, HaveTheReleaseEndBetweenFromAndTo) {
    for (const double until : {0.5, 1.0, 4.5})
        EXPECT_TRUE(holds(complaint(released_until(until)), "`releaseUntil`")) << until;
    auto upstream = released_until(-1.0);
    upstream.parameters.to = -2.0;
    EXPECT_EQ(complaint(upstream), "");
    upstream.parameters.release_until = -3.0;
    EXPECT_NE(complaint(upstream), "");
}

TEST(SurfacePlan, RefuseTheSmoothFieldOfWhatHasNone) {
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        auto setting = of_kind(kind);
        setting.parameters.interpolation = Interpolation::Smooth;
        EXPECT_TRUE(holds(complaint(setting), "`interpolation`"));
    }
}

TEST(SurfacePlan, RefuseOtherThanLinearBetweenTheStoredTimesOfAFormulaAndOfTheSmoothField) {
    for (const auto between : {Between::Cubic, Between::Flow}) {
        auto setting = of_kind(SurfaceKind::Path);
        setting.parameters.between = between;
        EXPECT_TRUE(holds(complaint(setting), "`between`"));
        const std::shared_ptr<const Flow> stored = make_stored_flow(std::make_shared<TimeStepCache>(
            std::make_shared<tests::SampledSource>(
                UniformGrid{Vec3(-1.0), Vec3(1.0), {4, 4, 4}}, std::vector{0.0, 2.0, 4.0},
                [](const Vec3&, double t) { return Vec3(t, 0.0, 0.0); }),
            TimeStepCache::Options{}));
        const auto plan = plan_surface(stored, setting.rake, setting.parameters);
        ASSERT_TRUE(plan);
        EXPECT_EQ(plan->flow, stored->interpolated(between));
        setting.parameters.interpolation = Interpolation::Smooth;
        const auto refused = plan_surface(stored, setting.rake, setting.parameters);
        ASSERT_FALSE(refused);
        EXPECT_TRUE(holds(refused.error().message, "`between`"));
    }
}

TEST(SurfacePlan, TakeTheDatasetsSpacingForASeparationLeftOut) {
    EXPECT_EQ(planned(of_kind(SurfaceKind::Stream)).parameters.separation, abc->finest_spacing());
}

TEST(SurfacePlan, HasThePartsOfBothRakesInsideTheDomainAndSaysWhatIsOutside) {
    const Box domain = abc->domain();
    EXPECT_FALSE(planned(between(second)).clipped);
    Asked asked = between({Rake::Kind::Line, {0.5 * (domain.lo + domain.hi), domain.hi * 3.0}, 9});
    const SurfacePlan plan = planned(asked);
    EXPECT_TRUE(plan.clipped);
    EXPECT_EQ(plan.rake, asked.rake);
    EXPECT_LT(glm::length(plan.parameters.rake2->points[1] - domain.hi), 1e-9);
    EXPECT_EQ(plan.seeding.at(1.0), asked.rake.points[1]);
    asked.parameters.rake2->points = {domain.hi * 2.0, domain.hi * 3.0};
    EXPECT_EQ(refusal(asked).code, Error::Code::OutOfDomain);
    EXPECT_TRUE(refusal(asked).message.starts_with("`rake2`: ")) << refusal(asked).message;
    std::swap(asked.rake, *asked.parameters.rake2);
    EXPECT_EQ(refusal(asked).code, Error::Code::OutOfDomain);
    EXPECT_EQ(refusal(asked).message.find('`'), std::string::npos) << refusal(asked).message;
}

TEST(SurfacePlan, RefusesNumbersThatTheDescriptionOfSurfaceSetDoesNotAllow) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto with = [&](double SurfaceParameters::*member, double value) {
        Asked asked = of_kind(SurfaceKind::Stream);
        asked.parameters.*member = value;
        return complaint(asked);
    };
    for (const double bad : {-0.1, 0.6, nan})
        EXPECT_EQ(with(&SurfaceParameters::merge, bad),
                  "`merge` must be a number between 0 and 0.5");
    for (const double bad : {-1.0, 0.0, 181.0, nan})
        EXPECT_TRUE(holds(with(&SurfaceParameters::angle, bad), "`angle`"));
    for (const double bad : {-1.0, 0.2, nan})
        EXPECT_TRUE(holds(with(&SurfaceParameters::stagnation_speed, bad), "`stagnationSpeed`"));
    for (const double bad : {-1.0, 1e-9, 1e9, nan})
        EXPECT_TRUE(holds(with(&SurfaceParameters::separation, bad), "`separation`"));
    for (const double bad : {4.0, nan})
        EXPECT_NE(with(&SurfaceParameters::from, bad), "") << bad;
    EXPECT_TRUE(holds(complaint(swept({nan, 1, 0})), "`sweep`"));
    EXPECT_TRUE(holds(complaint(swept({1e-320, 0, 0})), "`sweep`"));
    Asked none = of_kind(SurfaceKind::Stream);
    none.parameters.max_quads = 0;
    EXPECT_EQ(complaint(none), "`maxQuads` must be at least 1");
}

TEST(SurfacePlan, IsTheSameWhenItIsPlannedAgain) {
    for (Asked asked : {of_kind(SurfaceKind::Stream), between(second), released_until(2.0)}) {
        asked.rake.points.back() = abc->domain().hi * 2.0;
        const SurfacePlan once = planned(asked);
        const SurfacePlan twice = planned({once.rake, once.parameters});
        EXPECT_EQ(once.rake, twice.rake);
        EXPECT_EQ(once.parameters, twice.parameters);
        EXPECT_FALSE(twice.clipped);
    }
}

} // namespace wakesurf::core::surface_plan_test
