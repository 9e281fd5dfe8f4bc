// The sides of a surface's cells: a number for each piece that two cells share, and its curve. Two vertices
// beside each other are joined by a cubic that touches the surface at both: its distance from the surface
// is of fourth order in its length. Source: Schneider, Wiebel, Scheuermann, Smooth Stream Surfaces of
// Fourth Order Precision, EuroVis 2009, with the tangent planes of Vlachos et al., Curved PN Triangles,
// 2001.
#pragma once

#include "core/base/vec3.hpp"
#include "core/surface/quad_complex.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::core {

/// The pieces of the sides of a mesh's cells, between one vertex and the next, each once: numbers for what
/// both cells beside one share.
class SideTable {
  public:
    /// Builds the table. Cost: O(cells), 28 bytes a cell.
    explicit SideTable(const QuadComplex& mesh);

    std::size_t count() const { return to_.size(); }

    /// Returns the number of the piece between two vertices that are beside each other, in either order.
    std::size_t number(VertexId a, VertexId b) const;

    /// Only one cell has it.
    bool outline(std::size_t number) const { return cells_[number] == 1; }

    struct Ends {
        VertexId a, b; ///< a < b
    };

    /// Calls visit(number, Ends) for all, in order.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (VertexId a = 0; a + 1 < first_.size(); ++a)
            for (std::size_t k = first_[a]; k < first_[a + 1]; ++k)
                visit(k, Ends{a, to_[k]});
    }

  private:
    std::vector<std::uint32_t> first_; ///< by the smaller vertex, where its pieces begin
    std::vector<VertexId> to_;         ///< the larger vertex
    std::vector<std::uint8_t> cells_;  ///< how many have it
};

/// A point of a surface between its vertices: its place, and the surface's two coordinates there. Points add
/// and scale, so that one formula interpolates all of it.
struct PatchPoint {
    Vec3 position{0.0};
    double s = 0.0;
    double t = 0.0;
};

inline PatchPoint operator+(const PatchPoint& a, const PatchPoint& b) {
    return {a.position + b.position, a.s + b.s, a.t + b.t};
}

inline PatchPoint operator-(const PatchPoint& a, const PatchPoint& b) {
    return {a.position - b.position, a.s - b.s, a.t - b.t};
}

inline PatchPoint operator*(double k, const PatchPoint& a) {
    return {k * a.position, k * a.s, k * a.t};
}

/// Returns the normal of length 1 of the plane that tangents span; nothing where they span none.
std::optional<Vec3> unit_normal(const SurfaceTangents& tangents);

/// A cubic by its ends and its slopes there, by the part of the way. Flat: the straight line.
struct SideCurve {
    PatchPoint a, b;
    PatchPoint slope_a, slope_b;
    bool flat = false;

    PatchPoint at(double part) const;
    PatchPoint slope(double part) const;
};

/// Makes the curves of a mesh with tangents.
///
/// Within the surface a curve sets out along its chord, in the tangent plane: however the flow has sheared
/// the surface's coordinates, that is no detour. Along the outline and along creases it is the line of the
/// surface's coordinates, so that these keep their shape. What no tangent is known for at one end follows the
/// other end, of third order. A curve is flat where tangents are missing at both ends or where they are wild:
/// the cubic would leave the chord by more than a quarter of it, a tangent plane is more than 37 degrees from
/// the chord, or the two are more than 75 degrees from each other.
class SideCurves {
  public:
    /// @param mesh     outlives it. REQUIRES: it has tangents
    /// @param creases  values of s in ascending order where the rake has corners: tangents there are those of
    ///                 what comes after
    /// @param closed   s goes round
    SideCurves(const QuadComplex& mesh, std::vector<double> creases, bool closed)
        : mesh_(mesh), creases_(std::move(creases)), closed_(closed) {}

    /// @param outline  no other cell has the side
    SideCurve between(VertexId a, VertexId b, bool outline) const;

    /// Returns the normal, of length 1, of the part of the surface that lies towards another vertex; nothing
    /// where the tangents do not say.
    std::optional<Vec3> normal(VertexId at, VertexId towards) const;

    /// Returns a direction at a vertex, in the tangent plane there, and what the coordinates change by along
    /// it.
    PatchPoint along(VertexId at, const Vec3& direction) const;

    /// Returns the difference from one vertex to another the short way round.
    double s_between(VertexId from, VertexId to) const;

    bool closed() const { return closed_; }

    const QuadComplex& mesh() const { return mesh_; }

  private:
    bool on_crease(VertexId v) const;

    const QuadComplex& mesh_;
    std::vector<double> creases_;
    bool closed_;
};

} // namespace wakesurf::core
