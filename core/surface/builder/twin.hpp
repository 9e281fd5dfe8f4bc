// Twin surfaces: the same seeds through something else (another run or mesh, another interpolation or accuracy, a rake moved
// a little), so that each vertex has a partner and a distance is a subtraction. It needs no mesh of the twin.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

/// Plans a twin. Where its data end earlier, so does the twin. Loads no data. Error: InvalidArgument (a level surface, which
/// has no particles; settings that the flow does not have), OutOfDomain, OutOfTime where they begin later.
/// @param flow  that of the twin's data, not of a plan
Result<SurfacePlan>
plan_twin(const SurfacePlan& of, std::shared_ptr<const Flow> flow, const TwinSettings& settings);

struct TwinComparison {
    std::vector<Vec3>
        place; ///< of the twin's particle, one a vertex; not a number where there is none
    std::vector<float> distance; ///< one a vertex, those between traced ones from their neighbours
    std::vector<float> lag;      ///< as TwinDistance::lag50
    StatedTwin stated;
};

/// Traces the surface's particles through the twin and measures how far apart they are. The lag is the distance along the
/// flow over its speed: right where the two are near each other. The same for any number of threads. Error:
/// InvalidArgument where no particle can be compared, with the reason; as trace_vertices. Cost: see there.
/// REQUIRES: the plans are `plan` and its twin.
Result<TwinComparison> compare_twin(const SurfacePlan& plan,
                                    const Surface& surface,
                                    const SurfacePlan& twin,
                                    const std::stop_token& stop,
                                    const WorkPart& work = {});

/// The mean of several runs of one surface, and how far they spread.
struct TwinBand {
    std::vector<Vec3> mean; ///< one a vertex; its own place where it alone arrives
    std::vector<float>
        spread; ///< root mean square of the distances from the mean; not a number for one run
    std::vector<float> arrived; ///< number of runs
};

/// @param twins  of the surface's vertices
TwinBand band_of(const Surface& surface, std::span<const TwinComparison> twins);

} // namespace wakesurf::core
