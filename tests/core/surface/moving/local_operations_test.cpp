#include "core/surface/moving/local_operations.hpp"
#include "core/surface/moving/refinement.hpp"
#include "tests/support/flat_patch.hpp"
#include "tests/support/mesh_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

namespace wakesurf::core::local_operations_test {

using namespace tests;

namespace {

constexpr std::array every_way{Reconnection::LeftYoung, Reconnection::RightYoung,
                               Reconnection::LeftOld,   Reconnection::RightOld,
                               Reconnection::PairRight, Reconnection::PairLeft};

LocalOperations operations_on(MovingMesh& mesh) {
    return {mesh, [&](CellIndex index, std::size_t side) {
                const Cell& cell = mesh.quads[index].cell;
                return insert_middle(mesh, cell.corner[side], cell.corner[(side + 1) % 4]);
            }};
}

bool always(VertexId, VertexId, VertexId) {
    return true;
}

bool never(VertexId, VertexId, VertexId) {
    return false;
}

/// As the engine drops mid nodes: only on the border of the parameter rectangle, never along a tear.
auto on_border(const MovingMesh& mesh) {
    return [&mesh](VertexId a, VertexId b, VertexId c) {
        const auto& place = mesh.vertices.place;
        const RakeLattice& lattice = mesh.lattice;
        const auto all = [&](auto holds) {
            return holds(place[a]) && holds(place[b]) && holds(place[c]);
        };
        return all([](LatticePlace p) { return p.row == 0.0; }) ||
               all([&](LatticePlace p) { return p.row == lattice.last_row; }) ||
               (!lattice.closed &&
                (all([](LatticePlace p) { return p.column == 0.0; }) ||
                 all([&](LatticePlace p) { return p.column == lattice.columns; })));
    };
}

/// Ids of what there is now; says so when one that was gone has come back.
class Ids {
  public:
    bool fresh(const std::vector<std::uint32_t>& now) {
        const std::set<std::uint32_t> here(now.begin(), now.end());
        bool sound = here.size() == now.size();
        for (const std::uint32_t id : here)
            sound = sound && gone_.count(id) == 0;
        for (const std::uint32_t id : before_)
            if (here.count(id) == 0)
                gone_.insert(id);
        before_ = here;
        return sound;
    }

  private:
    std::set<std::uint32_t> before_, gone_;
};

/// Cells and their edges by (column, row), which no renumbering of slots or ids changes.
std::multiset<std::vector<double>> shapes(const MovingMesh& mesh) {
    std::multiset<std::vector<double>> all;
    for (const LinkedCell& slot : mesh.quads.slots()) {
        if (!slot.live)
            continue;
        std::vector<double> one;
        for (const auto* ids : {&slot.cell.corner, &slot.cell.mid})
            for (const VertexId v : *ids) {
                one.push_back(v == no_vertex ? -1.0 : mesh.vertices.place[v].column);
                one.push_back(v == no_vertex ? -1.0 : mesh.vertices.place[v].row);
            }
        all.insert(one);
    }
    return all;
}

/// The engine joins cells of one width, so that columns stay straight and every place a dyadic fraction; tiny ones anyhow.
enum class Joined { AlikeOnly, All };

bool alike(const MovingMesh& mesh, CellIndex cell, CellIndex partner) {
    const auto width = [&](const Cell& c) {
        const auto& place = mesh.vertices.place;
        return mesh.lattice.columns_between(place[c.corner[0]].column, place[c.corner[1]].column);
    };
    return width(mesh.quads[cell].cell) == width(mesh.quads[partner].cell);
}

enum class Done { Nothing, Split, Merged, Reconnected, Torn };

/// One random operation.
class Play {
  public:
    Play(MovingMesh& mesh, unsigned seed, Joined joined)
        : mesh_(mesh), operations_(operations_on(mesh)), random_(seed), joined_(joined) {}

