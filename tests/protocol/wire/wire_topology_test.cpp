#include "protocol/wire/wire_mesh.hpp"
#include "tests/protocol/wire/sample_meshes.hpp"

#include <algorithm>
#include <array>

namespace wakesurf::protocol::wire_topology_test {
namespace {

using core::no_vertex;

TEST(WireTopology, OfASheetKnowsTheVertexBeforeInTheColumnAndTheOneInTheColumnBefore) {
    constexpr std::uint32_t rows = 7;
    const WireTopology topology(samples::sheet(5, rows).cells, 5 * rows);
    for (std::uint32_t v = 0; v < 5 * rows; ++v) {
        const bool has_column = v >= rows;
        const bool has_row = v % rows > 0;
        const Neighbours& near = topology.neighbours[v];
        EXPECT_EQ(near.highest, has_row ? v - 1 : has_column ? v - rows : no_vertex);
        EXPECT_EQ(near.lowest, has_column ? v - rows : has_row ? v - 1 : no_vertex);
        const bool inside = has_column && has_row;
        EXPECT_EQ(near.opposite, inside ? v - rows - 1 : no_vertex);
        EXPECT_EQ(near.beside == no_vertex, !inside);
        if (inside) {
            EXPECT_EQ(near.beside + near.beside2, 2 * v - rows - 1);
        }
    }
}

TEST(WireTopology, PutsAHangingVertexBetweenTheEndsOfItsSide) {
    core::Cell coarse;
    coarse.corner = {0, 1, 2, 3};
    core::Cell below; // its corner 6 completes it, but 6 also hangs on the coarse cell
    below.corner = {4, 5, 6, 0};
    coarse.mid = {6, no_vertex, no_vertex, no_vertex};
    for (const auto& cells : {std::vector{coarse, below}, std::vector{below, coarse}}) {
        const WireTopology topology(cells, 7);
        EXPECT_EQ(topology.neighbours[6], (Neighbours{5, 0, 0, 1, no_vertex}));
    }
}

/// The definitions, word for word.
Neighbours by_definition(std::span<const core::Cell> cells, std::uint32_t v) {
    Neighbours near;
    bool hangs = false;
    for (const core::Cell& cell : cells) {
        std::vector<std::uint32_t> outline;
        for (std::size_t i = 0; i < 4; ++i) {
            outline.push_back(cell.corner[i]);
            if (cell.mid[i] != no_vertex)
                outline.push_back(cell.mid[i]);
        }
        for (std::size_t i = 0; i < outline.size(); ++i)
            for (const auto& [one, other] :
                 {std::array{outline[i], outline[(i + 1) % outline.size()]},
                  std::array{outline[(i + 1) % outline.size()], outline[i]}})
                if (one == v && other < v) {
                    near.highest =
                        near.highest == no_vertex ? other : std::max(near.highest, other);
                    near.lowest = std::min(near.lowest, other);
                }
        for (std::size_t i = 0; i < 4; ++i) {
            const auto corner = [&](std::size_t k) { return cell.corner[(i + k) % 4]; };
            if (!hangs && cell.mid[i] == v && corner(0) < v && corner(1) < v) {
                hangs = true;
                near = {near.highest, near.lowest, corner(0), corner(1), no_vertex};
            }
            if (near.beside == no_vertex && corner(0) == v && corner(1) < v && corner(2) < v &&
                corner(3) < v)
                near = {near.highest, near.lowest, corner(3), corner(1), corner(2)};
        }
    }
    return near;
}

TEST(WireTopology, FindsWhatTheDefinitionsSayInAnyCells) {
    for (std::uint32_t seed = 1; seed <= 40; ++seed)
        for (const auto& mesh :
             {samples::chaos(20, 30, seed), samples::hanging_sheet(6, 9, seed)}) {
            const WireTopology topology(mesh.cells, mesh.vertices());
            for (std::uint32_t v = 0; v < mesh.vertices(); ++v)
                ASSERT_EQ(topology.neighbours[v], by_definition(mesh.cells, v))
                    << "vertex " << v << ", seed " << seed;
        }
}

TEST(WireTopology, FindsTheSameFromTheCellsThatAreAddedAlone) {
    for (std::uint32_t seed = 1; seed < 60; ++seed) {
        const auto mesh = seed % 2 == 0 ? samples::hanging_sheet(9, 20, seed)
                                        : samples::chaos(60 + seed, 40, seed);
        const auto vertices = static_cast<std::uint32_t>(mesh.vertices());
        auto cells = mesh.cells;
        const auto added = samples::chaos(vertices + 10, 12, seed + 100).cells;
        cells.insert(cells.end(), added.begin(), added.end());
        const WireTopology anew(cells, vertices + 10);
        const WireTopology followed(WireTopology(mesh.cells, vertices), cells, vertices + 10);
        ASSERT_EQ(followed.neighbours, anew.neighbours) << seed;
        ASSERT_EQ(followed.cells, cells);
    }
}

} // namespace
} // namespace wakesurf::protocol::wire_topology_test
