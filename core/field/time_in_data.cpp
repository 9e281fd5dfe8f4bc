#include "core/field/time_in_data.hpp"

#include "core/base/rounding.hpp"

#include <algorithm>
#include <string>

namespace wakesurf::core {

Result<double> time_in_data(const Flow& flow, double time) {
    const auto bounds = flow.time_bounds();
    if (!bounds)
        return time;
    if (!within_rounding(time, (*bounds)[0], (*bounds)[1]))
        return fail(Error::Code::OutOfTime,
                    "time " + std::to_string(time) + " is outside the data's " +
                        std::to_string((*bounds)[0]) + " to " + std::to_string((*bounds)[1]),
                    "choose `time` inside it");
    return std::clamp(time, (*bounds)[0], (*bounds)[1]);
}

} // namespace wakesurf::core
