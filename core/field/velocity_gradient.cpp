#include "core/field/velocity_gradient.hpp"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

namespace wakesurf::core {

namespace {

constexpr std::size_t most_points = std::size_t{1} << 16;
constexpr std::size_t places = 7; ///< a point and its neighbours: below and above along x, y, z

constexpr int halvings = 6; ///< of the step, where the flow is thinner than it

/// The places at which the velocity is sampled, for each of some points.
struct Star {
    std::array<Vec3, places> at;
    std::array<bool, places> inside{}; ///< the place is in the flow
    std::array<double, 3> step{};
};

Star star_of(const Flow& flow, const Vec3& point, double longest) {
    Star star;
    star.at.fill(point);
    star.inside[0] = flow.status(point) == PointStatus::Inside;
    for (std::size_t axis = 0; star.inside[0] && axis < 3; ++axis) {
        const std::size_t below = 1 + 2 * axis;
        double step = longest;
        for (int tries = 0; tries <= halvings; ++tries, step /= 2.0) {
            star.step[axis] = step;
            for (const std::size_t place : {below, below + 1}) {
                Vec3 at = point;
                at[static_cast<int>(axis)] += place == below ? -step : step;
                star.inside[place] = flow.status(at) == PointStatus::Inside;
                // Sampled only where the result means something.
                star.at[place] = star.inside[place] ? at : point;
            }
            if (star.inside[below] || star.inside[below + 1])
                break;
        }
    }
    return star;
}

/// Column k is the derivative along axis k.
glm::dmat3 gradient_of(const Star& star, const Vec3* velocity) {
    glm::dmat3 out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t below = 1 + 2 * axis;
        const std::size_t from = star.inside[below] ? below : 0;
        const std::size_t to = star.inside[below + 1] ? below + 1 : 0;
        const int sides = (from == 0 ? 0 : 1) + (to == 0 ? 0 : 1);
        out[static_cast<int>(axis)] =
            sides > 0 ? (velocity[to] - velocity[from]) / (sides * star.step[axis])
                      : Vec3(std::numeric_limits<double>::quiet_NaN());
    }
    return out;
}

/// Calls `take` with the number of each point and the gradient there, some points at a time, in the order of
/// time: then each time-step is loaded about once.
template <class Take>
Result<void> each_gradient(const Flow& flow,
                           std::span<const Vec3> positions,
                           std::span<const double> times,
                           double step,
                           const std::stop_token& stop,
                           Take take) {
    std::vector<std::size_t> order(positions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return times[i]; });
    std::vector<Star> stars;
    std::vector<Vec3> asked, velocity;
    std::vector<double> when;
    std::vector<std::uint8_t> gap;
    for (std::size_t begin = 0; begin < order.size(); begin += most_points) {
        const std::size_t count = std::min(most_points, order.size() - begin);
        const std::span<const std::size_t> points(order.data() + begin, count);
        stars.resize(count);
        asked.resize(places * count);
        when.resize(places * count);
        velocity.resize(places * count);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end() && !stop.stop_requested(); ++i) {
                const auto first = static_cast<std::ptrdiff_t>(places * i);
                stars[i] = star_of(flow, positions[points[i]], step);
                std::ranges::copy(stars[i].at, asked.begin() + first);
                std::fill_n(when.begin() + first, places, times[points[i]]);
            }
        });
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "sampling was cancelled");
        if (auto sampled = flow.sample(asked, when, velocity, stop); !sampled)
            return sampled;
        gap.assign(asked.size(), 0);
        if (auto marked = flow.mark_gaps(asked, when, gap, stop); !marked)
            return marked;
        for (std::size_t i = 0; i < gap.size(); ++i) {
            auto& inside = stars[i / places].inside;
            if (gap[i] != 0 && i % places == 0)
                inside.fill(false);
            else if (gap[i] != 0)
                inside[i % places] = false;
        }
        for (std::size_t i = 0; i < count; ++i)
            take(points[i], gradient_of(stars[i], velocity.data() + places * i));
    }
    return {};
}

Vec3 vorticity(const glm::dmat3& g) {
    return {g[1].z - g[2].y, g[2].x - g[0].z, g[0].y - g[1].x};
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

double real_part(GradientField field, const glm::dmat3& gradient) {
    switch (field) {
    case GradientField::Vorticity:
        return glm::length(vorticity(gradient));
    case GradientField::VorticityX:
        return vorticity(gradient).x;
    case GradientField::VorticityY:
        return vorticity(gradient).y;
    case GradientField::VorticityZ:
        return vorticity(gradient).z;
    case GradientField::QCriterion:
        return q_criterion(gradient);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::optional<GradientField> find_gradient_field(std::string_view name) {
    const auto found = std::ranges::find(gradient_field_names, name);
    if (found == gradient_field_names.end())
        return std::nullopt;
    return static_cast<GradientField>(found - gradient_field_names.begin());
}

Result<std::vector<std::vector<float>>>
sample_gradient_fields(std::span<const GradientField> fields,
                       const Flow& flow,
                       std::span<const Vec3> positions,
                       std::span<const double> times,
                       const std::stop_token& stop) {
    std::vector<std::vector<float>> out(fields.size(), std::vector<float>(positions.size()));
    const auto keep = [&](std::size_t i, const glm::dmat3& gradient) {
        for (std::size_t k = 0; k < fields.size(); ++k)
            out[k][i] = static_cast<float>(real_part(fields[k], gradient));
    };
    if (fields.empty())
        return out;
    if (auto done = each_gradient(flow, positions, times, flow.finest_spacing(), stop, keep); !done)
        return tl::unexpected(done.error());
    return out;
}

} // namespace wakesurf::core
