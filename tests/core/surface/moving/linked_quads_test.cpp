#include "core/surface/moving/linked_quads.hpp"
#include "tests/support/flat_patch.hpp"
#include "tests/support/mesh_delta.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace wakesurf::core::linked_quads_test {

using namespace tests;

namespace {

Cell quad(VertexId a, VertexId b, VertexId c, VertexId d) {
    Cell cell;
    cell.corner = {a, b, c, d};
    return cell;
}

std::set<std::uint32_t> ids(const LinkedQuads& quads) {
    std::set<std::uint32_t> all;
    for (const LinkedCell& slot : quads.slots())
        if (slot.live)
            all.insert(slot.id);
    return all;
}

} // namespace

TEST(LinkedQuads, AnOutlineRunsRoundTheCellThroughItsMidNodes) {
    Cell cell = quad(0, 1, 2, 3);
    EXPECT_EQ(outline(cell).count, 4u);
    cell.mid = {4, 5, 6, 7};
    const Outline all = outline(cell);
    ASSERT_EQ(all.count, 8u);
    for (std::size_t k = 0; k < 8; ++k) {
        EXPECT_EQ(all.edge[k].to, all.edge[(k + 1) % 8].from);
        EXPECT_EQ(all.edge[k].side, k / 2);
        EXPECT_EQ(all.edge[k].half, k % 2);
    }
}

TEST(LinkedQuads, AppendedCellsKnowEachOtherAndThoseBeside) {
    //  6 --- 7 --- 8
    //  3 --- 4 --- 5
    //  0 --- 1 --- 2
    LinkedQuads quads;
    quads.append(std::array{quad(0, 1, 4, 3), quad(1, 2, 5, 4)}, {});
    EXPECT_EQ(quads[0].across[1][0], 1u);
    EXPECT_EQ(quads[1].across[3][0], 0u);
    EXPECT_EQ(quads[0].across[2][0], no_cell);
    quads.append(std::array{quad(3, 4, 7, 6), quad(4, 5, 8, 7)}, std::array{CellIndex{0}});
    EXPECT_EQ(quads.made().size(), 2u);
    EXPECT_EQ(quads[0].across[2][0], 2u);
    EXPECT_EQ(quads[2].across[0][0], 0u);
    EXPECT_EQ(quads[3].across[3][0], 2u);
    EXPECT_EQ(quads[3].across[0][0], no_cell) << "cell 1 was not named as beside";
    EXPECT_EQ(quads.live(), 4u);
}

TEST(LinkedQuads, AReplacedCellKeepsItsIdOnlyWhereAskedTo) {
    MovingMesh mesh = flat_patch(3, 3);
    LinkedQuads& quads = mesh.quads;
    Cell same = quads[4].cell;
    quads.replace(std::array{CellIndex{4}}, std::array{same}, 1);
    EXPECT_EQ(quads[4].id, 4u);
    quads.replace(std::array{CellIndex{4}}, std::array{same}, 0);
    EXPECT_EQ(quads[4].id, 9u);
    EXPECT_EQ(quads.live(), 9u);
    EXPECT_EQ(violation(mesh), "");
    EXPECT_EQ(slit(mesh), "");
}

TEST(LinkedQuads, AHoleIsBoundaryToAllRoundItAndItsSlotIsUsedAgainUnderANewId) {
    MovingMesh mesh = flat_patch(3, 3);
    const Cell centre = mesh.quads[4].cell;
    mesh.quads.replace(std::array{CellIndex{4}}, {}, 0);
    EXPECT_EQ(mesh.quads.live(), 8u);
    EXPECT_EQ(mesh.quads[1].across[2][0], no_cell);
    EXPECT_EQ(mesh.quads[3].across[1][0], no_cell);
    EXPECT_EQ(mesh.quads[5].across[3][0], no_cell);
    EXPECT_EQ(mesh.quads[7].across[0][0], no_cell);
    EXPECT_EQ(slit(mesh), "");
    mesh.quads.append(std::array{centre},
                      std::array{CellIndex{1}, CellIndex{3}, CellIndex{5}, CellIndex{7}});
    EXPECT_EQ(mesh.quads.made()[0], 4u);
    EXPECT_EQ(mesh.quads[4].id, 9u);
    EXPECT_EQ(slit(mesh), "");
    EXPECT_EQ(violation(mesh), "");
}

