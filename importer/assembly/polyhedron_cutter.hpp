// Polyhedra -> cells of the four shapes of a CellMesh. A polyhedron that is one of these shapes becomes that;
// others are cut round a node of their own into a pyramid for each face of 4 corners and a tetrahedron for
// each triangle of every other face. Faces of 3 and 4 corners stay whole and larger ones are cut the same way
// from both sides: conforming, without cracks where cells of two sizes meet.
#pragma once

#include "core/dataset/cell_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::importer {

/// Nodes that a mesh has besides the points of its source: the apex of a polyhedron, the centre of a face of five corners or
/// more. Their values are weighted means of other nodes'. Node i has the number `nodes of the source` + i and the parts first[i] .. first[i +
/// 1].
struct AddedNodes {
    std::vector<std::size_t> first{0};
    std::vector<std::uint32_t> node; ///< of the source
    std::vector<double> weight;      ///< of a node's parts: sums to 1

    std::size_t size() const { return first.size() - 1; }
};

/// Returns the volume, negative for a cell numbered inside out. A face of 4 nodes counts as 4 triangles round
/// its centre.
double cell_volume(const core::MeshCell& cell, std::span<const core::Vec3> points);

enum class Turned { Kept, Reordered, Flat };

/// Makes the volume positive by numbering the nodes the other way round. Returns Flat if the volume is below
/// rounding errors of the coordinates.
Turned turn_outside_out(core::MeshCell& cell, std::span<const core::Vec3> points);

using Polygon = std::vector<std::uint32_t>; ///< node numbers in turn

/// Returns the tetrahedron, pyramid, wedge or hexahedron that has these faces, perhaps inside out; empty for
/// any other body.
std::optional<core::MeshCell> standard_cell(std::span<const Polygon> faces);

class PolyhedronCutter {
  public:
    /// REQUIRES: mesh and nodes outlive this; mesh.points holds all nodes of the source and nothing else.
    PolyhedronCutter(core::CellMesh& mesh, AddedNodes& added) : mesh_(mesh), added_(added) {}

    /// Appends the cells of one polyhedron. The faces may be oriented any way; they come back oriented alike.
    void cut(std::vector<Polygon>& faces);

    /// Counts polyhedra that overlap themselves however they are cut: they are not star-shaped, seen from the
    /// mean of their nodes or from their centre of volume.
    std::size_t overlapping() const { return overlapping_; }

  private:
    struct Apex {
        core::Vec3 at{0.0};
        std::map<std::uint32_t, double> weights;
    };

    Apex mean_apex(std::span<const Polygon> faces) const;
    Apex middle_of(const Polygon& face) const;
    Apex centre_of_volume(std::span<const Polygon> faces, const Apex& mean) const;
    bool sees_all(std::span<const Polygon> faces, const core::Vec3& apex) const;
    std::uint32_t face_centre(const Polygon& face);
    std::uint32_t add(const Apex& apex);
    void emit(core::CellShape shape, std::span<const std::uint32_t> base, std::uint32_t apex);

    core::CellMesh& mesh_;
    AddedNodes& added_;
    /// Maps the sorted nodes of a face to its centre, until its other side is cut.
    std::map<Polygon, std::uint32_t> centres_;
    std::size_t overlapping_ = 0;
};

} // namespace wakesurf::importer
