#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/growing_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::core::growing_mesh_test {

namespace {

QuadComplex path_surface() {
    const auto flow = *make_analytic_flow("abc");
    SurfaceParameters p{.kind = SurfaceKind::Path, .to = 3.0, .separation = 0.3};
    const Rake rake{Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    return build_surface(*flow, rake, p)->mesh;
}

double oldest(const QuadComplex& mesh, const Cell& cell) {
    double age = 0.0;
    for (const auto* ids : {&cell.corner, &cell.mid})
        for (const VertexId v : *ids)
            if (v != no_vertex)
                age = std::max(age, std::abs(mesh.t[v]));
    return age;
}

} // namespace

TEST(GrowingMesh, ShowsTheCellsSweptSoFarAndNoOthers) {
    const QuadComplex whole = path_surface();
    const GrowingMesh growing(whole, 3.0);
    for (const double age : {0.0, 0.4, 1.5, 2.9, 3.0}) {
        const KeyedMesh shown = growing.at(age);
        const auto due = [&](double until) {
            return static_cast<std::size_t>(
                std::count_if(whole.cells.begin(), whole.cells.end(),
                              [&](const Cell& cell) { return oldest(whole, cell) <= until; }));
        };
        EXPECT_LE(shown.mesh.cells.size(), due(age + 1e-9));
        EXPECT_GE(shown.mesh.cells.size(), due(age - 3.0 / 512));
        for (const Cell& cell : shown.mesh.cells)
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
    KeyedMesh before = growing.at(0.0);
    for (int i = 1; i <= 40; ++i) {
        const KeyedMesh after = growing.at(3.0 * i / 40);
        ASSERT_GE(after.mesh.cells.size(), before.mesh.cells.size());
        EXPECT_TRUE(std::equal(before.mesh.cells.begin(), before.mesh.cells.end(),
                               after.mesh.cells.begin()));
        EXPECT_TRUE(std::equal(before.mesh.position.begin(), before.mesh.position.end(),
                               after.mesh.position.begin()));
        before = after;
    }
}

} // namespace wakesurf::core::growing_mesh_test
