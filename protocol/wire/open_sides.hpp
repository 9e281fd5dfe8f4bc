// The sides of cells that have no neighbour yet: a cell that comes later is most likely to lie along some of them.
// protocol/wire/README.md, Cells code. Twin: web-client/src/protocol/openSides.ts.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::protocol {

/// Sides, or the halves of those with a mid, by the vertices at their ends: of each vertex at most one that leaves it and one
/// that arrives. On a surface there are no more, except where two corners meet in a point; there the older is forgotten.
class OpenSides {
  public:
    /// @param vertices  all ids are below
    explicit OpenSides(std::uint32_t vertices)
        : leaves_to_(vertices, core::no_vertex), arrives_from_(vertices, core::no_vertex) {}

    /// A side of a cell, counter-clockwise from `x` to `y`: closes the neighbour's, from `y` to `x`, or is open now.
    void join(std::uint32_t x, std::uint32_t y) {
        if (leaves_to_[y] == x || arrives_from_[x] == y) {
            if (leaves_to_[y] == x)
                leaves_to_[y] = core::no_vertex;
            if (arrives_from_[x] == y)
                arrives_from_[x] = core::no_vertex;
        } else {
            leaves_to_[x] = y;
            arrives_from_[y] = x;
        }
    }

    /// The outline of a cell, in order.
    template <class Vertices>
    void join_outline(const Vertices& vertex, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            join(vertex[i], vertex[i + 1 < count ? i + 1 : 0]);
    }

    /// The vertex after `v` round a cell that closes the open side at `v`; `core::no_vertex` where none is known.
    std::uint32_t after(std::uint32_t v) const { return arrives_from_[v]; }

    /// The vertex before `v`, likewise.
    std::uint32_t before(std::uint32_t v) const { return leaves_to_[v]; }

  private:
    std::vector<std::uint32_t> leaves_to_;
    std::vector<std::uint32_t> arrives_from_;
};

} // namespace wakesurf::protocol
