#include "protocol/wire/wire_edit.hpp"
#include "tests/protocol/wire/sample_meshes.hpp"

#include <algorithm>
#include <random>
#include <string>

namespace wakesurf::protocol::wire_edit_test {
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
    std::uint32_t vertices = 0; ///< before
    std::vector<core::Cell> cells;
    std::vector<core::Cell> kept;
    MeshSize after;
    TopologyEdit edit;

    EditedFrom before() const { return {vertices, cells}; }
};

/// No cell that stays loses a corner, though some lose mids.
RandomEdit random_edit(std::uint32_t seed) {
    std::mt19937 random(seed);
    RandomEdit r;
    r.vertices = 8 + below(random, 1000);
    r.cells = samples::chaos(r.vertices, below(random, 900), seed + 1).cells;
    r.edit.removed_vertices = random_runs(random, r.vertices);
    const auto now = numbers_after(r.edit.removed_vertices, r.vertices);
    for (std::uint32_t i = 0; i < r.cells.size(); ++i)
        if (below(random, 5) == 0 || std::ranges::any_of(r.cells[i].corner, [&](std::uint32_t v) {
                return now[v] == core::no_vertex;
            }))
            r.edit.removed_cells.take(i);
    r.edit.added_vertices = 4 + below(random, 50);
    const std::uint32_t vertices_stay = r.vertices - r.edit.removed_vertices.count();
    r.edit.moved_vertices = random_runs(random, vertices_stay);
    const auto cells_stay =
        static_cast<std::uint32_t>(r.cells.size()) - r.edit.removed_cells.count();
    r.edit.replaced_cells = random_runs(random, cells_stay);
    r.edit.added_cells = below(random, 60);
    r.after = {vertices_stay + r.edit.added_vertices, cells_stay + r.edit.added_cells};
    r.edit.cells =
        samples::chaos(r.after.vertices, r.edit.replaced_cells.count() + r.edit.added_cells, seed)
            .cells;
    r.kept = kept_cells(r.edit.removed_vertices, r.edit.removed_cells, r.before());
    return r;
}

std::vector<std::uint32_t> written(const RandomEdit& r) {
    std::vector<std::uint32_t> numbers;
    append_edit(numbers, r.edit, r.kept, r.vertices - r.edit.removed_vertices.count());
    return numbers;
}

/// Why an edit is refused; empty where it is read.
std::string refusal(std::vector<std::uint32_t> given, const EditedFrom& before, MeshSize after) {
    Numbers numbers(std::move(given));
    const auto read = read_edit(numbers, before, after);
    return read ? std::string() : read.error().message;
}

std::string leads_to_other_than(MeshSize size) {
    return "a mesh update leads to another number of vertices or cells than " +
           std::to_string(size.vertices) + " and " + std::to_string(size.cells);
}

/// In its runs, or in the cells behind them.
bool is_damaged(const std::string& message) {
    return message == "the topology of a mesh update is damaged" ||
           message == "a cell of a mesh update has a vertex that is not there";
}

TEST(WireEdit, ReadsBackWhatItWrote) {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const RandomEdit r = random_edit(seed);
        Numbers numbers(written(r));
        const auto read = read_edit(numbers, r.before(), r.after);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        ASSERT_EQ(read->edit, r.edit) << seed;
        ASSERT_EQ(read->kept, r.kept) << seed;
        ASSERT_EQ(numbers.left(), 0u) << seed;
    }
}