TEST(LinkedQuads, TwoHalvesOfASideHaveTheirOwnNeighbours) {
    // A large cell with two small ones on top.
    LinkedQuads quads;
    Cell large = quad(0, 1, 2, 3);
    large.mid[2] = 4;
    quads.append(std::array{large, quad(3, 4, 6, 5), quad(4, 2, 7, 6)}, {});
    EXPECT_EQ(quads[0].across[2][0], 2u); // from corner 2 to the mid node: the right one
    EXPECT_EQ(quads[0].across[2][1], 1u);
    EXPECT_EQ(quads[1].across[0][0], 0u);
    EXPECT_EQ(quads[2].across[0][0], 0u);
    quads.replace(std::array{CellIndex{1}}, {}, 0);
    EXPECT_EQ(quads[0].across[2][0], 2u);
    EXPECT_EQ(quads[0].across[2][1], no_cell);
}

TEST(LinkedQuads, ReplacedTogetherMoreCellsMayComeThanGo) {
    MovingMesh mesh = flat_patch(2, 1);
    const VertexId low = insert_middle(mesh, 0, 1);
    const VertexId high = insert_middle(mesh, 3, 4);
    Cell with_mids = mesh.quads[0].cell;
    with_mids.mid[0] = low;
    with_mids.mid[2] = high;
    mesh.quads.replace(std::array{CellIndex{0}}, std::array{with_mids}, 1);
    mesh.quads.replace(std::array{CellIndex{0}},
                       std::array{quad(0, low, high, 3), quad(low, 1, 4, high)}, 0);
    EXPECT_EQ(mesh.quads.live(), 3u);
    EXPECT_EQ(ids(mesh.quads), (std::set<std::uint32_t>{1, 2, 3}));
    EXPECT_EQ(slit(mesh), "");
    EXPECT_EQ(violation(mesh), "");
}

TEST(LinkedQuads, RenumberingIsInvisibleInTheSnapshot) {
    MovingMesh mesh = flat_patch(6, 5);
    mesh.quads.replace(std::array{CellIndex{13}}, {}, 0);
    mesh.quads.replace(std::array{CellIndex{0}}, {}, 0); // its corner vertex goes with it
    mesh.vertices.remove(0);
    const std::uint64_t before = hash(snapshot(mesh, false));

    std::vector<CellIndex> cells;
    for (CellIndex i = 0; i < mesh.quads.slots().size(); ++i)
        if (mesh.quads[i].live)
            cells.push_back(i);
    std::vector<VertexId> vertices(mesh.vertices.slots() - 1);
    std::iota(vertices.begin(), vertices.end(), 1u);
    std::mt19937 random(3);
    std::shuffle(cells.begin(), cells.end(), random);
    std::shuffle(vertices.begin(), vertices.end(), random);
    std::vector<VertexId> slot(mesh.vertices.slots(), no_vertex);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        slot[vertices[i]] = static_cast<VertexId>(i);
    mesh.quads.renumber(cells, slot);
    mesh.vertices.renumber(vertices);

    EXPECT_EQ(mesh.quads.slots().size(), 28u);
    EXPECT_EQ(mesh.vertices.slots(), 41u);
    EXPECT_EQ(hash(snapshot(mesh, false)), before);
    EXPECT_EQ(violation(mesh), "");
    EXPECT_EQ(slit(mesh), "");
}

} // namespace wakesurf::core::linked_quads_test
