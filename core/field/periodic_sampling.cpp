#include "core/field/periodic_sampling.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

/// A part of the period: single precision of coordinates.
constexpr double on_the_side = 1e-6;

} // namespace

PeriodicPlace PeriodicBox::place_of(const Vec3& position) const {
    PeriodicPlace place{position, {0, 0, 0}};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double beyond = position[axis] - box_.lo[axis];
        const double period = box_.hi[axis] - box_.lo[axis];
        if (!axes_[i] || (beyond >= 0.0 && position[axis] <= box_.hi[axis]) ||
            !std::isfinite(beyond))
            continue;
        const double most = periods_beyond;
        place.periods[i] =
            static_cast<std::int8_t>(std::clamp(std::floor(beyond / period), -most, most));
    }
    place.in_box -= shift(place.periods);
    return place;
}

Vec3 PeriodicBox::shift(const Periods& periods) const {
    return box_.extent() * Vec3(periods[0], periods[1], periods[2]);
}

unsigned PeriodicBox::sides_at(const Vec3& in_box) const {
    unsigned sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double off = std::min(std::abs(in_box[axis] - box_.lo[axis]),
                                    std::abs(in_box[axis] - box_.hi[axis]));
        if (axes_[static_cast<std::size_t>(axis)] && off <= on_the_side * box_.extent()[axis])
            sides |= 1u << axis;
    }
    return sides;
}

std::optional<SideCrossing> PeriodicBox::crossing_at(const PeriodicPlace& place) const {
    const unsigned sides = sides_at(place.in_box);
    return sides == 0 ? std::nullopt : std::optional(SideCrossing{place, sides});
}

bool PeriodicBox::still_there(const SideCrossing& crossing, const PeriodicPlace& place) const {
    const Vec3 gone =
        place.in_box + shift(place.periods) - crossing.from.in_box - shift(crossing.from.periods);
    double shortest = std::numeric_limits<double>::infinity(); // period
    for (int axis = 0; axis < 3; ++axis)
        if (axes_[static_cast<std::size_t>(axis)])
            shortest = std::min(shortest, box_.extent()[axis]);
    return glm::length(gone) <= 4.0 * on_the_side * shortest &&
           (sides_at(place.in_box) & ~crossing.sides) == 0;
}

std::optional<PeriodicPlace> PeriodicBox::across(SideCrossing& crossing) const {
    const int ways = 1 << std::popcount(crossing.sides);
    while (crossing.tried < ways) {
        unsigned crossed = static_cast<unsigned>(ways - 1 - crossing.tried++);
        PeriodicPlace place = crossing.from;
        bool within = true;
        for (int axis = 0; axis < 3; ++axis) {
            if ((crossing.sides & (1u << axis)) == 0)
                continue;
            const bool to_low = low(place.in_box, axis) != ((crossed & 1u) != 0);
            if ((crossed & 1u) != 0) {
                auto& periods = place.periods[static_cast<std::size_t>(axis)];
                periods = static_cast<std::int8_t>(periods + (to_low ? 1 : -1));
                within = within && std::abs(periods) <= periods_beyond;
            }
            const double moved = (crossed & 1u) == 0 ? 0.0
                                 : to_low            ? -box_.extent()[axis]
                                                     : box_.extent()[axis];
            place.in_box[axis] =
                std::clamp(place.in_box[axis] + moved, box_.lo[axis], box_.hi[axis]);
            crossed >>= 1;
        }
        if (within)
            return place;
    }
    return std::nullopt;
}

} // namespace wakesurf::core
