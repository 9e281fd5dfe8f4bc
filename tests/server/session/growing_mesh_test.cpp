#include "core/field/analytic_flow.hpp"
#include "core/surface/surface_builder.hpp"
#include "server/session/growing_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

namespace {

core::QuadComplex path_surface() {
    const auto flow = *core::make_analytic_flow("abc");
    core::SurfaceParameters p;
    p.kind = core::SurfaceKind::Path;
    p.to = 3.0;
    p.separation = 0.3;
    const core::Rake rake{core::Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    return core::build_surface(*flow, rake, p)->mesh;
}

double oldest(const core::QuadComplex& mesh, const core::Cell& cell) {
    double age = 0.0;
    for (const auto* ids : {&cell.corner, &cell.mid})
        for (const core::VertexId v : *ids)
            if (v != core::no_vertex)
                age = std::max(age, std::abs(mesh.t[v]));
    return age;
}

} // namespace

TEST(GrowingMesh, ShowsTheCellsSweptSoFarAndNoOthers) {
    const core::QuadComplex whole = path_surface();
    const GrowingMesh growing(whole, 3.0);
    for (const double age : {0.0, 0.4, 1.5, 2.9, 3.0}) {
        const core::KeyedMesh shown = growing.at(age);
        const auto due = [&](double until) {
            return static_cast<std::size_t>(
                std::count_if(whole.cells.begin(), whole.cells.end(), [&](const core::Cell& cell) {
                    return oldest(whole, cell) <= until;
                }));
        };
        EXPECT_LE(shown.mesh.cells.size(), due(age + 1e-9));
        EXPECT_GE(shown.mesh.cells.size(), due(age - 3.0 / 512));
        for (const core::Cell& cell : shown.mesh.cells)
            EXPECT_LE(oldest(shown.mesh, cell), age + 1e-9);
        EXPECT_EQ(shown.mesh.validate(), "") << age;
        EXPECT_EQ(shown.vertex_id.size(), shown.mesh.vertices());
    }
    EXPECT_EQ(growing.at(3.0).mesh.cells.size(), whole.cells.size());
    EXPECT_EQ(growing.at(3.0).mesh.vertices(), whole.vertices());
    EXPECT_TRUE(growing.at(0.0).mesh.cells.empty());
}

TEST(GrowingMesh, OnlyAppendsAsItGrows) {
    const GrowingMesh growing(path_surface(), 3.0);
    core::KeyedMesh before = growing.at(0.0);
    for (int i = 1; i <= 40; ++i) {
        const core::KeyedMesh after = growing.at(3.0 * i / 40);
        ASSERT_GE(after.mesh.cells.size(), before.mesh.cells.size());
        EXPECT_TRUE(std::equal(before.mesh.cells.begin(), before.mesh.cells.end(),
                               after.mesh.cells.begin()));
        EXPECT_TRUE(std::equal(before.mesh.position.begin(), before.mesh.position.end(),
                               after.mesh.position.begin()));
        before = after;
    }
}

} // namespace wakesurf::server
