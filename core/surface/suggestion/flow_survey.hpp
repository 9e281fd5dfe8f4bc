// A coarse survey of a whole flow at one time: where there is fluid, where the flow goes, and where it turns.
// The input of a suggestion.
#pragma once

#include "core/field/flow.hpp"

#include <array>
#include <cstddef>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// Boxes of equal size that fill a domain, x fastest.
struct SurveyLattice {
    Box domain;
    std::array<int, 3> count{1, 1, 1};

    std::size_t size() const {
        return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
               static_cast<std::size_t>(count[2]);
    }

    Vec3 step() const { return domain.extent() / Vec3(count[0], count[1], count[2]); }

    std::size_t index(const std::array<int, 3>& at) const {
        return static_cast<std::size_t>((at[2] * count[1] + at[1]) * count[0] + at[0]);
    }

    std::array<int, 3> place(std::size_t index) const;
    Vec3 centre(const std::array<int, 3>& at) const;

    /// Returns the box that a point lies in; the nearest one for points outside.
    std::array<int, 3> box_of(const Vec3& point) const;
};

/// Returns about `points` boxes, as near to cubes as that allows, and at least 3 along each axis: a domain
/// may be thin.
SurveyLattice survey_lattice(const Box& domain, int points);

/// Marks the boxes without fluid in their middle. Cost: a lookup a box, in parallel.
std::vector<std::uint8_t> not_fluid(const Flow& flow, const SurveyLattice& lattice);

struct FlowSurvey {
    SurveyLattice lattice;
    std::vector<std::uint8_t> solid; ///< not_fluid()
    std::vector<Vec3> velocity;      ///< in the middles; zero where there is no fluid, or no number
    Vec3 mean{0.0};                  ///< velocity, of the fluid
    double speed = 0.0;              ///< the mean of the fluid's

    /// The flow goes through the domain, rather than round and round in it.
    bool through() const;

    /// The axis that the flow goes along, and which way. REQUIRES: through().
    int axis() const;

    double sign() const { return mean[axis()] < 0.0 ? -1.0 : 1.0; }
};

/// Takes some 30,000 lookups and samples at one time. Error: that of Flow::sample.
Result<FlowSurvey> survey_flow(const Flow& flow, double time, std::stop_token stop);

/// Computes by differences between the middles of boxes.
Vec3 vorticity_in(const FlowSurvey& survey, const std::array<int, 3>& box);

/// The place where the flow turns most, with a preference for the middle of the domain to its sides.
struct Rotation {
    Vec3 place{0.0};
    Vec3 vorticity{0.0};
    Vec3 velocity{0.0};
    /// Vorticity there x half of the longest side / mean speed: how much it matters.
    double strength = 0.0;
};

Rotation strongest_rotation(const FlowSurvey& survey);

} // namespace wakesurf::core
