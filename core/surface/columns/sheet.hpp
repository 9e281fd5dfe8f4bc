// A sheet: all strips of a rake in one direction of time, refined until every one is zipped and nowhere bends
// too sharply across its columns. Traces the curves the strips ask for, always from the rake, in batches.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/columns/strip.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/request/sheet_options.hpp"

#include <deque>
#include <map>
#include <set>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

class Sheet {
  public:
    Sheet(const Flow& flow, SeedingCurve seeding, SheetOptions options);
    Sheet(const Sheet&) = delete;
    Sheet(Sheet&&) = default;

    /// Builds the strips between `seeds` (parameters, increasing; a closed rake's last one is below 1).
    /// Returns false, with strips that are of no use, as soon as the quads exceed max_quads.
    /// Error: Cancelled, OverLimit where there is no memory, and what tracing reports.
    /// Cost: tracing, plus O(quads of the strips that changed) a round.
    /// @param work  told which part of the rake is done, and what memory the strips take
    Result<bool> build(const std::set<double>& seeds,
                       const Clock& clock,
                       std::stop_token stop,
                       WorkPart work = {});

    std::uint64_t quads() const;

    /// Returns the seed parameters at which the sheet now leaves the rake: `seeds` and those it added.
    const std::set<double>& seeds() const { return seeds_; }

    /// The strips along the rake; a closed rake's last one ends at the first one's left column.
    const std::vector<Strip>& strips() const { return strips_; }

    bool closed() const { return seeding_.closed(); }

    const SheetOptions& options() const { return options_; }

    const ZipRules& rules() const { return limits_.rules; }

    bool upstream() const { return options_.duration < 0.0; }

    /// Returns the curves of the columns of the mesh, for statistics.
    std::vector<const SeededCurve*> columns() const;

    struct Seconds {
        double load = 0.0, advect = 0.0, refine = 0.0;
    };

    Seconds seconds() const { return seconds_; }

  private:
    Result<void>
    trace(const std::set<double>& parameters, const Clock& clock, const std::stop_token& stop);

    struct StripDemand {
        std::size_t strip;
        Strip::Demand demand;
    };

    std::vector<StripDemand> bend_demands(const Clock& clock);
    Result<std::vector<std::size_t>>
    meet(const std::vector<StripDemand>& demands, const Clock& clock, const std::stop_token& stop);
    Result<void> hold(std::size_t quads, std::size_t& counted, const WorkPart& work) const;
    double part_without(const std::vector<std::size_t>& dirty) const;
    void cut_at(const std::vector<double>& new_seeds);
    Strip strip_between(double left, double right_s) const;
    void make_end_columns(const std::stop_token& stop);
    Result<std::size_t>
    zip(const std::vector<std::size_t>& dirty, const Clock& clock, const std::stop_token& stop);

    const Flow& flow_;
    SeedingCurve seeding_;
    SheetOptions options_;
    StripLimits limits_;
    std::set<double> seeds_;
    std::deque<SeededCurve> curves_;          ///< stable addresses
    std::map<double, SeededCurve*> curve_at_; ///< by seed parameter
    std::vector<Strip> strips_;               ///< along the rake
    Seconds seconds_;
};

} // namespace wakesurf::core
