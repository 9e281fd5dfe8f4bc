#include "importer/assembly/wall_assembly.hpp"

#include "importer/assembly/mesh_assembly.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkIdList.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <unordered_map>

namespace wakesurf::importer {

using core::BoundaryFace;
using core::CellMesh;
using core::MeshCell;
using core::Vec3;

namespace {

struct HashOfPoint {
    std::size_t operator()(const std::array<double, 3>& p) const {
        std::size_t hash = 0;
        for (const double x : p)
            hash = (hash ^ std::hash<double>()(x)) * 0x9e3779b97f4a7c15u;
        return hash;
    }
};

// Numbers boundary nodes by their exact coordinates: both sides of a baffle get one number.
class NumberedPoints {
  public:
    explicit NumberedPoints(const CellMesh& mesh, const std::vector<BoundaryFace>& boundary) {
        for (const auto& [cell, face] : boundary)
            for (const std::uint32_t node : core::face_nodes(mesh.cells[cell], face))
                if (node != no_node)
                    of_node_.emplace(node, number_of(mesh.points[node]));
    }

    std::uint32_t of_node(std::uint32_t node) const {
        const auto found = of_node_.find(node);
        return found == of_node_.end() ? no_node : found->second;
    }

    std::uint32_t at(const Vec3& p) const {
        const auto found = number_.find(key(p));
        return found == number_.end() ? no_node : found->second;
    }

  private:
    static std::array<double, 3> key(const Vec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

    std::uint32_t number_of(const Vec3& p) {
        return number_.emplace(key(p), static_cast<std::uint32_t>(number_.size())).first->second;
    }

    std::unordered_map<std::array<double, 3>, std::uint32_t, HashOfPoint> number_;
    std::unordered_map<std::uint32_t, std::uint32_t> of_node_;
};

using Polygon = std::vector<std::uint32_t>;

Polygon sorted_set(Polygon nodes) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

// Returns the polygons of a reader's walls by place, and true for no slip. A polygon with a point that is no
// boundary node is left out.
std::map<Polygon, bool> polygons_of(const std::vector<WallFaces>& walls,
                                    const NumberedPoints& numbered) {
    std::map<Polygon, bool> polygons;
    const auto ids = vtkSmartPointer<vtkIdList>::New();
    for (const auto& wall : walls)
        for (vtkIdType i = 0; wall.faces != nullptr && i < wall.faces->GetNumberOfCells(); ++i) {
            wall.faces->GetCellPoints(i, ids);
            Polygon polygon;
            for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k) {
                double p[3];
                wall.faces->GetPoint(ids->GetId(k), p);
                polygon.push_back(numbered.at({p[0], p[1], p[2]}));
            }
            bool& no_slip = polygons[sorted_set(std::move(polygon))];
            no_slip = no_slip || wall.no_slip;
        }
    return polygons;
}

// Finds the connected parts of a boundary, each known by its lowest boundary node.
class Components {
  public:
    Components(const CellMesh& mesh, const std::vector<BoundaryFace>& boundary)
        : parent_(mesh.points.size()) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
        for (const auto& [cell, face] : boundary) {
            const auto nodes = core::face_nodes(mesh.cells[cell], face);
            for (const std::uint32_t node : nodes)
                if (node != no_node)
                    parent_[of(node)] = of(nodes[0]);
        }
    }

