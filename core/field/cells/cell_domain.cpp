#include "core/field/cells/cell_domain.hpp"

#include "core/field/cells/cell_polynomial.hpp"
#include "core/field/cells/local_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wakesurf::core {

namespace {

/// Patches are this much larger than they are, in their own units: nothing passes between two.
constexpr double seam = 1e-9;

WallPatch patch_of(const CellMesh& mesh, const MeshCell& cell, const CellFace& face) {
    std::array<Vec3, 4> p{};
    for (std::size_t i = 0; i < face.count; ++i)
        p[i] = mesh.points[cell.node[face.node[i]]];
    WallPatch patch{};
    patch.triangle = face.count == 3;
    patch.a = p[0];
    patch.b = p[1] - p[0];
    patch.c = p[patch.triangle ? 2 : 3] - p[0];
    patch.d = patch.triangle ? Vec3(0.0) : (p[2] - p[1]) - patch.c;
    const double part = patch.triangle ? 1.0 / 3.0 : 0.5;
    const Vec3 middle = patch.a + part * (patch.b + patch.c) + part * part * patch.d;
    const Vec3 normal = glm::cross(patch.b + part * patch.d, patch.c + part * patch.d);
    Vec3 opposite(0.0); // from the face to the mean of the cell's other nodes
    for (std::size_t i = 0; i < node_count(cell.shape); ++i)
        if (std::find(face.node.begin(), face.node.begin() + face.count, i) ==
            face.node.begin() + face.count)
            opposite += mesh.points[cell.node[i]] - middle;
    opposite /= static_cast<double>(node_count(cell.shape) - face.count);
    patch.outward = glm::dot(normal, opposite) < 0.0 ? 1.0 : -1.0;
    if (const double area = glm::length(normal); area > 0.0)
        patch.rounding = 0.25 * face_tolerance * std::abs(glm::dot(normal, opposite)) / area;
    return patch;
}

Box box_of(const WallPatch& patch) {
    Box box{patch.a, patch.a};
    const auto add = [&](const Vec3& p) {
        box.lo = glm::min(box.lo, p);
        box.hi = glm::max(box.hi, p);
    };
    add(patch.a + patch.b);
    add(patch.a + patch.c);
    if (!patch.triangle)
        add(patch.a + patch.b + patch.c + patch.d);
    return box;
}

/// Real roots of a x^2 + b x + c, NaN where there are none.
std::array<double, 2> roots(double a, double b, double c) {
    const double root = std::sqrt(b * b - 4.0 * a * c);
    const double q = -0.5 * (b + std::copysign(root, b));
    return {q / a, c / q};
}

} // namespace

bool WallPatch::may_meet(const Vec3& from, const Vec3& to) const {
    const Vec3 normal = glm::cross(b + 0.5 * d, c + 0.5 * d);
    // The patch is within the hull of its corners.
    const double x = glm::dot(normal, b), y = glm::dot(normal, c);
    const double z = triangle ? 0.0 : x + y + glm::dot(normal, d);
    const double start = glm::dot(normal, from - a), end = glm::dot(normal, to - a);
    return !(std::min(start, end) > std::max({0.0, x, y, z}) ||
             std::max(start, end) < std::min({0.0, x, y, z}));
}

