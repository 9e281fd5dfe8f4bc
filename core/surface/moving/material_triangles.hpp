// The cells of a moving surface: a triangulation whose triangles are remembered in pairs, each of which is
// handed out as one quad. What changes it (split, flip, collapse, tear) does so on a few triangles; a vertex
// has one fan of triangles round it, unless contacts are allowed.
// Source: Krishnan, Garth, Joy, Time and Streak Surfaces for Flow Visualization in Large Time-Varying Data
// Sets, 2009.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace wakesurf::core {

using TriangleId = std::uint32_t;
inline constexpr TriangleId no_triangle = 0xffffffffu;

struct Triangle {
    static constexpr std::uint8_t alone = 3;

    std::array<VertexId, 3> vertex; ///< slots
    /// The triangle beyond the edge from vertex[k] to vertex[k + 1], at index k.
    std::array<TriangleId, 3> across{no_triangle, no_triangle, no_triangle};
    std::uint32_t quad = 0; ///< what the pair is called; never used again within a surface
    /// A vertex in the middle of the edge `mate` of an odd triangle, which has no other half, so that it can
    /// be handed out as a quad.
    VertexId hanging = no_vertex;
    /// The edge across which the other half of the quad is; `alone` without one.
    std::uint8_t mate = alone;
    bool live = false;

    bool odd() const { return hanging != no_vertex; }

    bool paired() const { return mate != alone && hanging == no_vertex; }

    /// Edge that begins at a vertex, 3: the triangle does not have it.
    unsigned edge_from(VertexId v) const {
        // Which it is cannot be foreseen: with branches a scan took a quarter longer.
        return 3u - 3u * (vertex[0] == v) - 2u * (vertex[1] == v) - 1u * (vertex[2] == v);
    }

    VertexId begin(unsigned k) const { return vertex[k]; }

    VertexId end(unsigned k) const { return vertex[(k + 1) % 3]; }

    VertexId opposite(unsigned k) const { return vertex[(k + 2) % 3]; }
};

class MaterialTriangles {
  public:
    /// Returns all slots, free ones included: see `live`.
    std::span<const Triangle> slots() const { return slots_; }

    const Triangle& operator[](TriangleId t) const { return slots_[t]; }

    std::size_t live() const { return slots_.size() - free_.size(); }

    /// Returns how many quads are handed out.
    std::size_t quads() const { return (live() + odd_ + 1) / 2; }

    /// No triangle has the vertex.
    bool unused(VertexId v) const { return v >= uses_.size() || uses_[v] == 0; }

    /// The triangles round a vertex, counter-clockwise, from the boundary where there is one. Returns true
    /// where there is.
    /// REQUIRES: !unused(v).
    bool fan(VertexId v, std::vector<TriangleId>& out) const;

    /// Returns which edge of the triangle beyond edge k of `t` is the same edge. REQUIRES: there is one.
    unsigned facing(TriangleId t, unsigned k) const {
        return slots_[slots_[t].across[k]].edge_from(slots_[t].end(k));
    }

    /// Returns the vertex opposite to edge k of `t` in the triangle beyond it. REQUIRES: there is one.
    VertexId opposite_beyond(TriangleId t, unsigned k) const {
        return slots_[slots_[t].across[k]].opposite(facing(t, k));
    }

    struct Edge {
        TriangleId triangle;
        unsigned k;
    };

    /// The triangle and edge from a to b; no_triangle where there is none. Cost: O(fan).
    Edge find(VertexId a, VertexId b) const;

    /// Parts of the surface may touch at a vertex only. Nothing but append(), remove() and what they use may
    /// be used then.
    void allow_contacts() { contacts_ = true; }

    /// Adds quads of four corners, counter-clockwise, as pairs of triangles, linked among themselves and to
    /// the boundary edges of what is there. What would touch the surface at a vertex only is left out, unless
    /// contacts are allowed.
    void append(std::span<const std::array<VertexId, 4>> quads);

    /// Adds triangles, counter-clockwise, that close a hole of the surface together.
    void fill(std::span<const std::array<VertexId, 3>> triangles);

