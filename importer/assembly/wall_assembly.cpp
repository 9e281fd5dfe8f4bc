#include "importer/assembly/wall_assembly.hpp"

#include "core/base/plain_text.hpp"
#include "importer/assembly/mesh_assembly.hpp"
#include "importer/base/text.hpp"

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

// What a reader says of a polygon.
struct Given {
    bool wall = false;
    bool no_slip = false;
    std::uint32_t name = no_name;
};

// Numbers the names of patches. A stranger's file may have any, and as many as it likes.
class PatchNames {
  public:
    std::uint32_t number(const std::string& name) {
        constexpr std::size_t longest = 100;
        std::string shown = core::display_name(name, longest);
        if (shown.empty())
            return no_name;
        auto found = std::ranges::find(names, shown);
        if (found == names.end() && names.size() + 1 >= most_patches) {
            shown = "further patches";
            found = std::ranges::find(names, shown);
        }
        const auto number = static_cast<std::uint32_t>(found - names.begin());
        if (found == names.end())
            names.push_back(std::move(shown));
        return number;
    }

    std::vector<std::string> names;
};

// Returns the polygons of a reader's walls and other patches by place. A polygon with a point that is no boundary node is left out.
std::map<Polygon, Given>
polygons_of(const SourceStep& step, const NumberedPoints& numbered, PatchNames& names) {
    std::map<Polygon, Given> polygons;
    const auto ids = vtkSmartPointer<vtkIdList>::New();
    const auto add = [&](const WallFaces& patch, bool wall) {
        const std::uint32_t name = names.number(patch.name);
        for (vtkIdType i = 0; patch.faces != nullptr && i < patch.faces->GetNumberOfCells(); ++i) {
            patch.faces->GetCellPoints(i, ids);
            Polygon polygon;
            for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k) {
                double p[3];
                patch.faces->GetPoint(ids->GetId(k), p);
                polygon.push_back(numbered.at({p[0], p[1], p[2]}));
            }
            Given& given = polygons[sorted_set(std::move(polygon))];
            if (given.name == no_name)
                given.name = name;
            given.wall = given.wall || wall;
            given.no_slip = given.no_slip || patch.no_slip;
        }
    };
    for (const WallFaces& wall : step.walls)
        add(wall, true);
    for (const WallFaces& other : step.others)
        add(other, false);
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
    using Kind = core::BoundaryPatch::Kind;
    using Cylindrical = std::array<double, 3>; ///< along the axis, from it, and the angle

    /// What is added from now on is of this patch.
    void begin(const std::string& name, Kind kind) {
        if (kind != Kind::Wall) // the body's points do not depend on what else is drawn
            number_.clear();
        out.patches.push_back({name, kind, 0});
    }

    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        out.triangles.push_back({number(a), number(b), number(c)});
        if (!out.patches.empty())
            ++out.patches.back().triangles;
    }

    /// Draws the faces of a thin wedge all the way round: it is stretched to one of `sectors`, and repeated. The walls
    /// are for display: of many triangles there are fewer sectors.
    void revolve(const core::SymmetryAxis& axis) {
        constexpr std::size_t most = 4'000'000;
        const std::size_t sectors =
            std::clamp<std::size_t>(most / std::max<std::size_t>(out.triangles.size(), 1), 12, 72);
        const Vec3 around = glm::cross(axis.direction, axis.radial);
        const auto points = std::move(out.points);
        const auto triangles = std::move(out.triangles);
        auto patches = std::move(out.patches);
        out = {};
        number_.clear();
        std::vector<Cylindrical> at;
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
        const bool named = !patches.empty();
        if (!named)
            patches.push_back({{}, Kind::Wall, triangles.size()});
        std::span<const std::array<std::uint32_t, 3>> rest(triangles);
        for (const auto& patch : patches) {
            if (named)
                begin(patch.name, patch.kind);
            revolve(rest.first(patch.triangles), at, half, sectors, axis);
            rest = rest.subspan(patch.triangles);
        }
    }

    core::WallGeometry out;

  private:
    void revolve(std::span<const std::array<std::uint32_t, 3>> triangles,
                 const std::vector<Cylindrical>& at,
                 double half,
                 std::size_t sectors,
                 const core::SymmetryAxis& axis) {
        const double sector = 2.0 * std::numbers::pi / static_cast<double>(sectors);
        const Vec3 around = glm::cross(axis.direction, axis.radial);
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

struct Corners {
    std::array<Vec3, 4> at;
    std::size_t count;

    std::span<const Vec3> all() const { return std::span(at).first(count); }
};

Corners corners_of(const CellMesh& mesh, const BoundaryFace& at) {
    const MeshCell& cell = mesh.cells[at.cell];
    const core::CellFace face = core::face(cell.shape, at.face);
    Corners corner{{}, face.count};
    for (std::size_t i = 0; i < face.count; ++i)
        corner.at[i] = mesh.points[cell.node[face.node[i]]];
    return corner;
}

/// The faces of each patch, in the order in which they are kept: the body's first, and last of each kind those without a name.
using FacesOfPatches =
    std::map<std::pair<core::BoundaryPatch::Kind, std::uint32_t>, std::vector<BoundaryFace>>;

FacesOfPatches faces_of_patches(const CellMesh& mesh, const Walls& walls) {
    using Kind = core::BoundaryPatch::Kind;
    const core::Box box = box_of(mesh);
    const auto boundary = core::boundary_faces(mesh);
    FacesOfPatches patches;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        const auto& at = boundary[i];
        const std::uint32_t name = i < walls.name_of_face.size() ? walls.name_of_face[i] : no_name;
        const bool wall = mesh.cells[at.cell].beyond[at.face] == core::beyond_wall;
        if (!wall && name == no_name)
            continue;
        const Kind kind = !wall                                        ? Kind::Other
                          : in_a_side(box, corners_of(mesh, at).all()) ? Kind::Side
                                                                       : Kind::Wall;
        if (kind == Kind::Wall || name != no_name)
            patches[{kind, name}].push_back(at);
    }
    return patches;
}

