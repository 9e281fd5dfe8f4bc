// Surfaces whose grid stays as the rake begins it (SurfaceParameters::refine), as the smoke surfaces of von Funck et al. 2008.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/surface_at.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace wakesurf::core::fixed_grid_test {

namespace {

constexpr SurfaceKind all_kinds[] = {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak,
                                     SurfaceKind::Time};

/// A rake of `seeds` across a vortex, which stretches and shears the surface far beyond the separation.
struct Case {
    SurfaceParameters parameters;
    Rake rake{Rake::Kind::Line, {{0.1, 0, -1}, {1.5, 0, -1}}, 9};

    explicit Case(SurfaceKind kind) {
        parameters.kind = kind;
        parameters.to = 3.0;
        parameters.separation = 0.2;
        parameters.refine = Refine::Off;
        parameters.accuracy = Accuracy::Exact;
        if (kind == SurfaceKind::Time)
            parameters.sweep = Vec3(0, 0, 0.8);
    }
};

Surface built(const Case& c, const char* flow_name = "lamb-oseen") {
    const auto flow = make_analytic_flow(flow_name);
    auto surface = build_surface(**flow, c.rake, c.parameters);
    EXPECT_TRUE(surface) << surface.error().message;
    return surface ? *std::move(surface) : Surface{};
}

/// Where the particle of a vertex is by a trace of its own.
Vec3 traced(const Flow& flow, const Case& c, double s, double t) {
    const SurfaceParameters& p = c.parameters;
    Curve curve;
    curve.seed = SeedingCurve(c.rake).at(s);
    curve.release = p.from;
    curve.duration = t;
    if (p.kind == SurfaceKind::Streak) {
        curve.release = t;
        curve.duration = p.to - t;
    } else if (p.kind == SurfaceKind::Time) {
        curve.seed += t * *p.sweep;
        curve.duration = p.to - p.from;
    }
    if (curve.duration == 0.0)
        return curve.seed;
    TraceOptions options{
        .frozen = p.kind == SurfaceKind::Stream, .tolerance = 1e-11, .longest_step = 0.1};
    EXPECT_TRUE(flow.trace({&curve, 1}, options, {}));
    return curve.last.position;
}

} // namespace

TEST(FixedGrid, HasAColumnASeedAndRowsOfWholeQuadsWhateverTheFlowDoes) {
    for (const SurfaceKind kind : all_kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        const Surface surface = built(Case(kind));
        const QuadComplex& mesh = surface.mesh;
        EXPECT_EQ(mesh.validate(), "");
        const std::set<double> columns(mesh.s.begin(), mesh.s.end());
        const std::set<double> rows(mesh.t.begin(), mesh.t.end());
        EXPECT_EQ(columns.size(), 9u);
        EXPECT_GE(rows.size(), 4u);
        EXPECT_EQ(mesh.vertices(), columns.size() * rows.size());
        EXPECT_EQ(mesh.cells.size(), (columns.size() - 1) * (rows.size() - 1));
        for (const Cell& cell : mesh.cells) {
            for (const VertexId mid : cell.mid)
                ASSERT_EQ(mid, no_vertex);
            ASSERT_EQ(mesh.s[cell.corner[0]], mesh.s[cell.corner[3]]);
            ASSERT_EQ(mesh.s[cell.corner[1]], mesh.s[cell.corner[2]]);
            ASSERT_EQ(mesh.t[cell.corner[0]], mesh.t[cell.corner[1]]);
            ASSERT_EQ(mesh.t[cell.corner[2]], mesh.t[cell.corner[3]]);
        }
        EXPECT_EQ(surface.statistics.approximated, 0u);
        EXPECT_GT(surface.statistics.max_edge, 0.3); // nothing is cut, however long it becomes
        EXPECT_FALSE(surface.statistics.coarsened());
    }
}

TEST(FixedGrid, ItsVerticesAreWhereTheirParticlesAre) {
    const auto flow = make_analytic_flow("lamb-oseen");
    for (const SurfaceKind kind : all_kinds) {
        const Case c(kind);
        const Surface surface = built(c);
        const QuadComplex& mesh = surface.mesh;
        for (VertexId v = 0; v < mesh.vertices(); v += 3)
            EXPECT_LT(glm::length(mesh.position[v] - traced(**flow, c, mesh.s[v], mesh.t[v])), 1e-6)
                << static_cast<int>(kind) << " " << mesh.s[v] << " " << mesh.t[v];
    }
}

