#include "core/surface/keyed_mesh.hpp"
#include "tests/support/flat_patch.hpp"
#include "tests/support/mesh_delta.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

namespace wakesurf::core::mesh_delta_test {

using namespace tests;

namespace {

void expect_same(const KeyedMesh& a, const KeyedMesh& b) {
    EXPECT_EQ(hash(a), hash(b));
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.vertex_id, b.vertex_id);
    EXPECT_EQ(a.cell_id, b.cell_id);
    EXPECT_EQ(a.mesh.position, b.mesh.position);
    EXPECT_EQ(a.mesh.s, b.mesh.s);
    EXPECT_EQ(a.mesh.t, b.mesh.t);
    EXPECT_EQ(a.mesh.velocity, b.mesh.velocity);
    EXPECT_EQ(a.mesh.deformation, b.mesh.deformation);
    EXPECT_EQ(a.mesh.component, b.mesh.component);
    EXPECT_EQ(a.mesh.approximated, b.mesh.approximated);
    EXPECT_EQ(a.mesh.cells, b.mesh.cells);
}

/// A mesh that is cut, joined, torn and moved at random; deterministic.
class Edited {
  public:
    explicit Edited(unsigned seed) : random_(seed) {}

    void edit() {
        MaterialTriangles& triangles = mesh_.triangles;
        for (int i = 0; i < 6; ++i) {
            const auto t = static_cast<TriangleId>(random_() % triangles.slots().size());
            const auto k = static_cast<unsigned>(random_() % 3);
            if (!triangles[t].live)
                continue;
            if (random_() % 8 == 0) {
                triangles.tear(t);
            } else if (random_() % 2 == 0) {
                triangles.split(t, k, insert_middle(mesh_, t, k));
            } else {
                const VertexId gone = triangles[t].begin(k), kept = triangles[t].end(k);
                std::vector<TriangleId> ring;
                if (triangles.collapsible(gone, kept, ring))
                    triangles.collapse(gone, kept, ring);
            }
        }
        pair_and_clean(mesh_);
        MaterialVertices& v = mesh_.vertices;
        for (int i = 0; i < 5; ++i)
            v.position[random_() % v.slots()].z += 0.125;
        v.velocity[random_() % v.slots()] += Vec3f(1.0f, 2.0f, 3.0f);
        v.approximated[random_() % v.slots()] ^= 1;
        mesh_.time += 0.5;
    }

    KeyedMesh now() const { return snapshot(mesh_, {.deformation = true}); }

    std::size_t live() const { return mesh_.triangles.live(); }

  private:
    MovingMesh mesh_ = flat_patch(6, 5);
    std::mt19937 random_;
};

/// Before and after one round of edits that brings every kind of change.
struct Pair {
    KeyedMesh before, after;
    MeshDelta delta;
};

Pair pair() {
    Edited edited(1);
    for (int i = 0; i < 100; ++i) {
        Pair p{edited.now(), {}, {}};
        edited.edit();
        p.after = edited.now();
        p.delta = difference(p.before, p.after);
        if (!p.delta.vertices_removed.empty() && !p.delta.vertices_added.empty() &&
            !p.delta.vertices_moved.empty() && !p.delta.cells_removed.empty() &&
            !p.delta.cells_added.empty() && !p.delta.cells_changed.empty())
            return p;
    }
    throw std::runtime_error("the edits are too tame");
}

} // namespace

TEST(MeshDelta, FoldingADifferenceGivesTheMeshAfter) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Edited edited(seed);
        KeyedMesh followed = edited.now();
        for (int round = 0; round < 25 && edited.live() > 4; ++round) {
            const KeyedMesh before = edited.now();
            edited.edit();
            const KeyedMesh after = edited.now();
            const MeshDelta delta = difference(before, after);
            EXPECT_EQ(delta.hash, hash(after));
            expect_same(fold(before, delta), after);
            followed = fold(followed, delta);
            ASSERT_FALSE(HasFailure()) << "seed " << seed << ", round " << round;
        }
        expect_same(followed, edited.now());
    }
}

