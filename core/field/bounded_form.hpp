// A closed form on its domain as a flow: sampled exactly, never through a grid.
#pragma once

#include "core/field/advance_particles.hpp"
#include "core/field/flow.hpp"
#include "core/field/trace_curves.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace wakesurf::core {

/// A form is a velocity(position, time). One with a body has solid(), and wall(box) if its shape can be
/// displayed.
template <class Form>
concept HasBody = requires(const Form& form, const Vec3& p) {
    form.solid(p);
};

template <class Form>
concept HasWall = requires(const Form& form, const Box& box) {
    form.wall(box);
};

template <class Form>
struct BoundedForm {
    Form form;
    Box box;

    Vec3 velocity(const Vec3& p, double t) const { return form.velocity(p, t); }

    /// Returns (grad v) w by central differences: 1e-5 of the domain balances truncation and rounding at
    /// about 1e-10.
    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const {
        const double length = glm::length(w);
        if (length == 0.0)
            return Vec3(0.0);
        const Vec3 side = box.extent();
        const double h = 1e-5 * std::min({side.x, side.y, side.z});
        const Vec3 offset = w * (h / length);
        return (form.velocity(p + offset, t) - form.velocity(p - offset, t)) * (length / (2.0 * h));
    }

    /// Returns 0 where a form says that it is free of divergence, which saves six velocities.
    double divergence(const Vec3& p, double t) const {
        if constexpr (requires { Form::divergence_free; })
            return 0.0;
        else
            return divergence_of([&](const Vec3& w) { return derivative(p, t, w); });
    }

    /// Implements SteadyField.
    static constexpr bool steady() {
        if constexpr (requires { Form::steady; })
            return Form::steady;
        return false;
    }

    PointStatus status(const Vec3& p) const {
        if (!box.contains(p))
            return PointStatus::OutsideDomain;
        return solid(p) ? PointStatus::InObstacle : PointStatus::Inside;
    }

    bool solid(const Vec3& p) const {
        if constexpr (HasBody<Form>)
            return form.solid(p);
        else
            return false;
    }

    double finest_spacing() const {
        const Vec3 side = box.extent();
        return std::min({side.x, side.y, side.z}) / 100.0;
    }

    /// True where one of the 26 points round `p`, a part of the finest spacing away on each axis, lies in the
    /// body.
    bool at_wall(const Vec3& p) const {
        if constexpr (!HasBody<Form>)
            return false;
        const double near = near_wall * finest_spacing();
        for (int i = 0; i < 27; ++i)
            if (solid(p + near * (Vec3(i % 3, i / 3 % 3, i / 9) - 1.0)))
                return true;
        return false;
    }
};

template <class Form>
class AnalyticFlow final : public Flow {
  public:
    AnalyticFlow(Form form, Box box) : field_{std::move(form), box} {
        if constexpr (HasWall<Form>) // a cylinder of no radius is none
            obstacle_ = !field_.form.wall(box).triangles.empty();
    }

    /// @param obstacle  there is one, whether its wall can be looked at or not
    AnalyticFlow(Form form, Box box, bool obstacle)
        : field_{std::move(form), box}, obstacle_(obstacle) {}

    Box domain() const override { return field_.box; }

    std::optional<std::array<double, 2>> time_range() const override { return std::nullopt; }

    double finest_spacing() const override { return field_.finest_spacing(); }

    PointStatus status(const Vec3& position) const override { return field_.status(position); }

    Result<TraceCost> trace(std::span<Curve> curves,
                            const TraceOptions& options,
                            std::stop_token stop) const override {
        // Each curve runs to its own end: the limit is infinitely late, or early for upstream ones.
        const double never = curves.empty() || curves.front().duration >= 0.0
                                 ? std::numeric_limits<double>::infinity()
                                 : -std::numeric_limits<double>::infinity();
        if (!trace_curves(field_, curves, options, never, stop))
            return tl::unexpected(cut_short(options));
        return TraceCost{};
    }

    Result<TraceCost> advance(const Particles& particles,
                              double to,
                              const AdvanceOptions& options,
                              std::stop_token stop) const override {
        int sign = 0;
        for (std::size_t i = 0; i < particles.count() && sign == 0; ++i)
            if (particles.end[i] == CurveEnd::Running && particles.time[i] != to)
                sign = particles.time[i] < to ? +1 : -1;
        if (!advance_particles(field_, particles, to, sign, options, stop))
            return fail(Error::Code::Cancelled, "the integration was cancelled");
        return TraceCost{};
    }

    bool few_data(double, double) const override { return true; }

    bool obstacle() const override { return obstacle_; }

    WallGeometry walls() const override {
        if constexpr (HasWall<Form>)
            return field_.form.wall(field_.box);
        else
            return {};
    }

    Result<void> sample(std::span<const Vec3> positions,
                        std::span<const double> times,
                        std::span<Vec3> velocities,
                        std::stop_token,
                        bool) const override {
        for (std::size_t i = 0; i < positions.size(); ++i)
            velocities[i] = field_.velocity(positions[i], times[i]);
        return {};
    }

  private:
    BoundedForm<Form> field_;
    bool obstacle_ = HasBody<Form>;
};

} // namespace wakesurf::core