    Done once(double tearing) {
        std::vector<CellIndex> live;
        for (CellIndex i = 0; i < mesh_.quads.slots().size(); ++i)
            if (mesh_.quads[i].live)
                live.push_back(i);
        const CellIndex cell = live[random_() % live.size()];
        const double choice = unit_(random_);
        if (choice < tearing) {
            operations_.tear(cell);
            return Done::Torn;
        }
        const Axis axis = random_() % 2 == 0 ? Axis::S : Axis::T;
        // Cutting and joining hold each other's balance at some 100 cells.
        if (unit_(random_) < 0.35)
            return unit_(random_) * double(live.size()) < 60.0 && operations_.split(cell, axis)
                       ? Done::Split
                       : Done::Nothing;
        if (unit_(random_) < 0.5) {
            const CellIndex partner = operations_.partner(cell, axis);
            if (partner == no_cell ||
                (axis == Axis::S && joined_ == Joined::AlikeOnly && !alike(mesh_, cell, partner)))
                return Done::Nothing;
            operations_.merge(cell, axis, on_border(mesh_));
            return Done::Merged;
        }
        const std::size_t first = random_() % every_way.size();
        for (std::size_t k = 0; k < every_way.size(); ++k) {
            const std::size_t way = (first + k) % every_way.size();
            if (operations_.reconnected(cell, every_way[way]).left == no_vertex)
                continue;
            operations_.reconnect(cell, every_way[way]);
            ++ways[way];
            return Done::Reconnected;
        }
        return Done::Nothing;
    }

    std::array<int, 6> ways{};

  private:
    MovingMesh& mesh_;
    LocalOperations operations_;
    std::mt19937 random_;
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
    Joined joined_;
};

std::string turned_over(const MovingMesh& mesh, Joined joined) {
    const auto upright = [&](const Cell& cell) {
        return joined == Joined::AlikeOnly ? least_height(mesh, cell) > 0.0
                                           : mesh.lattice.closed || signed_area(mesh, cell) > 0.0;
    };
    for (CellIndex i = 0; i < mesh.quads.slots().size(); ++i)
        if (mesh.quads[i].live && !upright(mesh.quads[i].cell))
            return "cell slot " + std::to_string(i) + " is turned over";
    return {};
}

/// Plays `count` operations and checks after every one. Returns how often each kind was done.
std::map<Done, int> play(MovingMesh& mesh,
                         unsigned seed,
                         int count,
                         double tearing,
                         int euler,
                         Joined joined = Joined::AlikeOnly) {
    Play random(mesh, seed, joined);
    Ids cell_ids, vertex_ids;
    std::map<Done, int> done;
    bool torn = false;
    const double whole = signed_area(mesh);
    for (int i = 0; i < count; ++i) {
        const Done what = random.once(tearing);
        ++done[what];
        torn = torn || what == Done::Torn;
        if (what == Done::Nothing)
            continue;
        const std::string where = "seed " + std::to_string(seed) + ", operation " +
                                  std::to_string(i) + " of kind " + std::to_string(int(what));
        EXPECT_EQ(violation(mesh), "") << where;
        EXPECT_EQ(slit(mesh), "") << where;
        EXPECT_EQ(turned_over(mesh, joined), "") << where;
        const KeyedMesh now = snapshot(mesh, false);
        EXPECT_TRUE(cell_ids.fresh(now.cell_id)) << where;
        EXPECT_TRUE(vertex_ids.fresh(now.vertex_id)) << where;
        if (!torn) {
            EXPECT_EQ(euler_characteristic(now.mesh), euler) << where;
            if (!mesh.lattice.closed) {
                EXPECT_NEAR(signed_area(mesh), whole, 1e-9) << where;
            }
            // Every vertex in use is in a cell: nothing is left behind.
            EXPECT_EQ(now.vertex_id.size(), mesh.vertices.used()) << where;
        }
        if (torn && i % 50 == 0)
            remove_unused_vertices(mesh);
        if (::testing::Test::HasFailure() || mesh.quads.live() < 3)
            break;
    }
    for (std::size_t k = 0; k < random.ways.size(); ++k)
        done[static_cast<Done>(100 + k)] = random.ways[k];
    return done;
}

} // namespace

TEST(LocalOperations, KeepAFlatPatchWatertightAndOfTheSameArea) {
    std::map<Done, int> done;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        MovingMesh mesh = flat_patch(6, 5);
        for (const auto& [what, count] : play(mesh, seed, 500, 0.0, 1))
            done[what] += count;
    }
    EXPECT_GT(done[Done::Split], 100);
    EXPECT_GT(done[Done::Merged], 100);
    for (int way = 0; way < 6; ++way)
        EXPECT_GT(done[static_cast<Done>(100 + way)], 5) << "reconnection " << way;
}

