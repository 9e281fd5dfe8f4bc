// Advances many curves at once over one field, in parallel. Each curve is a pure function of its seed, so the
// result is the same for any number of threads.
#pragma once

#include "core/field/field_in_series.hpp"
#include "core/integrate/cursor_of.hpp"
#include "core/integrate/runge_kutta_steps.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <span>
#include <utility>

namespace wakesurf::core {

/// Advances until the simulation time `limit` (infinite: to every curve's own end). Returns false if `stop` fired, or there is no memory
/// for the steps: see cut_short.
/// Isolated: a thread that waits here takes no work of another surface.
template <VelocityField Field>
bool trace_curves(const Field& field,
                  std::span<Curve> curves,
                  const TraceOptions& options,
                  double limit,
                  const std::stop_token& stop) {
    std::atomic<bool> whole{true};
    const auto advance = [&](Curve& curve) {
        const double until = curve.duration < 0.0 ? std::max(curve.duration, limit - curve.release)
                                                  : std::min(curve.duration, limit - curve.release);
        const double sign = curve.duration < 0.0 ? -1.0 : 1.0;
        const auto go = [&](auto steps) {
            if (!advance_curve(std::move(steps), curve, options, until, stop))
                whole = false;
        };
        if constexpr (FieldInSeries<Field>) {
            if (options.method == TraceOptions::Method::Dopri5)
                return go(field.series_steps(options, sign));
        }
        const auto& view = cursor_of(field);
        go(RungeKuttaSteps(view, options, sign));
    };
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, curves.size(), 4),
                          [&](const auto& range) {
                              for (std::size_t i = range.begin();
                                   i != range.end() && whole.load(std::memory_order_relaxed); ++i)
                                  if (curves[i].end == CurveEnd::Running)
                                      advance(curves[i]);
                          });
    });
    return whole;
}

} // namespace wakesurf::core
