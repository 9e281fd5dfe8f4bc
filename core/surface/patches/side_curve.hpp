// The sides of a surface's cells as curves. Two vertices beside each other are joined by a cubic that touches
// the surface at both: its distance from the surface is of fourth order in its length. Source: Schneider,
// Wiebel, Scheuermann, Smooth Stream Surfaces of Fourth Order Precision, EuroVis 2009, with the tangent
// planes of Vlachos et al., Curved PN Triangles, 2001.
#pragma once

#include "core/surface/patches/patch_point.hpp"
#include "core/surface/quad_complex.hpp"

#include <optional>
#include <span>
#include <vector>

namespace wakesurf::core {

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
