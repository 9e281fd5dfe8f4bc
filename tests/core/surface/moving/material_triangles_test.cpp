#include "core/surface/moving/material_triangles.hpp"
#include "core/surface/moving/release.hpp"
#include "tests/support/flat_patch.hpp"
#include "tests/support/mesh_hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace wakesurf::core::material_triangles_test {

using namespace tests;

namespace {

/// The two vertices of every edge, by id, whatever the slots are.
std::multiset<std::pair<VertexId, VertexId>> edges(const MovingMesh& mesh) {
    std::multiset<std::pair<VertexId, VertexId>> all;
    for (const Triangle& t : mesh.triangles.slots())
        if (t.live)
            for (unsigned k = 0; k < 3; ++k)
                all.insert({mesh.vertices.id[t.begin(k)], mesh.vertices.id[t.end(k)]});
    return all;
}

double material(const MovingMesh& mesh, TriangleId t) {
    if (t == no_triangle)
        return 1.0;
    const auto& [a, b, c] = mesh.triangles[t].vertex;
    return material_area(mesh, a, b, c);
}

bool can_flip(const MovingMesh& mesh, TriangleId t, unsigned k) {
    const Triangle& here = mesh.triangles[t];
    const TriangleId u = here.across[k];
    if (u == no_triangle)
        return false;
    const VertexId c = here.opposite(k);
    const VertexId d = mesh.triangles[u].opposite(mesh.triangles.facing(t, k));
    return material_area(mesh, here.begin(k), d, c) > 1e-3 &&
           material_area(mesh, d, here.end(k), c) > 1e-3 &&
           mesh.triangles.find(c, d).triangle == no_triangle &&
           mesh.triangles.find(d, c).triangle == no_triangle;
}

/// Taking `gone` into `kept` turns nothing over.
bool keeps_faces(const MovingMesh& mesh,
                 VertexId gone,
                 VertexId kept,
                 std::span<const TriangleId> ring) {
    return std::all_of(ring.begin(), ring.end(), [&](TriangleId t) {
        auto v = mesh.triangles[t].vertex;
        if (std::find(v.begin(), v.end(), kept) != v.end())
            return true;
        std::replace(v.begin(), v.end(), gone, kept);
        for (std::size_t k = 0; k < 3; ++k)
            if (std::abs(mesh.parameter_step(v[k], v[(k + 1) % 3]).s) > 0.3)
                return false; // on a tube the short way round would not be the surface's
        return material_area(mesh, v[0], v[1], v[2]) > 1e-3;
    });
}

} // namespace

TEST(MaterialTriangles, AppendedQuadsArePairsThatKnowThoseBeside) {
    const MovingMesh mesh = flat_patch(3, 2);
    EXPECT_EQ(mesh.triangles.live(), 12u);
    EXPECT_EQ(mesh.triangles.quads(), 6u);
    EXPECT_EQ(violation(mesh), "");
    const KeyedMesh out = snapshot(mesh, {});
    ASSERT_EQ(out.mesh.cells.size(), 6u);
    // As they were released: the first two corners are the row that left the rake last.
    EXPECT_EQ(out.mesh.cells[0].corner, (std::array<VertexId, 4>{0, 1, 5, 4}));
    EXPECT_EQ(out.mesh.cells[5].corner, (std::array<VertexId, 4>{6, 7, 11, 10}));
}

TEST(MaterialTriangles, WhatWouldTouchAtAVertexOnlyIsLeftOut) {
    // Two quads that share vertex 2, and no edge.
    MaterialTriangles triangles;
    const std::array touching{std::array<VertexId, 4>{0, 1, 2, 3},
                              std::array<VertexId, 4>{2, 4, 5, 6}};
    triangles.append(touching);
    EXPECT_EQ(triangles.live(), 2u);
    EXPECT_EQ(triangles.violation(), "");
    MaterialTriangles fixed;
    fixed.allow_contacts();
    fixed.append(touching);
    EXPECT_EQ(fixed.live(), 4u);
}

TEST(MaterialTriangles, AFlipOfAFlipIsWhatWasThereBefore) {
    MovingMesh mesh = flat_patch(3, 3);
    const auto before = edges(mesh);
    const std::uint64_t handed_out = hash(snapshot(mesh, {}));
    const unsigned diagonal = mesh.triangles[8].mate;
    mesh.triangles.flip(8, diagonal);
    EXPECT_NE(edges(mesh), before);
    EXPECT_EQ(hash(snapshot(mesh, {})), handed_out) << "the quad is the same";
    EXPECT_EQ(violation(mesh), "");
    mesh.triangles.flip(8, mesh.triangles[8].mate);
    EXPECT_EQ(edges(mesh), before);
}

