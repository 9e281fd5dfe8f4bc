// A survey of a flow: its velocity at a few places.
#pragma once

#include "core/field/flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// The velocities at those of some places that are in the fluid.
class FlowSamples {
  public:
    static Result<FlowSamples>
    at(const Flow& flow, std::span<const Vec3> places, double time, const std::stop_token& stop) {
        FlowSamples out;
        for (const Vec3& p : places)
            if (flow.status(p) == PointStatus::Inside)
                out.place.push_back(p);
        const std::vector<double> times(out.place.size(), time);
        out.velocity.resize(out.place.size());
        std::vector<std::uint8_t> gap(out.place.size());
        return flow.sample(out.place, times, out.velocity, stop)
            .and_then([&] { return flow.mark_gaps(out.place, times, gap, stop); })
            .map([&] {
                for (std::size_t i = 0; i < gap.size(); ++i)
                    if (gap[i] != 0 || !finite(out.velocity[i]))
                        out.velocity[i] = Vec3(0.0);
                return std::move(out);
            });
    }

    double fastest() const {
        double speed = 0.0;
        for (const Vec3& v : velocity)
            speed = std::max(speed, glm::length(v));
        return speed;
    }

    /// Returns the sum, and the largest, of the velocities' parts along a direction.
    std::array<double, 2> along(const Vec3& direction) const {
        double sum = 0.0;
        double largest = 0.0;
        for (const Vec3& v : velocity) {
            sum += glm::dot(v, direction);
            largest = std::max(largest, std::abs(glm::dot(v, direction)));
        }
        return {sum, largest};
    }

    std::vector<Vec3> place;
    std::vector<Vec3> velocity;
};

} // namespace wakesurf::core
