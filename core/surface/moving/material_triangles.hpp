// The cells of a moving surface: a triangulation whose triangles are remembered in pairs, each of which is
// handed out as one quad. What changes it (split, flip, collapse, tear) does so on a few triangles; a vertex
// has one fan of triangles round it, unless contacts are allowed.
// Source: Krishnan, Garth, Joy, Time and Streak Surfaces for Flow Visualization in Large Time-Varying Data
// Sets, 2009.
#pragma once

#include "core/surface/moving/claims.hpp"
#include "core/surface/quad_complex.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
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
    /// The edge across which the other half of the quad is; `alone` without one.
    std::uint8_t mate = alone;
    bool live = false;
    /// An odd triangle has no other half. That it can be handed out as a quad, a vertex hangs in the middle of its edge
    /// `mate`: hanging().
    bool is_odd = false;

    bool odd() const { return is_odd; }

    bool paired() const { return mate != alone && !is_odd; }

    /// Edge that begins at a vertex, 3: the triangle does not have it.
    unsigned edge_from(VertexId v) const {
        // Which it is cannot be foreseen: with branches a scan took a quarter longer.
        return 3u - 3u * (vertex[0] == v) - 2u * (vertex[1] == v) - 1u * (vertex[2] == v);
    }

    VertexId begin(unsigned k) const { return vertex[k]; }

    VertexId end(unsigned k) const { return vertex[(k + 1) % 3]; }

    VertexId opposite(unsigned k) const { return vertex[(k + 2) % 3]; }
};

/// The lists that edits leave, in no order; the counts are what they add.
struct TriangleChanges {
    /// Triangles that have been made or changed; among them dead ones, and some more than once.
    std::vector<TriangleId> touched;
    /// Triangles that have lost their other half, or never had one; dead ones among them.
    std::vector<TriangleId> loose;
    /// Vertices that no triangle has any more, or that hang on none any more; some may be used again.
    std::vector<VertexId> left;
    std::vector<TriangleId> free; ///< slots
    std::ptrdiff_t odd = 0;       ///< triangles
};

/// Several threads may flip, split, collapse, pair and part at the same time as edit_round() says, each with changes of its
/// own.
class MaterialTriangles {
  public:
    /// Returns all slots, free ones included: see `live`.
    std::span<const Triangle> slots() const { return slots_; }

    const Triangle& operator[](TriangleId t) const { return slots_[t]; }

    std::size_t live() const { return slots_.size() - changes_.free.size(); }

    /// Returns how many quads are handed out.
    std::size_t quads() const { return (live() + static_cast<std::size_t>(changes_.odd) + 1) / 2; }

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

    /// From a to b, or else from b to a.
    Edge find_either_way(VertexId a, VertexId b) const {
        const Edge there = find(a, b);
        return there.triangle != no_triangle ? there : find(b, a);
    }

    /// Parts of the surface may touch at a vertex only. Nothing but append(), remove() and what they use may
    /// be used then.
    void allow_contacts() { contacts_ = true; }

    /// Adds quads of four corners, counter-clockwise, as pairs of triangles, linked among themselves and to
    /// the boundary edges of what is there. What would touch the surface at a vertex only is left out, unless
    /// contacts are allowed.
    void append(std::span<const std::array<VertexId, 4>> quads);

    /// Adds triangles, counter-clockwise, linked among themselves and to the boundary edges of what is there. They are the last
    /// of touched() then.
    void fill(std::span<const std::array<VertexId, 3>> triangles);

    /// Two empty slots for each of `count` edges to be split, with room for vertices up to the slot `vertices`.
    std::vector<std::array<TriangleId, 2>> slots_to_split(std::size_t count, std::size_t vertices);

    /// Puts vertex m in the middle of an edge. @param slots  of the triangles this makes
    void split(TriangleId t,
               unsigned k,
               VertexId m,
               const std::array<TriangleId, 2>& slots,
               TriangleChanges& changes);

    void split(TriangleId t, unsigned k, VertexId m) {
        split(t, k, m, slots_to_split(1, std::size_t{m} + 1).front(), changes_);
    }

    /// Turns an inner edge into the one between the vertices opposite to it. REQUIRES: no such edge.
    void flip(TriangleId t, unsigned k, TriangleChanges& changes);

    void flip(TriangleId t, unsigned k) { flip(t, k, changes_); }

    /// Returns true where taking `gone` into `kept`, its neighbour, leaves a surface: their common neighbours
    /// are those of their edge, and not two boundaries are joined. `ring` becomes the fan of `gone`.
    bool collapsible(VertexId gone, VertexId kept, std::vector<TriangleId>& ring) const;

