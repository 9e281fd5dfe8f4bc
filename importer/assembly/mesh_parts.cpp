#include "importer/assembly/mesh_parts.hpp"

#include "core/base/rounding.hpp"
#include "core/dataset/cell_neighbours.hpp"
#include "core/field/cells/cell_locator.hpp"
#include "importer/assembly/point_merging.hpp"
#include "importer/base/text.hpp"

#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace wakesurf::importer {

using core::CellMesh;
using core::Vec3;

namespace {

/// The number of groups of parts that are measured at most.
constexpr std::size_t most_measured = 16;

/// Returns for each cell the lowest cell of its part.
std::vector<std::uint32_t> parts_of(const CellMesh& mesh) {
    DisjointSets sets(mesh.cells.size());
    for (std::uint32_t i = 0; i < mesh.cells.size(); ++i)
        for (const std::uint32_t next : mesh.cells[i].beyond)
            if (next < mesh.cells.size())
                sets.join(i, next);
    std::vector<std::uint32_t> out(mesh.cells.size());
    for (std::uint32_t i = 0; i < out.size(); ++i)
        out[i] = sets.lowest(i);
    return out;
}

struct Face {
    Vec3 centre{0.0};
    Vec3 outward{0.0}; ///< of length 1, or 0
};

Face face_of(const CellMesh& mesh, const core::BoundaryFace& at) {
    const core::MeshCell& cell = mesh.cells[at.cell];
    const core::CellFace corners = core::face(cell.shape, at.face);
    const auto point = [&](std::size_t i) {
        return mesh.points[cell.node[corners.node[i % corners.count]]];
    };
    Face face;
    for (std::size_t i = 0; i < corners.count; ++i)
        face.centre += point(i) / double(corners.count);
    Vec3 middle(0.0);
    for (std::size_t i = 0; i < core::node_count(cell.shape); ++i)
        middle += mesh.points[cell.node[i]] / double(core::node_count(cell.shape));
    const Vec3 normal = corners.count == 3 ? glm::cross(point(1) - point(0), point(2) - point(0))
                                           : glm::cross(point(2) - point(0), point(3) - point(1));
    if (const double length = glm::length(normal); length > 0.0)
        face.outward = normal / (glm::dot(normal, face.centre - middle) < 0.0 ? -length : length);
    return face;
}

/// Returns true if a place is in a cell or in one beside it.
bool in_or_beside(const CellMesh& mesh, std::uint32_t number, const Vec3& place) {
    core::CellGeometry geometry;
    Vec3 local;
    const auto holds = [&](std::uint32_t cell) {
        geometry.enter(mesh, cell);
        return core::contains(geometry, place, local);
    };
    const auto& beyond = mesh.cells[number].beyond;
    return holds(number) || std::any_of(beyond.begin(), beyond.end(), [&](std::uint32_t next) {
               return next < mesh.cells.size() && holds(next);
           });
}

class Parts {
  public:
    explicit Parts(const CellMesh& mesh)
        : mesh_(mesh), part_(parts_of(mesh)), faces_(core::boundary_faces(mesh)),
          groups_(mesh.cells.size()) {}

    std::string note() {
        if (std::all_of(part_.begin(), part_.end(), [](std::uint32_t part) { return part == 0; }))
            return {};
        look_beyond_faces();
        std::string out;
        if (!over_.empty())
            add_note(out, std::to_string(over_.size()) +
                              (over_.size() == 1 ? " part lies" : " parts lie") +
                              " over others, as fine levels over coarse ones: a particle stays in "
                              "the part that it is in");
        add_note(out, note_on_gaps());
        return out;
    }

  private:
    // Joins the parts that touch, and finds those that overlap.
    void look_beyond_faces() {
        const core::CellLocator locator(mesh_);
        const core::Vec3 off = core::rounding(locator.bounds());
        const double step = 2.0 * std::max({off.x, off.y, off.z});
        core::CellGeometry geometry;
        for (const auto& at : faces_) {
            const Face face = face_of(mesh_, at);
            const auto found = locator.find(face.centre + step * face.outward, geometry);
            if (!found || part_[found->cell] == part_[at.cell])
                continue;
            groups_.join(part_[found->cell], part_[at.cell]);
            if (in_or_beside(mesh_, found->cell, face.centre - step * face.outward))
                ++over_[part_[at.cell]];
        }
    }

    std::string note_on_gaps() {
        std::map<std::uint32_t, std::vector<std::uint32_t>> nodes; // at the border of each group
        for (const auto& at : faces_) {
            auto& here = nodes[groups_.lowest(part_[at.cell])];
            for (const std::uint32_t node : core::face_nodes(mesh_.cells[at.cell], at.face))
                if (node < mesh_.points.size())
                    here.push_back(node);
        }
        if (nodes.size() < 2)
            return {};
        double least = HUGE_VAL;
        double most = 0.0;
        std::size_t measured = 0;
        for (const auto& [group, own] : nodes) {
            if (measured++ == most_measured)
                break;
            const double gap = gap_to_others(nodes, group);
            least = std::min(least, gap);
            most = std::max(most, gap);
        }
        const std::string width = most - least > 1e-3 * most
                                      ? length_text(least) + " to " + length_text(most)
                                      : length_text(least);
        return "the cells are in " + std::to_string(nodes.size()) +
               " parts that do not touch: they are " + width + " apart, and particles end there";
    }

    double gap_to_others(const std::map<std::uint32_t, std::vector<std::uint32_t>>& nodes,
                         std::uint32_t group) const {
        auto points = vtkSmartPointer<vtkPoints>::New();
        points->SetDataTypeToDouble();
        for (const auto& [other, list] : nodes)
            for (const std::uint32_t node : other == group ? std::vector<std::uint32_t>() : list)
                points->InsertNextPoint(&mesh_.points[node][0]);
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points);
        auto locator = vtkSmartPointer<vtkStaticPointLocator>::New();
        locator->SetDataSet(data);
        locator->BuildLocator();
        double least = HUGE_VAL;
        for (const std::uint32_t node : nodes.at(group)) {
            const Vec3& p = mesh_.points[node];
            Vec3 near;
            points->GetPoint(locator->FindClosestPoint(&p[0]), &near[0]);
            least = std::min(least, glm::length(near - p));
        }
        return least;
    }

    const CellMesh& mesh_;
    std::vector<std::uint32_t> part_;
    std::vector<core::BoundaryFace> faces_;
    DisjointSets groups_;
    std::map<std::uint32_t, std::size_t> over_; ///< faces of each part that lie in another one
};

} // namespace

std::string note_on_parts(const CellMesh& mesh) {
    return Parts(mesh).note();
}

} // namespace wakesurf::importer
