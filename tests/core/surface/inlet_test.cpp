// Rakes where the domain begins, as people type them, in data whose coordinates and times are rounded to 32 bits.
#include "core/base/rounding.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace wakesurf::core::inlet_test {

using namespace tests;

namespace {

constexpr double a = 0.25, b = 0.3, c = 0.2;
const Vec3 low(0.1, -0.3, 0.7);
const std::vector<double> typed_times{0.1, 0.4, 0.7, 1.3};

Vec3 velocity(const Vec3& p, double t) {
    return {1.0, a * t + b * p.z, c};
}

/// Where it carries a particle from `p`, released at `t0`, in a time `t`. @param frozen  the field stays as it is at t0
Vec3 carried(const Vec3& p, double t0, double t, bool frozen) {
    const double of_time = frozen ? a * t0 * t : a * ((t0 + t) * (t0 + t) - t0 * t0) / 2.0;
    return p + Vec3(t, of_time + b * (p.z * t + c * t * t / 2.0), c * t);
}

double in_32_bits(double x) {
    return static_cast<float>(x);
}

Vec3 in_32_bits(const Vec3& p) {
    return {in_32_bits(p.x), in_32_bits(p.y), in_32_bits(p.z)};
}

Vec3 turned(const Vec3& p, double angle) {
    return {std::cos(angle) * p.x - std::sin(angle) * p.y,
            std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
}

struct Case {
    const char* name;
    Grid grid;
    double angle = 0.0; ///< the inlet's, round z
};

/// Two wide, of eight cells a side.
std::vector<Case> cases() {
    std::vector<Case> all;
    UniformGrid uniform{.origin = in_32_bits(low), .spacing = Vec3(0.25), .dimensions = {9, 9, 9}};
    all.push_back({"uniform", uniform});
    RectilinearGrid rectilinear;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i <= 8; ++i)
            rectilinear.coordinates[static_cast<std::size_t>(axis)].push_back(
                in_32_bits(low[axis] + 2.0 * std::pow(i / 8.0, 1.5)));
    all.push_back({"rectilinear", rectilinear});
    for (const double angle : {0.0, -std::numbers::pi / 7.0})
        all.push_back(
            {angle == 0.0 ? "cells" : "inclined cells",
             block({8, 8, 8},
                   [angle](const Vec3& u) { return in_32_bits(turned(low + 2.0 * u, angle)); }),
             angle});
    return all;
}

std::unique_ptr<Flow> flow_of(const Grid& grid) {
    std::vector<double> times;
    for (const double time : typed_times)
        times.push_back(in_32_bits(time));
    auto source = std::make_shared<SampledSource>(grid, times, velocity);
    return make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
}

/// True in the other faces of the domain.
bool leaves(const Vec3& p, double angle) {
    const Vec3 high = low + 2.0 - turned(p, -angle);
    return std::min({high.x, high.y, high.z}) < 1e-6;
}

/// In the inlet, on its lower edge, from corner to corner, and on its side.
const std::vector<std::array<Vec3, 2>> lines{{low + Vec3(0, 0.4, 0.4), low + Vec3(0, 0.8, 0.6)},
                                             {low, low + Vec3(0, 2, 0)},
                                             {low, low + Vec3(0, 2, 2)},
                                             {low, low + Vec3(0, 0, 2)}};

} // namespace

