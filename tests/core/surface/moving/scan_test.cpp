// One look in single precision at all triangles finds what the exact rules would, asked of each.
#include "core/field/analytic_flow.hpp"
#include "core/surface/moving/edge_changes.hpp"
#include "core/surface/moving/joins.hpp"
#include "core/surface/moving/pairing.hpp"
#include "core/surface/moving/scan.hpp"
#include "core/surface/moving/triangle_shape.hpp"
#include "tests/support/moving_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace wakesurf::core::scan_test {

namespace {

using namespace tests;

struct Moved {
    MovingRun run;
    MovingMesh mesh;
    RefinementRules rules;

    RefinementContext context() { return {mesh, *run.flow, rules}; }
};

/// A surface some steps on, then bent and stretched as by one long step, so that much of it needs something.
Moved moved(const char* flow, SurfaceKind kind, const Rake& rake, double to) {
    SurfaceParameters p{.kind = kind, .to = to, .separation = 0.05};
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(0.1, 0.5, 0.0);
    Moved made{{*make_analytic_flow(flow), rake, p, flow}, {}, {}};
    follow(made.run, 0, [&](const MovingSurface& surface, const KeyedMesh&) {
        made.mesh = surface.state().mesh;
        made.rules = surface.state().plan->rules;
        made.rules.separation = surface.state().separation;
    });
    for (VertexId v = 0; v < made.mesh.vertices.slots(); ++v) {
        Vec3& x = made.mesh.vertices.position[v];
        x += 0.02 * Vec3(std::sin(40.0 * x.y), 0.5 * std::sin(60.0 * x.x), std::cos(30.0 * x.x));
        made.mesh.vertices.along_s[v] *= 1.0 + 0.3 * std::sin(50.0 * x.x);
        if (v % 97 == 0 && made.mesh.vertices.role[v] == VertexRole::Free)
            made.mesh.vertices.end[v] = CurveEnd::Domain;
    }
    return made;
}

Moved of_double_gyre() {
    return moved("double-gyre", SurfaceKind::Time,
                 {Rake::Kind::Line, {{0.3, 0.2, 0.1}, {1.7, 0.2, 0.1}}, 16}, 3.0);
}

template <class Asks>
std::set<TriangleId> all_that(const MovingMesh& mesh, const Asks& asks) {
    std::set<TriangleId> found;
    for (TriangleId t = 0; t < mesh.triangles.slots().size(); ++t)
        if (mesh.triangles[t].live && asks(t))
            found.insert(t);
    return found;
}

/// What is found in so many steps, one after another.
struct Found {
    std::set<TriangleId> flipping, cutting, joining, pairing;
};

Found found_in(const RefinementContext& context, std::uint64_t steps) {
    Found all;
    ScanMemory memory;
    for (std::uint64_t turn = 0; turn < steps; ++turn) {
        const Needs needs = scan(context, turn, memory);
        all.flipping.insert(needs.flipping.begin(), needs.flipping.end());
        all.cutting.insert(needs.cutting.begin(), needs.cutting.end());
        all.joining.insert(needs.joining.begin(), needs.joining.end());
        all.pairing.insert(needs.pairing.begin(), needs.pairing.end());
    }
    return all;
}

/// @param least  of triangles that need each, or the test says nothing
void expect_all_found(Moved made, std::size_t least) {
    SCOPED_TRACE(made.run.name);
    const RefinementContext context = made.context();
    const MovingMesh& mesh = made.mesh;
    const auto alive = [&](TriangleId t) { return !has_dead_vertex(mesh, t); };
    const auto flips = all_that(mesh, [&](TriangleId t) {
        for (unsigned k = 0; k < 3;
             ++k) // of an inner edge the triangle with the smaller number tells
            if (mesh.triangles[t].across[k] > t && should_flip(context, t, k))
                return alive(t);
        return false;
    });
    const auto cuts =
        all_that(mesh, [&](TriangleId t) { return !alive(t) || needs_cut(context, t); });
    const auto joins =
        all_that(mesh, [&](TriangleId t) { return alive(t) && may_join(context, t); });
    // A quad half of which is dead is clipped, and looks for another half then.
    const auto pairs = all_that(mesh, [&](TriangleId t) {
        const Triangle& here = mesh.triangles[t];
        return alive(t) && (here.odd() || alive(here.across[here.mate])) &&
               is_poor_pair(context, t);
    });
    const Found found = found_in(context, 12);
    EXPECT_EQ(found.flipping, flips);
    EXPECT_EQ(found.cutting, cuts);
    EXPECT_EQ(found.joining, joins);
    // Of a quad one half is enough.
    for (const TriangleId t : pairs)
        EXPECT_TRUE(found.pairing.contains(t) ||
                    found.pairing.contains(mesh.triangles[t].across[mesh.triangles[t].mate]))
            << t;
    for (const auto& [what, count] : {std::pair{"flips", flips.size()},
                                      {"cuts", cuts.size()},
                                      {"joins", joins.size()},
                                      {"pairs", pairs.size()}})
        EXPECT_GT(count, least) << what;
}

} // namespace

TEST(Scan, FindsWhatTheExactRulesFind) {
    expect_all_found(of_double_gyre(), 20);
    expect_all_found(moved("abc", SurfaceKind::Streak,
                           {Rake::Kind::Line, {{1.0, 1.0, 1.0}, {2.0, 1.0, 1.5}}, 12}, 3.0),
                     20);
    expect_all_found(moved("cylinder", SurfaceKind::Streak,
                           {Rake::Kind::Line, {{-2.0, -0.6, -0.5}, {-2.0, 0.6, 0.5}}, 12}, 4.0),
                     20);
}

TEST(Scan, FindsTheSameHoweverLargeTheSurfaceIs) {
    Moved made = of_double_gyre();
    const Needs needs = [&] {
        ScanMemory memory;
        return scan(made.context(), 0, memory);
    }();
    for (const double scale : {1e-9, 1e9}) {
        SCOPED_TRACE(scale);
        Moved other{made.run, made.mesh, made.rules};
        other.rules.separation *= scale;
        MaterialVertices& v = other.mesh.vertices;
        for (auto* vectors : {&v.position, &v.along_s, &v.along_t})
            for (Vec3& each : *vectors)
                each *= scale;
        ScanMemory memory;
        const Needs found = scan(other.context(), 0, memory);
        EXPECT_EQ(found.cutting, needs.cutting);
        EXPECT_EQ(found.joining, needs.joining);
        EXPECT_EQ(found.pairing, needs.pairing);
    }
}

} // namespace wakesurf::core::scan_test
