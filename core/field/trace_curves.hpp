// Advances many curves at once over one field, in parallel. Each curve is a pure function of its seed, so the
// result is the same for any number of threads.
#pragma once

#include "core/base/for_each_index.hpp"
#include "core/dataset/missing_bricks.hpp"
#include "core/field/field_in_series.hpp"
#include "core/field/look_ahead.hpp"
#include "core/field/trace_together.hpp"
#include "core/integrate/cursor_of.hpp"
#include "core/integrate/runge_kutta.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace wakesurf::core {

/// Advances until the simulation time `limit` (infinite: to every curve's own end). Returns false if `stop`
/// fired, or there is no memory for the steps: see cut_short; or what is missing cannot be had: see
/// MissingBricks::error. Isolated: a thread that waits here takes no work of another surface.
/// @param kernel  of curves that go together, where the field lets them
template <VelocityField Field>
bool trace_curves(const Field& field,
                  std::span<Curve> curves,
                  const TraceOptions& options,
                  double limit,
                  const std::stop_token& stop,
                  const SeriesKernel& kernel = series_portable) {
    MissingBricks* missing = nullptr;
    if constexpr (PagedField<Field>)
        missing = field.missing();
    const auto carry = [&](const auto& steps_of) {
        using Steps = decltype(steps_of(cursor_of(field), 1.0));
        std::vector<WaitingAt<Steps>> waiting(missing != nullptr ? curves.size() : 0);
        std::vector<std::uint8_t> done(waiting.size());
        std::atomic<bool> whole{true};
        const auto until = [&](const Curve& curve) {
            return curve.duration < 0.0 ? std::max(curve.duration, limit - curve.release)
                                        : std::min(curve.duration, limit - curve.release);
        };
        const auto direction = [](const Curve& curve) { return curve.duration < 0.0 ? -1.0 : 1.0; };
        const auto advance = [&](std::size_t i) {
            Curve& curve = curves[i];
            const auto& view = cursor_of(field);
            if (!advance_curve(steps_of(view, direction(curve)), curve, options, until(curve), stop,
                               waiting.empty() ? nullptr : &waiting[i]))
                whole = false;
            if (!done.empty())
                done[i] = missed(view) || curve.wanted > 0 ? 0 : 1;
            if (const std::size_t wanted = std::exchange(curve.wanted, 0))
                missing->want(*options.memory, wanted);
        };
        const auto goes_on = [&](std::size_t i) {
            return curves[i].end == CurveEnd::Running && (done.empty() || !done[i]);
        };
        const auto advance_together = [&](auto begin, std::size_t end) {
            const auto& view = cursor_of(field);
            using Advance = CurveAdvance<Steps, KeepInCurve>;
            const auto next = [&]() -> std::optional<Advance> {
                while (begin != end && !goes_on(begin))
                    ++begin;
                if (begin == end || !whole.load(std::memory_order_relaxed))
                    return std::nullopt;
                Curve& curve = curves[begin++];
                if (curve.attempts == 0)
                    set_out(curve);
                return Advance(steps_of(view, direction(curve)), curve, options, until(curve), stop,
                               KeepInCurve{curve, options});
            };
            if (!trace_together(kernel, next))
                whole = false;
        };
        const auto advance_range = [&](std::size_t begin, std::size_t end) {
            const bool together = StepsInLanes<Steps> && missing == nullptr;
            for_each_range(end - begin, together ? 8 : 4, [&](std::size_t from, std::size_t to) {
                if constexpr (StepsInLanes<Steps>)
                    if (together)
                        return advance_together(begin + from, begin + to);
                for (std::size_t i = begin + from;
                     i != begin + to && whole.load(std::memory_order_relaxed); ++i)
                    if (goes_on(i))
                        advance(i);
            });
            return whole.load();
        };
        const auto ahead = [&](std::size_t begin, std::size_t end) {
            if constexpr (PagedField<Field>) {
                const Field view = field;
                for (const Curve& curve : curves.subspan(begin, end - begin))
                    if (curve.end == CurveEnd::Running)
                        look_ahead(view, curve.last.position,
                                   curve.release + (options.frozen ? 0.0 : curve.last.time),
                                   curve.duration < 0.0 ? -1 : 1, options.frozen);
            }
        };
        return MissingBricks::in_rounds(missing, curves.size(), stop, MissingBricks::Again::GoOn,
                                        advance_range, ahead);
    };
    if constexpr (FieldInSeries<Field>) {
        if (options.method == TraceOptions::Method::Dopri5)
            return carry(
                [&](const auto& view, double sign) { return view.series_steps(options, sign); });
        else
            return carry([&](const auto& view, double sign) {
                return RungeKuttaSteps(view, options, sign);
            });
    } else {
        return carry(
            [&](const auto& view, double sign) { return RungeKuttaSteps(view, options, sign); });
    }
}

} // namespace wakesurf::core
