// The error that the integrator's steps make on a moving surface: a sample of its vertices is carried a
// second time, in finer steps, and what is learnt there holds for the others near by.
#pragma once

#include "core/base/box.hpp"
#include "core/field/flow.hpp"
#include "core/surface/moving/moving_mesh.hpp"

#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// The error across the surface per unit of time, by place in the domain. It is a value: part of a surface's
/// state.
class StepErrors {
  public:
    StepErrors() = default;
    explicit StepErrors(const Box& domain);

    /// Begins with steps as long as `h`: what was learnt before counts for less, and as much as it would be
    /// with such steps.
    void begin(double h);

    /// Says that nothing is known of steps as long as `h`.
    bool too_long(double h) const { return h > 1.1 * step_; }

    void learn(const Vec3& position, double rate);

    /// Returns the error learnt near by; elsewhere the largest that is known.
    double at(const Vec3& position) const;

    /// Returns the distance from one end of the domain to the other.
    double largest_distance() const { return widest_; }

    std::size_t bytes() const { return rate_.capacity() * sizeof(float); }

  private:
    std::size_t place(const Vec3& position) const;

    Vec3 low_{0.0};
    double widest_ = 0.0; ///< of the domain
    Vec3 scale_{0.0};
    std::vector<float> rate_; ///< of boxes; 0: nothing is known
    float largest_ = 0.0f;
    double step_ = 0.0; ///< length of the integrator's
};

/// A sample of a mesh's vertices, before a step.
class StepSample {
  public:
    /// @param turn  another sample each
    StepSample(const MovingMesh& mesh, std::uint64_t turn);

    /// Carries them to where the mesh has been carried, in finer steps, and adds to `errors` how far across
    /// the surface they come from its vertices. REQUIRES: the mesh has been carried with `options`, and is
    /// otherwise as it was. Error: as advancing.
    Result<void> learn(StepErrors& errors,
                       const Flow& flow,
                       const MovingMesh& mesh,
                       AdvanceOptions options,
                       std::stop_token stop);

  private:
    std::vector<VertexId> vertex_;
    std::vector<Vec3> start_, position_;
    std::vector<double> time_;
    std::vector<CurveEnd> end_;
    double from_;
};

/// Adds to every moving vertex the errors of the steps since `since`.
void add_step_errors(MovingMesh& mesh, const StepErrors& errors, double since);

/// The moving vertices whose error has come to more than `trusted`, and would have less were they traced
/// again.
std::vector<VertexId> vertices_beyond(const MovingMesh& mesh, double trusted);

/// Returns the error of a vertex, a length across the surface, with that of the steps since `since`.
float stated_error(const MovingMesh& mesh, VertexId v, const StepErrors& errors, double since);

} // namespace wakesurf::core