TEST(Inlet, SurfacesFromRakesInItAreWholeAndRightInEveryGridOf32Bits) {
    for (const Case& each : cases()) {
        const auto flow = flow_of(each.grid);
        for (const auto& [first, last] : lines)
            for (const SurfaceKind kind :
                 {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
                const Rake typed{
                    Rake::Kind::Line, {turned(first, each.angle), turned(last, each.angle)}, 17};
                const auto rake = clip_rake(typed, flow->domain());
                ASSERT_TRUE(rake) << each.name << ": " << rake.error().message;
                EXPECT_FALSE(rake->clipped) << each.name;
                SurfaceParameters p{.kind = kind,
                                    .from = typed_times.front(),
                                    .to = typed_times.back(),
                                    .separation = 0.1,
                                    .accuracy = Accuracy::Exact};
                const auto surface = build_surface(*flow, rake->rake, p);
                ASSERT_TRUE(surface) << each.name << ": " << surface.error().message;
                const QuadComplex& mesh = surface->mesh;
                const SeedingCurve seeding(typed);
                const bool streak = kind == SurfaceKind::Streak;
                std::vector<double> seeds;
                for (std::size_t i = 0; i < mesh.vertices(); ++i) {
                    const double released = streak ? mesh.t[i] : p.from;
                    const double age = streak ? p.to - mesh.t[i] : mesh.t[i];
                    const Vec3 exact =
                        carried(seeding.at(mesh.s[i]), released, age, kind == SurfaceKind::Stream);
                    // Where a streak surface is cut at another face, s and t are those of the edge that was cut.
                    if (streak && leaves(mesh.position[i], each.angle))
                        continue;
                    ASSERT_LT(glm::length(mesh.position[i] - exact), 1e-5)
                        << each.name << " s " << mesh.s[i] << " t " << mesh.t[i];
                    if (age < 1e-6)
                        seeds.push_back(mesh.s[i]);
                }
                // The edge at the rake is there, of every seed of it.
                std::ranges::sort(seeds);
                ASSERT_GE(seeds.size(), 17u) << each.name << " " << static_cast<int>(kind);
                EXPECT_EQ(seeds.front(), 0.0) << each.name;
                for (std::size_t i = 1; i < seeds.size(); ++i)
                    EXPECT_LE(seeds[i] - seeds[i - 1], 1.0 / 16.0 + 1e-9) << each.name;
                // From the upper sides the flow leaves at once.
                EXPECT_GT(seeds.back(), glm::length(last - first) > 1.0 ? 0.9 : 1.0 - 1e-9)
                    << each.name;
            }
    }
}

TEST(Inlet, APointInItIsInsideAndOneTenThousandthBeforeItIsNot) {
    for (const Case& each : cases()) {
        const auto flow = flow_of(each.grid);
        for (int i = 1; i < 100; ++i)
            for (const double before : {0.0, 1e-4}) {
                const Vec3 p = turned(low + Vec3(-before, 0.02 * i, 0.0199 * i), each.angle);
                EXPECT_EQ(flow->status(onto_faces(p, flow->domain())),
                          before == 0.0 ? PointStatus::Inside : PointStatus::OutsideDomain)
                    << each.name << " " << i;
            }
    }
}

TEST(Inlet, InADomainThatIsLongAndThinRoundingIsThatOfEachAxis) {
    const Vec3 size(1000.0, 1000.0, 1e-3);
    const auto flow = flow_of(block(
        {4, 4, 4}, [&](const Vec3& u) { return in_32_bits(Vec3(0.1, 0.1, 0.0) + size * u); }));
    EXPECT_EQ(flow->status({0.1, 500.0, 5e-4}), PointStatus::Inside);
    // A quarter of the thickness above; 32 bits keep the length to a tenth of that.
    EXPECT_EQ(flow->status({500.0, 500.0, 1.2e-3}), PointStatus::OutsideDomain);
    EXPECT_EQ(flow->status({500.0, 500.0, 1.001e-3}), PointStatus::OutsideDomain);
}

TEST(Inlet, ATimeThatIsTypedIsThatOfTheDataIn32BitsAndAnEarlierOneIsNot) {
    const auto flow = flow_of(cases().front().grid);
    const Rake rake{Rake::Kind::Line, {{0.5, 0.0, 1.0}, {0.5, 0.5, 1.0}}, 5};
    SurfaceParameters p;
    p.separation = 0.1;
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak}) {
        p.kind = kind;
        p.from = 0.1;
        p.to = 1.3;
        EXPECT_TRUE(build_surface(*flow, rake, p));
        std::swap(p.from, p.to);
        EXPECT_TRUE(build_surface(*flow, rake, p));
        p.from = 0.0999;
        p.to = 1.3;
        const auto early = build_surface(*flow, rake, p);
        ASSERT_FALSE(early);
        EXPECT_EQ(early.error().code, Error::Code::OutOfTime);
    }
}

} // namespace wakesurf::core::inlet_test
