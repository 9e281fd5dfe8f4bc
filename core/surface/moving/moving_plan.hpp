// The constants of a moving surface: the origin of its points, and the rules at one separation.
#pragma once

#include "core/surface/budget_search.hpp"
#include "core/surface/moving/origin.hpp"
#include "core/surface/moving/refinement_context.hpp"
#include "core/surface/request/surface_plan.hpp"

#include <optional>
#include <vector>

namespace wakesurf::core {

/// A streak or time surface as asked for, from which it can be begun at any separation.
struct MovingRequest {
    MovingRequest(SurfacePlan asked, double fastest);

    SurfacePlan plan;
    double largest_speed; ///< in the domain, at the start
    Origin origin;

    /// Returns how far the fastest particle goes, in units of length.
    double travel() const;
};

struct MovingPlan {
    MovingRequest request;
    Columns columns;
    std::vector<double> seeds; ///< of a row on the rake
    RefinementRules rules;
    AdvanceOptions carry; ///< its step is chosen anew in every step
    double end = 0.0;
    double release_until = 0.0;
    bool fast = false;
    double finest_spacing = 0.0;
    bool estimates = true;                ///< how far vertices may be from the true surface
    std::optional<BudgetSearch> search{}; ///< that led here, for where this plan exceeds the budget
};

constexpr double row_spacing = 0.75; ///< of the separation, as the columns of stream surfaces

/// The request at `separation`, which may be larger than the one asked for.
MovingPlan make_plan(const MovingRequest& request, double separation);

/// The request's own separation, or a larger one where the surface would take too many steps.
double least_separation(const MovingRequest& request);

/// Returns the intervals between the seeds of a row at `separation`.
double seeds_at(const MovingRequest& request, double separation);

/// Returns the search that says which separations to try for the request.
BudgetSearch budget_search(const MovingRequest& request);

} // namespace wakesurf::core
