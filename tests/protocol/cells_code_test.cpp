#include "protocol/cells_code.hpp"
#include "tests/protocol/sample_meshes.hpp"

namespace wakesurf::protocol {
namespace {

using core::Cell;
using core::no_vertex;

Bytes encoded(std::span<const Cell> cells) {
    CellsEncoder encoder;
    for (const Cell& cell : cells)
        encoder.put(cell);
    const std::size_t announced = encoder.size();
    Bytes bytes = encoder.finish();
    EXPECT_LE(bytes.size(), announced);
    return bytes;
}

std::vector<Cell> round_trip(const core::QuadComplex& mesh) {
    std::vector<Cell> cells;
    const auto result =
        decode_cells(encoded(mesh.cells), static_cast<std::uint32_t>(mesh.cells.size()),
                     static_cast<std::uint32_t>(mesh.vertices()), cells);
    EXPECT_TRUE(result.has_value()) << result.error().message;
    return cells;
}

TEST(CellsCode, GivesBackRegularHangingAndChaoticCells) {
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        for (const auto& mesh : {samples::sheet(2 + seed % 7, 2 + seed % 11),
                                 samples::hanging_sheet(2 + seed % 7, 3 + seed % 31, seed),
                                 samples::chaos(1 + seed * seed, seed, seed)})
            ASSERT_EQ(round_trip(mesh), mesh.cells) << "seed " << seed;
    }
}

TEST(CellsCode, GivesBackIdsAtTheEndsOfTheirRange) {
    const core::VertexId last = no_vertex - 1;
    std::vector<Cell> cells(2);
    cells[0].corner = {last, 0, last, 0};
    cells[0].mid = {0, last, 0, last};
    cells[1].corner = {0, last, 0, last};
    std::vector<Cell> decoded;
    ASSERT_TRUE(decode_cells(encoded(cells), 2, no_vertex, decoded).has_value());
    EXPECT_EQ(decoded, cells);
}

TEST(CellsCode, CostsNextToNothingOnASheetAndTwoBytesWithHangingNodes) {
    const auto regular = samples::sheet(100, 200);
    EXPECT_LE(encoded(regular.cells).size(), regular.cells.size() / 20);
    const auto hanging = samples::hanging_sheet(100, 200, 7);
    EXPECT_LE(encoded(hanging.cells).size(), 2 * hanging.cells.size());
}

TEST(CellsCode, LearnsTheStrideOfRowOrderedVertices) {
    auto mesh = samples::sheet(100, 200);
    for (Cell& cell : mesh.cells)
        for (auto& corner : cell.corner)
            corner = corner % 200 * 100 + corner / 200;
    EXPECT_LE(encoded(mesh.cells).size(), mesh.cells.size() / 4);
    EXPECT_EQ(round_trip(mesh), mesh.cells);
}

TEST(CellsCode, RefusesEveryTruncationAndLeavesTheCellsAlone) {
    const auto mesh = samples::hanging_sheet(5, 20, 3);
    const Bytes code = encoded(mesh.cells);
    const auto count = static_cast<std::uint32_t>(mesh.cells.size());
    const auto vertices = static_cast<std::uint32_t>(mesh.vertices());
    for (std::size_t size = 0; size < code.size(); ++size) {
        std::vector<Cell> cells(3);
        ASSERT_FALSE(decode_cells(std::span(code).first(size), count, vertices, cells)) << size;
        ASSERT_EQ(cells.size(), 3u);
    }
    std::vector<Cell> cells;
    EXPECT_FALSE(decode_cells(code, count - 1, vertices, cells)) << "bytes after the last cell";
    EXPECT_FALSE(decode_cells(code, count + 1, vertices, cells));
    EXPECT_FALSE(decode_cells(code, count, vertices - 1, cells)) << "a vertex that was not sent";
}

TEST(CellsCode, RefusesRunsThatAreEmptyTooLongOrOfOtherCells) {
    std::vector<Cell> cells;
    for (const auto& code :
         {Bytes{std::byte{0xf0}, std::byte{0}}, Bytes{std::byte{0xf0}, std::byte{9}},
          Bytes{std::byte{0xf1}, std::byte{1}, std::byte{0}},
          Bytes{std::byte{0xf0}, std::byte{0xff}, std::byte{0xff}, std::byte{0xff}, std::byte{0xff},
                std::byte{0x1f}}})
        EXPECT_FALSE(decode_cells(code, 8, 100, cells));
    const Bytes run{std::byte{0xf0}, std::byte{8}};
    EXPECT_TRUE(decode_cells(run, 8, 100, cells));
    cells.clear();
    EXPECT_FALSE(decode_cells(run, 8, 8, cells)) << "the run walks off the vertices";
}

TEST(CellsCode, SurvivesMutationsWithIdsInRangeOrAnError) {
    const auto mesh = samples::hanging_sheet(6, 30, 11);
    const Bytes code = encoded(mesh.cells);
    const auto count = static_cast<std::uint32_t>(mesh.cells.size());
    const auto vertices = static_cast<std::uint32_t>(mesh.vertices());
    std::mt19937 random(5);
    for (int i = 0; i < 20'000; ++i) {
        Bytes mutated = code;
        for (auto n = 1 + random() % 4; n > 0; --n)
            mutated[random() % mutated.size()] = static_cast<std::byte>(random());
        std::vector<Cell> cells;
        if (!decode_cells(mutated, count, vertices, cells))
            continue;
        ASSERT_EQ(cells.size(), count);
        for (const Cell& cell : cells) {
            for (const auto corner : cell.corner)
                ASSERT_LT(corner, vertices);
            for (const auto mid : cell.mid)
                ASSERT_TRUE(mid == no_vertex || mid < vertices);
        }
    }
}

} // namespace
} // namespace wakesurf::protocol
