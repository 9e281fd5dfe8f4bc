#include "protocol/wire/slice_file.hpp"

#include "protocol/wire/vector_bytes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace wakesurf::protocol {

namespace {

constexpr std::array<std::uint8_t, 4> slice_magic{'W', 'S', 'L', 1};
constexpr std::uint64_t most_samples = std::uint64_t{1} << 24;

} // namespace

std::size_t slice_file_bytes(std::size_t columns, std::size_t rows) {
    return slice_header_bytes + columns * rows * sizeof(std::uint16_t);
}

std::string slice_file(const core::SliceRaster& raster, double time) {
    const auto [lo, hi] = raster.range.value_or(std::array{0.0F, 0.0F});
    Bytes head;
    for (const std::uint8_t each : slice_magic)
        append(head, each);
    for (const std::size_t each : {raster.columns, raster.rows, raster.in_flow})
        append(head, static_cast<std::uint32_t>(each));
    for (const core::Vec3& each : {raster.window.corner, raster.window.across, raster.window.up})
        append_vector(head, each);
    for (const double each : {time, double{lo}, double{hi}})
        append(head, each);
    std::string out(slice_file_bytes(raster.columns, raster.rows), '\0');
    std::memcpy(out.data(), head.data(), head.size());
    const double scale = hi > lo ? slice_codes / (double{hi} - double{lo}) : 0.0;
    char* at = out.data() + slice_header_bytes;
    for (const float value : raster.values) {
        const auto code = std::isfinite(value)
                              ? static_cast<std::uint16_t>((double{value} - lo) * scale + 0.5)
                              : no_slice_value;
        std::memcpy(at, &code, sizeof code);
        at += sizeof code;
    }
    return out;
}

core::Result<SliceFile> read_slice_file(std::span<const std::byte> bytes) {
    const auto wrong = core::fail(core::Error::Code::Corrupt, "this is no file of a slice",
                                  "ask for slice.bin again");
    if (bytes.size() < slice_header_bytes || std::memcmp(bytes.data(), slice_magic.data(), 4) != 0)
        return wrong;
    SliceFile out;
    core::SliceRaster& raster = out.raster;
    raster.columns = number_at<std::uint32_t>(bytes, 4);
    raster.rows = number_at<std::uint32_t>(bytes, 8);
    raster.in_flow = number_at<std::uint32_t>(bytes, 12);
    raster.window = {vector_at(bytes, 16), vector_at(bytes, 40), vector_at(bytes, 64)};
    out.time = number_at<double>(bytes, 88);
    const double lo = number_at<double>(bytes, 96);
    const double hi = number_at<double>(bytes, 104);
    const std::uint64_t samples = std::uint64_t{raster.columns} * raster.rows;
    if (samples == 0 || samples > most_samples ||
        bytes.size() != slice_file_bytes(raster.columns, raster.rows) || !(lo <= hi))
        return wrong;
    raster.values.resize(samples);
    bool any = false;
    for (std::size_t i = 0; i < samples; ++i) {
        const auto code = number_at<std::uint16_t>(bytes, slice_header_bytes + 2 * i);
        any = any || code != no_slice_value;
        raster.values[i] = code == no_slice_value
                               ? std::numeric_limits<float>::quiet_NaN()
                               : static_cast<float>(lo + (hi - lo) * code / slice_codes);
    }
    if (any)
        raster.range = {static_cast<float>(lo), static_cast<float>(hi)};
    return out;
}

} // namespace wakesurf::protocol
