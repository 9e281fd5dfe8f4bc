#include "protocol/wire_topology.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::protocol {

namespace {

using core::Cell;
using core::no_vertex;

/// Finds the neighbours of all vertices, or only of those marked.
template <class Wanted>
class Finder {
  public:
    Finder(std::vector<Neighbours>& of, Wanted wanted) : of_(of), wanted_(wanted) {}

    void add(const Cell& cell) {
        join_outline(cell);
        complete_highest_corner(cell);
        complete_mids(cell);
    }

  private:
    void join(std::uint32_t u, std::uint32_t w) {
        const std::uint32_t upper = std::max(u, w);
        if (u == w || !wanted_(upper))
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
        if (highest.beside == no_vertex && p < c[i] && n < c[i] && o < c[i] && wanted_(c[i])) {
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
            if (mid == no_vertex || from >= mid || to >= mid || !wanted_(mid))
                continue;
            Neighbours& hanging = of_[mid];
            if (hanging.beside == no_vertex || hanging.opposite != no_vertex)
                hanging = {hanging.highest, hanging.lowest, from, to, no_vertex};
        }
    }

    std::vector<Neighbours>& of_;
    Wanted wanted_;
};

bool any(const Cell& cell, std::span<const std::uint8_t> marked) {
    const auto& [c, m] = cell;
    unsigned found = marked[c[0]] | marked[c[1]] | marked[c[2]] | marked[c[3]];
    if ((m[0] & m[1] & m[2] & m[3]) != no_vertex)
        for (const std::uint32_t mid : m)
            found |= mid == no_vertex ? 0u : marked[mid];
    return found != 0;
}

Neighbours renumbered(const Neighbours& near, std::span<const std::uint32_t> now) {
    const auto number = [now](std::uint32_t v) { return v == no_vertex ? no_vertex : now[v]; };
    return {number(near.highest), number(near.lowest), number(near.beside), number(near.beside2),
            number(near.opposite)};
}

} // namespace

WireTopology::WireTopology(std::vector<Cell> all, std::size_t vertices)
    : cells(std::move(all)), neighbours(vertices) {
    Finder find(neighbours, [](std::uint32_t) { return true; });
    for (const Cell& cell : cells)
        find.add(cell);
}

WireTopology::WireTopology(const WireTopology& before,
                           const KeptCells& kept,
                           std::span<const Cell> changed,
                           std::vector<Cell> all,
                           std::size_t vertices)
    : cells(std::move(all)) {
    std::vector<std::uint8_t> marked = kept.touched;
    marked.resize(vertices, 1);
    for (const Cell& cell : changed)
        for (const auto* ids : {&cell.corner, &cell.mid})
            for (const std::uint32_t v : *ids)
                if (v != no_vertex)
                    marked[v] = 1;
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
        if (marked[v] != 0)
            neighbours[v] = {};
    Finder find(neighbours, [&](std::uint32_t v) { return marked[v] != 0; });
    for (const Cell& cell : cells)
        if (any(cell, marked))
            find.add(cell);
}

} // namespace wakesurf::protocol
