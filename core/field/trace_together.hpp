// Curves that go cell by cell by Taylor series, four at a time: each takes its steps in a lane of a batch and
// then leaves the lane to the next. A curve gets the bits that it would get alone, whatever is beside it.
#pragma once

#include "core/field/kernel/series_batch.hpp"
#include "core/integrate/advance_curve.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace wakesurf::core {

/// Steps whose attempts can be made in a lane.
template <class Steps>
concept StepsInLanes = requires(
    Steps& steps, const Curve& curve, CurveStep& step, SeriesBatch& batch, std::size_t lane) {
    steps.put(curve, batch, lane);
    { steps.bound(curve, 1.0, batch, lane) } -> std::same_as<bool>;
    { steps.take(curve, batch, lane, step) } -> std::same_as<StepOutcome>;
};

/// Advances the curves that `next` gives until it gives none. Returns false if one was stopped, and the others
/// are then on their way.
/// @param next  next() returns std::optional<CurveAdvance>: of a curve that is to go on
template <class Next>
bool trace_together(const SeriesKernel& kernel, const Next& next) {
    using Advance = typename decltype(next())::value_type;
    constexpr std::size_t lanes = SeriesBatch::lanes;
    const auto batch = std::make_unique<SeriesBatch>();
    std::array<std::optional<Advance>, lanes> advance;
    bool stopped = false;
    // Fills a lane whose curve has come to `state`, unless that goes on.
    const auto fill = [&](std::size_t lane, typename Advance::Next state) {
        while (state == Advance::Next::Done) {
            advance[lane].reset();
            if (auto another = next()) {
                advance[lane].emplace(std::move(*another));
                state = advance[lane]->begin();
            } else {
                return;
            }
        }
        stopped = stopped || state == Advance::Next::Stopped;
    };
    for (std::size_t lane = 0; lane < lanes; ++lane)
        fill(lane, Advance::Next::Done);
    CurveStep step;
    for (;;) {
        std::size_t some = 0;
        for (std::size_t lane = 0; lane < lanes; ++lane)
            if (advance[lane]) {
                advance[lane]->steps().put(advance[lane]->curve(), *batch, lane);
                ++some;
            }
        if (stopped || some == 0)
            return !stopped;
        kernel.expand(*batch);
        std::array<bool, lanes> goes{};
        for (std::size_t lane = 0; lane < lanes; ++lane)
            if (advance[lane])
                goes[lane] = advance[lane]->steps().bound(advance[lane]->curve(),
                                                          advance[lane]->left(), *batch, lane);
        kernel.step(*batch);
        for (std::size_t lane = 0; lane < lanes; ++lane)
            if (advance[lane]) {
                const StepOutcome outcome =
                    goes[lane]
                        ? advance[lane]->steps().take(advance[lane]->curve(), *batch, lane, step)
                        : StepOutcome::Stagnation;
                fill(lane, advance[lane]->took(outcome, step));
            }
    }
}

} // namespace wakesurf::core
