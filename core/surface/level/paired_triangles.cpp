#include "core/surface/level/paired_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace wakesurf::core {

namespace {

using LevelCorners = std::array<std::uint32_t, 3>;

constexpr std::uint32_t no_triangle_beyond = 0xffffffffu;
/// The least cosine between the normals of two triangles of a quad: at less than 18 degrees a quad looks like
/// its triangles.
constexpr double flat_enough = 0.95;
/// Sine of the sharpest turn at a quad's corner, so that it is convex whichever diagonal it is drawn with.
constexpr double least_turn_of_pair = 0.05;
constexpr std::size_t grades = 1024; ///< of quads, as good as each other within one

/// Returns the numbers below `size` in the order of their keys, those of one key in ascending order.
/// @param key  of a number, below `keys`
template <class Key>
std::vector<std::uint32_t> in_order(std::size_t size, std::size_t keys, const Key& key) {
    std::vector<std::uint32_t> place(keys + 1, 0);
    for (std::uint32_t i = 0; i < size; ++i)
        ++place[key(i) + 1];
    for (std::size_t k = 0; k < keys; ++k)
        place[k + 1] += place[k];
    std::vector<std::uint32_t> order(size);
    for (std::uint32_t i = 0; i < size; ++i)
        order[place[key(i)]++] = i;
    return order;
}

/// Returns the triangle beyond each side, from corner i to corner i + 1, as 3 * triangle + side.
std::vector<std::uint32_t> sides_beyond(std::span<const LevelCorners> triangles,
                                        std::size_t points) {
    const auto ends = [&](std::uint32_t side) {
        const LevelCorners& corners = triangles[side / 3];
        const auto [lo, hi] = std::minmax(corners[side % 3], corners[(side % 3 + 1) % 3]);
        return std::pair(lo, hi);
    };
    const std::size_t sides = 3 * triangles.size();
    std::vector<std::uint32_t> lower(sides), upper(sides);
    for (std::uint32_t side = 0; side < sides; ++side)
        std::tie(lower[side], upper[side]) = ends(side);
    const auto order = in_order(sides, points, [&](std::uint32_t side) { return lower[side]; });
    std::vector<std::uint32_t> beyond(sides, no_triangle_beyond);
    for (std::size_t first = 0; first < sides; ++first) {
        if (beyond[order[first]] != no_triangle_beyond)
            continue;
        // A vertex has few of them.
        for (std::size_t i = first + 1; i < sides && lower[order[i]] == lower[order[first]]; ++i)
            if (upper[order[i]] == upper[order[first]] && beyond[order[i]] == no_triangle_beyond) {
                beyond[order[i]] = order[first];
                beyond[order[first]] = order[i];
                break;
            }
    }
    return beyond;
}

class TrianglePairing {
  public:
    TrianglePairing(std::vector<Vec3>& points, std::span<const LevelCorners> triangles)
        : points_(points), triangles_(triangles), beyond_(sides_beyond(triangles, points.size())),
          cell_of_(triangles.size(), no_triangle_beyond) {}

    std::vector<Cell> cells() {
        pair();
        cut_what_is_left();
        return std::move(cells_);
    }

  private:
    std::uint32_t corner(std::uint32_t triangle, std::uint32_t k) const {
        return triangles_[triangle][k % 3];
    }

    Vec3 twice_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
    }

