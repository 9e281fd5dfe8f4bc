#include "protocol/wire/wire_topology.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::protocol {

namespace {

using core::Cell;
using core::no_vertex;

/// Finds the neighbours of vertices, cell after cell. Adding a cell again makes no difference.
class Finder {
  public:
    explicit Finder(std::vector<Neighbours>& of) : of_(of) {}

    void add(const Cell& cell) {
        join_outline(cell);
        complete_highest_corner(cell);
        complete_mids(cell);
    }

  private:
    void join(std::uint32_t u, std::uint32_t w) {
        const std::uint32_t upper = std::max(u, w);
        if (u == w)
            return;
        const std::uint32_t low = std::min(u, w);
        Neighbours& high = of_[upper];
        high.lowest = std::min(high.lowest, low);
        // No vertex is -1, and without a branch this takes half the time.
        high.highest = static_cast<std::uint32_t>(
            std::max(static_cast<std::int32_t>(high.highest), static_cast<std::int32_t>(low)));
    }

    void join_outline(const Cell& cell) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t from = cell.corner[i];
            const std::uint32_t to = cell.corner[(i + 1) % 4];
            const std::uint32_t mid = cell.mid[i];
            if (mid == no_vertex) {
                join(from, to);
            } else {
                join(from, mid);
                join(mid, to);
            }
        }
    }

    /// Only a cell's highest corner can have the other three below it.
    void complete_highest_corner(const Cell& cell) {
        const auto& c = cell.corner;
        const std::size_t one = c[0] >= c[1] ? 0 : 1;
        const std::size_t other = c[2] >= c[3] ? 2 : 3;
        const std::size_t i = c[one] >= c[other] ? one : other;
        const std::uint32_t p = c[(i + 3) % 4];
        const std::uint32_t n = c[(i + 1) % 4];
        const std::uint32_t o = c[(i + 2) % 4];
        Neighbours& highest = of_[c[i]];
        if (highest.beside == no_vertex && p < c[i] && n < c[i] && o < c[i]) {
            highest.beside = p;
            highest.beside2 = n;
            highest.opposite = o;
        }
    }

    void complete_mids(const Cell& cell) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t mid = cell.mid[i];
            const std::uint32_t from = cell.corner[i];
            const std::uint32_t to = cell.corner[(i + 1) % 4];
            if (mid == no_vertex || from >= mid || to >= mid)
                continue;
            Neighbours& hanging = of_[mid];
            if (hanging.beside == no_vertex || hanging.opposite != no_vertex)
                hanging = {hanging.highest, hanging.lowest, from, to, no_vertex};
        }
    }

    std::vector<Neighbours>& of_;
};

Neighbours renumbered(const Neighbours& near, std::span<const std::uint32_t> now) {
    const auto number = [now](std::uint32_t v) { return v == no_vertex ? no_vertex : now[v]; };
    return {number(near.highest), number(near.lowest), number(near.beside), number(near.beside2),
            number(near.opposite)};
}

/// Whether a cell that replaces another takes a vertex that has lost nothing: which cell is the first there may then be another
/// one. Forgets the neighbours of those.
bool forget_taken(const TopologyEdit& edit,
                  const KeptCells& kept,
                  std::vector<Neighbours>& neighbours) {
    bool taken = false;
    for (const Cell& cell : std::span(edit.cells).first(edit.replaced_cells.count()))
        for (const auto* ids : {&cell.corner, &cell.mid})
            for (const std::uint32_t v : *ids)
                if (v < kept.stay && kept.touched[v] == 0) {
                    neighbours[v] = {};
                    taken = true;
                }
    return taken;
}

} // namespace

WireTopology::WireTopology(std::vector<Cell> all, std::size_t vertices)
    : cells(std::move(all)), neighbours(vertices) {
    Finder find(neighbours);
    for (const Cell& cell : cells)
        find.add(cell);
}

WireTopology::WireTopology(const WireTopology& before,
                           const KeptCells& kept,
                           const TopologyEdit& edit,
                           std::vector<Cell> all,
                           std::size_t vertices)
    : cells(std::move(all)) {
    // Vertices keep their order, so that which neighbour is the highest or the lowest stays as well.
    neighbours.reserve(vertices);
    if (kept.now.empty())
        neighbours = before.neighbours;
    else
        for (std::size_t v = 0; v < kept.now.size(); ++v)
            if (kept.now[v] != no_vertex)
                neighbours.push_back(renumbered(before.neighbours[v], kept.now));
    neighbours.resize(vertices);
    for (std::size_t v = 0; v < kept.stay; ++v)
        if (kept.touched[v] != 0)
            neighbours[v] = {};
    Finder find(neighbours);
    if (forget_taken(edit, kept, neighbours)) {
        for (const Cell& cell : cells)
            find.add(cell);
        return;
    }
    auto near = kept.near.begin();
    for (const Run& run : edit.replaced_cells.all()) {
        for (; near != kept.near.end() && *near < run.begin; ++near)
            find.add(cells[*near]);
        for (std::uint32_t i = run.begin; i < run.end; ++i)
            find.add(cells[i]);
    }
    for (; near != kept.near.end(); ++near)
        find.add(cells[*near]);
    for (std::size_t i = cells.size() - edit.added_cells; i < cells.size(); ++i)
        find.add(cells[i]);
}

} // namespace wakesurf::protocol