bool WallPatch::left_by(const Vec3& from, const Vec3& to) const {
    const Vec3 way = to - from;
    const double length = glm::length(way);
    if (!(length > 0.0))
        return false;
    const Vec3 direction = way / length;
    // The segment's line as two planes through it.
    const Vec3 other = std::abs(direction.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 n1 = glm::normalize(glm::cross(direction, other));
    const Vec3 n2 = glm::cross(direction, n1);
    const Vec3 start = a - from;
    const double a1 = glm::dot(n1, start), b1 = glm::dot(n1, b), c1 = glm::dot(n1, c);
    const double a2 = glm::dot(n2, start), b2 = glm::dot(n2, b), c2 = glm::dot(n2, c);
    const double d1 = glm::dot(n1, d), d2 = glm::dot(n2, d);

    const auto leaves_at = [&](double s, double t) {
        const Vec3 hit = start + s * b + t * c + s * t * d;
        const Vec3 normal = outward * glm::cross(b + t * d, c + s * d);
        const double area = glm::length(normal);
        if (!(area > 0.0))
            return false;
        // A particle that slides along the wall, on it to rounding, stays inside. It may be as far beyond as
        // cells reach beyond their faces; but it gets no farther.
        return glm::dot(normal, way - hit) > rounding * area &&
               glm::dot(normal, hit) > -8.0 * rounding * area;
    };
    if (triangle) {
        const double area = b1 * c2 - b2 * c1;
        const double s = (c1 * a2 - c2 * a1) / area;
        const double t = (b2 * a1 - b1 * a2) / area;
        return s >= -seam && t >= -seam && s + t <= 1.0 + seam && leaves_at(s, t);
    }
    // t from either equation, in the other: quadratic in s.
    const double q2 = b1 * d2 - b2 * d1;
    const double q1 = (a1 * d2 - a2 * d1) + (b1 * c2 - b2 * c1);
    const double q0 = a1 * c2 - a2 * c1;
    const bool linear = std::abs(q2) <= 1e-14 * (std::abs(q1) + std::abs(q0));
    const auto all = linear ? std::array{-q0 / q1, std::nan("")} : roots(q2, q1, q0);
    for (const double s : all) {
        if (!(s >= -seam && s <= 1.0 + seam))
            continue;
        const double e1 = c1 + s * d1;
        const double e2 = c2 + s * d2;
        const double t = std::abs(e1) > std::abs(e2) ? -(a1 + s * b1) / e1 : -(a2 + s * b2) / e2;
        if (t >= -seam && t <= 1.0 + seam && leaves_at(s, t))
            return true;
    }
    return false;
}

CellWalls::CellWalls(const CellMesh& mesh) {
    std::vector<FloatBox> boxes;
    for (const MeshCell& cell : mesh.cells)
        for (std::size_t f = 0; f < face_count(cell.shape); ++f) {
            if (cell.beyond[f] != beyond_wall)
                continue;
            on_wall_.resize(mesh.points.size());
            const CellFace corners = face(cell.shape, f);
            for (std::size_t i = 0; i < corners.count; ++i)
                on_wall_[cell.node[corners.node[i]]] = 1;
            patch_.push_back(patch_of(mesh, cell, corners));
            boxes.push_back(rounded_outward(box_of(patch_.back())));
        }
    if (patch_.empty())
        return;
    tree_ = BoxTree(boxes);
    beside_.resize(mesh.cells.size());
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
        for (std::size_t k = 0; k < node_count(mesh.cells[i].shape); ++k)
            beside_[i] |= on_wall_[mesh.cells[i].node[k]];
}

double CellWalls::share(const CellMesh& mesh, std::uint32_t cell, const Vec3& u) const {
    if (patch_.empty() || !beside(cell))
        return 0.0;
    const MeshCell& each = mesh.cells[cell];
    CellPolynomial share; // one on the wall, zero at the other nodes
    share.fit(each.shape, [&](std::size_t i) {
        Components value;
        value.z[0] = on_wall_[each.node[i]];
        return value;
    });
    return share.at(each.shape == CellShape::Pyramid, u).z[0];
}

bool CellWalls::crossed(const Vec3& from, const Vec3& to) const {
    return tree_.visit(Box{glm::min(from, to), glm::max(from, to)},
                       [&](std::uint32_t number) { return patch_[number].left_by(from, to); });
}

bool connected(const CellMesh& mesh) {
    if (mesh.cells.empty())
        return true;
    std::vector<bool> reached(mesh.cells.size());
    std::vector<std::uint32_t> open{0};
    reached[0] = true;
    std::size_t count = 1;
    while (!open.empty()) {
        const MeshCell& cell = mesh.cells[open.back()];
        open.pop_back();
        for (const std::uint32_t next : cell.beyond)
            if (next < mesh.cells.size() && !reached[next]) {
                reached[next] = true;
                open.push_back(next);
                ++count;
            }
    }
    return count == mesh.cells.size();
}

} // namespace wakesurf::core
