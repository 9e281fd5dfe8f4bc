#include "core/surface/columns/curve_errors.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/carried_error.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wakesurf::core {

namespace {

constexpr std::size_t knot_steps = 4; ///< between two tests of the neighbours

/// The place of a particle at a time and its velocity, at the start of a step.
struct CurveState {
    double time;
    Vec3 position, velocity;
};

/// Returns the state at the end of the curve's first `steps` steps.
CurveState state_after(const Curve& curve, std::size_t steps) {
    if (steps < curve.steps.size()) {
        const CurveStep& step = curve.steps[steps];
        return {step.time, Vec3(step.c[0]), Vec3(step.c[1] + step.c[2]) / step.dt};
    }
    const CurveStep& step = curve.steps.back();
    return {curve.last.time, curve.last.position,
            Vec3(step.c[1] - step.c[2] - step.c[3]) / step.dt};
}

/// A neighbouring curve, read in order of time.
class Neighbour {
  public:
    Neighbour(const SeededCurve* curve, double s)
        : curve_(curve == nullptr ? nullptr : &curve->curve),
          apart_(curve == nullptr ? 0.0 : curve->s - s) {}

    /// dx/ds as the difference to where the neighbour's particle is at that time; nothing where that has
    /// ended.
    std::optional<Vec3> tangent(const CurveState& at) {
        if (curve_ == nullptr || std::abs(at.time) > std::abs(curve_->last.time))
            return std::nullopt;
        const auto& steps = curve_->steps;
        while (step_ + 1 < steps.size() && std::abs(steps[step_ + 1].time) <= std::abs(at.time))
            ++step_;
        if (steps.empty())
            return std::nullopt;
        const CurveStep& step = steps[step_];
        const double theta = std::clamp((at.time - step.time) / step.dt, 0.0, 1.0);
        return (Vec3(step.at(theta)) - at.position) / apart_;
    }

  private:
    const Curve* curve_;
    double apart_;
    std::size_t step_ = 0;
};

} // namespace

CurveErrors::CurveErrors(std::vector<const SeededCurve*> curves, const std::stop_token& stop)
    : curves_(std::move(curves)) {
    const auto before = [](const SeededCurve* a, const SeededCurve* b) { return a->s < b->s; };
    std::sort(curves_.begin(), curves_.end(), before);
    curves_.erase(std::unique(curves_.begin(), curves_.end()), curves_.end());
    knots_.resize(curves_.size());
    for_each_index(
        curves_.size(),
        [&](std::size_t i) {
            if (!stop.stop_requested())
                knots_[i] = along(*curves_[i], i > 0 ? curves_[i - 1] : nullptr,
                                  i + 1 < curves_.size() ? curves_[i + 1] : nullptr);
        },
        4);
}

std::vector<CurveErrors::Knot>
CurveErrors::along(const SeededCurve& seeded, const SeededCurve* left, const SeededCurve* right) {
    const Curve& curve = seeded.curve;
    std::vector<Knot> knots{{0.0, 0.0}};
    Neighbour before(left, seeded.s), after(right, seeded.s);
    Vec3 across = curve.seed_tangent;
    CarriedError error;
    double pending = 0.0, expansion = 0.0;
    for (std::size_t i = 0; i < curve.steps.size(); ++i) {
        pending += double(curve.steps[i].error);
        expansion += double(curve.steps[i].expansion);
        const bool last = i + 1 == curve.steps.size();
        if ((i + 1) % knot_steps != 0 && !last)
            continue;
        const CurveState at = state_after(curve, i + 1);
        const auto a = before.tangent(at);
        const auto b = after.tangent(at);
        // Across a tear one of the two says nothing of the surface; else both do.
        if (a && b)
            across = glm::dot(*a, *a) < glm::dot(*b, *b) ? *a : *b;
        else if (a || b)
            across = a ? *a : *b;
        const SurfaceTangents here{across, at.velocity, expansion};
        error.add(here, pending);
        pending = 0.0;
        const double arc = last ? curve.last.arc : curve.steps[i + 1].c[0].w;
        const double stated = error.across(here);
        knots.push_back({arc, stated < arc ? stated : arc}); // no farther than it has come
    }
    return knots;
}

float CurveErrors::at(const SeededCurve* curve, double arc) const {
    const auto place =
        std::lower_bound(curves_.begin(), curves_.end(), curve,
                         [](const SeededCurve* a, const SeededCurve* b) { return a->s < b->s; });
    const auto& knots = knots_[static_cast<std::size_t>(place - curves_.begin())];
    const auto after = std::upper_bound(knots.begin(), knots.end(), arc,
                                        [](double a, const Knot& knot) { return a < knot.arc; });
    if (after == knots.end())
        return static_cast<float>(knots.back().error);
    const Knot& from = *std::prev(after);
    const double part = (arc - from.arc) / (after->arc - from.arc);
    return static_cast<float>(from.error + part * (after->error - from.error));
}

} // namespace wakesurf::core
