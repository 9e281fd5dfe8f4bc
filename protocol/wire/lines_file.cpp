#include "protocol/wire/lines_file.hpp"

#include "protocol/wire/vector_bytes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace wakesurf::protocol {

namespace {

constexpr std::array<std::uint8_t, 4> lines_magic{'W', 'S', 'T', 1};

core::Vec3 middle_of(const std::vector<core::Vec3>& points) {
    if (points.empty())
        return core::Vec3(0.0);
    core::Vec3 lo = points.front();
    core::Vec3 hi = lo;
    for (const core::Vec3& each : points) {
        lo = glm::min(lo, each);
        hi = glm::max(hi, each);
    }
    return 0.5 * (lo + hi);
}

/// Returns whether offsets begin at 0, grow and end at the number of points.
bool sound_offsets(const core::StreamLines& lines) {
    return lines.offsets.front() == 0 && lines.offsets.back() == lines.points.size() &&
           std::is_sorted(lines.offsets.begin(), lines.offsets.end());
}

} // namespace

std::size_t lines_file_bytes(std::size_t lines, std::size_t points) {
    return lines_header_bytes + 4 * (2 * lines + 1) + 16 * points;
}

std::string lines_file(const core::StreamLines& lines, double time) {
    const auto [lo, hi] = lines.range.value_or(std::array{0.0F, 0.0F});
    const core::Vec3 origin = middle_of(lines.points);
    Bytes out;
    out.reserve(lines_file_bytes(lines.lines(), lines.points.size()));
    for (const std::uint8_t each : lines_magic)
        append(out, each);
    const core::LineEnds& ends = lines.ends;
    for (const std::size_t each : {lines.lines(), lines.points.size()})
        append(out, static_cast<std::uint32_t>(each));
    for (const std::uint32_t each :
         {lines.seeds, lines.outside, ends.limit, ends.domain, ends.wall, ends.rest, ends.cut})
        append(out, each);
    for (const double each : {time, double{lo}, double{hi}})
        append(out, each);
    append_vector(out, origin);
    for (const std::uint32_t each : lines.offsets)
        append(out, each);
    for (const std::uint32_t each : lines.seed)
        append(out, each);
    for (const core::Vec3& each : lines.points)
        for (int axis = 0; axis < 3; ++axis)
            append(out, static_cast<float>(each[axis] - origin[axis]));
    for (const float each : lines.values)
        append(out, each);
    return {reinterpret_cast<const char*>(out.data()), out.size()};
}

core::Result<LinesFile> read_lines_file(std::span<const std::byte> bytes) {
    const auto wrong = core::fail(core::Error::Code::Corrupt, "this is no file of streamlines",
                                  "ask for lines.bin again");
    if (bytes.size() < lines_header_bytes || std::memcmp(bytes.data(), lines_magic.data(), 4) != 0)
        return wrong;
    const auto whole = [&](std::size_t at) { return number_at<std::uint32_t>(bytes, at); };
    const std::size_t count = whole(4);
    const std::size_t points = whole(8);
    if (bytes.size() != lines_file_bytes(count, points))
        return wrong;
    LinesFile out;
    core::StreamLines& lines = out.lines;
    lines.seeds = whole(12);
    lines.outside = whole(16);
    lines.ends = {whole(20), whole(24), whole(28), whole(32), whole(36)};
    out.time = number_at<double>(bytes, 40);
    const core::Vec3 origin = vector_at(bytes, 64);
    std::size_t at = lines_header_bytes;
    for (std::size_t i = 0; i <= count; ++i, at += 4)
        lines.offsets.push_back(whole(at));
    for (std::size_t i = 0; i < count; ++i, at += 4)
        lines.seed.push_back(whole(at));
    const auto number = [&] {
        at += 4;
        return number_at<float>(bytes, at - 4);
    };
    for (std::size_t i = 0; i < points; ++i) {
        const float x = number();
        const float y = number();
        lines.points.push_back(origin + core::Vec3(x, y, number()));
    }
    for (std::size_t i = 0; i < points; ++i)
        lines.values.push_back(number());
    if (!sound_offsets(lines))
        return wrong;
    if (std::any_of(lines.values.begin(), lines.values.end(),
                    [](float value) { return std::isfinite(value); }))
        lines.range = {static_cast<float>(number_at<double>(bytes, 48)),
                       static_cast<float>(number_at<double>(bytes, 56))};
    return out;
}

} // namespace wakesurf::protocol
