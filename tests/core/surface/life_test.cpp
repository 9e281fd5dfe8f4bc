// Particles that end at an age: what is left of the surface is a closed form, or another surface.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace wakesurf::core::life_test {

namespace {

const std::vector<Accuracy> accuracies{Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact};

Rake line(const Vec3& a, const Vec3& b) {
    return {Rake::Kind::Line, {a, b}, 9};
}

SurfaceParameters living(SurfaceKind kind, double to, double life, double separation = 0.2) {
    SurfaceParameters p{.kind = kind, .to = to, .separation = separation, .life = life};
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0, 0, 1);
    return p;
}

double area(const QuadComplex& mesh) {
    double sum = 0.0;
    for (const Cell& cell : mesh.cells) {
        const auto& [a, b, c, d] = cell.corner;
        sum += 0.5 * glm::length(glm::cross(mesh.position[c] - mesh.position[a],
                                            mesh.position[d] - mesh.position[b]));
    }
    return sum;
}

double oldest(const QuadComplex& mesh, double time) {
    double most = 0.0;
    for (const double t : mesh.t)
        most = std::max(most, std::abs(time - t));
    return most;
}

Surface built(const std::string& flow, const Rake& rake, const SurfaceParameters& p) {
    auto surface = build_surface(**make_analytic_flow(flow), rake, p);
    EXPECT_TRUE(surface) << (surface ? "" : surface.error().message);
    return std::move(*surface);
}

} // namespace

TEST(Life, CutsAStreakSurfaceInUniformFlowToARectangle) {
    for (const Accuracy accuracy : accuracies)
        for (const double to : {5.0, -5.0}) {
            SurfaceParameters p = living(SurfaceKind::Streak, to, 2.05);
            p.accuracy = accuracy;
            const Surface surface = built("uniform", line({0, -1, 0}, {0, 1, 0}), p);
            EXPECT_NEAR(area(surface.mesh), 2.0 * 2.05, 1e-9);
            EXPECT_NEAR(oldest(surface.mesh, to), 2.05, 1e-9);
            for (std::size_t v = 0; v < surface.mesh.vertices(); ++v)
                ASSERT_NEAR(surface.mesh.position[v].x, to - surface.mesh.t[v], 1e-9);
            EXPECT_GT(surface.statistics.terminated.time, 0u);
            EXPECT_EQ(surface.mesh.validate(), "");
        }
}

TEST(Life, CutsAStreakSurfaceThatTurnsToASectorWhoseLastRowIsJustAsOld) {
    // Each circle of radius r turns once in 2 pi; the sector is between radii 1 and 2.
    const double life = 1.3;
    SurfaceParameters p = living(SurfaceKind::Streak, 6.0, life, 0.1);
    p.accuracy = Accuracy::Exact;
    const Surface surface = built("rotation?w=0", line({1, 0, 0}, {2, 0, 0}), p);
    EXPECT_NEAR(oldest(surface.mesh, 6.0), life, 1e-9);
    for (std::size_t v = 0; v < surface.mesh.vertices(); ++v) {
        const Vec3 x = surface.mesh.position[v];
        if (surface.mesh.approximated[v] == 0) {
            ASSERT_NEAR(std::abs(std::atan2(x.y, x.x)), 6.0 - surface.mesh.t[v], 1e-6);
        }
    }
    EXPECT_NEAR(area(surface.mesh), 0.5 * (4.0 - 1.0) * life, 2e-3 * 1.95);
}

TEST(Life, LeavesWhatWasReleasedSinceThenAlsoWhereTheFlowChanges) {
    const Rake rake = line({1.0, 0.3, 0}, {1.0, 0.7, 0});
    const double life = 3.0, to = 9.0;
    SurfaceParameters p = living(SurfaceKind::Streak, to, life, 0.03);
    p.accuracy = Accuracy::Exact;
    const Surface short_lived = built("double-gyre", rake, p);
    p.life.reset();
    p.from = to - life;
    const Surface released_late = built("double-gyre", rake, p);
    EXPECT_NEAR(area(short_lived.mesh), area(released_late.mesh), 0.01 * area(released_late.mesh));
    EXPECT_NEAR(oldest(short_lived.mesh, to), life, 1e-9);
    EXPECT_NEAR(oldest(released_late.mesh, to), life, 1e-9);
}

