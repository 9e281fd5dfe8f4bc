#include "core/surface/slice/slice_raster.hpp"

#include "core/base/rounding.hpp"
#include "core/field/time_in_data.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace wakesurf::core {

namespace {

/// Samples that are worked on together: what they take besides the raster stays in a processor's cache.
constexpr std::size_t band_samples = std::size_t{1} << 16;
/// Place, shares of nodes, velocity and so on of each of them; the seven places of a gradient take most.
constexpr std::size_t band_bytes = 1200;

/// A part of a raster's samples, those of them in the flow.
struct Band {
    std::vector<std::uint32_t> sample; ///< number in the raster
    std::vector<Vec3> place;
};

/// Finds the samples from `begin` to `end` that are in the flow, in their order.
Band in_flow(const SliceRaster& raster,
             const Flow& flow,
             std::size_t begin,
             std::size_t end,
             const std::stop_token& stop) {
    const Box domain = flow.domain();
    std::vector<Vec3> places(end - begin);
    std::vector<std::uint8_t> inside(end - begin);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, 1024), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end() && !stop.stop_requested(); ++i) {
            const Vec3 place =
                onto_faces(raster.place(i % raster.columns, i / raster.columns), domain);
            places[i - begin] = place;
            inside[i - begin] = domain.contains(place) && flow.status(place) == PointStatus::Inside;
        }
    });
    Band band;
    for (std::size_t k = 0; k < places.size(); ++k)
        if (inside[k] != 0) {
            band.sample.push_back(static_cast<std::uint32_t>(begin + k));
            band.place.push_back(places[k]);
        }
    return band;
}

void take_values(const Band& band, std::span<const float> values, SliceRaster& into) {
    into.in_flow += band.sample.size();
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!std::isfinite(values[k]))
            continue;
        into.values[band.sample[k]] = values[k];
        if (!into.range)
            into.range = {values[k], values[k]};
        auto& [least, most] = *into.range;
        least = std::min(least, values[k]);
        most = std::max(most, values[k]);
    }
}

} // namespace

std::array<std::size_t, 2> raster_size(const PlaneWindow& window, std::size_t samples) {
    const double across = glm::length(window.across);
    const double up = glm::length(window.up);
    const double longest = std::max(across, up);
    const auto along = [&](double side) {
        return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(
                                            static_cast<double>(samples) * side / longest)));
    };
    return {along(across), along(up)};
}

std::size_t slice_memory(std::size_t columns, std::size_t rows) {
    return columns * rows * sizeof(float) + std::min(columns * rows, band_samples) * band_bytes;
}

Result<SliceRaster>
sample_slice(const SliceRequest& request, const Flow& flow, const std::stop_token& stop) {
    const auto time = time_in_data(flow, request.time);
    if (!time)
        return tl::unexpected(time.error());
    const auto window = plane_window(request.plane, flow.domain());
    if (!window)
        return tl::unexpected(window.error());
    SliceRaster raster;
    raster.window = *window;
    const auto [columns, rows] = raster_size(raster.window, request.samples);
    raster.columns = columns;
    raster.rows = rows;
    raster.values.assign(raster.columns * raster.rows, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t begin = 0; begin < raster.values.size(); begin += band_samples) {
        const std::size_t end = std::min(begin + band_samples, raster.values.size());
        const Band band = in_flow(raster, flow, begin, end, stop);
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "the slice was cancelled");
        const auto values = sample_field(request.field, flow, band.place, *time, stop);
        if (!values)
            return tl::unexpected(values.error());
        take_values(band, *values, raster);
    }
    return raster;
}

} // namespace wakesurf::core