TEST(WireEdit, IsRefusedWhenItLeadsToAnotherMeshOrIsDamaged) {
    std::mt19937 random(4);
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const RandomEdit r = random_edit(seed);
        const auto good = written(r);
        MeshSize other = r.after;
        ++other.vertices;
        EXPECT_EQ(refusal(good, r.before(), other), leads_to_other_than(other));
        other = r.after;
        ++other.cells;
        EXPECT_EQ(refusal(good, r.before(), other), leads_to_other_than(other));
        for (std::size_t size = 0; size < good.size(); ++size)
            EXPECT_TRUE(
                is_damaged(refusal({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)},
                                   r.before(), r.after)))
                << size;
        for (int i = 0; i < 200; ++i) {
            auto bad = good;
            bad[random() % bad.size()] ^= 1u << (random() % (i % 4 == 0 ? 32 : 4));
            Numbers numbers(bad);
            if (const auto read =
                    read_edit(numbers, r.before(), r.after)) { // another edit, but a whole one
                const TopologyEdit& edit = read->edit;
                EXPECT_EQ(edit.cells.size(),
                          edit.replaced_cells.count() + std::size_t{edit.added_cells});
                EXPECT_EQ(r.vertices - edit.removed_vertices.count() + edit.added_vertices,
                          r.after.vertices);
                for (const core::Cell& cell : edited_cells(read->kept, edit))
                    for (const auto corner : cell.corner)
                        ASSERT_LT(corner, r.after.vertices);
            }
        }
    }
}

TEST(WireEdit, AnnouncingMoreThanThereIsAllocatesNothing) {
    const std::vector<std::uint32_t> huge{0, 0,        0,  0,
                                          0, 1u << 24, 15, 15}; // cells, two of which are there
    EXPECT_TRUE(is_damaged(refusal(huge, {}, {0, 1u << 24})));
    EXPECT_EQ(refusal(huge, {}, {0, 1}), leads_to_other_than({0, 1}));
    EXPECT_TRUE(is_damaged(refusal({0xffffffffu}, {}, {0, 0}))) << "runs";
}

TEST(WireEdit, SaysOfAStripOfCellsTheSameDifferencesAgainAndAgain) {
    TopologyEdit edit;
    edit.cells = samples::sheet(2, 50).cells;
    edit.added_vertices = 100;
    edit.added_cells = 49;
    std::vector<std::uint32_t> numbers;
    append_edit(numbers, edit, {}, 0);
    EXPECT_EQ(numbers.size(), 6u + 49u * 5u);
    EXPECT_LT(pack_numbers(numbers)->size(), 40u);
}

TEST(KeptCells, HaveNewNumbersAndNoVertexThatHasGone) {
    core::Cell cell;
    cell.corner = {0, 2, 4, 6};
    cell.mid = {3, core::no_vertex, core::no_vertex, 5};
    core::Cell apart;
    apart.corner = {7, 8, 9, 10};
    Runs removed;
    removed.take({1, 2});
    removed.take({5, 6}); // a mid
    Runs removed_cells;
    removed_cells.take(1);
    const std::array before{cell, apart};
    const auto kept = kept_cells(removed, removed_cells, {11, before});
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept.front().corner, (std::array<core::VertexId, 4>{0, 1, 3, 4}));
    EXPECT_EQ(kept.front().mid, (std::array<core::VertexId, 4>{2, core::no_vertex, core::no_vertex,
                                                               core::no_vertex}));
}

TEST(WireEdit, IsRefusedWhenItTakesACornerFromACellThatStaysUnlessItReplacesTheCell) {
    core::Cell cell;
    cell.corner = {0, 1, 2, 3};
    TopologyEdit edit;
    edit.removed_vertices.take({3, 4});
    edit.added_vertices = 1;
    const std::array before{cell};
    const auto read = [&] {
        std::vector<std::uint32_t> written;
        append_edit(written, edit, kept_cells(edit.removed_vertices, {}, {4, before}), 3);
        Numbers numbers(written);
        return read_edit(numbers, {4, before}, {4, 1});
    };
    EXPECT_EQ(read().error().message, "a mesh update takes a corner from a cell that stays");
    edit.replaced_cells.take(0);
    edit.cells = {cell};
    const auto replaced = read();
    ASSERT_TRUE(replaced.has_value());
    EXPECT_EQ(edited_cells(replaced->kept, replaced->edit), std::vector{cell});
}

TEST(Runs, TakeGapsAlongThatAreShorterThanTheBridge) {
    Runs runs;
    for (const std::uint32_t i : {3u, 4u, 8u, 20u})
        runs.take({i, i + 1}, 3);
    EXPECT_TRUE(std::ranges::equal(runs.all(), std::vector<protocol::Run>{{3, 9}, {20, 21}}));
    EXPECT_EQ(runs.count(), 7u);
}

} // namespace
} // namespace wakesurf::protocol::wire_edit_test