TEST(Life, HoldsAtEveryTimeAtWhichASurfaceIsShown) {
    const std::shared_ptr<const Flow> flow = make_analytic_flow("uniform").value();
    const auto plan =
        plan_surface(flow, line({0, -1, 0}, {0, 1, 0}), living(SurfaceKind::Streak, 6.0, 1.5))
            .value();
    for (const double time : {0.7, 1.5, 1.6, 3.1, 6.0}) {
        const auto shown = value_of(surface_at(plan, time, SteadyClock{}, {}));
        EXPECT_NEAR(area(shown.mesh), 2.0 * std::min(time, 1.5), 1e-9) << time;
    }
}

TEST(Life, ThatIsShorterThanARowLeavesAStripAtTheRake) {
    const Surface surface =
        built("uniform", line({0, -1, 0}, {0, 1, 0}), living(SurfaceKind::Streak, 3.0, 0.04, 0.5));
    EXPECT_NEAR(area(surface.mesh), 2.0 * 0.04, 1e-9);
}

TEST(Life, LeavesWholeQuadsOfAGridThatStays) {
    SurfaceParameters p = living(SurfaceKind::Streak, 5.0, 2.0);
    p.refine = Refine::Off;
    const Surface surface = built("uniform", line({0, -1, 0}, {0, 1, 0}), p);
    EXPECT_LE(oldest(surface.mesh, 5.0), 2.0 + 1e-9);
    EXPECT_GT(oldest(surface.mesh, 5.0), 2.0 - 0.2);
}

TEST(Life, EndsAPathSurfaceAsIfItWereAskedForThatLong) {
    const Rake rake = line({1.0, 0.3, 0}, {1.0, 0.7, 0});
    for (const double to : {4.0, -4.0})
        for (const Refine refine : {Refine::On, Refine::Off}) {
            SurfaceParameters p = living(SurfaceKind::Path, to, 2.5, 0.05);
            p.refine = refine;
            const Surface short_lived = built("double-gyre", rake, p);
            p.life.reset();
            p.to = std::copysign(2.5, to);
            const Surface asked = built("double-gyre", rake, p);
            EXPECT_EQ(short_lived.mesh.position, asked.mesh.position);
            EXPECT_EQ(short_lived.mesh.t, asked.mesh.t);
        }
    SurfaceParameters both = living(SurfaceKind::Path, 4.0, 2.5, 0.05);
    both.direction = Direction::Both;
    const Surface surface = built("double-gyre", rake, both);
    const auto [first, last] = std::minmax_element(surface.mesh.t.begin(), surface.mesh.t.end());
    EXPECT_NEAR(*first, -2.5, 1e-9);
    EXPECT_NEAR(*last, 2.5, 1e-9);
}

TEST(Life, EndsATimeSurfaceWithAllItsParticles) {
    const std::shared_ptr<const Flow> flow = make_analytic_flow("uniform").value();
    const Rake rake = line({0, -1, 0}, {0, 1, 0});
    const auto plan = plan_surface(flow, rake, living(SurfaceKind::Time, 4.0, 2.0)).value();
    const auto before = value_of(surface_at(plan, 2.0, SteadyClock{}, {}));
    EXPECT_NEAR(area(before.mesh), 2.0, 1e-9);
    const auto after = value_of(surface_at(plan, 2.5, SteadyClock{}, {}));
    EXPECT_TRUE(after.mesh.cells.empty());
    ASSERT_TRUE(after.statistics.empty);
    EXPECT_EQ(after.statistics.empty->reason, Emptiness::Reason::AllLeft);
    EXPECT_TRUE(holds(after.statistics.empty->hint, "`life`"));
}

TEST(Life, LongerThanTheSurfaceChangesNothing) {
    const Rake rake = line({1.0, 0.3, 0}, {1.0, 0.7, 0});
    for (const SurfaceKind kind : {SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        SurfaceParameters p = living(kind, 2.0, 50.0, 0.1);
        if (kind == SurfaceKind::Time)
            p.sweep = Vec3(0.2, 0, 0);
        const Surface with = built("double-gyre", rake, p);
        p.life.reset();
        EXPECT_EQ(with.mesh.position, built("double-gyre", rake, p).mesh.position);
    }
}

TEST(Life, BelongsToParticlesThatAreReleasedAtATime) {
    const auto flow = make_analytic_flow("uniform");
    const Rake rake = line({0, -1, 0}, {0, 1, 0});
    const auto refused = [&](const SurfaceParameters& p) {
        return build_surface(**flow, rake, p).error().message;
    };
    EXPECT_EQ(refused(living(SurfaceKind::Stream, 2.0, 1.0)),
              "`life` belongs to path, streak or time surfaces");
    for (const double bad : {0.0, -1.0, std::nan("")})
        EXPECT_EQ(refused(living(SurfaceKind::Streak, 2.0, bad)),
                  "`life` must be a number greater than 0");
}

} // namespace wakesurf::core::life_test