    std::uint32_t of(std::uint32_t node) {
        while (parent_[node] != node)
            node = parent_[node] = parent_[parent_[node]];
        return node;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

// Returns six times the volume under a face, seen from `origin`; faces of a cell point out of it.
double sixfold_volume(const CellMesh& mesh, const BoundaryFace& at, const Vec3& origin) {
    const MeshCell& cell = mesh.cells[at.cell];
    const core::CellFace face = core::face(cell.shape, at.face);
    const auto corner = [&](std::size_t i) {
        return mesh.points[cell.node[face.node[i % face.count]]] - origin;
    };
    Vec3 centre(0.0);
    for (std::size_t i = 0; i < face.count; ++i)
        centre += corner(i) / static_cast<double>(face.count);
    double volume = 0.0;
    for (std::size_t i = 0; i < face.count; ++i)
        volume += glm::dot(centre, glm::cross(corner(i), corner(i + 1)));
    return volume;
}

// Makes the boundaries of holes walls. The boundary of a hole points into it: the volume that it encloses is
// negative, that of the domain's outside positive. A baffle encloses none.
void wall_off_holes(CellMesh& mesh, const std::vector<BoundaryFace>& boundary) {
    struct Part {
        double volume = 0.0;
        Vec3 lo{HUGE_VAL};
        Vec3 hi{-HUGE_VAL};
    };

    Components components(mesh, boundary);
    std::map<std::uint32_t, Part> parts;
    const auto part_of = [&](const BoundaryFace& at) {
        return components.of(core::face_nodes(mesh.cells[at.cell], at.face)[0]);
    };
    for (const auto& at : boundary) {
        const std::uint32_t root = part_of(at);
        Part& part = parts[root];
        part.volume += sixfold_volume(mesh, at, mesh.points[root]);
        for (const std::uint32_t node : core::face_nodes(mesh.cells[at.cell], at.face))
            if (node != no_node) {
                part.lo = glm::min(part.lo, mesh.points[node]);
                part.hi = glm::max(part.hi, mesh.points[node]);
            }
    }
    constexpr double rounding = 1e-12; // of a volume, relative to the cube of its size
    for (const auto& at : boundary) {
        const Part& part = parts[part_of(at)];
        const double size = glm::length(part.hi - part.lo);
        if (part.volume <= rounding * size * size * size)
            mesh.cells[at.cell].beyond[at.face] = core::beyond_wall;
    }
}

class Triangles {
  public:
    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        out.triangles.push_back({number(a), number(b), number(c)});
    }

    /// Draws the faces of a thin wedge all the way round: it is stretched to one of `sectors`, and repeated. The walls
    /// are for display: of many triangles there are fewer sectors.
    void revolve(const core::SymmetryAxis& axis) {
        constexpr std::size_t most = 4'000'000;
        const std::size_t sectors =
            std::clamp<std::size_t>(most / std::max<std::size_t>(out.triangles.size(), 1), 12, 72);
        const double sector = 2.0 * std::numbers::pi / static_cast<double>(sectors);
        const Vec3 around = glm::cross(axis.direction, axis.radial);
        const auto points = std::move(out.points);
        const auto triangles = std::move(out.triangles);
        out = {};
        number_.clear();
        std::vector<std::array<double, 3>> at; // along the axis, from it, and the angle
        double half = 0.0;
        for (const auto& p : points) {
            const Vec3 from = Vec3(p) - axis.origin;
            const double x = glm::dot(from, axis.radial);
            const double y = glm::dot(from, around);
            at.push_back({glm::dot(from, axis.direction), std::hypot(x, y), std::atan2(y, x)});
            if (x > 0.0)
                half = std::max(half, std::abs(at.back()[2]));
        }
        if (!(half > 0.0))
            return;
        for (std::size_t k = 0; k < sectors; ++k)
            for (const auto& triangle : triangles) {
                std::array<Vec3, 3> corner;
                for (std::size_t i = 0; i < 3; ++i) {
                    const auto& [along, radius, angle] = at[triangle[i]];
                    // Both sides of a sector are reckoned alike: its neighbours have the very same points.
                    const double turn =
                        sector * (static_cast<double>(k) +
                                  std::round(0.5 * (angle / half + 1.0) * 1024.0) / 1024.0);
                    corner[i] = axis.origin + along * axis.direction +
                                radius * (std::cos(turn) * axis.radial + std::sin(turn) * around);
                }
                add(corner[0], corner[1], corner[2]);
            }
    }

    core::WallGeometry out;

  private:
    std::uint32_t number(const Vec3& p) {
        const auto [found, fresh] =
            number_.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(out.points.size()));
        if (fresh)
            out.points.emplace_back(p);
        return found->second;
    }

    std::unordered_map<std::array<double, 3>, std::uint32_t, HashOfPoint> number_;
};

core::Box box_of(const CellMesh& mesh) {
    core::Box box{Vec3(HUGE_VAL), Vec3(-HUGE_VAL)};
    for (const Vec3& p : mesh.points)
        box = {glm::min(box.lo, p), glm::max(box.hi, p)};
    return box;
}

bool in_a_side(const core::Box& box, std::span<const Vec3> corners) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {box.lo[axis], box.hi[axis]})
            if (std::all_of(corners.begin(), corners.end(), [&](const Vec3& p) {
                    return std::abs(p[axis] - side) <= 1e-9 * box.diagonal();
                }))
                return true;
    return false;
}

void add_wall_faces(const CellMesh& mesh, Triangles& triangles) {
    const core::Box box = box_of(mesh);
    for (const auto& [number, f] : core::boundary_faces(mesh)) {
        const MeshCell& cell = mesh.cells[number];
        if (cell.beyond[f] != core::beyond_wall)
            continue;
        const core::CellFace face = core::face(cell.shape, f);
        std::array<Vec3, 4> corner;
        for (std::size_t i = 0; i < face.count; ++i)
            corner[i] = mesh.points[cell.node[face.node[i]]];
        if (in_a_side(box, std::span(corner).first(face.count)))
            continue;
        triangles.add(corner[0], corner[1], corner[2]);
        if (face.count == 4)
            triangles.add(corner[0], corner[2], corner[3]);
    }
}

