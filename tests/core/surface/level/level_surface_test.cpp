#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/level/level_source.hpp"
#include "core/surface/level/level_surface.hpp"
#include "core/surface/patches/tessellation.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::level_surface_test {
namespace {

/// One cell with a field that goes from 0 to 4 along x, which remembers what it was asked for.
class Planes final : public LevelSource {
  public:
    const Grid& grid() const override { return grid_; }

    Result<std::shared_ptr<const NodeValues>>
    values(const std::string& field, double time, const std::stop_token&) const override {
        asked_field = field;
        asked_time = time;
        return std::make_shared<const NodeValues>(found);
    }

    Result<void> check_field(const std::string& name) const override {
        if (name == "p")
            return {};
        return fail(Error::Code::NotFound, "no field " + name);
    }

    mutable std::string asked_field;
    mutable double asked_time = 0.0;
    NodeValues found{{0, 4, 0, 4, 0, 4, 0, 4}, {0.0, 4.0}};

  private:
    Grid grid_ = UniformGrid{Vec3(0.0, 1.0, 1.0), Vec3(4.0, 1.0, 1.0), {2, 2, 2}};
};

const std::shared_ptr<const Flow> abc = make_analytic_flow("abc").value();

SurfaceParameters level_of(double level, double from = 0.0, double to = 5.0) {
    SurfaceParameters p{.kind = SurfaceKind::Level, .from = from, .to = to};
    p.field = "p";
    p.level = level;
    return p;
}

struct Level {
    explicit Level(const SurfaceParameters& parameters)
        : plan(plan_surface(abc, {}, parameters).value()), source(std::make_shared<Planes>()) {
        EXPECT_TRUE(take_levels(plan, source));
    }

    SurfacePlan plan;
    std::shared_ptr<Planes> source;
};

TEST(LevelSurface, IsAMeshThatBeginsAtNoRake) {
    const Level level(level_of(3.0));
    const auto surface = build_surface(level.plan).value();
    EXPECT_EQ(surface.mesh.cells.size(), 1u) << "two triangles are one quad";
    EXPECT_EQ(surface.statistics.quads, 1u);
    EXPECT_EQ(surface.statistics.vertices, 4u);
    EXPECT_EQ(surface.statistics.kind, SurfaceKind::Level);
    EXPECT_FALSE(surface.statistics.empty);
    EXPECT_EQ(surface.statistics.field_range, (std::array{0.0, 4.0}));
    for (std::size_t i = 0; i < 4; ++i) {
        Vec3 velocity;
        const std::array place{surface.mesh.position[i]};
        const std::array time{5.0};
        ASSERT_TRUE(abc->sample(place, time, std::span(&velocity, 1), {}));
        EXPECT_EQ(surface.mesh.velocity[i], Vec3f(velocity));
        EXPECT_EQ(surface.mesh.s[i], 0.0);
        EXPECT_EQ(surface.mesh.t[i], 0.0);
    }
}

TEST(LevelSurface, IsOfTheTimeThatIsShownWithinItsOwn) {
    const Level level(level_of(3.0, 1.0, 4.0));
    const auto time = [&](std::optional<double> clock) {
        EXPECT_TRUE(surface_at(level.plan, clock, SteadyClock{}, {}));
        return level.source->asked_time;
    };
    EXPECT_EQ(time(std::nullopt), 4.0);
    EXPECT_EQ(time(2.5), 2.5);
    EXPECT_EQ(time(0.0), 1.0);
    EXPECT_EQ(time(9.0), 4.0);
    EXPECT_EQ(level.source->asked_field, "p");
}

TEST(LevelSurface, OutsideTheRangeIsEmptyAndSaysTheRange) {
    const auto surface = build_surface(Level(level_of(7.5)).plan).value();
    ASSERT_TRUE(surface.statistics.empty);
    EXPECT_EQ(surface.statistics.empty->reason, Emptiness::Reason::OutsideRange);
    EXPECT_EQ(surface.statistics.empty->message,
              "level 7.5 is outside the range of p at t = 5, 0 to 4");
    EXPECT_EQ(surface.statistics.empty->hint, "choose a level from 0 to 4");
    EXPECT_FALSE(surface.statistics.empty->natural());
}

TEST(LevelSurface, OfAFieldWithoutValuesSaysSo) {
    const Level level(level_of(1.0));
    level.source->found.any = false;
    const auto surface = build_surface(level.plan).value();
    ASSERT_TRUE(surface.statistics.empty);
    EXPECT_EQ(surface.statistics.empty->reason, Emptiness::Reason::NotFinite);
    EXPECT_EQ(surface.statistics.empty->message, "p has no values at t = 5");
    EXPECT_FALSE(surface.statistics.field_range);
    EXPECT_EQ(surface.statistics.empty->hint, "choose another field, or another time");
    level.source->found.times = {1, 2.5};
    EXPECT_EQ(build_surface(level.plan)->statistics.empty->hint,
              "p has values at t = 1, 2.5: choose such a time, or another field");
    level.source->found.times = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    EXPECT_TRUE(holds(build_surface(level.plan)->statistics.empty->hint, "6, 7, ... 9:"));
}

TEST(LevelSurface, OfMoreQuadsThanAllowedIsRefusedWithTheirNumber) {
    auto parameters = level_of(3.0);
    parameters.max_quads = 1;
    EXPECT_TRUE(build_surface(Level(parameters).plan));
    Level level(parameters);
    level.plan.parameters.max_quads = 0;
    const auto refused = build_surface(level.plan);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Error::Code::OverLimit);
    EXPECT_EQ(refused.error().message, "the level set of p has 2 triangles, more than `maxQuads` 0 "
                                       "quads are made of");
    EXPECT_EQ(refused.error().limit, 0U);
}

TEST(LevelSurface, NeedsAFieldThatThereIsAndData) {
    auto parameters = level_of(3.0);
    parameters.field = "q";
    SurfacePlan plan = plan_surface(abc, {}, parameters).value();
    EXPECT_EQ(take_levels(plan, std::make_shared<Planes>()).error().code, Error::Code::NotFound);
    EXPECT_EQ(take_levels(plan, nullptr).error().code, Error::Code::Unsupported);
    parameters.field.reset();
    EXPECT_TRUE(holds(plan_surface(abc, {}, parameters).error().message, "needs `field`"));
    parameters = level_of(3.0);
    parameters.level.reset();
    EXPECT_TRUE(holds(plan_surface(abc, {}, parameters).error().message, "needs `level`"));
    parameters = level_of(3.0);
    parameters.kind = SurfaceKind::Path;
    EXPECT_TRUE(
        holds(plan_surface(abc, {}, parameters).error().message, "belongs to level surfaces"));
}

TEST(LevelSurface, HasNoCurvedCells) {
    const Level level(level_of(3.0));
    const auto surface = build_surface(level.plan).value();
    std::vector<double> times(surface.mesh.vertices(), 5.0);
    EXPECT_EQ(tessellate(level.plan, surface.mesh, times, 4, {}).error().code,
              Error::Code::InvalidArgument);
    EXPECT_TRUE(tessellate(level.plan, surface.mesh, times, 1, {}));
}

TEST(LevelSurface, MayBeOfOneTime) {
    EXPECT_TRUE(plan_surface(abc, {}, level_of(3.0, 2.0, 2.0)));
}

} // namespace
} // namespace wakesurf::core::level_surface_test