TEST(MeshDelta, ADifferenceFromNothingIsAKeyframe) {
    const KeyedMesh mesh = pair().after;
    const MeshDelta keyframe = difference({}, mesh);
    EXPECT_EQ(keyframe.vertices_added.size(), mesh.vertex_id.size());
    EXPECT_EQ(keyframe.cells_added.size(), mesh.cell_id.size());
    EXPECT_TRUE(keyframe.vertices_moved.empty() && keyframe.vertices_removed.empty() &&
                keyframe.cells_changed.empty() && keyframe.cells_removed.empty());
    expect_same(fold({}, keyframe), mesh);
}

TEST(MeshDelta, NothingDiffersFromItself) {
    const KeyedMesh mesh = pair().after;
    const MeshDelta delta = difference(mesh, mesh);
    EXPECT_TRUE(delta.vertices_added.empty() && delta.vertices_moved.empty() &&
                delta.vertices_removed.empty() && delta.cells_added.empty() &&
                delta.cells_changed.empty() && delta.cells_removed.empty());
    expect_same(fold(mesh, delta), mesh);
}

TEST(MeshDelta, ADifferenceBackwardsUndoesIt) {
    const Pair p = pair();
    expect_same(fold(p.after, difference(p.after, p.before)), p.before);
}

TEST(MeshDelta, OnlyWhatChangedIsInADifference) {
    const KeyedMesh before = pair().after;
    KeyedMesh after = before;
    after.mesh.velocity[7].x += 1.0f;
    const MeshDelta delta = difference(before, after);
    ASSERT_EQ(delta.vertices_moved.size(), 1u);
    EXPECT_EQ(delta.vertices_moved[0].id, before.vertex_id[7]);
    EXPECT_TRUE(delta.cells_changed.empty());
}

TEST(MeshDelta, ADeltaThatDoesNotFitThrows) {
    const Pair p = pair();
    EXPECT_THROW(fold({}, p.delta), std::logic_error);
    EXPECT_THROW(fold(p.after, p.delta), std::logic_error); // what it removes has gone
    MeshDelta delta = p.delta;
    delta.vertices_moved.push_back(delta.vertices_moved.back());
    delta.vertices_moved.back().id = 1u << 30;
    EXPECT_THROW(fold(p.before, delta), std::logic_error);
    delta = p.delta;
    delta.cells_added.back().cell.corner[0] = 1u << 30;
    EXPECT_THROW(fold(p.before, delta), std::logic_error);
}

TEST(MeshDelta, AnythingAddedTwiceThrows) {
    const Pair p = pair();
    MeshDelta delta = difference(p.before, p.before);
    delta.vertices_added = {difference({}, p.before).vertices_added.front()};
    EXPECT_THROW(fold(p.before, delta), std::logic_error);
    delta = difference(p.before, p.before);
    delta.cells_added = {difference({}, p.before).cells_added.front()};
    EXPECT_THROW(fold(p.before, delta), std::logic_error);
}

TEST(MeshDelta, TheHashSeesEveryBitOfShapeAndNoAttributes) {
    const KeyedMesh mesh = pair().after;
    const std::uint64_t whole = hash(mesh);
    std::set<std::uint64_t> seen{whole};
    const auto changed = [&](auto change) {
        KeyedMesh other = mesh;
        change(other);
        return hash(other);
    };
    const auto fresh = [&](auto change) { return seen.insert(changed(change)).second; };
    EXPECT_TRUE(fresh(
        [](KeyedMesh& m) { m.mesh.position[3].z = std::nextafter(m.mesh.position[3].z, 9.0); }));
    EXPECT_TRUE(fresh([](KeyedMesh& m) { m.mesh.s[3] += 1e-9; }));
    EXPECT_TRUE(fresh([](KeyedMesh& m) { m.mesh.t[3] += 1e-9; }));
    EXPECT_TRUE(fresh([](KeyedMesh& m) { ++m.vertex_id.back(); }));
    EXPECT_TRUE(fresh([](KeyedMesh& m) { ++m.cell_id.back(); }));
    EXPECT_TRUE(fresh([](KeyedMesh& m) { std::swap(m.mesh.cells[0], m.mesh.cells[1]); }));
    EXPECT_TRUE(fresh([](KeyedMesh& m) { m.mesh.cells.pop_back(), m.cell_id.pop_back(); }));
    EXPECT_EQ(changed([](KeyedMesh& m) { m.mesh.velocity[3].x += 1.0f; }), whole);
}

} // namespace wakesurf::core::mesh_delta_test
