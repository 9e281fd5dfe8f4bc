#include "protocol/wire/wire_edit.hpp"

#include "protocol/wire/corrupt.hpp"
#include "protocol/wire/wire_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace wakesurf::protocol {

namespace {

using core::Cell;
using core::Error;
using core::no_vertex;

void append_runs(std::vector<std::uint32_t>& numbers, const Runs& runs) {
    numbers.push_back(static_cast<std::uint32_t>(runs.all().size()));
    std::uint32_t at = 0;
    for (const Run& run : runs.all()) {
        numbers.push_back(run.begin - at);
        numbers.push_back(run.end - run.begin);
        at = run.end;
    }
}

/// Reads runs. If they do not fit, the numbers have failed.
Runs read_runs(Numbers& numbers, std::uint32_t over) {
    Runs runs;
    std::uint32_t at = 0;
    for (std::uint32_t left = numbers.next(over); left > 0; --left) {
        const std::uint32_t begin = at + numbers.next(over - at);
        const std::uint32_t take = numbers.next(over - begin);
        if (take == 0)
            numbers.take(numbers.left() + 1);
        if (numbers.failed())
            return {};
        at = begin + take;
        runs.take({begin, at});
    }
    return runs;
}

/// Returns the replaced ones of the cells that stay.
std::vector<Cell> replaced_of(std::span<const Cell> kept, const Runs& replaced) {
    std::vector<Cell> cells;
    cells.reserve(replaced.count());
    for (const Run& run : replaced.all()) {
        const auto some = kept.subspan(run.begin, run.end - run.begin);
        cells.insert(cells.end(), some.begin(), some.end());
    }
    return cells;
}

/// Returns true if a cell that stays and is not replaced has lost a corner.
bool corner_lost(std::span<const Cell> kept, const Runs& replaced) {
    bool lost = false;
    for_each_gap(replaced, static_cast<std::uint32_t>(kept.size()),
                 [&](std::uint32_t begin, std::uint32_t end) {
                     for (std::uint32_t i = begin; i < end; ++i)
                         for (const std::uint32_t corner : kept[i].corner)
                             lost = lost || corner == no_vertex;
                 });
    return lost;
}

} // namespace

std::vector<Cell>
kept_cells(const Runs& removed_vertices, const Runs& removed_cells, const EditedFrom& before) {
    std::vector<Cell> kept = without(removed_cells, before.cells);
    if (removed_vertices.count() == 0)
        return kept;
    const auto now = numbers_after(removed_vertices, before.vertices);
    for (Cell& cell : kept)
        for (std::size_t i = 0; i < 4; ++i) {
            cell.corner[i] = now[cell.corner[i]];
            cell.mid[i] = cell.mid[i] == no_vertex ? no_vertex : now[cell.mid[i]];
        }
    return kept;
}

void append_edit(std::vector<std::uint32_t>& numbers,
                 const TopologyEdit& edit,
                 std::span<const Cell> kept,
                 std::uint32_t stay) {
    append_runs(numbers, edit.removed_vertices);
    numbers.push_back(edit.added_vertices);
    append_runs(numbers, edit.moved_vertices);
    append_runs(numbers, edit.removed_cells);
    append_runs(numbers, edit.replaced_cells);
    numbers.push_back(edit.added_cells);
    append_cells(numbers, edit.cells,
                 {replaced_of(kept, edit.replaced_cells), stay, stay + edit.added_vertices});
}

core::Result<ReadEdit> read_edit(Numbers& numbers, const EditedFrom& before, MeshSize after) {
    const auto cells_before = static_cast<std::uint32_t>(before.cells.size());
    TopologyEdit edit;
    edit.removed_vertices = read_runs(numbers, before.vertices);
    edit.added_vertices = numbers.next();
    const std::uint32_t stay = before.vertices - edit.removed_vertices.count();
    edit.moved_vertices = read_runs(numbers, stay);
    edit.removed_cells = read_runs(numbers, cells_before);
    const std::uint32_t cells_stay = cells_before - edit.removed_cells.count();
    edit.replaced_cells = read_runs(numbers, cells_stay);
    edit.added_cells = numbers.next();
    if (numbers.failed())
        return corrupt("the topology of a mesh update is damaged");
    if (std::uint64_t{stay} + edit.added_vertices != after.vertices ||
        std::uint64_t{cells_stay} + edit.added_cells != after.cells)
        return corrupt(fmt::format("a mesh update leads to another number of vertices or cells "
                                   "than {} and {}",
                                   after.vertices, after.cells));
    std::vector<Cell> kept;
    if (!edit.keeps_topology() || edit.added_cells > 0)
        kept = kept_cells(edit.removed_vertices, edit.removed_cells, before);
    if (edit.removed_vertices.count() > 0 && corner_lost(kept, edit.replaced_cells))
        return corrupt("a mesh update takes a corner from a cell that stays");
    const auto replaced = replaced_of(kept, edit.replaced_cells);
    auto cells =
        read_cells(numbers, replaced.size() + edit.added_cells, {replaced, stay, after.vertices});
    if (!cells)
        return tl::unexpected(cells.error());
    edit.cells = std::move(*cells);
    return ReadEdit{std::move(edit), std::move(kept)};
}

std::vector<Cell> edited_cells(std::vector<Cell> kept, const TopologyEdit& edit) {
    auto source = edit.cells.begin();
    for (const Run& run : edit.replaced_cells.all())
        for (std::uint32_t i = run.begin; i < run.end; ++i)
            kept[i] = *source++;
    kept.insert(kept.end(), source, edit.cells.end());
    return kept;
}

} // namespace wakesurf::protocol