std::size_t faces_beside_body(const FacesOfPatches& patches) {
    std::size_t count = 0;
    for (const auto& [patch, faces] : patches)
        count += patch.first != core::BoundaryPatch::Kind::Wall ? faces.size() : 0;
    return count;
}

void add_faces(const CellMesh& mesh, const std::vector<BoundaryFace>& faces, Triangles& triangles) {
    for (const auto& at : faces) {
        const auto [corner, count] = corners_of(mesh, at);
        triangles.add(corner[0], corner[1], corner[2]);
        if (count == 4)
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
    PatchNames names;
    const auto polygons = polygons_of(step, numbered, names);
    std::set<Polygon> matched;
    for (const auto& [cell, face] : boundary) {
        if (polygons.empty())
            break;
        found.name_of_face.push_back(no_name);
        const Polygon nodes = source_polygon(assembly, mesh->cells[cell], face);
        Polygon key;
        for (const std::uint32_t node : nodes)
            key.push_back(numbered.of_node(node));
        const auto given = polygons.find(sorted_set(std::move(key)));
        if (given == polygons.end())
            continue;
        found.name_of_face.back() = given->second.name;
        if (!given->second.wall)
            continue;
        matched.insert(given->first);
        mesh->cells[cell].beyond[face] = core::beyond_wall;
        if (given->second.no_slip)
            found.still.insert(found.still.end(), nodes.begin(), nodes.end());
    }
    found.still = sorted_set(std::move(found.still));
    found.unmatched = static_cast<std::size_t>(std::ranges::count_if(
                          polygons, [](const auto& each) { return each.second.wall; })) -
                      matched.size();
    found.names = std::move(names.names);
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

core::WallGeometry
wall_geometry(GridAssembly& assembly, const SourceStep& step, const Walls& walls) {
    using Kind = core::BoundaryPatch::Kind;
    Triangles triangles;
    const auto* mesh = std::get_if<CellMesh>(&assembly.grid);
    auto patches = mesh != nullptr ? faces_of_patches(*mesh, walls) : FacesOfPatches();
    if (faces_beside_body(patches) > most_side_faces) {
        std::erase_if(patches, [](const auto& each) { return each.first.first != Kind::Wall; });
        add_note(assembly.note, "patches that are no walls, and walls in the sides of the domain, "
                                "are not kept for display: they have more than " +
                                    std::to_string(most_side_faces) + " faces");
    }
    const bool named = !walls.names.empty();
    const auto add_patches = [&](bool of_body) {
        for (const auto& [patch, faces] : patches) {
            const auto& [kind, name] = patch;
            if ((kind == Kind::Wall) != of_body)
                continue;
            if (named)
                triangles.begin(name == no_name ? "other walls" : walls.names[name], kind);
            add_faces(*mesh, faces, triangles);
        }
    };
    add_patches(true);
    if (named && !step.solids.empty())
        triangles.begin("solids", Kind::Wall);
    for (const auto& solid : step.solids)
        if (solid != nullptr)
            add_polygons(*solid, triangles);
    add_patches(false);
    if (mesh != nullptr && mesh->axis)
        triangles.revolve(*mesh->axis);
    return std::move(triangles.out);
}

} // namespace wakesurf::importer