TEST(MaterialTriangles, ACollapseIsTheInverseOfASplit) {
    for (const TriangleId t : {0u, 8u, 9u})
        for (unsigned k = 0; k < 3; ++k) {
            MovingMesh mesh = flat_patch(3, 3);
            const auto before = edges(mesh);
            const VertexId kept = mesh.triangles[t].begin(k);
            const VertexId made = insert_middle(mesh, t, k);
            mesh.triangles.split(t, k, made);
            EXPECT_EQ(mesh.triangles.violation(), "");
            EXPECT_NE(edges(mesh), before);
            std::vector<TriangleId> ring;
            ASSERT_TRUE(mesh.triangles.collapsible(made, kept, ring));
            mesh.triangles.collapse(made, kept, ring);
            EXPECT_EQ(mesh.triangles.violation(), "");
            EXPECT_EQ(edges(mesh), before);
        }
}

TEST(MaterialTriangles, PairsOfWhichBothHalvesSurviveAJoinKeepTheirQuad) {
    MovingMesh mesh = flat_patch(4, 4);
    MaterialTriangles& triangles = mesh.triangles;
    const auto quads = [&] {
        std::multiset<std::uint32_t> all;
        for (const Triangle& t : triangles.slots())
            if (t.live && t.paired())
                all.insert(t.quad);
        return all;
    };
    const auto before = quads();
    std::vector<TriangleId> ring;
    ASSERT_TRUE(triangles.collapsible(12, 13, ring));
    triangles.collapse(12, 13, ring);
    EXPECT_EQ(triangles.violation(), "");
    const auto after = quads();
    EXPECT_EQ(after.size() + 4, before.size()) << "two quads have lost a half each";
    EXPECT_TRUE(std::includes(before.begin(), before.end(), after.begin(), after.end()));
}

TEST(MaterialTriangles, AnOddTriangleLooksForAnotherHalfAfterAJoin) {
    MovingMesh mesh = flat_patch(4, 4);
    MaterialTriangles& triangles = mesh.triangles;
    const auto [t, k] = triangles.find(11, 12);
    const VertexId middle = insert_middle(mesh, t, k);
    triangles.part(t);
    triangles.leave_odd(std::array{MaterialTriangles::Odd{t, k, middle}});
    std::vector<TriangleId> ring;
    ASSERT_TRUE(triangles.collapsible(12, 13, ring));
    triangles.collapse(12, 13, ring);
    ASSERT_TRUE(triangles[t].live);
    EXPECT_FALSE(triangles[t].odd()) << "its hanging vertex is no longer on its edge";
    EXPECT_GT(std::count(triangles.loose().begin(), triangles.loose().end(), t), 0);
}

TEST(MaterialTriangles, NoJoinTakesAWholePartAwayOrJoinsTwoBoundaries) {
    std::vector<TriangleId> ring;
    const MovingMesh one = flat_patch(1, 1);
    EXPECT_FALSE(one.triangles.collapsible(1, 0, ring)); // its only triangle would go
    const MovingMesh strip = flat_patch(3, 1);
    EXPECT_FALSE(
        strip.triangles.collapsible(1, 5, ring)); // from one side of the strip to the other
    EXPECT_TRUE(strip.triangles.collapsible(1, 2, ring));
    const MovingMesh tube = flat_patch(3, 3, true);
    EXPECT_FALSE(tube.triangles.collapsible(4, 3, ring))
        << "three columns are as few as a tube can have";
}

TEST(MaterialTriangles, AHoleOfThreeEdgesClosesWhenOneOfThemShrinks) {
    MovingMesh mesh = flat_patch(4, 4);
    mesh.triangles.tear(mesh.triangles.find(6, 7).triangle);
    const auto open = [&] {
        std::size_t count = 0;
        for (const Triangle& t : mesh.triangles.slots())
            count += t.live ? static_cast<std::size_t>(
                                  std::count(t.across.begin(), t.across.end(), no_triangle))
                            : 0;
        return count;
    };
    EXPECT_EQ(open(), 16u + 3u);
    std::vector<TriangleId> ring;
    ASSERT_TRUE(mesh.triangles.collapsible(7, 6, ring));
    mesh.triangles.collapse(7, 6, ring);
    EXPECT_EQ(mesh.triangles.violation(), "");
    EXPECT_EQ(open(), 16u);
}

TEST(MaterialTriangles, ATearLeavesNoTwoPartsThatHangTogetherAtAVertex) {
    MovingMesh mesh = flat_patch(4, 4);
    mesh.triangles.tear(mesh.triangles.find(6, 7).triangle);
    EXPECT_EQ(mesh.triangles.violation(), "");
    mesh.triangles.tear(mesh.triangles.find(12, 13).triangle);
    EXPECT_EQ(mesh.triangles.violation(), "");
    pair_and_clean(mesh);
    EXPECT_EQ(violation(mesh), "");
}

