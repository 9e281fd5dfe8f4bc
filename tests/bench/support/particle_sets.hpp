// The start of particles in the advection benchmarks. Order matters more than anything else: neighbours in
// memory that are neighbours in the field share its cache lines.
#pragma once

#include "core/dataset/grid.hpp"
#include "core/integrate/particles.hpp"

#include <vector>

namespace wakesurf::bench {

/// Returns a sheet of 173 x 173 particles, folded, in mesh order, like the vertices of a streak surface.
std::vector<core::Vec3> front_particles(const core::UniformGrid& grid);

/// Returns 30,000 places, uniformly random, the same every time, eight cells away from the border.
std::vector<core::Vec3> random_particles(const core::UniformGrid& grid);

/// Holds particles, with the results of Flow::advance in arrays of their own.
class CarriedParticles {
  public:
    CarriedParticles(std::vector<core::Vec3> start, bool tangents)
        : start_(std::move(start)), tangents_(tangents) {}

    /// Returns the particles at the start, at time 0.
    core::Particles restart() {
        position_ = start_;
        time_.assign(start_.size(), 0.0);
        end_.assign(start_.size(), core::CurveEnd::Running);
        if (tangents_) {
            along_s_.assign(start_.size(), core::Vec3(1.0, 0.0, 0.0));
            along_t_.assign(start_.size(), core::Vec3(0.0, 1.0, 0.0));
            expansion_.assign(start_.size(), 0.0f);
        }
        return {position_, along_s_, along_t_, time_, end_, {}, {}, {}, expansion_};
    }

    const std::vector<core::Vec3>& start() const { return start_; }

    const std::vector<core::Vec3>& position() const { return position_; }

  private:
    std::vector<core::Vec3> start_, position_, along_s_, along_t_;
    std::vector<double> time_;
    std::vector<float> expansion_;
    std::vector<core::CurveEnd> end_;
    bool tangents_;
};

} // namespace wakesurf::bench
