#include "core/surface/level/paired_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

using LevelCorners = std::array<std::uint32_t, 3>;

constexpr std::uint32_t no_triangle_beyond = 0xffffffffu;
/// Cosine between the normals of two triangles of a quad: below 18 degrees apart a quad looks like what it is made of.
constexpr double flat_enough = 0.95;
/// Sine of the sharpest turn at a quad's corner, so that it is convex whichever diagonal it is drawn with.
constexpr double least_turn = 0.05;

/// The triangle beyond each side, from corner i to corner i + 1, as 3 * triangle + side.
std::vector<std::uint32_t> sides_beyond(std::span<const LevelCorners> triangles) {
    struct Side {
        std::uint64_t edge; ///< the lower vertex first
        std::uint32_t side;
    };

    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const auto [lo, hi] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
            sides.push_back({std::uint64_t{lo} << 32 | hi, 3 * t + k});
        }
    std::ranges::sort(sides, [](const Side& a, const Side& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.side < b.side;
    });
    std::vector<std::uint32_t> beyond(sides.size(), no_triangle_beyond);
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
        if (sides[i].edge == sides[i + 1].edge) {
            beyond[sides[i].side] = sides[i + 1].side;
            beyond[sides[i + 1].side] = sides[i].side;
            ++i;
        }
    return beyond;
}

class TrianglePairing {
  public:
    TrianglePairing(std::vector<Vec3>& points, std::span<const LevelCorners> triangles)
        : points_(points), triangles_(triangles), beyond_(sides_beyond(triangles)),
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

    Vec3 normal(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const Vec3 n = glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
        const double length = glm::length(n);
        return length > 0.0 ? n / length : Vec3(0.0);
    }

    /// The sharpest turn of a quad's outline as seen along its normal, or less than nothing where it is bent or not convex.
    double quality(const std::array<std::uint32_t, 4>& q) const {
        const Vec3 one = normal(q[0], q[1], q[2]);
        const Vec3 other = normal(q[0], q[2], q[3]);
        if (!(glm::dot(one, other) >= flat_enough))
            return -1.0;
        const Vec3 up = one + other;
        double least = 1.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3 in = points_[q[(k + 1) % 4]] - points_[q[k]];
            const Vec3 out = points_[q[(k + 2) % 4]] - points_[q[(k + 1) % 4]];
            const double size = glm::length(in) * glm::length(out) * glm::length(up);
            const double turn = size > 0.0 ? glm::dot(glm::cross(in, out), up) / size : -1.0;
            least = std::min(least, turn);
        }
        return least;
    }

    std::array<std::uint32_t, 4> quad_over(std::uint32_t side) const {
        const std::uint32_t t = side / 3, k = side % 3;
        const std::uint32_t other = beyond_[side] / 3, j = beyond_[side] % 3;
        return {corner(t, k + 2), corner(t, k), corner(other, j + 2), corner(t, k + 1)};
    }

    /// The best quads first; triangles that have only one partner left would be better, but cost more to find.
    void pair() {
        struct Choice {
            double quality;
            std::uint32_t side;
        };

        std::vector<Choice> choices;
        for (std::uint32_t side = 0; side < beyond_.size(); ++side)
            if (beyond_[side] != no_triangle_beyond && side < beyond_[side])
                if (const double how = quality(quad_over(side)); how > least_turn)
                    choices.push_back({how, side});
        std::ranges::sort(choices, [](const Choice& a, const Choice& b) {
            return a.quality != b.quality ? a.quality > b.quality : a.side < b.side;
        });
        for (const Choice& each : choices) {
            const std::uint32_t t = each.side / 3, other = beyond_[each.side] / 3;
            if (cell_of_[t] != no_triangle_beyond || cell_of_[other] != no_triangle_beyond)
                continue;
            cell_of_[t] = cell_of_[other] = static_cast<std::uint32_t>(cells_.size());
            cells_.push_back({quad_over(each.side), {no_vertex, no_vertex, no_vertex, no_vertex}});
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

    /// Where both that share a side would cut it, they share its middle.
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

    /// On the side of the cell that the triangle beyond has become.
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