TEST(MaterialTriangles, StaySoundWhateverIsDoneToThem) {
    std::size_t splits = 0, flips = 0, collapses = 0, tears = 0, odd = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        const bool closed = seed % 3 == 2;
        MovingMesh mesh = flat_patch(6, 5, closed);
        std::mt19937 random(seed);
        std::vector<TriangleId> ring;
        double whole = area(mesh);
        for (int i = 0; i < 400 && mesh.triangles.live() > 20; ++i) {
            MaterialTriangles& triangles = mesh.triangles;
            const auto t = static_cast<TriangleId>(random() % triangles.slots().size());
            const auto k = static_cast<unsigned>(random() % 3);
            if (!triangles[t].live)
                continue;
            const VertexId gone = triangles[t].begin(k), kept = triangles[t].end(k);
            const auto choice = random() % 100;
            bool boundary_moved = false;
            if (choice < 2) {
                triangles.tear(t);
                ++tears;
                boundary_moved = true;
            } else if (choice < 35) {
                // Halved again and again there is none left.
                if (material(mesh, t) < 1e-3 || material(mesh, triangles[t].across[k]) < 1e-3)
                    continue;
                triangles.split(t, k, insert_middle(mesh, t, k));
                ++splits;
            } else if (choice < 65) {
                if (can_flip(mesh, t, k)) {
                    triangles.flip(t, k);
                    ++flips;
                }
            } else if (triangles.collapsible(gone, kept, ring) &&
                       keeps_faces(mesh, gone, kept, ring)) {
                std::vector<TriangleId> round;
                boundary_moved = triangles.fan(gone, round);
                triangles.collapse(gone, kept, ring);
                ++collapses;
            }
            ASSERT_EQ(triangles.violation(), "") << "seed " << seed << ", " << i;
            if (boundary_moved)
                whole = area(mesh);
            if (!closed) {
                ASSERT_NEAR(area(mesh), whole, 1e-9) << "seed " << seed << ", " << i;
            }
            if (i % 7 == 0) {
                pair_and_clean(mesh);
                ASSERT_EQ(violation(mesh), "") << "seed " << seed << ", " << i;
                ASSERT_EQ(mesh.vertices.used(), snapshot(mesh, {}).vertex_id.size())
                    << "those that nothing has any more are removed, and no others";
                odd += 2 * triangles.quads() - triangles.live();
            }
        }
    }
    EXPECT_GT(splits, 500u);
    EXPECT_GT(flips, 200u);
    EXPECT_GT(collapses, 200u);
    EXPECT_GT(tears, 20u);
    EXPECT_GT(odd, 0u);
}

TEST(MaterialTriangles, RenumberingIsInvisibleInTheSnapshot) {
    MovingMesh mesh = flat_patch(6, 5);
    mesh.triangles.tear(26);
    mesh.triangles.split(8, 0, insert_middle(mesh, 8, 0));
    pair_and_clean(mesh);
    const std::uint64_t before = hash(snapshot(mesh, {}));
    std::vector<TriangleId> triangles;
    for (TriangleId t = 0; t < mesh.triangles.slots().size(); ++t)
        if (mesh.triangles[t].live)
            triangles.push_back(t);
    std::vector<VertexId> vertices;
    for (VertexId v = 0; v < mesh.vertices.slots(); ++v)
        if (mesh.vertices.role[v] != VertexRole::Unused)
            vertices.push_back(v);
    std::mt19937 random(3);
    std::shuffle(triangles.begin(), triangles.end(), random);
    std::shuffle(vertices.begin(), vertices.end(), random);
    std::vector<VertexId> slot(mesh.vertices.slots(), no_vertex);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        slot[vertices[i]] = static_cast<VertexId>(i);
    mesh.triangles.renumber(triangles, slot);
    mesh.vertices.renumber(vertices);
    EXPECT_EQ(hash(snapshot(mesh, {})), before);
    EXPECT_EQ(violation(mesh), "");
}

TEST(MaterialTriangles, KeepAllVerticesWhenMemoryIsSortedThatHangingOnesAreIn) {
    MovingMesh mesh = flat_patch(2, 2);
    mesh.triangles.part(0);
    mesh.triangles.leave_odd(std::array{MaterialTriangles::Odd{0, 2, insert_middle(mesh, 0, 2)}});
    const std::size_t used = mesh.vertices.used();
    sort_memory(mesh, 0.0);
    EXPECT_EQ(mesh.triangles.violation(), "");
    EXPECT_FALSE(mesh.triangles.unused(static_cast<VertexId>(used - 1)))
        << "the last of the patch, which the hanging vertex has moved on";
}

} // namespace wakesurf::core::material_triangles_test
