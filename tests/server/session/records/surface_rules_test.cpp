#include "core/field/analytic_flow.hpp"
#include "server/session/records/surface_rules.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::surface_rules_test {

namespace {

using core::SurfaceKind;

OpenDataset abc() {
    auto info = core::describe_analytic_flow("abc").value();
    const auto lattice = protocol::lattice_over(info.bounds);
    return {std::move(info), lattice, core::make_analytic_flow("abc").value()};
}

protocol::SurfaceSetting of_kind(SurfaceKind kind) {
    protocol::SurfaceSetting setting;
    setting.rake = "r1";
    setting.dataset = "abc";
    setting.parameters.kind = kind;
    setting.parameters.from = 1.0;
    setting.parameters.to = 4.0;
    return setting;
}

protocol::SurfaceSetting swept(const core::Vec3& sweep, SurfaceKind kind = SurfaceKind::Time) {
    auto setting = of_kind(kind);
    setting.parameters.sweep = sweep;
    return setting;
}

protocol::SurfaceSetting between(const std::string& rake2, SurfaceKind kind = SurfaceKind::Time) {
    auto setting = of_kind(kind);
    setting.rake2 = rake2;
    return setting;
}

protocol::SurfaceSetting released_until(double until, SurfaceKind kind = SurfaceKind::Streak) {
    auto setting = of_kind(kind);
    setting.parameters.release_until = until;
    return setting;
}

/// Empty where the rules have nothing against it.
std::string complaint(protocol::SurfaceSetting setting) {
    const auto complete = complete_surface(setting, abc());
    if (complete)
        return {};
    EXPECT_EQ(complete.error().code, core::Error::Code::InvalidArgument);
    EXPECT_FALSE(complete.error().hint.empty());
    return complete.error().message;
}

} // namespace

TEST(SurfaceRules, FillInTheDirectionThatTheTimesSayAndRefuseAnother) {
    auto setting = of_kind(SurfaceKind::Path);
    ASSERT_TRUE(complete_surface(setting, abc()));
    EXPECT_EQ(setting.parameters.direction, core::Direction::Forward);
    setting = of_kind(SurfaceKind::Path);
    setting.parameters.to = -2.0;
    ASSERT_TRUE(complete_surface(setting, abc()));
    EXPECT_EQ(setting.parameters.direction, core::Direction::Backward);
    setting.parameters.direction = core::Direction::Forward;
    EXPECT_NE(complaint(setting), "");
    setting = of_kind(SurfaceKind::Streak);
    setting.parameters.direction = core::Direction::Both;
    EXPECT_NE(complaint(setting).find("stream and path"), std::string::npos);
    setting.parameters.kind = SurfaceKind::Path;
    EXPECT_EQ(complaint(setting), "");
}

TEST(SurfaceRules, LetEveryKindBeAskedForWithWhatBelongsToIt) {
    EXPECT_EQ(complaint(of_kind(SurfaceKind::Stream)), "");
    EXPECT_EQ(complaint(of_kind(SurfaceKind::Path)), "");
    EXPECT_EQ(complaint(of_kind(SurfaceKind::Streak)), "");
    EXPECT_EQ(complaint(released_until(2.0)), "");
    EXPECT_EQ(complaint(released_until(4.0)), "");
    EXPECT_EQ(complaint(swept({0, 1, 0})), "");
    EXPECT_EQ(complaint(between("r2")), "");
}

TEST(SurfaceRules, NameWhatDoesNotBelongToTheKind) {
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        EXPECT_NE(complaint(swept({0, 1, 0}, kind)).find("`sweep`"), std::string::npos);
        EXPECT_NE(complaint(between("r2", kind)).find("`rake2`"), std::string::npos);
    }
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Time})
        EXPECT_NE(complaint(released_until(2.0, kind)).find("`releaseUntil`"), std::string::npos);
}

TEST(SurfaceRules, AskForOneSecondCurveOfATimeSurface) {
    EXPECT_NE(complaint(of_kind(SurfaceKind::Time)).find("one of `rake2` and `sweep`"),
              std::string::npos);
    auto both = swept({0, 1, 0});
    both.rake2 = "r2";
    EXPECT_NE(complaint(both).find("one of `rake2` and `sweep`"), std::string::npos);
    EXPECT_NE(complaint(between("r1")).find("the rake itself"), std::string::npos);
    EXPECT_NE(complaint(swept({0, 0, 0})).find("`sweep`"), std::string::npos);
}

TEST(SurfaceRules, HaveTheReleaseEndBetweenFromAndTo) {
    for (const double until : {0.5, 1.0, 4.5})
        EXPECT_NE(complaint(released_until(until)).find("`releaseUntil`"), std::string::npos)
            << until;
    auto upstream = released_until(-1.0);
    upstream.parameters.to = -2.0;
    EXPECT_EQ(complaint(upstream), "");
    upstream.parameters.release_until = -3.0;
    EXPECT_NE(complaint(upstream), "");
}

TEST(SurfaceRules, RefuseTheSmoothFieldOfWhatHasNone) {
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        auto setting = of_kind(kind);
        setting.parameters.interpolation = core::Interpolation::Smooth;
        EXPECT_NE(complaint(setting).find("`interpolation`"), std::string::npos);
    }
}

TEST(SurfaceRules, TakeTheDatasetsSpacingForASeparationLeftOut) {
    auto setting = of_kind(SurfaceKind::Stream);
    ASSERT_TRUE(complete_surface(setting, abc()));
    EXPECT_EQ(setting.parameters.separation, abc().flow->finest_spacing());
}

} // namespace wakesurf::server::surface_rules_test
