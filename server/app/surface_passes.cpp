#include "server/app/surface_passes.hpp"

#include <fmt/core.h>

#include <cmath>
#include <optional>

namespace wakesurf::server {

namespace {

constexpr double finer = 2.5; ///< six times as many quads as the pass before

BuiltSurface marked(BuiltSurface built, double requested, const TimeLimit& limit) {
    core::SurfaceStatistics& statistics = built.surface.statistics;
    statistics.requested_separation = requested;
    statistics.stopped = fmt::format(
        "the time limit of {:g} s was reached, so its separation is {:.4g} instead of {:.4g}",
        limit.seconds(), statistics.separation, requested);
    built.cut_short = true;
    return built;
}

} // namespace

core::Error nothing_within(const TimeLimit& limit) {
    return {core::Error::Code::Cancelled,
            fmt::format("--seconds: nothing was there yet after {:g} s", limit.seconds()),
            "give it more time"};
}

core::Result<BuiltSurface> build_within(const TimeLimit& limit,
                                        core::SurfaceParameters parameters,
                                        double coarsest,
                                        const BuildPass& build) {
    const double requested = parameters.separation;
    int passes = 1;
    if (limit.set() && coarsest > requested)
        passes += static_cast<int>(std::log(coarsest / requested) / std::log(finer));
    std::optional<BuiltSurface> there;
    for (int coarser = passes - 1; coarser >= 0; --coarser) {
        parameters.separation = requested * std::pow(finer, coarser);
        auto made = build(parameters);
        if (coarser == 0 && made)
            return made;
        // A coarse surface that shows nothing says nothing of the finer ones.
        if (made && !made->surface.statistics.empty)
            there = *std::move(made);
        else if (!made && !limit.over())
            return made;
        if (limit.over())
            break;
    }
    if (there)
        return marked(*std::move(there), requested, limit);
    return tl::unexpected(nothing_within(limit));
}

} // namespace wakesurf::server
