#include "core/surface/columns/zip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

/// A chord between two particles close to a convex wall dips into it by at most half its length; above a
/// quarter of the separation that is worth refining, below it stays within an eighth.
bool crosses_obstacle(const ZipRules& rules, const Vec3& a, const Vec3& b, double length) {
    return rules.obstacle && length > 0.25 * rules.separation &&
           rules.flow->status(0.5 * (a + b)) == PointStatus::InObstacle;
}

bool leaves_joinable(std::size_t a, std::size_t b) {
    return (a == 0 && b == 0) || (a > 0 && b > 0 && joinable(a, b));
}

} // namespace

std::optional<ZipStep> next_quad(const ZipRules& rules,
                                 std::span<const Vec3> left,
                                 std::span<const Vec3> right,
                                 StripFront front,
                                 ZipMode mode) {
    constexpr ZipStep choices[] = {{1, 1}, {2, 1}, {1, 2}};
    constexpr double hanging_node_cost =
        0.15; // as skew: a T is taken when it straightens the front by 9 degrees
    const std::size_t left_rest = left.size() - 1 - front.left;
    const std::size_t right_rest = right.size() - 1 - front.right;
    const Vec3 left_now = left[front.left];
    const Vec3 right_now = right[front.right];

    std::optional<ZipStep> best;
    double best_cost = std::numeric_limits<double>::infinity();
    for (const ZipStep& step : choices) {
        if (step.left > left_rest || step.right > right_rest)
            continue;
        if (mode == ZipMode::ToBothEnds &&
            !leaves_joinable(left_rest - step.left, right_rest - step.right))
            continue;
        const Vec3 l = left[front.left + step.left];
        const Vec3 r = right[front.right + step.right];
        const Vec3 edge = r - l;
        const double length = glm::length(edge);
        if (length > rules.separation * (1.0 + 1e-9) || crosses_obstacle(rules, l, r, length))
            continue;
        const Vec3 along = (l - left_now) + (r - right_now);
        const double product = length * glm::length(along);
        const double skew = product > 0.0 ? std::abs(glm::dot(edge, along)) / product : 1.0;
        const double cost = skew + (step.left != step.right ? hanging_node_cost : 0.0);
        if (cost < best_cost) {
            best = step;
            best_cost = cost;
        }
        if (best_cost <= hanging_node_cost)
            break; // the other choices cost that much at least
    }
    return best;
}

double front_width(const Column& left, const Column& right, StripFront front) {
    const auto direction = [](const Column& column, std::size_t i) {
        if (column.segments() == 0)
            return Vec3(0.0);
        const std::size_t from = std::min(i, column.segments() - 1);
        return column.position[from + 1] - column.position[from];
    };
    const Vec3 edge = right.position[front.right] - left.position[front.left];
    const Vec3 along = direction(left, front.left) + direction(right, front.right);
    const double length = glm::length(along);
    if (length == 0.0)
        return glm::length(edge);
    return glm::length(edge - along * (glm::dot(edge, along) / (length * length)));
}

} // namespace wakesurf::core
