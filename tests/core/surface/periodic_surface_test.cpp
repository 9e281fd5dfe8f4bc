// Surfaces through a flow that repeats: drawn on beyond the box of its grid.
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/bricked_source.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wakesurf::core::periodic_surface_test {
namespace {

std::shared_ptr<const Flow> flow_through(const UniformGrid& grid,
                                         PeriodicAxes axes,
                                         tests::SampledSource::Velocity velocity,
                                         bool by_brick = false) {
    auto source = std::make_shared<tests::SampledSource>(grid, std::vector{0.0, 2.0, 5.0},
                                                         std::move(velocity));
    source->periodic_axes = axes;
    TimeStepCache::Options options;
    options.by_brick = by_brick;
    if (!by_brick)
        return make_stored_flow(std::make_shared<TimeStepCache>(std::move(source), options));
    options.budget_bytes = std::size_t{1} << 16;
    return make_stored_flow(std::make_shared<TimeStepCache>(
        std::make_shared<tests::BrickedSource>(std::move(source), 2u), options));
}

Box round(const QuadComplex& mesh) {
    Box box{Vec3(std::numeric_limits<double>::infinity()),
            Vec3(-std::numeric_limits<double>::infinity())};
    for (const Vec3& p : mesh.position) {
        box.lo = glm::min(box.lo, p);
        box.hi = glm::max(box.hi, p);
    }
    return box;
}

SurfaceParameters parameters_of(SurfaceKind kind) {
    SurfaceParameters p;
    p.kind = kind;
    p.to = 4.0;
    p.separation = 0.1;
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0.0, 0.0, 0.3);
    return p;
}

Vec3 wavy(const Vec3& p, double t) {
    constexpr double turn = 6.283185307179586;
    return {1.0 + 0.2 * std::sin(turn * p.x), 0.1 * std::sin(turn * (p.x + 0.1 * t)), 0.0};
}

const UniformGrid one_period{Vec3(0.0), Vec3(0.125), {9, 9, 9}};
const UniformGrid several{Vec3(-8.0, -1.0, 0.0), Vec3(0.125), {137, 25, 9}};
const Rake line{Rake::Kind::Line, {{0.6, 0.3, 0.4}, {0.6, 0.7, 0.5}}, 6};

} // namespace

TEST(PeriodicSurface, OfEachKindGoesOnToItsEndTimeInAStreamThatRepeats) {
    const Vec3 wind(1.1, 0.0, 0.0);
    const auto flow =
        flow_through(one_period, {true, false, false}, [&](const Vec3&, double) { return wind; });
    for (const auto& [kind, name] : tests::every_kind) {
        const auto surface = build_surface(*flow, line, parameters_of(kind));
        ASSERT_TRUE(surface.has_value()) << name << surface.error().message;
        const Box box = round(surface->mesh);
        EXPECT_NEAR(box.hi.x, 0.6 + 4.0 * 1.1, 1e-5) << name;
        EXPECT_NEAR(box.hi.y - box.lo.y, 0.4, 1e-5) << name;
        EXPECT_EQ(surface->statistics.terminated.domain, 0u) << name;
    }
}

TEST(PeriodicSurface, IsTheSameThroughTimeStepsThatComeBrickByBrick) {
    const auto whole = flow_through(one_period, {true, true, false}, wavy);
    const auto bricks = flow_through(one_period, {true, true, false}, wavy, true);
    ASSERT_NE(bricks->bricks(), nullptr);
    for (const auto& [kind, name] : tests::every_kind) {
        const auto surface = build_surface(*whole, line, parameters_of(kind));
        const auto other = build_surface(*bricks, line, parameters_of(kind));
        ASSERT_TRUE(surface.has_value() && other.has_value()) << name;
        EXPECT_EQ(surface->mesh.position, other->mesh.position) << name;
    }
}

TEST(PeriodicSurface, IsThatOfAGridOfSeveralPeriods) {
    const auto flow = flow_through(one_period, {true, true, false}, wavy);
    const auto twin = flow_through(several, {}, wavy);
    for (const auto& [kind, name] : tests::every_kind) {
        SurfaceParameters p = parameters_of(kind);
        p.accuracy = Accuracy::Exact;
        const auto surface = build_surface(*flow, line, p);
        const auto other = build_surface(*twin, line, p);
        ASSERT_TRUE(surface.has_value() && other.has_value()) << name;
        const Box a = round(surface->mesh);
        const Box b = round(other->mesh);
        EXPECT_GT(a.hi.x, 3.0) << name;
        EXPECT_LT(glm::length(a.lo - b.lo) + glm::length(a.hi - b.hi), 1e-4) << name;
        EXPECT_NEAR(static_cast<double>(surface->mesh.cells.size()),
                    static_cast<double>(other->mesh.cells.size()),
                    0.02 * static_cast<double>(other->mesh.cells.size()))
            << name;
    }
}

} // namespace wakesurf::core::periodic_surface_test
