#include "protocol/wire/cells_code.hpp"
#include "tests/protocol/wire/sample_meshes.hpp"

#include <algorithm>
#include <random>

namespace wakesurf::protocol {
namespace {

using core::Cell;
using core::no_vertex;

const KeptCells no_cells;
const Runs none;

Bytes encoded(const core::QuadComplex& mesh) {
    return encode_cells(mesh.cells, {static_cast<std::uint32_t>(mesh.vertices()), no_cells, none});
}

core::Result<std::vector<Cell>>
decoded(std::span<const std::byte> code, std::size_t count, std::size_t vertices) {
    return decode_cells(code, static_cast<std::uint32_t>(count),
                        {static_cast<std::uint32_t>(vertices), no_cells, none});
}

TEST(CellsCode, GivesBackRegularHangingAndChaoticCells) {
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        for (const auto& mesh : {samples::sheet(2 + seed % 7, 2 + seed % 11),
                                 samples::hanging_sheet(2 + seed % 7, 3 + seed % 31, seed),
                                 samples::chaos(1 + seed * seed, seed, seed)}) {
            const auto cells = decoded(encoded(mesh), mesh.cells.size(), mesh.vertices());
            ASSERT_TRUE(cells.has_value()) << cells.error().message;
            ASSERT_EQ(*cells, mesh.cells) << "seed " << seed;
        }
    }
}

TEST(CellsCode, CostsNextToNothingOnASheetInAnyUsualOrderAndTwoBytesWithHangingNodes) {
    auto regular = samples::sheet(100, 200);
    EXPECT_LE(encoded(regular).size(), 4u * 99) << "bytes a strip";
    for (Cell& cell : regular.cells) // rows of vertices, columns of cells
        for (auto& corner : cell.corner)
            corner = corner % 200 * 100 + corner / 200;
    EXPECT_LE(encoded(regular).size(), regular.cells.size() / 30);
    std::ranges::stable_sort(regular.cells, {}, [](const Cell& cell) { return cell.corner[0]; });
    EXPECT_LE(encoded(regular).size(), regular.cells.size() / 30) << "rows of both";
    const auto hanging = samples::hanging_sheet(100, 200, 7);
    EXPECT_LE(encoded(hanging).size(), 2 * hanging.cells.size());
}

/// The cells of a sheet that are still there where some were removed or replaced.
struct Hole {
    core::QuadComplex mesh;
    KeptCells kept;
    Runs replaced;
    std::vector<Cell> cells; ///< the replaced, then the removed ones again

    explicit Hole(std::uint32_t seed, std::uint32_t columns = 20)
        : mesh(samples::hanging_sheet(columns, 60, seed)) {
        std::mt19937 random(seed);
        Runs removed;
        for (std::uint32_t i = 0; i < mesh.cells.size(); ++i)
            if (random() % 20 == 0)
                removed.take(i);
        kept = keep_cells({}, static_cast<std::uint32_t>(mesh.vertices()), removed, mesh.cells);
        for (std::uint32_t i = 0; i < kept.cells.size(); ++i)
            if (random() % 20 == 0)
                replaced.take(i);
        kept.leave_out(replaced);
        for (const Run& run : replaced.all())
            for (std::uint32_t i = run.begin; i < run.end; ++i) {
                cells.push_back(kept.cells[i]);
                std::ranges::fill(cells.back().mid, no_vertex); // what a coarsening does
            }
        for (const Run& run : removed.all())
            cells.insert(cells.end(), mesh.cells.begin() + run.begin, mesh.cells.begin() + run.end);
    }

    CellContext context() const {
        return {static_cast<std::uint32_t>(mesh.vertices()), kept, replaced};
    }
};

TEST(CellsCode, FillsHolesFromTheCellsAroundThem) {
    std::size_t with = 0;
    std::size_t without = 0;
    for (std::uint32_t seed = 1; seed < 30; ++seed) {
        const Hole hole(seed);
        const Bytes code = encode_cells(hole.cells, hole.context());
        const auto cells =
            decode_cells(code, static_cast<std::uint32_t>(hole.cells.size()), hole.context());
        ASSERT_TRUE(cells.has_value()) << cells.error().message;
        ASSERT_EQ(*cells, hole.cells);
        with += code.size();
        without += encode_cells(hole.cells, {hole.context().vertices, no_cells, none}).size();
    }
    EXPECT_LE(2 * with, without);
}

TEST(CellsCode, LooksOfManyCellsThatStayAtTheLastOnesAndAtThoseByAChange) {
    const Hole hole(3, 250);
    ASSERT_GT(hole.kept.cells.size(), 2u * 4096);
    const Bytes code = encode_cells(hole.cells, hole.context());
    const auto cells =
        decode_cells(code, static_cast<std::uint32_t>(hole.cells.size()), hole.context());
    ASSERT_TRUE(cells.has_value()) << cells.error().message;
    EXPECT_EQ(*cells, hole.cells);
    // A row more at the end of the sheet, where nothing was touched.
    const auto sheet = samples::sheet(80, 60);
    const KeptCells kept =
        keep_cells({}, static_cast<std::uint32_t>(sheet.vertices()), {}, sheet.cells);
    ASSERT_GT(kept.cells.size(), 4096u);
    std::vector<Cell> column;
    const auto first = static_cast<std::uint32_t>(sheet.vertices());
    for (std::uint32_t i = 0; i + 1 < 60; ++i)
        column.push_back({{first - 60 + i, first + i, first + i + 1, first - 60 + i + 1},
                          {no_vertex, no_vertex, no_vertex, no_vertex}});
    EXPECT_LE(encode_cells(column, {first + 60, kept, none}).size(), 20u);
}

TEST(CellsCode, RefusesEveryTruncationAndVerticesThatWereNotSent) {
    const auto mesh = samples::hanging_sheet(5, 20, 3);
    const Bytes code = encoded(mesh);
    for (std::size_t size = 0; size < code.size(); ++size)
        ASSERT_FALSE(decoded(std::span(code).first(size), mesh.cells.size(), mesh.vertices()))
            << size;
    Bytes longer = code;
    longer.push_back(std::byte{0});
    EXPECT_FALSE(decoded(longer, mesh.cells.size(), mesh.vertices()))
        << "bytes after the last cell";
    EXPECT_FALSE(decoded(code, 0, mesh.vertices()));
    EXPECT_FALSE(decoded(code, mesh.cells.size(), mesh.vertices() - 1))
        << "a vertex that was not sent";
    EXPECT_TRUE(decoded({}, 0, mesh.vertices()));
}

TEST(CellsCode, SurvivesMutationsWithIdsInRangeOrAnError) {
    std::mt19937 random(5);
    for (const std::uint32_t seed : {11u, 12u}) {
        const Hole hole(seed);
        const Bytes code = encode_cells(hole.cells, hole.context());
        for (int i = 0; i < 5'000; ++i) {
            Bytes mutated = code;
            for (auto n = 1 + random() % 4; n > 0; --n)
                mutated[random() % mutated.size()] = static_cast<std::byte>(random());
            const auto cells = decode_cells(mutated, static_cast<std::uint32_t>(hole.cells.size()),
                                            hole.context());
            if (!cells)
                continue;
            ASSERT_EQ(cells->size(), hole.cells.size());
            for (const Cell& cell : *cells) {
                for (const auto corner : cell.corner)
                    ASSERT_LT(corner, hole.mesh.vertices());
                for (const auto mid : cell.mid)
                    ASSERT_TRUE(mid == no_vertex || mid < hole.mesh.vertices());
            }
        }
    }
}

} // namespace
} // namespace wakesurf::protocol
