// Surfaces through time-steps that come brick by brick, beside those through whole ones: the same bytes.
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "tests/support/bricked_source.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace wakesurf::core::bricks_twin_test {

using tests::BrickedSource;
using tests::SampledSource;

namespace {

/// A vortex that drifts through a stream.
Vec3 drifting(const Vec3& p, double t) {
    const double x = p.x - 0.3 * t, y = p.y, r = 1.0 + x * x + y * y;
    return {0.6 - y / r, x / r + 0.05 * std::sin(2.0 * p.z), 0.2 * std::cos(x + t)};
}

enum class Shape { Uniform, Rectilinear };
enum class Inside { Fluid, Obstacle, Gap };

std::shared_ptr<const TimeStepSource> series(Shape shape, Inside inside) {
    const UniformGrid uniform{Vec3(-2.0, -1.5, -1.0), Vec3(0.11), {40, 29, 19}};
    Grid grid = uniform;
    if (shape == Shape::Rectilinear) {
        RectilinearGrid stretched;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::uint32_t i = 0; i < uniform.dimensions[axis]; ++i) {
                const int a = static_cast<int>(axis);
                stretched.coordinates[axis].push_back(uniform.origin[a] + uniform.spacing[a] * i +
                                                      0.03 * std::sin(0.4 * i));
            }
        grid = stretched;
    }
    const auto velocity = [inside](const Vec3& p, double t) {
        const bool gap = inside == Inside::Gap && glm::length(p - Vec3(1.2, 0.2, 0.1)) < 0.3;
        return gap ? Vec3(std::numeric_limits<double>::quiet_NaN()) : drifting(p, t);
    };
    SolidMask mask;
    const SampledSource nodes(grid, {0.0}, velocity);
    if (inside == Inside::Obstacle)
        for (std::size_t node = 0; node < node_count(grid); ++node)
            mask.fluid.push_back(glm::length(nodes.position(node) - Vec3(0.6, 0.1, 0.0)) > 0.35);
    return std::make_shared<SampledSource>(grid, std::vector{0.0, 0.5, 0.9, 1.4, 2.0}, velocity,
                                           mask);
}

std::unique_ptr<Flow>
flow_of(std::shared_ptr<const TimeStepSource> source, std::size_t budget, bool by_brick) {
    TimeStepCache::Options options;
    options.budget_bytes = budget;
    options.by_brick = by_brick;
    return make_stored_flow(std::make_shared<TimeStepCache>(std::move(source), options));
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

/// The first array that differs; empty where none does.
std::string difference(const QuadComplex& a, const QuadComplex& b) {
    return !same_bytes(a.position, b.position)   ? "positions"
           : !same_bytes(a.velocity, b.velocity) ? "velocities"
           : !same_bytes(a.s, b.s)               ? "seed parameters"
           : !same_bytes(a.t, b.t)               ? "release times"
           : !same_bytes(a.error, b.error)       ? "errors"
           : a.cells.size() != b.cells.size()    ? "cells"
                                                 : "";
}

struct Case {
    Shape shape;
    Inside inside;
    SurfaceKind kind;
    Accuracy accuracy;
    Interpolation interpolation;
};

SurfaceParameters parameters_of(const Case& each) {
    SurfaceParameters parameters{.kind = each.kind,
                                 .to = 1.9,
                                 .accuracy = each.accuracy,
                                 .interpolation = each.interpolation};
    if (each.kind == SurfaceKind::Time)
        parameters.sweep = Vec3(0.4, 0.0, 0.0);
    return parameters;
}

/// Orders of arrival of each case and size of bricks.
unsigned orders() {
    const char* const text = std::getenv("WAKESURF_ORDERS");
    return text == nullptr ? 1 : static_cast<unsigned>(std::stoul(text));
}

class BricksTwin : public testing::TestWithParam<Case> {};

} // namespace

TEST_P(BricksTwin, HasTheSameBytesInAnyBricksAndOrderOfArrival) {
    const Case& each = GetParam();
    const auto whole = series(each.shape, each.inside);
    const Rake rake{Rake::Kind::Line, {{-1.6, -0.9, -0.4}, {-1.6, 0.9, 0.5}}, 9};
    const auto flow = flow_of(whole, std::size_t{1} << 30, false);
    const auto flat = value_of(build_surface(*flow, rake, parameters_of(each)));
    ASSERT_GT(flat.mesh.cells.size(), 20u);
    for (const std::uint32_t cells :
         each.accuracy == Accuracy::Balanced ? std::array{4u, 16u} : std::array{8u, 32u}) {
        for (unsigned order = 0; order < orders(); ++order) {
            const auto bricked = std::make_shared<BrickedSource>(whole, cells, 7 * cells + order);
            const auto paged = flow_of(bricked, std::size_t{1} << 19, true);
            const auto surface = value_of(build_surface(*paged, rake, parameters_of(each)));
            EXPECT_GT(bricked->read_so_far(), 0u);
            EXPECT_EQ(difference(flat.mesh, surface.mesh), "")
                << "bricks of " << cells << ", order " << order << ": " << surface.mesh.vertices()
                << " vertices for " << flat.mesh.vertices();
        }
    }
}

