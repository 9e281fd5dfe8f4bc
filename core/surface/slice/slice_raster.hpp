// A slice: a field on a plane through the data, as a raster of samples. A raster costs the same for every kind of grid, is as fine as
// the screen that shows it, and can be had coarsely first; the cells that a plane cuts would be more than the pixels of a large mesh.
#pragma once

#include "core/base/plane.hpp"
#include "core/base/result.hpp"
#include "core/field/flow.hpp"
#include "core/field/sampled_field.hpp"
#include "core/surface/slice/plane_window.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

struct SliceRequest {
    Plane plane;
    SampledField field;
    double time = 0.0;         ///< of no meaning in a flow that stands still
    std::size_t samples = 256; ///< along the longer side; at least 1
};

/// Samples of a field at the centres of the squares that a window is divided into.
struct SliceRaster {
    PlaneWindow window;
    std::size_t columns = 0;
    std::size_t rows = 0;
    /// Row by row from the window's corner; NaN outside the domain, in bodies and where the field has no value.
    std::vector<float> values;
    std::size_t in_flow =
        0; ///< samples in the domain and outside bodies, with or without a value; of a difference, in both at the most
    std::optional<std::array<float, 2>> range; ///< of the values; nothing where there is none

    Vec3 place(std::size_t column, std::size_t row) const {
        return window.at((static_cast<double>(column) + 0.5) / static_cast<double>(columns),
                         (static_cast<double>(row) + 0.5) / static_cast<double>(rows));
    }
};

/// Returns how many columns and rows a window is divided into, of `samples` along its longer side: into squares, but for rounding.
std::array<std::size_t, 2> raster_size(const PlaneWindow& window, std::size_t samples);

/// The memory that a raster and making it take, in bytes.
std::size_t slice_memory(std::size_t columns, std::size_t rows);

/// Error: OutOfDomain and InvalidArgument as plane_window, OutOfTime, Cancelled, what reading reports. Runs in parallel; the bytes do not
/// depend on the number of threads. Thread safety: concurrent calls are fine. Cost: a sample of the field for each one in the flow.
Result<SliceRaster>
sample_slice(const SliceRequest& request, const Flow& flow, const std::stop_token& stop);

/// Returns a raster minus a field of the same or another flow at the same places. Where that flow is not, has a body or no value, the
/// difference has none. Of the request field and time count. Errors, threads and cost as of sample_slice.
Result<SliceRaster> slice_minus(const SliceRaster& raster,
                                const SliceRequest& request,
                                const Flow& flow,
                                const std::stop_token& stop);

} // namespace wakesurf::core