    /// The sharpest turn of a quad's outline as seen along its normal, or less than nothing where it is bent
    /// or not convex.
    double quality(const std::array<std::uint32_t, 4>& q) const {
        const Vec3 one = twice_area(q[0], q[1], q[2]);
        const Vec3 other = twice_area(q[0], q[2], q[3]);
        const double ones = glm::dot(one, one), others = glm::dot(other, other);
        const double along = glm::dot(one, other);
        if (!(along > 0.0 && along * along >= flat_enough * flat_enough * ones * others))
            return -1.0;
        const Vec3 up = one / std::sqrt(ones) + other / std::sqrt(others);
        std::array<Vec3, 4> side;
        std::array<double, 4> length;
        for (std::size_t k = 0; k < 4; ++k) {
            side[k] = points_[q[(k + 1) % 4]] - points_[q[k]];
            length[k] = glm::dot(side[k], side[k]);
        }
        double least = 1.0; // signed squares
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t next = (k + 1) % 4;
            const double turn = glm::dot(glm::cross(side[k], side[next]), up);
            const double size = length[k] * length[next];
            least = std::min(least, size > 0.0 ? turn * std::abs(turn) / size : -1.0);
        }
        return least > 0.0 ? std::sqrt(least / glm::dot(up, up)) : -1.0;
    }

    std::array<std::uint32_t, 4> quad_over(std::uint32_t side) const {
        const std::uint32_t t = side / 3, k = side % 3;
        const std::uint32_t other = beyond_[side] / 3, j = beyond_[side] % 3;
        return {corner(t, k + 2), corner(t, k), corner(other, j + 2), corner(t, k + 1)};
    }

    /// The best quads first, of as good ones that of the lowest number; triangles that have only one partner
    /// left would be better, but cost more to find.
    void pair() {
        std::vector<std::uint32_t> sides;
        std::vector<std::uint16_t> worse;
        for (std::uint32_t side = 0; side < beyond_.size(); ++side)
            if (beyond_[side] != no_triangle_beyond && side < beyond_[side])
                if (const double how = quality(quad_over(side)); how > least_turn_of_pair) {
                    sides.push_back(side);
                    worse.push_back(
                        static_cast<std::uint16_t>((1.0 - std::min(how, 1.0)) * (grades - 1)));
                }
        for (const std::uint32_t i :
             in_order(sides.size(), grades, [&](std::uint32_t each) { return worse[each]; })) {
            const std::uint32_t t = sides[i] / 3, other = beyond_[sides[i]] / 3;
            if (cell_of_[t] != no_triangle_beyond || cell_of_[other] != no_triangle_beyond)
                continue;
            cell_of_[t] = cell_of_[other] = static_cast<std::uint32_t>(cells_.size());
            cells_.push_back({quad_over(sides[i]), {no_vertex, no_vertex, no_vertex, no_vertex}});
        }
    }

    std::uint32_t longest_side(std::uint32_t t) const {
        std::uint32_t longest = 0;
        double most = -1.0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Vec3 side = points_[corner(t, k + 1)] - points_[corner(t, k)];
            if (const double length = glm::dot(side, side); length > most) {
                most = length;
                longest = k;
            }
        }
        return longest;
    }

    /// Cuts the remaining triangles; if both triangles at a side would cut it, they share its middle.
    void cut_what_is_left() {
        struct Cut {
            std::uint32_t side, middle;
        };

        std::vector<std::uint32_t> middle(beyond_.size(), no_vertex);
        std::vector<Cut> cuts;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (cell_of_[t] != no_triangle_beyond)
                continue;
            const std::uint32_t side = 3 * t + longest_side(t);
            const std::uint32_t other = beyond_[side];
            std::uint32_t at = other != no_triangle_beyond ? middle[other] : no_vertex;
            if (at == no_vertex) {
                at = static_cast<std::uint32_t>(points_.size());
                points_.push_back(
                    0.5 * (points_[corner(t, side % 3)] + points_[corner(t, side % 3 + 1)]));
            }
            middle[side] = at;
            cuts.push_back({side, at});
            const std::uint32_t k = side % 3;
            cell_of_[t] = static_cast<std::uint32_t>(cells_.size());
            cells_.push_back({{corner(t, k + 2), corner(t, k), at, corner(t, k + 1)},
                              {no_vertex, no_vertex, no_vertex, no_vertex}});
        }
        for (const Cut& cut : cuts)
            if (const auto other = beyond_[cut.side];
                other != no_triangle_beyond && middle[other] == no_vertex)
                hang(cut.middle, other);
    }

    /// Hangs a vertex on the side of the cell that the triangle beyond has become.
    void hang(std::uint32_t vertex, std::uint32_t side) {
        const std::uint32_t a = corner(side / 3, side % 3), b = corner(side / 3, side % 3 + 1);
        Cell& cell = cells_[cell_of_[side / 3]];
        for (std::size_t k = 0; k < 4; ++k)
            if (cell.corner[k] == a && cell.corner[(k + 1) % 4] == b)
                cell.mid[k] = vertex;
    }

    std::vector<Vec3>& points_;
    std::span<const LevelCorners> triangles_;
    std::vector<std::uint32_t> beyond_;
    std::vector<std::uint32_t> cell_of_; ///< of each triangle
    std::vector<Cell> cells_;
};

} // namespace

std::vector<Cell> paired_triangles(std::vector<Vec3>& points,
                                   std::span<const std::array<std::uint32_t, 3>> triangles) {
    return TrianglePairing(points, triangles).cells();
}

} // namespace wakesurf::core