    /// Puts vertex m in the middle of an edge.
    void split(TriangleId t, unsigned k, VertexId m);

    /// Turns an inner edge into the one between the vertices opposite to it. REQUIRES: no such edge.
    void flip(TriangleId t, unsigned k);

    /// Returns true where taking `gone` into `kept`, its neighbour, leaves a surface: their common neighbours
    /// are those of their edge, and not two boundaries are joined. `ring` becomes the fan of `gone`.
    bool collapsible(VertexId gone, VertexId kept, std::vector<TriangleId>& ring) const;

    /// A hole of three edges, one of which goes, is closed. REQUIRES: collapsible(gone, kept, ring).
    void collapse(VertexId gone, VertexId kept, std::span<const TriangleId> ring);

    /// Takes a triangle out, and what would be left hanging at one vertex.
    void tear(TriangleId t);

    /// Takes a triangle out alone. What is left may hang together at a vertex only, see allow_contacts().
    void remove(TriangleId t);

    /// Makes the triangle beyond edge k the other half of `t`'s quad. REQUIRES: neither has another half.
    void pair(TriangleId t, unsigned k, std::uint32_t quad);

    /// Gives a triangle without another half a quad of its own.
    void leave_odd(TriangleId t, unsigned k, VertexId hanging, std::uint32_t quad);

    /// Takes the two halves of a quad apart, or the odd triangle's hanging vertex away.
    void part(TriangleId t);

    /// Triangles that have been made or changed since the list was last cleared; among them dead ones, and
    /// some more than once.
    std::vector<TriangleId>& touched() { return touched_; }

    /// Triangles that have lost their other half, or never had one, since the list was last cleared; dead
    /// ones among them.
    std::vector<TriangleId>& loose() { return loose_; }

    /// Vertices that no triangle has any more, or that hang on none any more, since the list was last cleared; some may be used again.
    std::vector<VertexId>& left() { return left_; }

    std::uint32_t take_id() { return next_id_++; }

    std::uint32_t next_id() const { return next_id_; }

    /// Sets the id of the first triangle. REQUIRES: none has been made.
    void number_from(std::uint32_t first) { next_id_ = first; }

    /// Moves triangles and vertices to the slots they have in `order` and `vertex_slot`. For keeping memory
    /// in mesh order.
    void renumber(std::span<const TriangleId> order, std::span<const VertexId> vertex_slot);

    std::size_t bytes() const {
        return slots_.capacity() * sizeof(Triangle) + free_.capacity() * sizeof(TriangleId) +
               of_.capacity() * sizeof(TriangleId) + uses_.capacity() * sizeof(std::uint16_t) +
               (touched_.capacity() + loose_.capacity() + left_.capacity()) * sizeof(TriangleId);
    }

    /// Returns the first violation of what keeps the links sound, or nothing: those of neighbours answer each
    /// other, each vertex has one fan, halves of quads know each other. Cost: O(triangles).
    std::string violation() const;

  private:
    /// By directed edge. Never iterated: its order decides nothing.
    using OpenEdges = std::unordered_map<std::uint64_t, TriangleId>;

    TriangleId add(VertexId a, VertexId b, VertexId c);
    void add_open(VertexId v, OpenEdges& open) const;
    void link(std::span<const TriangleId> made, OpenEdges& open);
    void relink(TriangleId t, TriangleId from, TriangleId to);
    void change(TriangleId t);
    void zip(VertexId v);
    VertexId beyond_boundary(VertexId v, std::span<const TriangleId> ring, VertexId other) const;
    bool one_fan(VertexId v) const;

    std::vector<Triangle> slots_;
    std::vector<TriangleId> free_;
    std::vector<TriangleId> of_;      ///< of vertex slots: one triangle
    std::vector<std::uint16_t> uses_; ///< of vertex slots: by triangles
    std::vector<TriangleId> touched_;
    std::vector<TriangleId> loose_;
    std::vector<VertexId> left_;
    std::size_t odd_ = 0;
    bool contacts_ = false;
    std::uint32_t next_id_ = 0;
};

} // namespace wakesurf::core
