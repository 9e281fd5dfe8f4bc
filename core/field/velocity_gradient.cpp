#include "core/field/velocity_gradient.hpp"

#include <glm/matrix.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>

namespace wakesurf::core {

namespace {

constexpr std::size_t most_at_once = std::size_t{1} << 16;
constexpr std::size_t places = 7; ///< a point and its neighbours: below and above along x, y, z

/// Where the velocity is asked for, for each of some points, and which of the places are in the flow.
struct Star {
    std::array<Vec3, places> at;
    std::array<bool, places> inside{};
};

Star star_of(const Flow& flow, const Vec3& point, double step) {
    Star star;
    star.at.fill(point);
    for (int axis = 0; axis < 3; ++axis) {
        star.at[1 + 2 * axis][axis] -= step;
        star.at[2 + 2 * axis][axis] += step;
    }
    for (std::size_t k = 0; k < places; ++k) {
        star.inside[k] = flow.status(star.at[k]) == PointStatus::Inside;
        // Not asked for where it means nothing.
        if (!star.inside[k])
            star.at[k] = point;
    }
    return star;
}

glm::dmat3 gradient_of(const Star& star, const Vec3* velocity, double step) {
    glm::dmat3 out(std::numeric_limits<double>::quiet_NaN());
    for (int axis = 0; axis < 3; ++axis) {
        const auto below = static_cast<std::size_t>(1 + 2 * axis);
        const std::size_t from = star.inside[below] ? below : 0;
        const std::size_t to = star.inside[below + 1] ? below + 1 : 0;
        const double distance = (from == 0 ? 0.0 : step) + (to == 0 ? 0.0 : step);
        out[axis] = star.inside[0] && distance > 0.0
                        ? (velocity[to] - velocity[from]) / distance
                        : Vec3(std::numeric_limits<double>::quiet_NaN());
    }
    return out;
}

} // namespace

Result<std::vector<glm::dmat3>> velocity_gradients(const Flow& flow,
                                                   std::span<const Vec3> positions,
                                                   std::span<const double> times,
                                                   double step,
                                                   const std::stop_token& stop) {
    std::vector<glm::dmat3> out(positions.size());
    std::vector<std::size_t> order(positions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return times[i]; });
    std::vector<Star> stars;
    std::vector<Vec3> asked, velocity;
    std::vector<double> when;
    for (std::size_t begin = 0; begin < order.size(); begin += most_at_once) {
        const std::size_t count = std::min(most_at_once, order.size() - begin);
        const std::span<const std::size_t> points(order.data() + begin, count);
        stars.resize(count);
        asked.resize(places * count);
        when.resize(places * count);
        velocity.resize(places * count);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end() && !stop.stop_requested(); ++i) {
                stars[i] = star_of(flow, positions[points[i]], step);
                std::ranges::copy(stars[i].at,
                                  asked.begin() + static_cast<std::ptrdiff_t>(places * i));
                std::fill_n(when.begin() + static_cast<std::ptrdiff_t>(places * i), places,
                            times[points[i]]);
            }
        });
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "sampling was cancelled");
        if (auto sampled = flow.sample(asked, when, velocity, stop); !sampled)
            return tl::unexpected(sampled.error());
        for (std::size_t i = 0; i < count; ++i)
            out[points[i]] = gradient_of(stars[i], velocity.data() + places * i, step);
    }
    return out;
}

double vorticity(const glm::dmat3& g) {
    return glm::length(Vec3(g[1].z - g[2].y, g[2].x - g[0].z, g[0].y - g[1].x));
}

double q_criterion(const glm::dmat3& g) {
    const glm::dmat3 strain = 0.5 * (g + glm::transpose(g));
    const glm::dmat3 rotation = 0.5 * (g - glm::transpose(g));
    double q = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        q +=
            0.5 * (glm::dot(rotation[axis], rotation[axis]) - glm::dot(strain[axis], strain[axis]));
    return q;
}

std::optional<GradientField> find_gradient_field(std::string_view name) {
    if (name == vorticity_name)
        return GradientField::Vorticity;
    if (name == q_criterion_name)
        return GradientField::QCriterion;
    return std::nullopt;
}

Result<std::vector<float>> sample_gradient_field(GradientField field,
                                                 const Flow& flow,
                                                 std::span<const Vec3> positions,
                                                 std::span<const double> times,
                                                 const std::stop_token& stop) {
    const auto gradients = velocity_gradients(flow, positions, times, flow.finest_spacing(), stop);
    if (!gradients)
        return tl::unexpected(gradients.error());
    std::vector<float> out;
    out.reserve(gradients->size());
    for (const glm::dmat3& gradient : *gradients)
        out.push_back(static_cast<float>(
            field == GradientField::Vorticity ? vorticity(gradient) : q_criterion(gradient)));
    return out;
}

} // namespace wakesurf::core
