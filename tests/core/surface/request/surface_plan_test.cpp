#include "core/field/analytic_flow.hpp"
#include "core/surface/request/surface_plan.hpp"

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
    EXPECT_NE(complaint(asked).find("stream and path"), std::string::npos);
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
        EXPECT_NE(complaint(swept({0, 1, 0}, kind)).find("`sweep`"), std::string::npos);
        EXPECT_NE(complaint(between(second, kind)).find("`rake2`"), std::string::npos);
    }
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Time})
        EXPECT_NE(complaint(released_until(2.0, kind)).find("`releaseUntil`"), std::string::npos);
}

TEST(SurfacePlan, AskForOneSecondCurveOfATimeSurface) {
    EXPECT_NE(complaint(of_kind(SurfaceKind::Time)).find("one of `rake2` and `sweep`"),
              std::string::npos);
    auto both = swept({0, 1, 0});
    both.parameters.rake2 = second;
    EXPECT_NE(complaint(both).find("one of `rake2` and `sweep`"), std::string::npos);
    EXPECT_NE(complaint(swept({0, 0, 0})).find("`sweep`"), std::string::npos);
}

TEST(SurfacePlan, HaveTheReleaseEndBetweenFromAndTo) {
    for (const double until : {0.5, 1.0, 4.5})
        EXPECT_NE(complaint(released_until(until)).find("`releaseUntil`"), std::string::npos)
            << until;
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
        EXPECT_NE(complaint(setting).find("`interpolation`"), std::string::npos);
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
        EXPECT_NE(with(&SurfaceParameters::angle, bad).find("`angle`"), std::string::npos);
    for (const double bad : {-1.0, 0.2, nan})
        EXPECT_NE(with(&SurfaceParameters::stagnation_speed, bad).find("`stagnationSpeed`"),
                  std::string::npos);
    for (const double bad : {-1.0, 1e-9, 1e9, nan})
        EXPECT_NE(with(&SurfaceParameters::separation, bad).find("`separation`"),
                  std::string::npos);
    for (const double bad : {4.0, nan})
        EXPECT_NE(with(&SurfaceParameters::from, bad), "") << bad;
    EXPECT_NE(complaint(swept({nan, 1, 0})).find("`sweep`"), std::string::npos);
    EXPECT_NE(complaint(swept({1e-320, 0, 0})).find("`sweep`"), std::string::npos);
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
