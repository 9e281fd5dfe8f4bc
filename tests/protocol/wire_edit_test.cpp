#include "protocol/wire_edit.hpp"
#include "tests/protocol/sample_meshes.hpp"

#include <algorithm>
#include <random>

namespace wakesurf::protocol {
namespace {

std::uint32_t below(std::mt19937& random, std::uint32_t limit) {
    return static_cast<std::uint32_t>(random() % limit);
}

Runs random_runs(std::mt19937& random, std::uint32_t over) {
    Runs runs;
    for (std::uint32_t at = below(random, 5); at < over;) {
        const std::uint32_t end = std::min(over, at + 1 + below(random, 7));
        runs.take({at, end});
        at = end + below(random, 300);
    }
    return runs;
}

struct RandomEdit {
    MeshSize before, after;
    TopologyEdit edit;
};

RandomEdit random_edit(std::uint32_t seed) {
    std::mt19937 random(seed);
    RandomEdit r;
    r.before = {below(random, 1000), below(random, 900)};
    r.edit.removed_vertices = random_runs(random, r.before.vertices);
    r.edit.added_vertices = 1 + below(random, 50);
    const std::uint32_t vertices_stay = r.before.vertices - r.edit.removed_vertices.count();
    r.edit.moved_vertices = random_runs(random, vertices_stay);
    r.edit.removed_cells = random_runs(random, r.before.cells);
    const std::uint32_t cells_stay = r.before.cells - r.edit.removed_cells.count();
    r.edit.replaced_cells = random_runs(random, cells_stay);
    r.edit.added_cells = below(random, 60);
    r.after = {vertices_stay + r.edit.added_vertices, cells_stay + r.edit.added_cells};
    r.edit.cells =
        samples::chaos(r.after.vertices, r.edit.replaced_cells.count() + r.edit.added_cells, seed)
            .cells;
    return r;
}

TEST(WireEdit, ReadsBackWhatItWrote) {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const RandomEdit r = random_edit(seed);
        const auto read = read_edit(write_edit(r.edit), r.before, r.after);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        ASSERT_EQ(*read, r.edit) << seed;
    }
}

TEST(WireEdit, IsRefusedWhenItLeadsToAnotherMeshOrIsDamaged) {
    std::mt19937 random(4);
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const RandomEdit r = random_edit(seed);
        const Bytes good = write_edit(r.edit);
        MeshSize other = r.after;
        ++other.vertices;
        EXPECT_FALSE(read_edit(good, r.before, other).has_value());
        other = r.after;
        ++other.cells;
        EXPECT_FALSE(read_edit(good, r.before, other).has_value());
        for (std::size_t size = 0; size < good.size(); ++size)
            EXPECT_FALSE(read_edit(std::span(good).first(size), r.before, r.after).has_value());
        for (int i = 0; i < 200; ++i) {
            Bytes bad = good;
            bad[random() % bad.size()] ^= static_cast<std::byte>(1 + random() % 255);
            if (const auto read =
                    read_edit(bad, r.before, r.after)) { // another edit, but a whole one
                EXPECT_EQ(read->cells.size(),
                          read->replaced_cells.count() + std::size_t{read->added_cells});
                EXPECT_EQ(r.before.vertices - read->removed_vertices.count() + read->added_vertices,
                          r.after.vertices);
            }
        }
    }
}

TEST(WireEdit, AnnouncingMoreThanThereIsAllocatesNothing) {
    const Bytes huge{std::byte{0},    std::byte{0},   std::byte{0},    std::byte{0},
                     std::byte{0},    std::byte{1},   std::byte{0xf0}, std::byte{0xff},
                     std::byte{0xff}, std::byte{0x7f}};
    EXPECT_FALSE(read_edit(huge, {}, {0, 1}).has_value());
    EXPECT_FALSE(read_edit(huge, {}, {0, 1u << 24}).has_value());
}

TEST(WireEdit, GivesTheCellsThatStayTheirVerticesNewNumbers) {
    core::Cell cell;
    cell.corner = {0, 2, 4, 6};
    cell.mid = {3, core::no_vertex, core::no_vertex, 5};
    TopologyEdit edit;
    edit.removed_vertices.take({1, 2});
    edit.removed_vertices.take({5, 6}); // a mid
    auto cells = edit_cells(edit, std::span(&cell, 1), 7);
    ASSERT_TRUE(cells.has_value());
    EXPECT_EQ(cells->front().corner, (std::array<core::VertexId, 4>{0, 1, 3, 4}));
    EXPECT_EQ(cells->front().mid, (std::array<core::VertexId, 4>{
                                      2, core::no_vertex, core::no_vertex, core::no_vertex}));
    edit.removed_vertices.take({6, 7}); // a corner
    EXPECT_FALSE(edit_cells(edit, std::span(&cell, 1), 7).has_value());
    edit.replaced_cells.take(0);
    edit.cells = {cell};
    cells = edit_cells(edit, std::span(&cell, 1), 7);
    ASSERT_TRUE(cells.has_value());
    EXPECT_EQ(cells->front(), cell) << "a replaced cell comes in new numbers";
}

TEST(Runs, TakeGapsAlongThatAreShorterThanTheBridge) {
    Runs runs;
    for (const std::uint32_t i : {3u, 4u, 8u, 20u})
        runs.take({i, i + 1}, 3);
    EXPECT_TRUE(std::ranges::equal(runs.all(), std::vector<protocol::Run>{{3, 9}, {20, 21}}));
    EXPECT_EQ(runs.count(), 7u);
}

} // namespace
} // namespace wakesurf::protocol