TEST(FixedGrid, RefinedTheSameRequestHasOtherQuads) {
    for (const SurfaceKind kind : all_kinds) {
        Case c(kind);
        c.parameters.refine = Refine::On;
        const std::vector<double> s = built(c).mesh.s;
        EXPECT_GT(std::set<double>(s.begin(), s.end()).size(), 9u) << static_cast<int>(kind);
    }
}

TEST(FixedGrid, LeavesOutQuadsWithAParticleThatHasEnded) {
    for (const SurfaceKind kind : all_kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        Case c(kind);
        c.rake = {Rake::Kind::Line, {{-2, -1, 0}, {-2, 1, 0}}, 21}; // the middle one meets the body
        c.parameters.stagnation_speed = 0.02;
        c.parameters.to = 6.0;
        if (kind == SurfaceKind::Time)
            c.parameters.sweep = Vec3(0.6, 0, 0);
        const Surface surface = built(c, "sphere");
        const QuadComplex& mesh = surface.mesh;
        EXPECT_EQ(mesh.validate(), "");
        const auto flow = make_analytic_flow("sphere");
        std::map<double, int> of_column;
        for (VertexId v = 0; v < mesh.vertices(); ++v) {
            EXPECT_EQ((*flow)->status(mesh.position[v]), PointStatus::Inside);
            ++of_column[mesh.s[v]];
        }
        EXPECT_LE(of_column.size(), 21u);
        EXPECT_GE(of_column.size(), 20u);
        if (of_column.contains(0.5)) {
            EXPECT_LT(of_column[0.5], of_column[0.0]);
        }
        EXPECT_GT(surface.statistics.terminated.stagnation + surface.statistics.terminated.obstacle,
                  0u);
    }
}

TEST(FixedGrid, KeepsTheQuadBudgetWithLongerRows) {
    for (const SurfaceKind kind : all_kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        Case c(kind);
        c.parameters.separation = 0.02;
        c.parameters.max_quads = 150;
        const Surface surface = built(c);
        EXPECT_LE(surface.mesh.cells.size(), 150u);
        EXPECT_GE(surface.mesh.cells.size(), 60u);
        EXPECT_TRUE(surface.statistics.coarsened());
    }
}

TEST(FixedGrid, ATubeIsClosedAndBothDirectionsMeetAtTheRake) {
    Case c(SurfaceKind::Stream);
    c.rake = {Rake::Kind::Circle, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 12};
    c.parameters.direction = Direction::Both;
    const Surface surface = built(c);
    EXPECT_EQ(surface.mesh.validate(), "");
    std::map<double, int> of_row;
    for (const double t : surface.mesh.t)
        ++of_row[t];
    for (const auto& [t, vertices] : of_row)
        EXPECT_EQ(vertices, 12) << t;
    EXPECT_LT(of_row.begin()->first, -2.9);
    EXPECT_GT(of_row.rbegin()->first, 2.9);
    EXPECT_EQ(surface.mesh.cells.size(), 12 * (of_row.size() - 1));
}

TEST(FixedGrid, AtAnEarlierTimeOfTheClockItIsTheSameGridWithFewerRows) {
    const auto flow = make_analytic_flow("lamb-oseen");
    for (const SurfaceKind kind : {SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        const Case c(kind);
        const auto earlier =
            surface_at(plan_surface(**flow, c.rake, c.parameters).value(), 1.5, SteadyClock{}, {});
        ASSERT_TRUE(earlier) << earlier.error().message;
        const QuadComplex& mesh = earlier->mesh;
        EXPECT_EQ(mesh.validate(), "");
        const std::set<double> columns(mesh.s.begin(), mesh.s.end());
        const std::set<double> rows(mesh.t.begin(), mesh.t.end());
        EXPECT_EQ(columns.size(), 9u);
        EXPECT_EQ(mesh.cells.size(), 8 * (rows.size() - 1));
        const QuadComplex whole = built(c).mesh;
        if (kind == SurfaceKind::Time) {
            EXPECT_EQ(mesh.cells.size(), whole.cells.size());
        } else {
            EXPECT_LT(mesh.cells.size(), whole.cells.size());
        }
    }
}

} // namespace wakesurf::core::fixed_grid_test
