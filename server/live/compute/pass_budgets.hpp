// Decides in which passes a surface is built, and how large the early ones may be, from the times of the
// last ones. A coarse pass shows an edit at once; a refined one follows where the final surface takes long.
#pragma once

#include "core/surface/surface_statistics.hpp"
#include "protocol/wire/mesh_stream.hpp"
#include "server/live/compute/compute_pool.hpp"

#include <cstdint>
#include <optional>

namespace wakesurf::server {

class PassBudgets {
  public:
    using Phase = protocol::Phase;

    /// @param at_once  the first pass is expected to be quick: a stream surface's is
    explicit PassBudgets(bool at_once);

    /// Parameters have changed: what the final pass took tells nothing any more.
    void forget();

    /// @param separation  asked of the final pass
    void took(Phase phase,
              double seconds,
              const core::SurfaceStatistics& statistics,
              double separation,
              std::uint64_t max_quads);

    /// A pass of a whole surface that was there already, a little further on.
    void moved_on(double seconds) { step_seconds_ = seconds; }

    /// A newer edit ended a pass after so long.
    void cut_short(Phase phase, double seconds);

    /// A surface had more quads than an early pass may have, even where it could not be coarser. Returns
    /// whether the pass should be tried again at once: it may have more now, and was refused soon enough.
    bool too_many(Phase phase, double seconds);

    bool coarse_first() const;
    bool refined_too() const;

    /// Most quads of a coarse or refined pass.
    std::uint64_t quads(Phase phase) const;

    /// The separation at which the last coarse or refined pass would have had a little fewer: looking for
    /// it again costs more than the surface. 0: there was none.
    double separation(Phase phase) const;

    PriorityClass priority(Phase phase) const;
    PriorityClass priority_of_moving_on() const;

  private:
    /// The aim of an early pass.
    struct Aim {
        double budget; ///< s
        double least, most;
        double quads;
        double separation = 0.0;
        int refused = 0; ///< passes since the last one that ended

        /// @param had  quads and the separation of a pass that took so long; nothing: it was cut short
        void learn(double seconds, const core::SurfaceStatistics* had);
    };

    double expected_final() const;
    void aim_refined(double seconds, const core::SurfaceStatistics& had);

    const Aim& early(Phase phase) const { return phase == Phase::Coarse ? coarse_ : refined_; }

    Aim& early(Phase phase) { return phase == Phase::Coarse ? coarse_ : refined_; }

    Aim coarse_, refined_;
    double coarse_seconds_;
    /// The time of the newest final pass, or the time that it was at work at least, in s.
    std::optional<double> final_seconds_;
    /// Estimated from the coarse pass, while there was no final one, in s.
    std::optional<double> estimated_seconds_;
    double step_seconds_ = 1.0;
    /// The work grows with this power of the quads: smaller cells of a moving surface also take more steps.
    double power_;
    bool refined_known_ = false; ///< what a refined pass takes was measured
};

} // namespace wakesurf::server
