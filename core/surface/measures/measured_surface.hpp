// The numbers that people ask for of one state of a surface, each with its errors: area, flux, where and how old it
// meets a plane or a box, how long particles stay, what passes through a closed tube.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/measures/error_spread.hpp"
#include "core/surface/measures/field_mean.hpp"
#include "core/surface/measures/measured.hpp"
#include "core/surface/measures/region.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

/// A number with its name and unit.
struct NamedNumber {
    std::string name;
    int length = 0; ///< the power of the unit of length in its unit
    int time = 0;   ///< the power of the unit of time
    double value = not_known;
    std::string unit{}; ///< of a field; these have no powers
};

/// The numbers of one state.
struct SurfaceNumbers {
    std::vector<NamedNumber> numbers; ///< of a plan and a region always the same ones
    std::vector<std::string>
        notes; ///< why some are not known, and what to know of others; one sentence each
};

/// A state of a surface, prepared for measuring. What its cells cover is extrapolated from the cells and from halves of
/// them on the curved patches through their vertices, so it is of fourth order; of a level surface, which has no
/// tangents, of second.
class MeasuredSurface {
  public:
    /// @param state  with `ended` if it is not of the plan's end; with its interval errors if there are any
    /// @param times   as vertex_times
    /// @param fields  whose means are wanted; each is sampled here, once
    /// REQUIRES: the plan asks for tangents, unless it is of a level surface. Error: OverLimit, Cancelled, what sampling
    /// reports. Cost: as tessellate in two pieces, and some thousand samples.
    static Result<MeasuredSurface> of(const SurfacePlan& plan,
                                      const Surface& state,
                                      std::vector<double> times,
                                      std::span<const AveragedField> fields,
                                      const std::stop_token& stop,
                                      const WorkPart& work = {});

    /// @param age  stream and path surfaces: measures what is no older; others are as they are
    /// Error: Cancelled, what sampling reports.
    Result<SurfaceNumbers>
    numbers(double age, const std::optional<Region>& through, const std::stop_token& stop) const;

  private:
    struct Mesh {
        QuadComplex mesh;
        std::vector<double> ages;                 ///< empty: it has none
        std::vector<std::vector<float>> values{}; ///< of each field that is averaged
    };

    friend class NumbersOfState;

    SurfacePlan plan_;
    SurfaceStatistics statistics_;
    double time_ = 0.0;
    std::vector<AveragedField> fields_;
    Mesh whole_;
    std::optional<Mesh> halved_;
    std::optional<ErrorSpreader> spreader_;
    std::vector<double> errors_,
        interval_errors_; ///< one a vertex of `whole_`; not_known where it has none
};

} // namespace wakesurf::core
