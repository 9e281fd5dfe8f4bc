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

} // namespace

WireTopology::WireTopology(std::vector<Cell> all, std::size_t vertices)
    : cells(std::move(all)), neighbours(vertices) {
    Finder find(neighbours);
    for (const Cell& cell : cells)
        find.add(cell);
}

WireTopology::WireTopology(const WireTopology& before, std::vector<Cell> all, std::size_t vertices)
    : cells(std::move(all)) {
    neighbours.reserve(vertices);
    neighbours = before.neighbours;
    neighbours.resize(vertices);
    Finder find(neighbours);
    for (std::size_t i = before.cells.size(); i < cells.size(); ++i)
        find.add(cells[i]);
}

} // namespace wakesurf::protocol