    /// A hole of three edges, one of which goes, is closed. REQUIRES: collapsible(gone, kept, ring).
    void collapse(VertexId gone,
                  VertexId kept,
                  std::span<const TriangleId> ring,
                  TriangleChanges& changes);

    void collapse(VertexId gone, VertexId kept, std::span<const TriangleId> ring) {
        collapse(gone, kept, ring, changes_);
    }

    /// Takes a triangle out, and what would be left hanging at one vertex.
    void tear(TriangleId t);

    /// Takes a triangle out alone. What is left may hang together at a vertex only, see allow_contacts().
    void remove(TriangleId t);

    /// Makes the triangle beyond edge k the other half of `t`'s quad. REQUIRES: neither has another half.
    void pair(TriangleId t, unsigned k, std::uint32_t quad);

    /// A triangle without another half, which vertex `hanging` is to hang on in the middle of edge k.
    struct Odd {
        TriangleId triangle;
        unsigned k;
        VertexId hanging;
    };

    /// Gives triangles without another half quads of their own.
    void leave_odd(std::span<const Odd> triangles);

    /// Returns the vertex that hangs on an odd triangle. Cost: O(log(odd triangles)).
    VertexId hanging(TriangleId t) const;

    /// Takes the two halves of a quad apart, or the odd triangle's hanging vertex away.
    void part(TriangleId t, TriangleChanges& changes);

    void part(TriangleId t) { part(t, changes_); }

    /// Adds what edits have changed.
    void add(const TriangleChanges& changes);

    /// Of the lists of TriangleChanges, since they were last cleared.
    std::vector<TriangleId>& touched() { return changes_.touched; }

    std::vector<TriangleId>& loose() { return changes_.loose; }

    std::vector<VertexId>& left() { return changes_.left; }

    /// Returns the first of `count` ids of quads.
    std::uint32_t take_ids(std::size_t count) {
        return std::exchange(next_id_, next_id_ + static_cast<std::uint32_t>(count));
    }

    /// The vertices, or triangles, that the edits of a round have taken.
    Claims& claims() { return claims_; }

    std::uint32_t next_id() const { return next_id_; }

    /// Sets the id of the first triangle. REQUIRES: none has been made.
    void number_from(std::uint32_t first) { next_id_ = first; }

    /// Moves triangles and vertices to the slots they have in `order` and `vertex_slot`. For keeping memory
    /// in mesh order.
    void renumber(std::span<const TriangleId> order, std::span<const VertexId> vertex_slot);

    std::size_t bytes() const {
        return slots_.capacity() * sizeof(Triangle) + of_.capacity() * sizeof(TriangleId) +
               uses_.capacity() * sizeof(std::uint16_t) + claims_.bytes() +
               (changes_.touched.capacity() + changes_.loose.capacity() + changes_.left.capacity() +
                changes_.free.capacity()) *
                   sizeof(TriangleId) +
               odd_.capacity() * sizeof(Odd);
    }

    /// Returns the first violation of what keeps the links sound, or nothing: those of neighbours answer each
    /// other, each vertex has one fan, halves of quads know each other. Cost: O(triangles).
    std::string violation() const;

  private:
    /// A directed edge, and a triangle that has it.
    struct OpenEdge {
        VertexId from, to;
        TriangleId triangle;
    };

    TriangleId empty_slot();
    void make_room(std::size_t vertices);
    void make(TriangleId t, const std::array<VertexId, 3>& vertices, TriangleChanges& changes);
    TriangleId add(VertexId a, VertexId b, VertexId c);
    void add_open(VertexId v, std::vector<OpenEdge>& open) const;
    void relink(TriangleId t, VertexId begin, TriangleId to);
    void change(TriangleId t, TriangleChanges& changes);
    void zip(VertexId v, TriangleChanges& changes);
    VertexId beyond_boundary(VertexId v, std::span<const TriangleId> ring, VertexId other) const;
    bool one_fan(VertexId v) const;

    std::vector<Triangle> slots_;
    std::vector<TriangleId> of_;      ///< of vertex slots: one triangle
    std::vector<std::uint16_t> uses_; ///< of vertex slots: by triangles
    std::vector<Odd> odd_;            ///< in the order of triangles, which may not be odd any more
    TriangleChanges changes_;
    Claims claims_;
    bool contacts_ = false;
    std::uint32_t next_id_ = 0;
};

} // namespace wakesurf::core
