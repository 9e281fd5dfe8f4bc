// Finds how coarse a surface has to be for its quad budget: which separations are tried one after the other,
// from what was counted at those before. Cheap trials at a small part of the budget come first, so that
// finding the separation costs less than the surface itself.
#pragma once

#include "core/base/box.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <optional>

namespace wakesurf::core {

/// Progress gives a trial, or a surface that is begun again, this part of what is left to do.
inline constexpr double trial_share = 0.5;

/// Chooses the trials; a value. The next trial depends on the counts alone, so the same surface always ends
/// at the same separation.
class BudgetSearch {
  public:
    /// A trial at `separation`, abandoned beyond `most` quads.
    struct Trial {
        double separation;
        std::uint64_t most;
    };

    /// @param requested  separation asked for: none smaller is tried
    /// @param coarsest   none larger is tried, unless it is what was asked for
    /// @param estimate   quads at `requested` if nothing stretched the surface
    /// @param most       the quad budget, at least 1
    BudgetSearch(double requested, double coarsest, double estimate, std::uint64_t most);

    /// Returns the next trial; nothing if not even the coarsest surface fits.
    std::optional<Trial> next();

    /// Takes the number of quads of the last trial. Returns true if this surface is the one to keep.
    bool built(std::uint64_t quads);

    /// Accepts the finest surface counted from now on.
    void settle();

    /// Records that the trial was abandoned, or would have been.
    void exceeded();

    /// Coarser surfaces have been counted, and the last one is large enough to tell the separation of the
    /// next trial.
    bool near() const;

    /// Returns how many trials with the whole budget were given up.
    int given_up() const { return given_up_; }

    double coarsest() const { return coarsest_; }

  private:
    struct Count {
        double separation;
        double quads;
    };

    /// Returns the exponent of the power law between separation and quads.
    double exponent() const;

    /// Returns the separation at which that law, from the finest surface counted, has so many quads.
    double separation_of(double quads, double at_least) const;

    double requested_;
    double coarsest_;
    double estimate_;
    std::uint64_t most_;
    Trial last_{};
    int trials_ = 0;
    int given_up_ = 0;
    bool settled_ = false; ///< the search is over
    /// The largest separation abandoned with the whole budget; 0: none.
    double too_fine_ = 0.0;
    double too_fine_trial_ = 0.0; ///< likewise, with less than the budget
    std::optional<Count> finest_; ///< counted, and within the budget
    std::optional<Count> before_; ///< the one counted before that
};

/// The largest separation that a quad budget may lead to: a tenth of the domain's longest side.
double coarsest_separation(const Box& domain);

/// Returns the error of a surface that needs more quads than allowed even at the largest separation.
tl::unexpected<Error> cannot_be_coarser(std::uint64_t max_quads, double separation);

} // namespace wakesurf::core
