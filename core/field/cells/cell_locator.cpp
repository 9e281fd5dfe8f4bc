#include "core/field/cells/cell_locator.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <limits>

namespace wakesurf::core {

namespace {

Box box_of(const CellMesh& mesh, const MeshCell& cell) {
    Box box{mesh.points[cell.node[0]], mesh.points[cell.node[0]]};
    for (std::size_t i = 1; i < node_count(cell.shape); ++i) {
        // In this order a NaN stays: such a cell must not be found.
        box.lo = glm::min(mesh.points[cell.node[i]], box.lo);
        box.hi = glm::max(mesh.points[cell.node[i]], box.hi);
        if (!finite(mesh.points[cell.node[i]]))
            box.lo = Vec3(std::numeric_limits<double>::quiet_NaN());
    }
    return box;
}

/// True where a plane along one of the cell's faces has all nodes on one side of it and `p` beyond them: the
/// cell is within the hull of its nodes.
bool beyond_nodes(const CellGeometry& geometry, const Vec3& p) {
    const CellShape shape = geometry.shape();
    std::array<Vec3, 8> node;
    const std::size_t count = node_count(shape);
    for (std::size_t i = 0; i < count; ++i)
        node[i] = geometry.position(node_local(shape, i)) - p;
    for (std::size_t f = 0; f < face_count(shape); ++f) {
        const CellFace corner = face(shape, f);
        const auto at = [&](std::size_t i) { return node[corner.node[i]]; };
        const Vec3 normal = corner.count == 3 ? glm::cross(at(1) - at(0), at(2) - at(0))
                                              : glm::cross(at(2) - at(0), at(3) - at(1));
        double least = glm::dot(normal, node[0]), most = least;
        for (std::size_t i = 1; i < count; ++i) {
            least = std::min(least, glm::dot(normal, node[i]));
            most = std::max(most, glm::dot(normal, node[i]));
        }
        const double tolerance = 1e3 * face_tolerance * (most - least);
        if (least > tolerance || most < -tolerance)
            return true;
    }
    return false;
}

} // namespace

bool contains(CellGeometry& geometry, const Vec3& p, Vec3& local) {
    if (geometry.flat() || geometry.surely_outside(p))
        return false;
    local = cell_centre(geometry.shape());
    if (geometry.invert(p, local))
        return inside_cell(geometry.shape(), local);
    if (beyond_nodes(geometry, p))
        return false;
    for (const double w : {0.1, 0.9}) // twisted: from near every corner
        for (const double v : {0.1, 0.9})
            for (const double u : {0.1, 0.9}) {
                local = clamp_to_cell(geometry.shape(), {u, v, w});
                if (geometry.invert(p, local) && inside_cell(geometry.shape(), local))
                    return true;
            }
    return false;
}

CellLocator::CellLocator(const CellMesh& mesh) : mesh_(mesh) {
    std::vector<FloatBox> boxes(mesh.cells.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes.size(), 4096),
                      [&](const auto& some) {
                          for (std::size_t i = some.begin(); i != some.end(); ++i)
                              boxes[i] = rounded_outward(box_of(mesh, mesh.cells[i]));
                      });
    tree_ = BoxTree(boxes);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Box all{Vec3(infinite), Vec3(-infinite)};
    for (const MeshCell& cell : mesh.cells)
        for (std::size_t i = 0; i < node_count(cell.shape); ++i)
            if (const Vec3& p = mesh.points[cell.node[i]]; finite(p)) {
                all.lo = glm::min(all.lo, p);
                all.hi = glm::max(all.hi, p);
            }
    bounds_ = mesh.cells.empty() ? Box{} : all;
}

std::optional<CellPlace> CellLocator::find(const Vec3& p, CellGeometry& geometry) const {
    std::optional<CellPlace> found;
    if (!finite(p))
        return found;
    std::uint32_t entered = BoxTree::none();
    tree_.visit(p, [&](std::uint32_t cell) {
        if (found && found->cell < cell)
            return false;
        geometry.enter(mesh_, entered = cell);
        if (Vec3 local; contains(geometry, p, local))
            found = CellPlace{cell, local};
        return false;
    });
    if (found && found->cell != entered)
        geometry.enter(mesh_, found->cell);
    return found;
}

std::optional<std::uint32_t> CellLocator::near(const Vec3& p) const {
    const std::uint32_t cell = tree_.nearest(p);
    return cell == BoxTree::none() ? std::nullopt : std::optional(cell);
}

} // namespace wakesurf::core