TEST(BricksInLittleMemory, GiveWayToTheSurfaceThatReadsThem) {
    const UniformGrid grid{Vec3(-2.0, -1.5, -1.0), Vec3(0.05), {80, 58, 38}};
    const auto whole =
        std::make_shared<SampledSource>(grid, std::vector{0.0, 0.5, 0.9, 1.4, 2.0}, drifting);
    const Rake rake{Rake::Kind::Line, {{-1.6, -0.9, -0.4}, {-1.6, 0.9, 0.5}}, 9};
    const MemoryAccount account(std::size_t{8} << 20);
    for (const auto kind : {SurfaceKind::Stream, SurfaceKind::Path}) {
        const SurfaceParameters p{.kind = kind, .to = 1.9, .separation = 0.04};
        const auto flat =
            value_of(build_surface(*flow_of(whole, std::size_t{1} << 30, false), rake, p));
        TimeStepCache::Options options;
        options.account = account;
        options.by_brick = true;
        const std::shared_ptr<const Flow> paged = make_stored_flow(
            std::make_shared<TimeStepCache>(std::make_shared<BrickedSource>(whole, 8, 3), options));
        const auto plan = plan_surface(paged, rake, p).value();
        for (const double time : whole->times()) { // bricks take all that they may
            std::vector<Vec3> places;
            for (std::size_t node = 0; node < node_count(Grid(grid)); node += 101)
                places.push_back(whole->position(node));
            std::vector<Vec3> velocities(places.size());
            ASSERT_TRUE(paged->sample(places, std::vector(places.size(), time), velocities, {}));
        }
        EXPECT_LT(account.free(), account.budget() / 5);
        WorkMemory memory(account);
        const auto surface = surface_at(plan, {}, SteadyClock{}, {}, {nullptr, &memory});
        ASSERT_TRUE(surface) << surface.error().message;
        EXPECT_EQ(difference(flat.mesh, surface->mesh), "");
    }
}

TEST(DamagedBricks, EndTheSurfaceAtTheLastTimeBeforeThemAndSaySo) {
    const auto whole = series(Shape::Uniform, Inside::Fluid);
    const Rake rake{Rake::Kind::Line, {{-1.6, -0.9, -0.4}, {-1.6, 0.9, 0.5}}, 9};
    for (const SurfaceKind kind : {SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        for (const Interpolation interpolation : {Interpolation::Linear, Interpolation::Smooth}) {
            SurfaceParameters parameters = parameters_of(
                {Shape::Uniform, Inside::Fluid, kind, Accuracy::Balanced, interpolation});
            const auto bricked = std::make_shared<BrickedSource>(whole, 8);
            bricked->broken_from = 3;
            const auto flow = flow_of(bricked, std::size_t{1} << 19, true);
            const auto ended = value_of(build_surface(*flow, rake, parameters));
            // Cubics in time need the time-step after as well.
            const double last = interpolation == Interpolation::Smooth ? 0.5 : 0.9;
            EXPECT_EQ(ended.ended, last);
            EXPECT_TRUE(holds(ended.statistics.stopped, "is damaged"));
            parameters.to = last;
            const auto shorter =
                build_surface(*flow_of(whole, std::size_t{1} << 30, false), rake, parameters);
            ASSERT_TRUE(shorter);
            EXPECT_EQ(difference(ended.mesh, shorter->mesh), "")
                << static_cast<int>(kind) << " " << static_cast<int>(interpolation);
        }
}

namespace {

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const SurfaceKind kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact})
            for (const Inside inside : {Inside::Fluid, Inside::Obstacle, Inside::Gap})
                for (const auto& [shape, interpolation] :
                     {std::pair(Shape::Uniform, Interpolation::Linear),
                      std::pair(Shape::Uniform, Interpolation::Smooth),
                      std::pair(Shape::Rectilinear, Interpolation::Linear)})
                    all.push_back({shape, inside, kind, accuracy, interpolation});
    return all;
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    const Case& c = info.param;
    return std::array{"Stream", "Path", "Streak", "Time"}[static_cast<std::size_t>(c.kind)] +
           std::string(
               std::array{"Fast", "Balanced", "Exact"}[static_cast<std::size_t>(c.accuracy)]) +
           std::array{"Fluid", "Obstacle", "Gap"}[static_cast<std::size_t>(c.inside)] +
           (c.shape == Shape::Rectilinear              ? "Rectilinear"
            : c.interpolation == Interpolation::Smooth ? "Smooth"
                                                       : "Uniform");
}

} // namespace

INSTANTIATE_TEST_SUITE_P(AllKinds, BricksTwin, testing::ValuesIn(cases()), name_of);

} // namespace wakesurf::core::bricks_twin_test
