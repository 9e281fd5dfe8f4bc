#include "protocol/wire/wire_edit.hpp"

#include "protocol/wire/bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

namespace wakesurf::protocol {

WireDraft begin_draft(const WireMesh& before,
                      const TopologyEdit& edit,
                      std::shared_ptr<const WireTopology> topology) {
    WireDraft draft;
    const Runs& removed = edit.removed_vertices;
    draft.position_before = without(removed, std::span(before.position));
    draft.change_before = without(removed, std::span(before.change));
    for (const auto& codes : before.codes)
        draft.codes_before.push_back(without(removed, std::span(codes)));
    draft.stay = static_cast<std::uint32_t>(draft.position_before.size());
    const std::size_t vertices = std::size_t{draft.stay} + edit.added_vertices;

    WireMesh& after = draft.after;
    after.lattice_bits = before.lattice_bits;
    after.ranges = before.ranges;
    after.topology = std::move(topology);
    after.position.reserve(vertices);
    after.position = draft.position_before;
    after.position.resize(vertices);
    after.change.resize(vertices);
    for (const auto& codes : draft.codes_before) {
        after.codes.emplace_back().reserve(vertices);
        after.codes.back() = codes;
        after.codes.back().resize(vertices);
    }
    return draft;
}

namespace {

using core::Cell;
using core::no_vertex;

constexpr std::size_t slots = 8; ///< corners 0 to 3, then mids 0 to 3

template <class AnyCell>
auto& vertex_of(AnyCell& cell, std::size_t slot) {
    return slot < 4 ? cell.corner[slot] : cell.mid[slot - 4];
}

std::uint32_t mids_of(const Cell& cell) {
    std::uint32_t mids = 0;
    for (std::size_t side = 0; side < 4; ++side)
        mids |= cell.mid[side] != no_vertex ? 1u << side : 0u;
    return mids;
}

/// Calls code(vertex, base) for each vertex in turn, which returns the vertex. Encoder and decoder use this
/// walk.
template <class Cells, class Code>
void walk(const Cells& cells, const CellContext& context, Code code) {
    /// For each slot, the one of the same cell that a new vertex is near; corners 0 and 1 have that of the
    /// cell before.
    constexpr std::array<std::size_t, slots> near{0, 1, 1, 0, 0, 1, 2, 3};
    for (std::size_t slot = 0; slot < slots; ++slot) {
        std::uint32_t before = context.stay;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            auto& vertex = vertex_of(cells[i], slot);
            if (slot >= 4 && vertex == no_vertex)
                continue;
            const std::uint32_t old =
                i < context.replaced.size() ? vertex_of(context.replaced[i], slot) : no_vertex;
            const std::uint32_t base = old != no_vertex ? old
                                       : slot < 2       ? before
                                                        : cells[i].corner[near[slot]];
            const std::uint32_t now = code(vertex, base);
            if (old == no_vertex)
                before = now;
        }
    }
}

} // namespace

void append_cells(std::vector<std::uint32_t>& numbers,
                  std::span<const Cell> cells,
                  const CellContext& context) {
    for (const Cell& cell : cells)
        numbers.push_back(mids_of(cell));
    walk(cells, context, [&](std::uint32_t vertex, std::uint32_t base) {
        numbers.push_back(zigzag(vertex - base));
        return vertex;
    });
}

core::Result<std::vector<Cell>>
read_cells(Numbers& numbers, std::size_t count, const CellContext& context) {
    const auto mids = numbers.take(count);
    std::vector<Cell> cells(mids.size());
    bool fine = mids.size() == count;
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t side = 0; side < 4; ++side)
            cells[i].mid[side] = (mids[i] >> side & 1u) != 0 ? 0u : no_vertex;
    walk(std::span(cells), context, [&](std::uint32_t& vertex, std::uint32_t base) {
        vertex = base + unzigzag(numbers.next());
        fine = fine && vertex < context.vertices;
        return vertex;
    });
    if (fine && !numbers.failed())
        return cells;
    return corrupt("a cell of a mesh update has a vertex that is not there");
}

void Runs::take(Run run, std::uint32_t bridge) {
    if (!runs_.empty() && run.begin - runs_.back().end <= bridge) {
        count_ += run.end - runs_.back().end;
        runs_.back().end = run.end;
    } else {
        count_ += run.end - run.begin;
        runs_.push_back(run);
    }
}

std::vector<std::uint32_t> numbers_after(const Runs& removed, std::uint32_t count) {
    std::vector<std::uint32_t> now(count, core::no_vertex);
    std::uint32_t next = 0;
    for_each_gap(removed, count, [&](std::uint32_t begin, std::uint32_t end) {
        std::iota(now.begin() + begin, now.begin() + end, next);
        next += end - begin;
    });
    return now;
}

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
