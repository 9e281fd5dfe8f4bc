#include "importer/assembly/polyhedron_cutter.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

namespace wakesurf::importer {

using core::CellShape;
using core::MeshCell;
using core::Vec3;

namespace {

// The bound on rounding errors of a volume, as a part of the cube of the cell's size: some units of double
// precision.
constexpr double rounding = 1e-15;

double size_of(const MeshCell& cell, std::span<const Vec3> points) {
    Vec3 lo = points[cell.node[0]];
    Vec3 hi = lo;
    for (std::size_t i = 1; i < core::node_count(cell.shape); ++i) {
        lo = glm::min(lo, points[cell.node[i]]);
        hi = glm::max(hi, points[cell.node[i]]);
    }
    return glm::length(hi - lo);
}

template <std::size_t N>
void renumber(MeshCell& cell, const std::array<std::size_t, N>& order) {
    const auto before = cell.node;
    for (std::size_t i = 0; i < N; ++i)
        cell.node[i] = before[order[i]];
}

void mirror(MeshCell& cell) {
    switch (cell.shape) {
    case CellShape::Tetrahedron:
        return renumber<4>(cell, {1, 0, 2, 3});
    case CellShape::Pyramid:
        return renumber<5>(cell, {0, 3, 2, 1, 4});
    case CellShape::Wedge:
        return renumber<6>(cell, {3, 4, 5, 0, 1, 2});
    case CellShape::Hexahedron:
        return renumber<8>(cell, {4, 5, 6, 7, 0, 1, 2, 3});
    }
}

} // namespace

double cell_volume(const MeshCell& cell, std::span<const Vec3> points) {
    const Vec3 origin = points[cell.node[0]];
    std::array<Vec3, 8> corner;
    for (std::size_t i = 0; i < core::node_count(cell.shape); ++i)
        corner[i] = points[cell.node[i]] - origin;
    const std::size_t faces = core::face_count(cell.shape);
    double sixfold = 0.0;
    for (std::size_t f = 0; f < faces; ++f) {
        const core::CellFace face = core::face(cell.shape, f);
        Vec3 centre(0.0);
        for (std::size_t i = 0; i < face.count; ++i)
            centre += corner[face.node[i]];
        centre /= static_cast<double>(face.count);
        for (std::size_t i = 0; i < face.count; ++i) {
            const std::size_t next = i + 1 < face.count ? i + 1 : 0;
            sixfold += glm::dot(centre, glm::cross(corner[face.node[i]], corner[face.node[next]]));
        }
    }
    return sixfold / 6.0;
}

Turned turn_outside_out(MeshCell& cell, std::span<const Vec3> points) {
    const double volume = cell_volume(cell, points);
    const double size = size_of(cell, points);
    if (!(std::abs(volume) > rounding * size * size * size))
        return Turned::Flat;
    if (volume > 0.0)
        return Turned::Kept;
    mirror(cell);
    return Turned::Reordered;
}

namespace {

std::vector<std::uint32_t> nodes_of(std::span<const Polygon> faces) {
    std::vector<std::uint32_t> nodes;
    for (const auto& face : faces)
        nodes.insert(nodes.end(), face.begin(), face.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

Polygon sorted(Polygon face) {
    std::sort(face.begin(), face.end());
    return face;
}

// Returns the other end of the edge that leaves `base` at `node`; empty unless there is exactly one.
std::optional<std::uint32_t>
opposite(std::span<const Polygon> faces, const Polygon& base, std::uint32_t node) {
    std::optional<std::uint32_t> found;
    for (const auto& face : faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const std::uint32_t a = face[i];
            const std::uint32_t b = face[(i + 1) % face.size()];
            if (a != node && b != node)
                continue;
            const std::uint32_t other = a == node ? b : a;
            if (std::find(base.begin(), base.end(), other) != base.end())
                continue;
            if (found && *found != other)
                return std::nullopt;
            found = other;
        }
    return found;
}

// Returns true if `cell` has exactly the faces given.
bool has_faces(const MeshCell& cell, std::span<const Polygon> faces) {
    if (core::face_count(cell.shape) != faces.size())
        return false;
    std::set<Polygon> given;
    for (const auto& face : faces)
        given.insert(sorted(face));
    for (std::size_t f = 0; f < core::face_count(cell.shape); ++f) {
        const core::CellFace corners = core::face(cell.shape, f);
        Polygon face;
        for (std::size_t i = 0; i < corners.count; ++i)
            face.push_back(cell.node[corners.node[i]]);
        if (!given.contains(sorted(face)))
            return false;
    }
    return given.size() == faces.size();
}

std::optional<MeshCell> prism(std::span<const Polygon> faces, const Polygon& base) {
    MeshCell cell{};
    cell.shape = base.size() == 4 ? CellShape::Hexahedron : CellShape::Wedge;
    for (std::size_t i = 0; i < base.size(); ++i) {
        const auto above = opposite(faces, base, base[i]);
        if (!above)
            return std::nullopt;
        cell.node[i] = base[i];
        cell.node[base.size() + i] = *above;
    }
    return cell;
}

MeshCell peaked(const Polygon& base, std::uint32_t peak) {
    MeshCell cell{};
    cell.shape = base.size() == 4 ? CellShape::Pyramid : CellShape::Tetrahedron;
    std::copy(base.begin(), base.end(), cell.node.begin());
    cell.node[base.size()] = peak;
    return cell;
}

// Returns six times the volume between an apex and a polygon cut round its centre. It is positive if the
// polygon, seen from the apex, runs clockwise: from outside counterclockwise.
double sixfold_volume(std::span<const Vec3> points, const Polygon& face, const Vec3& apex) {
    Vec3 centre(0.0);
    for (const std::uint32_t node : face)
        centre += points[node] - apex;
    centre /= static_cast<double>(face.size());
    double volume = 0.0;
    for (std::size_t i = 0; i < face.size(); ++i)
        volume += glm::dot(
            centre, glm::cross(points[face[i]] - apex, points[face[(i + 1) % face.size()]] - apex));
    return volume;
}

// Turns faces until every edge is run through once in each direction.
void orient_alike(std::vector<Polygon>& faces) {
    std::vector<bool> done(faces.size(), false);
    std::vector<std::size_t> next{0};
    done[0] = true;
    const auto runs = [](const Polygon& face, std::uint32_t a, std::uint32_t b) {
        for (std::size_t i = 0; i < face.size(); ++i)
            if (face[i] == a && face[(i + 1) % face.size()] == b)
                return true;
        return false;
    };
    while (!next.empty()) {
        const Polygon face = faces[next.back()];
        next.pop_back();
        for (std::size_t i = 0; i < face.size(); ++i)
            for (std::size_t f = 0; f < faces.size(); ++f) {
                const std::uint32_t a = face[i];
                const std::uint32_t b = face[(i + 1) % face.size()];
                const bool same_way = !done[f] && runs(faces[f], a, b);
                if (done[f] || (!same_way && !runs(faces[f], b, a)))
                    continue;
                if (same_way)
                    std::reverse(faces[f].begin(), faces[f].end());
                done[f] = true;
                next.push_back(f);
            }
    }
}

} // namespace

std::optional<MeshCell> standard_cell(std::span<const Polygon> faces) {
    const auto with = [&](std::size_t corners) {
        return static_cast<std::size_t>(std::count_if(
            faces.begin(), faces.end(), [&](const auto& f) { return f.size() == corners; }));
    };
    const std::size_t triangles = with(3);
    const std::size_t quads = with(4);
    if (triangles + quads != faces.size() || faces.size() > 6)
        return std::nullopt;
    const auto nodes = nodes_of(faces);
    std::optional<MeshCell> cell;
    if (quads == 6 && triangles == 0 && nodes.size() == 8)
        cell = prism(faces, faces[0]);
    else if (triangles == 2 && quads == 3 && nodes.size() == 6)
        cell = prism(faces, *std::find_if(faces.begin(), faces.end(),
                                          [](const auto& f) { return f.size() == 3; }));
    else if ((triangles == 4 && quads == 1 && nodes.size() == 5) ||
             (triangles == 4 && quads == 0 && nodes.size() == 4)) {
        const auto& base =
            *std::max_element(faces.begin(), faces.end(),
                              [](const auto& a, const auto& b) { return a.size() < b.size(); });
        const auto peak = std::find_if(nodes.begin(), nodes.end(), [&](std::uint32_t node) {
            return std::find(base.begin(), base.end(), node) == base.end();
        });
        if (peak != nodes.end())
            cell = peaked(base, *peak);
    }
    return cell && has_faces(*cell, faces) ? cell : std::nullopt;
}

PolyhedronCutter::Apex PolyhedronCutter::mean_apex(std::span<const Polygon> faces) const {
    const auto nodes = nodes_of(faces);
    Apex apex;
    const double share = 1.0 / static_cast<double>(nodes.size());
    const Vec3 origin = mesh_.points[nodes.front()];
    for (const std::uint32_t node : nodes) {
        apex.at += share * (mesh_.points[node] - origin);
        apex.weights[node] = share;
    }
    apex.at += origin;
    return apex;
}

PolyhedronCutter::Apex PolyhedronCutter::centre_of_volume(std::span<const Polygon> faces,
                                                          const Apex& mean) const {
    Apex centre;
    double whole = 0.0;
    for (const auto& face : faces) {
        const double volume = sixfold_volume(mesh_.points, face, mean.at);
        whole += volume;
        // Tetrahedra of the apex, the face's centre and an edge: their centres are the means of their
        // corners.
        for (const auto& [node, share] : mean.weights)
            centre.weights[node] += volume * share / 4.0;
        Vec3 middle(0.0);
        for (const std::uint32_t node : face)
            middle += (mesh_.points[node] - mean.at) / static_cast<double>(face.size());
        for (std::size_t i = 0; i < face.size(); ++i) {
            const std::uint32_t a = face[i];
            const std::uint32_t b = face[(i + 1) % face.size()];
            const double part =
                glm::dot(middle, glm::cross(mesh_.points[a] - mean.at, mesh_.points[b] - mean.at));
            centre.weights[a] += part / 4.0;
            centre.weights[b] += part / 4.0;
        }
        for (const std::uint32_t node : face)
            centre.weights[node] += volume / 4.0 / static_cast<double>(face.size());
    }
    if (whole == 0.0)
        return mean;
    for (auto& [node, weight] : centre.weights) {
        weight /= whole;
        centre.at += weight * (mesh_.points[node] - mean.at);
    }
    centre.at += mean.at;
    return centre;
}

bool PolyhedronCutter::sees_all(std::span<const Polygon> faces, const Vec3& apex) const {
    bool outwards = true;
    bool inwards = true;
    const auto judge = [&](double volume) {
        outwards = outwards && volume > 0.0;
        inwards = inwards && volume < 0.0;
    };
    for (const auto& face : faces) {
        if (face.size() <= 4) {
            judge(sixfold_volume(mesh_.points, face, apex));
            continue;
        }
        const Vec3 centre = middle_of(face).at - apex;
        for (std::size_t i = 0; i < face.size(); ++i)
            judge(glm::dot(centre, glm::cross(mesh_.points[face[i]] - apex,
                                              mesh_.points[face[(i + 1) % face.size()]] - apex)));
    }
    return outwards || inwards;
}

// Returns the mean of the corners, or the centre of area if not all edges are visible from the mean inside
// the polygon.
PolyhedronCutter::Apex PolyhedronCutter::middle_of(const Polygon& face) const {
    const Apex mean = mean_apex({&face, 1});
    const auto corner = [&](std::size_t i) {
        return mesh_.points[face[i % face.size()]] - mean.at;
    };
    Vec3 area(0.0);
    for (std::size_t i = 0; i < face.size(); ++i)
        area += glm::cross(corner(i), corner(i + 1));
    std::vector<double> parts;
    for (std::size_t i = 0; i < face.size(); ++i)
        parts.push_back(glm::dot(area, glm::cross(corner(i), corner(i + 1))));
    if (std::all_of(parts.begin(), parts.end(), [](double part) { return part > 0.0; }))
        return mean;
    const double whole = std::accumulate(parts.begin(), parts.end(), 0.0);
    if (!(whole > 0.0))
        return mean;
    Apex centre;
    for (std::size_t i = 0; i < face.size(); ++i) {
        for (const auto& [node, share] : mean.weights)
            centre.weights[node] += parts[i] / whole / 3.0 * share;
        centre.weights[face[i]] += parts[i] / whole / 3.0;
        centre.weights[face[(i + 1) % face.size()]] += parts[i] / whole / 3.0;
    }
    for (const auto& [node, weight] : centre.weights)
        centre.at += weight * (mesh_.points[node] - mean.at);
    centre.at += mean.at;
    return centre;
}

std::uint32_t PolyhedronCutter::add(const Apex& apex) {
    const auto number = static_cast<std::uint32_t>(mesh_.points.size());
    mesh_.points.push_back(apex.at);
    for (const auto& [node, weight] : apex.weights) {
        added_.node.push_back(node);
        added_.weight.push_back(weight);
    }
    added_.first.push_back(added_.node.size());
    return number;
}

std::uint32_t PolyhedronCutter::face_centre(const Polygon& face) {
    Polygon key = sorted(face);
    const auto found = centres_.find(key);
    if (found != centres_.end()) {
        const std::uint32_t number = found->second;
        centres_.erase(found); // a face has two sides
        return number;
    }
    const std::uint32_t number = add(middle_of(face));
    centres_.emplace(std::move(key), number);
    return number;
}

void PolyhedronCutter::emit(CellShape shape,
                            std::span<const std::uint32_t> base,
                            std::uint32_t apex) {
    MeshCell cell{};
    cell.shape = shape;
    std::copy(base.begin(), base.end(), cell.node.begin());
    cell.node[base.size()] = apex;
    if (turn_outside_out(cell, mesh_.points) != Turned::Flat)
        mesh_.cells.push_back(cell);
}

void PolyhedronCutter::cut(std::vector<Polygon>& faces) {
    Apex apex = mean_apex(faces);
    if (!sees_all(faces, apex.at)) {
        orient_alike(faces);
        if (!sees_all(faces, apex.at)) {
            Apex centre = centre_of_volume(faces, apex);
            if (sees_all(faces, centre.at))
                apex = std::move(centre);
            else
                ++overlapping_;
        }
    }
    const std::uint32_t peak = add(apex);
    for (const auto& face : faces) {
        if (face.size() <= 4) {
            emit(face.size() == 4 ? CellShape::Pyramid : CellShape::Tetrahedron, face, peak);
            continue;
        }
        const std::uint32_t centre = face_centre(face);
        for (std::size_t i = 0; i < face.size(); ++i)
            emit(CellShape::Tetrahedron, std::array{face[i], face[(i + 1) % face.size()], centre},
                 peak);
    }
}

} // namespace wakesurf::importer
