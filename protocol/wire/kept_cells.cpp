#include "protocol/wire/kept_cells.hpp"

namespace wakesurf::protocol {

using core::Cell;
using core::no_vertex;

namespace {

/// A lost corner counts as touched.
bool is_touched(const Cell& cell, std::span<const std::uint8_t> touched) {
    const auto is = [touched](std::uint32_t v) { return v >= touched.size() || touched[v] != 0; };
    const auto& [c, m] = cell;
    if (is(c[0]) || is(c[1]) || is(c[2]) || is(c[3]))
        return true;
    if ((m[0] & m[1] & m[2] & m[3]) == no_vertex)
        return false;
    return (m[0] != no_vertex && is(m[0])) || (m[1] != no_vertex && is(m[1])) ||
           (m[2] != no_vertex && is(m[2])) || (m[3] != no_vertex && is(m[3]));
}

/// In new numbers. Sets `lost` where a vertex has gone.
Cell renumbered(const Cell& cell, std::span<const std::uint32_t> now, bool& lost) {
    Cell result;
    for (std::size_t i = 0; i < 4; ++i) {
        result.corner[i] = now[cell.corner[i]];
        result.mid[i] = cell.mid[i] == no_vertex ? no_vertex : now[cell.mid[i]];
        lost = lost || result.corner[i] == no_vertex ||
               (result.mid[i] == no_vertex && cell.mid[i] != no_vertex);
    }
    return result;
}

} // namespace

void KeptCells::touch(const Cell& cell) {
    for (const auto* ids : {&cell.corner, &cell.mid})
        for (const std::uint32_t v : *ids)
            if (v < touched.size()) // not gone
                touched[v] = 1;
}

void KeptCells::leave_out(const Runs& replaced) {
    for (const Run& run : replaced.all())
        for (std::uint32_t i = run.begin; i < run.end; ++i)
            touch(cells[i]);
    for_each_gap(replaced, static_cast<std::uint32_t>(cells.size()),
                 [&](std::uint32_t begin, std::uint32_t end) {
                     for (std::uint32_t i = begin; i < end; ++i)
                         if (is_touched(cells[i], touched))
                             near.push_back(i);
                 });
}

KeptCells keep_cells(const Runs& removed_vertices,
                     std::uint32_t vertices_before,
                     const Runs& removed_cells,
                     std::span<const Cell> before) {
    KeptCells kept;
    kept.stay = vertices_before - removed_vertices.count();
    kept.touched.assign(kept.stay, 0);
    if (removed_vertices.count() == 0) {
        kept.cells = without(removed_cells, before);
        for (const Run& run : removed_cells.all())
            for (std::uint32_t i = run.begin; i < run.end; ++i)
                kept.touch(before[i]);
        return kept;
    }
    kept.now = numbers_after(removed_vertices, vertices_before);
    kept.cells.reserve(before.size() - removed_cells.count());
    for_each_gap(removed_cells, static_cast<std::uint32_t>(before.size()),
                 [&](std::uint32_t begin, std::uint32_t end) {
                     for (std::uint32_t i = begin; i < end; ++i) {
                         bool lost = false;
                         kept.cells.push_back(renumbered(before[i], kept.now, lost));
                         if (lost)
                             kept.touch(kept.cells.back());
                     }
                 });
    for (const Run& run : removed_cells.all())
        for (std::uint32_t i = run.begin; i < run.end; ++i) {
            bool lost = false;
            kept.touch(renumbered(before[i], kept.now, lost));
        }
    return kept;
}

} // namespace wakesurf::protocol