TEST(LocalOperations, KeepAFlatPatchWatertightWhateverIsJoined) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        MovingMesh mesh = flat_patch(6, 5);
        play(mesh, seed, 400, 0.0, 1, Joined::All);
    }
}

TEST(LocalOperations, KeepATubeWatertight) {
    for (const int columns : {3, 4, 6})
        for (unsigned seed = 1; seed <= 2; ++seed) {
            MovingMesh mesh = flat_patch(columns, 5, true);
            play(mesh, seed, 300, 0.0, 0);
            if (HasFailure())
                FAIL() << columns << " columns";
        }
}

TEST(LocalOperations, LeaveNoSlitsBesideTears) {
    int torn = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        MovingMesh mesh = flat_patch(6, 5);
        torn += play(mesh, seed, 500, 0.03, 1)[Done::Torn];
    }
    EXPECT_GT(torn, 20);
}

TEST(LocalOperations, MergingUndoesASplit) {
    for (const Axis axis : {Axis::S, Axis::T})
        for (const CellIndex cell : {0u, 14u, 29u}) { // two corners of the patch and one inside
            MovingMesh mesh = flat_patch(6, 5);
            const auto before = shapes(mesh);
            LocalOperations operations = operations_on(mesh);
            ASSERT_TRUE(operations.split(cell, axis));
            EXPECT_EQ(mesh.quads.live(), 31u);
            EXPECT_NE(shapes(mesh), before);
            ASSERT_NE(operations.partner(cell, axis), no_cell);
            operations.merge(cell, axis, always);
            EXPECT_EQ(shapes(mesh), before);
            EXPECT_EQ(mesh.vertices.used(), 42u);
        }
}

TEST(LocalOperations, AMidNodeOnTheBorderStaysWhereItMayNotBeDropped) {
    MovingMesh mesh = flat_patch(2, 1);
    LocalOperations operations = operations_on(mesh);
    ASSERT_TRUE(operations.split(0, Axis::S));
    operations.merge(0, Axis::S, never);
    EXPECT_NE(mesh.quads[0].cell.mid[0], no_vertex);
    EXPECT_NE(mesh.quads[0].cell.mid[2], no_vertex);
    EXPECT_EQ(violation(mesh), "");
}

TEST(LocalOperations, ASplitCutsTheLargerNeighbourFirst) {
    MovingMesh mesh = flat_patch(2, 1);
    LocalOperations operations = operations_on(mesh);
    ASSERT_TRUE(operations.split(0, Axis::T)); // its right neighbour has a mid node now
    EXPECT_NE(mesh.quads[1].cell.mid[3], no_vertex);
    ASSERT_TRUE(operations.split(0, Axis::T)); // which would need two
    EXPECT_EQ(mesh.quads.live(), 5u);
    EXPECT_EQ(slit(mesh), "");
    EXPECT_EQ(violation(mesh), "");
}

TEST(LocalOperations, AReconnectionAndItsMirrorGiveBackTheSameEdges) {
    const std::array<std::array<Reconnection, 2>, 2> mirrors{
        {{Reconnection::LeftYoung, Reconnection::LeftOld},
         {Reconnection::RightYoung, Reconnection::RightOld}}};
    for (const auto& [young, old] : mirrors) {
        MovingMesh mesh = flat_patch(3, 2);
        LocalOperations operations = operations_on(mesh);
        // Cells 1 and 4 share a cross edge; a neighbour of cell 1 is cut so that a node hangs on its side.
        ASSERT_TRUE(operations.split(young == Reconnection::LeftYoung ? 0 : 2, Axis::T));
        const auto before = shapes(mesh);
        ASSERT_NE(operations.reconnected(1, young).left, no_vertex);
        operations.reconnect(1, young);
        EXPECT_NE(shapes(mesh), before);
        EXPECT_EQ(violation(mesh), "");
        EXPECT_EQ(operations.reconnected(1, young).left, no_vertex);
        ASSERT_NE(operations.reconnected(1, old).left, no_vertex);
        operations.reconnect(1, old);
        EXPECT_EQ(shapes(mesh), before);
    }
}

