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
    for (std::size_t k = 0; k < values.size(); ++k)
        if (std::isfinite(values[k]))
            into.values[band.sample[k]] = values[k];
}

std::optional<std::array<float, 2>> range_of(std::span<const float> values) {
    std::optional<std::array<float, 2>> range;
    for (const float value : values) {
        if (!std::isfinite(value))
            continue;
        if (!range)
            range = {value, value};
        auto& [least, most] = *range;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    return range;
}

/// Returns the samples of a field on the window of a raster.
Result<SliceRaster> sample_window(const PlaneWindow& window,
                                  const SliceRequest& request,
                                  const std::array<std::size_t, 2>& size,
                                  const Flow& flow,
                                  const std::stop_token& stop) {
    const auto time = time_in_data(flow, request.time);
    if (!time)
        return tl::unexpected(time.error());
    SliceRaster raster;
    raster.window = window;
    raster.columns = size[0];
    raster.rows = size[1];
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
    raster.range = range_of(raster.values);
    return raster;
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
    return sample_window(*window, request, raster_size(*window, request.samples), flow, stop);
}

Result<SliceRaster> slice_minus(const SliceRaster& raster,
                                const SliceRequest& request,
                                const Flow& flow,
                                const std::stop_token& stop) {
    auto other = sample_window(raster.window, request, {raster.columns, raster.rows}, flow, stop);
    if (!other)
        return other;
    for (std::size_t i = 0; i < raster.values.size(); ++i)
        other->values[i] = raster.values[i] - other->values[i];
    other->in_flow = std::min(raster.in_flow, other->in_flow);
    other->range = range_of(other->values);
    return other;
}

} // namespace wakesurf::core
