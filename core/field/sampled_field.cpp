#include "core/field/sampled_field.hpp"

#include "core/field/sample_scalar.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace wakesurf::core {

namespace {

/// Calls `value` with each velocity. A place where the data have a gap has no value.
template <class Value>
Result<std::vector<float>> of_velocity(const Flow& flow,
                                       std::span<const Vec3> places,
                                       double time,
                                       const std::stop_token& stop,
                                       const Value& value) {
    std::vector<Vec3f> velocities(places.size());
    if (auto sampled = flow.sample_at(places, time, velocities, stop); !sampled)
        return tl::unexpected(sampled.error());
    std::vector<std::uint8_t> gap(places.size());
    const std::vector<double> times(places.size(), time);
    if (auto marked = flow.mark_gaps(places, times, gap, stop); !marked)
        return tl::unexpected(marked.error());
    std::vector<float> out(places.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = gap[i] != 0 ? std::numeric_limits<float>::quiet_NaN() : value(velocities[i]);
    return out;
}

} // namespace

Result<std::vector<float>> sample_field(const SampledField& field,
                                        const Flow& flow,
                                        std::span<const Vec3> places,
                                        double time,
                                        const std::stop_token& stop) {
    if (places.empty())
        return std::vector<float>{};
    if (std::holds_alternative<SpeedField>(field))
        return of_velocity(flow, places, time, stop, [](const Vec3f& v) { return glm::length(v); });
    if (const auto* along = std::get_if<VelocityAlong>(&field))
        return of_velocity(flow, places, time, stop, [d = Vec3f(along->direction)](const Vec3f& v) {
            return glm::dot(v, d);
        });
    const std::vector<double> times(places.size(), time);
    if (const auto* stored = std::get_if<StoredScalar>(&field))
        return sample_scalar(flow, *stored->source, stored->scalar, places, times, stop);
    const std::array wanted{std::get<GradientField>(field)};
    return sample_gradient_fields(wanted, flow, places, times, stop)
        .map([](std::vector<std::vector<float>>&& lists) { return std::move(lists.front()); });
}

} // namespace wakesurf::core