TEST(LocalOperations, ReconnectingAPairTakesOneCellAndLeavesTwoHangingNodes) {
    for (const auto how : {Reconnection::PairRight, Reconnection::PairLeft}) {
        MovingMesh mesh = flat_patch(3, 3);
        LocalOperations operations = operations_on(mesh);
        const auto [left, right] = operations.reconnected(1, how);
        ASSERT_NE(left, no_vertex);
        const auto& place = mesh.vertices.place;
        EXPECT_EQ(place[left].row, how == Reconnection::PairRight ? 1.0 : 2.0);
        EXPECT_EQ(place[right].row, how == Reconnection::PairRight ? 2.0 : 1.0);
        operations.reconnect(1, how);
        EXPECT_EQ(mesh.quads.live(), 8u);
        EXPECT_EQ(mesh.vertices.used(), 16u);
        EXPECT_EQ(violation(mesh), "");
        EXPECT_EQ(slit(mesh), "");
        EXPECT_EQ(signed_area(mesh), 9.0);
    }
}

TEST(LocalOperations, ARingIsNotJoinedToCellsOfHalfItsLength) {
    // The short way round between the ends of such a cell's side is no longer the cell's own.
    for (const int columns : {3, 4}) {
        MovingMesh mesh = flat_patch(columns, 2, true);
        EXPECT_EQ(operations_on(mesh).partner(0, Axis::S), no_cell) << columns;
        EXPECT_NE(operations_on(mesh).partner(0, Axis::T), no_cell) << columns;
    }
    MovingMesh mesh = flat_patch(5, 2, true);
    EXPECT_NE(operations_on(mesh).partner(0, Axis::S), no_cell);
}

TEST(LocalOperations, ARingOfHangingNodesIsRefused) {
    // Round a tube of rows 0..3 two cells a column: the lower one is two rows high on its left and one on its right, where
    // it is half the left side of the next. Cutting any of them along the ring asks for the next, and so on round.
    for (const int columns : {3, 5, 80}) {
        MovingMesh tube = flat_patch(columns, 3, true);
        MovingMesh mesh;
        mesh.lattice = tube.lattice;
        mesh.vertices = tube.vertices;
        const auto at = [&](int row, int column) {
            return static_cast<VertexId>(row * columns + column % columns);
        };
        std::vector<Cell> cells;
        for (int k = 0; k < columns; ++k) {
            Cell lower, upper;
            lower.corner = {at(0, k), at(0, k + 1), at(1, k + 1), at(2, k)};
            lower.mid[3] = at(1, k);
            upper.corner = {at(2, k), at(1, k + 1), at(3, k + 1), at(3, k)};
            upper.mid[1] = at(2, k + 1);
            cells.insert(cells.end(), {lower, upper});
        }
        mesh.quads.append(cells, {});
        ASSERT_EQ(violation(mesh), "");
        ASSERT_EQ(slit(mesh), "");
        ASSERT_EQ(euler_characteristic(snapshot(mesh, false).mesh), 0);

        LocalOperations operations = operations_on(mesh);
        EXPECT_FALSE(operations.split(0, Axis::T));
        EXPECT_FALSE(operations.split(1, Axis::T));
        EXPECT_EQ(mesh.quads.live(), cells.size());
        EXPECT_TRUE(operations.split(0, Axis::S)); // the other way is free
        EXPECT_EQ(violation(mesh), "");
        EXPECT_EQ(slit(mesh), "");
        EXPECT_EQ(euler_characteristic(snapshot(mesh, false).mesh), 0);
    }
}

} // namespace wakesurf::core::local_operations_test
