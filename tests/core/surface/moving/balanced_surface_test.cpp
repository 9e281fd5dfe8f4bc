// What the accuracy `balanced` is worth: the quads of an exact surface, for less work.
#include "tests/support/meshed_field.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <gtest/gtest.h>

#include <array>

namespace wakesurf::core::balanced_surface_test {

namespace {

using namespace tests;

/// Surfaces of requests at random, those that fit into the quad budget.
struct Sums {
    int compared = 0;
    double fast = 0.0, balanced = 0.0, exact = 0.0;
    std::uint64_t balanced_steps = 0, exact_steps = 0;

    void add(const Flow& flow, const Rake& rake, SurfaceParameters p, const std::string& what) {
        std::array<double, 3> quads{};
        for (const Accuracy accuracy : {Accuracy::Exact, Accuracy::Balanced, Accuracy::Fast}) {
            p.accuracy = accuracy;
            p.max_quads = 10'000;
            const auto surface = build_surface(flow, rake, p);
            if (!surface || (accuracy == Accuracy::Exact && surface->statistics.coarsened()))
                return;
            EXPECT_FALSE(surface->statistics.coarsened()) << what;
            quads[static_cast<std::size_t>(accuracy)] =
                static_cast<double>(surface->statistics.quads);
        }
        const auto [f, b, e] = quads;
        ++compared;
        fast += f;
        balanced += b;
        exact += e;
        // A sheet that is torn and folded has some hundred quads more or less with each constant.
        EXPECT_LE(b, 1.3 * e + 200.0) << what;
        EXPECT_LE(f, 1.3 * b + 200.0) << what;
    }
};

Rake line(const Flow& flow, std::mt19937& random) {
    const auto part = [&] {
        return 0.1 + 0.8 * static_cast<double>(random()) / std::mt19937::max();
    };
    const auto point = [&] {
        const double x = part(), y = part();
        return flow.domain().lo + flow.domain().extent() * Vec3(0.4 * x, y, part());
    };
    const Vec3 from = point();
    return {Rake::Kind::Line, {from, from + 0.4 * (point() - from)}, 12};
}

void add_anywhere(Sums& sums, const Flow& flow, int count, double to, const char* name) {
    std::mt19937 random(5);
    for (int i = 0; i < count; ++i) {
        const Rake rake = line(flow, random);
        SurfaceParameters p{.kind = i % 3 == 2 ? SurfaceKind::Time : SurfaceKind::Streak,
                            .to = to,
                            .separation = 0.02 * glm::length(flow.domain().extent())};
        if (p.kind == SurfaceKind::Time)
            p.sweep = 0.1 * flow.domain().extent();
        sums.add(flow, rake, p, name + (" " + std::to_string(i)));
    }
}

} // namespace

TEST(BalancedSurface, HasAtMostAThirdMoreQuadsThanAnExactOneInEveryFlow) {
    Sums sums;
    std::mt19937 random(32);
    for (const AnalyticEntry& entry : analytic_entries()) {
        // The tornado's velocity jumps, where an exact particle takes very many steps: below it is sampled.
        if (entry.name == "tornado")
            continue;
        for (const SurfaceKind kind :
             {SurfaceKind::Streak, SurfaceKind::Time, SurfaceKind::Streak}) {
            const AskedSurface asked = surface_anywhere(entry, kind, 0.15, random);
            sums.add(*asked.flow, asked.rake, asked.parameters, std::string(entry.name));
        }
    }
    EXPECT_GE(sums.compared, 30);
    EXPECT_LE(sums.balanced, 1.05 * sums.exact);
}

TEST(BalancedSurface, HasAtMostAThirdMoreQuadsOnAMeshOfCellsWithABody) {
    CellMesh mesh = block({30, 60, 6}, round_cylinder, true);
    mark_walls(mesh, [](const Vec3& c) { return std::hypot(c.x, c.y) < 0.51; });
    const auto flow =
        meshed_flow(std::move(mesh), {0.0, 2.0, 4.0, 6.0}, [](const Vec3& p, double t) {
            const double r2 = std::max(0.25, p.x * p.x + p.y * p.y);
            const double part = 0.25 / (r2 * r2);
            return Vec3(1.0 - part * (p.x * p.x - p.y * p.y),
                        -2.0 * part * p.x * p.y + 0.3 * std::sin(t + p.x), 0.1 * std::cos(p.y));
        });
    Sums sums;
    add_anywhere(sums, *flow, 9, 6.0, "cylinder");
    EXPECT_GE(sums.compared, 5);
}

TEST(BalancedSurface, OfAStoredVortexHasAtMostAThirdMoreQuads) {
    const std::shared_ptr<const Flow> form = *make_analytic_flow("tornado");
    UniformGrid grid{.origin = form->domain().lo,
                     .spacing = form->domain().extent() / 47.0,
                     .dimensions = {48, 48, 48}};
    auto source = std::make_shared<SampledSource>(
        grid, std::vector<double>{0.0, 1.0, 2.0, 3.0}, [form](const Vec3& p, double t) {
            Vec3 v;
            EXPECT_TRUE(form->sample({&p, 1}, {&t, 1}, {&v, 1}, {}));
            return v;
        });
    const auto flow =
        make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
    Sums sums;
    add_anywhere(sums, *flow, 9, 3.0, "tornado");
    EXPECT_GE(sums.compared, 5);
}

} // namespace wakesurf::core::balanced_surface_test
