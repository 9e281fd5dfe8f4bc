#include "core/surface/measures/numbers_over_time.hpp"

#include "core/surface/builder/interval_errors.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/evolution.hpp"
#include "core/surface/time_direction.hpp"

namespace wakesurf::core {

namespace {

void add_row(NumberTable& table, SurfaceNumbers&& numbers) {
    std::vector<double> row;
    for (const NamedNumber& number : numbers.numbers)
        row.push_back(number.value);
    table.columns = std::move(numbers.numbers);
    table.rows.push_back(std::move(row));
    table.notes.push_back(std::move(numbers.notes));
}

/// States the errors between stored times, or why they cannot be, and measures. @param times  as of MeasuredSurface
Result<MeasuredSurface> measured(const SurfacePlan& plan,
                                 Surface& state,
                                 std::vector<double> times,
                                 std::span<const AveragedField> fields,
                                 const std::stop_token& stop,
                                 const WorkPart& work) {
    if (const auto stated = state_interval_errors(plan, state, stop, work); !stated) {
        if (stop.stop_requested())
            return tl::unexpected(stated.error());
        state.mesh.interval_error.clear();
        state.statistics.interval_left_out = stated.error().message;
    }
    return MeasuredSurface::of(plan, state, std::move(times), fields, stop, work);
}

} // namespace

Result<NumberTable> numbers_over_time(SurfacePlan plan,
                                      std::span<const double> times,
                                      const std::optional<Region>& through,
                                      std::span<const AveragedField> fields,
                                      const Clock& clock,
                                      const std::stop_token& stop,
                                      const WorkPart& work) {
    SurfaceParameters& p = plan.parameters;
    p.tangents = p.kind != SurfaceKind::Level;
    NumberTable table;
    if (p.kind == SurfaceKind::Stream || p.kind == SurfaceKind::Path) {
        auto whole = build_surface(plan, stop, clock, work);
        if (!whole)
            return tl::unexpected(whole.error());
        const auto ready = measured(plan, *whole, vertex_times(*whole, p), fields, stop, work);
        if (!ready)
            return tl::unexpected(ready.error());
        for (const double time : times) {
            auto numbers = ready->numbers(age_at(p, time), through, stop);
            if (!numbers)
                return tl::unexpected(numbers.error());
            add_row(table, *std::move(numbers));
        }
        table.statistics = std::move(whole->statistics);
        return table;
    }
    auto evolution = Evolution::start(plan, clock, stop, work);
    if (!evolution)
        return tl::unexpected(evolution.error());
    for (const double time : times) {
        auto state = evolution->at(time, stop, work);
        if (!state)
            return tl::unexpected(state.error());
        Surface surface{std::move(state->mesh.mesh), std::move(state->statistics),
                        p.from + time_sign(p) * age_at(p, time)};
        const std::size_t before = work.memory() != nullptr ? work.memory()->bytes() : 0;
        const auto ready = measured(plan, surface, std::move(state->times), fields, stop, work);
        if (!ready)
            return tl::unexpected(ready.error());
        auto numbers = ready->numbers(age_at(p, time), through, stop);
        if (!numbers)
            return tl::unexpected(numbers.error());
        add_row(table, *std::move(numbers));
        if (work.memory() != nullptr)
            work.gives_back(work.memory()->bytes() - before);
        table.statistics = std::move(surface.statistics);
    }
    return table;
}

} // namespace wakesurf::core
