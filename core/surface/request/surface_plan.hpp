// From what was asked to what is built: a request and a flow become one plan, which is checked and complete.
// A session and the command line make it once, and everything that builds, plays or writes the surface works
// from it.
#pragma once

#include "core/base/result.hpp"
#include "core/field/flow.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"

#include <memory>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

class LevelSource;
struct SheetOptions;

/// The request that plan_surface has checked and completed; a value.
struct SurfacePlan {
    std::shared_ptr<const Flow> flow; ///< what carries the particles
    /// The part of the rake inside the domain.
    Rake rake;
    /// The parameters, with a separation and a direction; `rake2` is inside the domain too.
    SurfaceParameters parameters;
    /// The seeding curve of `rake`.
    SeedingCurve seeding;
    /// The source of a level surface over the flow's data: set when the data are opened.
    std::shared_ptr<const LevelSource> levels{};
    /// Part of a rake was outside the domain and is left out.
    bool clipped = false;

    /// Returns the largest speed on 3^3 points of the domain and 17 of the rake, at `from`, which defines "at
    /// rest"; where all is at rest then, at `to` or between, unless the field is frozen. It is no member, since it
    /// needs data to be loaded.
    Result<double> largest_speed(std::stop_token stop) const;

    /// Returns the sheets of a stream or path surface, one a direction, at `separation`, which may be larger
    /// than the one asked for.
    std::vector<SheetOptions> sheets(double separation, double largest_speed) const;
};

/// Checks a request, completes it and cuts its rakes to the domain. Loads no data. Error: InvalidArgument (a
/// value or a kind that the description of surface.set does not allow; times and a direction that contradict
/// each other; a separation that shows nothing of this flow; an interpolation that the flow does not have; a
/// rake that is none), OutOfDomain, OutOfTime. Each names the parameter as the API does.
Result<SurfacePlan>
plan_surface(std::shared_ptr<const Flow> flow, const Rake& rake, SurfaceParameters parameters);

/// Plans for a flow that outlives the plan.
Result<SurfacePlan>
plan_surface(const Flow& flow, const Rake& rake, const SurfaceParameters& parameters);

/// Returns the error that the integrator may make per unit length.
double trace_tolerance(Accuracy accuracy);

} // namespace wakesurf::core