void add_polygons(vtkPolyData& data, Triangles& triangles) {
    const auto ids = vtkSmartPointer<vtkIdList>::New();
    const auto point = [&](vtkIdType i) {
        double p[3];
        data.GetPoint(ids->GetId(i), p);
        return Vec3(p[0], p[1], p[2]);
    };
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        data.GetCellPoints(i, ids);
        const bool strip = data.GetCellType(i) == VTK_TRIANGLE_STRIP;
        for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k)
            triangles.add(point(strip ? k - 2 : 0), point(k - 1), point(k));
    }
}

// Makes walls of the faces that lie at the same places as others of other nodes.
void wall_off_pieces(GridAssembly& assembly, const std::vector<BoundaryFace>& boundary) {
    auto& mesh = std::get<CellMesh>(assembly.grid);
    std::map<Polygon, std::vector<std::pair<BoundaryFace, Polygon>>> at_places;
    for (const auto& at : boundary) {
        Polygon nodes = source_polygon(assembly, mesh.cells[at.cell], at.face);
        Polygon places = nodes;
        for (auto& node : places)
            node = assembly.place[node];
        at_places[sorted_set(std::move(places))].emplace_back(at, std::move(nodes));
    }
    for (const auto& [places, faces] : at_places)
        for (const auto& [at, nodes] : faces)
            if (std::any_of(faces.begin(), faces.end(),
                            [&own = nodes](const auto& other) { return other.second != own; }))
                mesh.cells[at.cell].beyond[at.face] = core::beyond_wall;
}

} // namespace

Walls find_walls(GridAssembly& assembly, const SourceStep& step) {
    Walls found;
    auto* mesh = std::get_if<CellMesh>(&assembly.grid);
    if (mesh == nullptr)
        return found;
    const auto boundary = core::boundary_faces(*mesh);
    const NumberedPoints numbered(*mesh, boundary);
    const auto polygons = polygons_of(step.walls, numbered);
    std::set<Polygon> matched;
    for (const auto& [cell, face] : boundary) {
        if (polygons.empty())
            break;
        const Polygon nodes = source_polygon(assembly, mesh->cells[cell], face);
        Polygon key;
        for (const std::uint32_t node : nodes)
            key.push_back(numbered.of_node(node));
        const auto wall = polygons.find(sorted_set(std::move(key)));
        if (wall == polygons.end())
            continue;
        matched.insert(wall->first);
        mesh->cells[cell].beyond[face] = core::beyond_wall;
        if (wall->second)
            found.still.insert(found.still.end(), nodes.begin(), nodes.end());
    }
    found.still = sorted_set(std::move(found.still));
    found.unmatched = polygons.size() - matched.size();
    if (!assembly.place.empty())
        wall_off_pieces(assembly, boundary);
    wall_off_holes(*mesh, boundary);
    return found;
}

void add_still_walls(GridAssembly& assembly,
                     std::span<const float> first,
                     std::span<const float> last) {
    auto* mesh = std::get_if<CellMesh>(&assembly.grid);
    if (mesh == nullptr)
        return;
    const auto still = [](std::span<const float> velocity, std::uint32_t node) {
        return velocity[3 * node] == 0.0f && velocity[3 * node + 1] == 0.0f &&
               velocity[3 * node + 2] == 0.0f;
    };
    for (const auto& [cell, face] : core::boundary_faces(*mesh)) {
        const auto nodes = core::face_nodes(mesh->cells[cell], face);
        if (std::all_of(nodes.begin(), nodes.end(), [&](std::uint32_t node) {
                return node == no_node || (still(first, node) && still(last, node));
            }))
            mesh->cells[cell].beyond[face] = core::beyond_wall;
    }
}

core::WallGeometry wall_geometry(const GridAssembly& assembly, const SourceStep& step) {
    Triangles triangles;
    if (const auto* mesh = std::get_if<CellMesh>(&assembly.grid))
        add_wall_faces(*mesh, triangles);
    for (const auto& solid : step.solids)
        if (solid != nullptr)
            add_polygons(*solid, triangles);
    if (const auto* mesh = std::get_if<CellMesh>(&assembly.grid); mesh != nullptr && mesh->axis)
        triangles.revolve(*mesh->axis);
    return std::move(triangles.out);
}

} // namespace wakesurf::importer
