#include "server/remote/zarr/zarr_axes.hpp"

#include "core/dataset/grid.hpp"
#include "store/velocity_names.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;

namespace {

constexpr std::uint64_t most_nodes_along = std::uint64_t{1} << 20;
constexpr std::uint64_t most_steps = std::uint64_t{1} << 20;
constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_time(const std::string& name) {
    const auto small = lower(name);
    return small == "time" || small == "t" || small == "times" || small == "timestep";
}

std::optional<std::size_t> place_of(const std::string& name) {
    const auto small = lower(name);
    if (small == "z" || small == "depth" || small == "height" || small == "altitude" ||
        small == "level" || small == "lev")
        return 2;
    return small == "x"   ? std::optional<std::size_t>(0)
           : small == "y" ? std::optional<std::size_t>(1)
                          : std::nullopt;
}

std::optional<ZarrAxes> by_names(const ZarrArray& array) {
    ZarrAxes out;
    std::array<bool, 3> found{};
    for (std::size_t axis = 0; axis < array.dimensions.size(); ++axis) {
        const auto place = place_of(array.dimensions[axis]);
        if (place && found[*place])
            return std::nullopt;
        if (place) {
            found[*place] = true;
            out.place[*place] = axis;
        } else if (is_time(array.dimensions[axis]) && !out.time) {
            out.time = axis;
        } else if (array.shape[axis] == 3 && !out.component) {
            out.component = axis;
        } else {
            return std::nullopt;
        }
    }
    return found == std::array{true, true, true} ? std::optional(out) : std::nullopt;
}

std::optional<ZarrAxes> by_order(const ZarrArray& array) {
    const auto& shape = array.shape;
    const bool said_time = !array.dimensions.empty() && is_time(array.dimensions[0]);
    const auto meaning = store::meaning_of_vector(array.name);
    // A U may be the whole velocity, but a u hardly ever is: an array of three time-steps is then one
    // component.
    const bool vector =
        array.name.empty() || (meaning != store::VectorName::Other &&
                               meaning != store::VectorName::Unknown && array.name != "u");
    const bool letter = array.name.size() == 1;
    const auto of = [](std::size_t z, std::optional<std::size_t> time,
                       std::optional<std::size_t> component) {
        return ZarrAxes{{z + 2, z + 1, z}, time, component};
    };
    if (shape.size() == 3)
        return said_time ? std::nullopt : std::optional(of(0, {}, {}));
    if (shape.size() == 4 && vector && !said_time && shape[3] == 3)
        return of(0, {}, 3);
    if (shape.size() == 4 && vector && !letter && !said_time && shape[0] == 3)
        return of(1, {}, 0);
    if (shape.size() == 4)
        return of(1, 0, {});
    if (shape.size() == 5 && shape[4] == 3)
        return of(1, 0, 4);
    if (shape.size() == 5 && shape[1] == 3)
        return of(2, 0, 1);
    return std::nullopt;
}

/// Returns the array of the coordinates along an axis; null if there is none.
const ZarrArray*
line_along(const ZarrGroup& group, const ZarrArray& array, std::size_t axis, const char* usual) {
    const auto* line = group.find(array.dimensions.empty() ? usual : array.dimensions[axis]);
    return line != nullptr && line->shape == std::vector{array.shape[axis]} ? line : nullptr;
}

Result<void> check_rising(const std::vector<double>& values, const std::string& name) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]) || (i > 0 && !(values[i - 1] < values[i])))
            return fail(Error::Code::Unsupported,
                        name + " is not strictly increasing, or has values that are not finite",
                        "write the data with " + name + " rising");
    return {};
}

void add_note(std::string& note, const std::string& text) {
    note += (note.empty() ? "" : "; ") + text;
}

/// Converts "seconds since 2000-01-01" to "seconds".
std::string without_reference(const std::string& unit) {
    return unit.substr(0, std::min(unit.find(" since "), unit.size()));
}

core::Grid grid_of(const std::array<std::vector<double>, 3>& nodes, bool even) {
    if (!even)
        return core::RectilinearGrid{nodes};
    core::UniformGrid grid;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        grid.origin[axis] = nodes[i].front();
        grid.spacing[axis] =
            (nodes[i].back() - nodes[i].front()) / static_cast<double>(nodes[i].size() - 1);
        grid.dimensions[i] = static_cast<std::uint32_t>(nodes[i].size());
    }
    return grid;
}

/// Returns 0, 1, 2 and so on.
std::vector<double> numbered(std::uint64_t count) {
    std::vector<double> out(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = static_cast<double>(i);
    return out;
}

} // namespace

std::array<std::uint64_t, 3> ZarrAxes::nodes(const ZarrArray& array) const {
    return {array.shape[place[0]], array.shape[place[1]], array.shape[place[2]]};
}

std::optional<ZarrAxes> zarr_axes(const ZarrArray& array) {
    if (auto named = by_names(array))
        return named;
    const bool some_place = std::ranges::any_of(
        array.dimensions, [](const std::string& name) { return place_of(name).has_value(); });
    return some_place ? std::nullopt : by_order(array);
}

Result<ZarrCoordinates> zarr_coordinates(const ZarrGroup& group,
                                         const ZarrArray& array,
                                         const ZarrAxes& axes,
                                         const ChunkObjects& objects) {
    ZarrCoordinates out;
    std::array<std::vector<double>, 3> nodes;
    bool even = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint64_t count = array.shape[axes.place[i]];
        if (count > most_nodes_along)
            return fail(Error::Code::OverLimit, std::string("there are ") + std::to_string(count) +
                                                    " nodes along " + axis_names[i]);
        if (count < 2)
            return fail(Error::Code::Unsupported,
                        std::string("there is one node along ") + axis_names[i],
                        "extrude the data by a cell or more first");
        const ZarrArray* line = line_along(group, array, axes.place[i], axis_names[i]);
        if (line == nullptr) {
            add_note(out.note, std::string("there are no coordinates along ") + axis_names[i] +
                                   ": node numbers are used");
            nodes[i] = numbered(count);
            continue;
        }
        if (lower(line->unit).starts_with("degree"))
            return fail(Error::Code::Unsupported,
                        line->name + " is an angle (" + line->unit + "), not a length",
                        "interpolate the data to a Cartesian grid first");
        auto read = objects.read_line(*line, most_nodes_along);
        if (!read)
            return tl::unexpected(read.error());
        if (auto rising = check_rising(*read, line->name); !rising)
            return tl::unexpected(rising.error());
        const bool single = line->number == ZarrArray::Number::Float && line->number_bytes == 4;
        even = even && core::is_even(*read, single);
        nodes[i] = std::move(*read);
        out.length_unit = line->unit;
    }
    out.grid = grid_of(nodes, even);
    const std::uint64_t steps = axes.steps(array);
    if (steps > most_steps)
        return fail(Error::Code::OverLimit, "there are " + std::to_string(steps) + " time-steps");
    const ZarrArray* line = axes.time ? line_along(group, array, *axes.time, "time") : nullptr;
    if (line == nullptr) {
        out.times = numbered(steps);
        if (steps > 1)
            add_note(out.note, "there are no times: the numbers of the time-steps are used");
        return out;
    }
    auto times = objects.read_line(*line, most_steps);
    if (!times)
        return tl::unexpected(times.error());
    out.times = std::move(*times);
    out.time_unit = without_reference(line->unit);
    if (out.time_unit != line->unit)
        add_note(out.note, "times are " + line->unit);
    return check_rising(out.times, line->name).map([&] { return std::move(out); });
}

} // namespace wakesurf::server
