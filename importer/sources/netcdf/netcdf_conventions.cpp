#include "importer/sources/netcdf/netcdf_conventions.hpp"

#include "importer/base/text.hpp"
#include "importer/fields/physical_units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

enum class Way { Compass, Axes };

struct Direction {
    std::string_view word;
    std::size_t axis;
    bool backward;
    Way way;
};

constexpr auto directions = std::to_array<Direction>({{"eastward", 0, false, Way::Compass},
                                                      {"northward", 1, false, Way::Compass},
                                                      {"westward", 0, true, Way::Compass},
                                                      {"southward", 1, true, Way::Compass},
                                                      {"upward", 2, false, Way::Compass},
                                                      {"downward", 2, true, Way::Compass},
                                                      {"vertical", 2, false, Way::Compass},
                                                      {"grid_eastward", 0, false, Way::Axes},
                                                      {"grid_northward", 1, false, Way::Axes},
                                                      {"x", 0, false, Way::Axes},
                                                      {"y", 1, false, Way::Axes},
                                                      {"z", 2, false, Way::Axes}});

// Those of something else are no flow: eastward_sea_water_velocity_due_to_tides, surface_eastward_...
constexpr auto fluids = std::to_array<std::string_view>(
    {"air", "sea_water", "water", "land_ice", "sea_ice", "fluid", ""});

struct Component {
    Direction direction;
    std::string_view fluid;
};

std::string joined(std::initializer_list<std::string_view> words) {
    std::string out;
    for (const auto word : words)
        if (!word.empty())
            out.append(out.empty() ? "" : "_").append(word);
    return out;
}

std::optional<Component> component_of(const NetcdfFile& file, const NetcdfVariable& variable) {
    auto name = lower_case(file.text(variable, "standard_name"));
    name.erase(0, name.find_first_not_of(' '));
    name.erase(name.find_last_not_of(' ') + 1);
    if (name.empty())
        return std::nullopt;
    for (const auto& direction : directions) {
        if (name == joined({direction.word, "wind"}))
            return Component{direction, "air"};
        for (const auto fluid : fluids)
            if (name == joined({direction.word, fluid, "velocity"}) ||
                name == joined({fluid, direction.word, "velocity"}))
                return Component{direction, fluid};
    }
    return std::nullopt;
}

// Adds the triples of one fluid. Of two variables for one component there are two triples: the choice asks.
void add_triples(const std::array<std::vector<std::string>, 3>& parts,
                 std::vector<StatedComponents>& out) {
    std::size_t most = 0;
    for (const auto& part : parts) {
        if (part.empty())
            return;
        most = std::max(most, part.size());
    }
    const auto of = [&](std::size_t axis, std::size_t i) {
        return parts[axis][std::min(i, parts[axis].size() - 1)];
    };
    for (std::size_t i = 0; i < most; ++i)
        out.push_back({of(0, i), of(1, i), of(2, i)});
}

} // namespace

std::vector<StatedComponents>
stated_velocities(const NetcdfFile& file, const std::vector<std::string>& names, bool level) {
    struct Found {
        std::map<Way, std::array<std::vector<std::string>, 2>> level;
        std::vector<std::string> vertical;
    };

    std::map<std::string_view, Found> of_fluids;
    for (const auto& name : names) {
        const auto* variable = file.variable(name);
        const auto part = variable == nullptr ? std::nullopt : component_of(file, *variable);
        if (!part)
            continue;
        auto& found = of_fluids[part->fluid];
        const std::size_t axis = part->direction.axis;
        (axis == 2 ? found.vertical : found.level[part->direction.way].at(axis)).push_back(name);
    }
    std::vector<StatedComponents> out;
    for (auto& [fluid, found] : of_fluids) {
        if (level && found.vertical.empty())
            found.vertical.push_back(joined({"upward", fluid, "velocity"}));
        for (const Way way : {Way::Axes, Way::Compass}) {
            const std::size_t before = out.size();
            auto& [x, y] = found.level[way];
            add_triples({x, y, found.vertical}, out);
            if (out.size() > before)
                break;
        }
    }
    return out;
}

bool points_backward(const NetcdfFile& file, const NetcdfVariable& variable, bool z_down) {
    if (const auto part = component_of(file, variable))
        return part->direction.word == "z" ? z_down : part->direction.backward;
    if (!file.text(variable, "standard_name").empty() ||
        !factor_to_si(file.text(variable, "units"), Quantity::Velocity)) // of fluxes it means else
        return false;
    const auto positive = lower_case(file.text(variable, "positive"));
    const auto words = lower_case(file.text(variable, "long_name"));
    return positive == "down" || words.starts_with("downward") ||
           words.find(" downward") != std::string::npos;
}

std::string stated_tendency(const NetcdfFile& file, const NetcdfVariable& variable) {
    const auto name = lower_case(file.text(variable, "standard_name"));
    if (name.find("tendency_of") != std::string::npos)
        return name;
    // Without a standard name, of pressure by the unit.
    const auto units = file.text(variable, "units");
    const auto small = lower_case(units);
    const auto begins = [&](const char* unit) { return small.starts_with(unit); };
    const bool by_time = small.find("s-1") != std::string::npos ||
                         small.find("/s") != std::string::npos ||
                         small.find("s^-1") != std::string::npos;
    return by_time && (begins("pa") || begins("hpa") || begins("mb")) ? units : "";
}

core::Result<void> refuse_tendencies(const NetcdfFile& file,
                                     const std::vector<std::string>& velocity) {
    bool level = !velocity.empty();
    std::vector<std::string> names = velocity;
    if (velocity.empty())
        for (const auto& variable : file.variables()) {
            names.push_back(variable.name);
            const auto part = component_of(file, variable);
            level = level || (part && part->direction.axis < 2);
        }
    for (const auto& name : names)
        if (const auto* variable = file.variable(name); level && variable != nullptr)
            if (const auto stated = stated_tendency(file, *variable);
                !stated.empty() && variable->dimensions.size() > 2)
                return core::fail(Error::Code::Unsupported,
                                  file.name() + " has no vertical velocity: " + name +
                                      " is a rate of change (" + stated + ")",
                                  "write the upward velocity in m s-1 beside it; of omega in Pa "
                                  "s-1 it is -omega / (density x 9.81)");
    return {};
}

namespace {

template <std::size_t N>
bool is_one_of(const std::string& text, const std::array<std::string_view, N>& list) {
    return std::find(list.begin(), list.end(), text) != list.end();
}

AxisKind kind_of_name(const std::string& path) {
    const std::string name = last_of_path(path);
    constexpr std::array<std::string_view, 4> time{"time", "t", "times", "timestep"};
    constexpr std::array<std::string_view, 6> z{"z", "depth", "height", "altitude", "level", "lev"};
    if (is_one_of(name, time))
        return AxisKind::Time;
    if (is_one_of(name, z))
        return AxisKind::Z;
    return name == "x" ? AxisKind::X : name == "y" ? AxisKind::Y : AxisKind::Unknown;
}

// Classifies a coordinate variable by its name, which models choose freely: x, xh, x_c, zu_3d, x_position.
AxisKind kind_of_coordinate(const std::string& path) {
    const std::string name = last_of_path(path);
    if (const auto kind = kind_of_name(name); kind != AxisKind::Unknown)
        return kind;
    const bool short_name = name.size() <= 3 || name[1] == '_' || name[2] == '_';
    if (!short_name || name[0] < 'x' || name[0] > 'z')
        return AxisKind::Unknown;
    return name[0] == 'x' ? AxisKind::X : name[0] == 'y' ? AxisKind::Y : AxisKind::Z;
}

// Returns the kind that a variable states in its attributes.
AxisKind stated_kind(const NetcdfFile& file, const NetcdfVariable& variable) {
    const auto axis = lower_case(file.text(variable, "axis"));
    const auto standard = lower_case(file.text(variable, "standard_name"));
    if (axis == "t" ||
        lower_case(file.text(variable, "units")).find(" since ") != std::string::npos)
        return AxisKind::Time;
    if (axis == "x" || axis == "y" || axis == "z")
        return axis == "x" ? AxisKind::X : axis == "y" ? AxisKind::Y : AxisKind::Z;
    if (standard == "projection_x_coordinate" || standard == "projection_y_coordinate")
        return standard[11] == 'x' ? AxisKind::X : AxisKind::Y;
    return file.text(variable, "positive").empty() ? AxisKind::Unknown : AxisKind::Z;
}

// A depth is positive downwards by its name, unless it says otherwise or its values are heights already.
bool says_depth(const NetcdfFile& file,
                const NetcdfVariable& variable,
                const std::vector<double>& nodes) {
    const auto standard = lower_case(file.text(variable, "standard_name"));
    return file.text(variable, "positive").empty() &&
           (standard.starts_with("depth") ||
            (standard.empty() && lower_case(last_of_path(variable.name)) == "depth")) &&
           std::ranges::none_of(nodes, [](double node) { return node < 0.0; });
}

tl::unexpected<Error>
no_length(const NetcdfFile& file, const std::string& dimension, const char* what) {
    return core::fail(Error::Code::Unsupported,
                      file.name() + ": " + dimension + " is " + what + ", not a length",
                      "interpolate the data to a Cartesian grid in metres first");
}

core::Result<void> refuse_angles_and_levels(const NetcdfFile& file,
                                            const std::string& dimension,
                                            const std::string& name,
                                            const std::string& units) {
    constexpr std::array<std::string_view, 7> angles{
        "longitude", "latitude", "lon", "lat", "grid_longitude", "grid_latitude", "degrees"};
    constexpr std::array<std::string_view, 7> pressures{"pa",       "hpa",       "mb", "mbar",
                                                        "millibar", "millibars", "kpa"};
    if (is_one_of(name, angles) || units.starts_with("degree"))
        return no_length(file, dimension, "an angle (longitude or latitude)");
    if (is_one_of(units, pressures) || name.find("sigma") != std::string::npos ||
        name.find("pressure") != std::string::npos)
        return no_length(file, dimension, "a pressure or sigma level");
    return {};
}

} // namespace

// CF names the coordinate variable as its dimension; other models do not. Then it is the one variable along
// the dimension that states that it is an axis, or, if none does, the one named like one.
const NetcdfVariable* coordinates_of(const NetcdfFile& file, int dimension) {
    const auto along = [&](const NetcdfVariable& variable) {
        return variable.dimensions == std::vector<int>{dimension} && has_numbers(variable);
    };
    const auto* same = file.variable(file.dimensions()[static_cast<std::size_t>(dimension)].name);
    if (same != nullptr && along(*same))
        return same;
    const NetcdfVariable* stated = nullptr;
    const NetcdfVariable* named = nullptr;
    std::size_t several = 0;
    for (const auto& variable : file.variables()) {
        if (!along(variable))
            continue;
        if (stated_kind(file, variable) != AxisKind::Unknown) {
            if (stated != nullptr)
                return nullptr;
            stated = &variable;
        } else if (kind_of_coordinate(lower_case(variable.name)) != AxisKind::Unknown) {
            named = &variable;
            ++several;
        }
    }
    return stated != nullptr ? stated : several == 1 ? named : nullptr;
}

core::Result<AxisKind> axis_kind(const NetcdfFile& file, int dimension) {
    const auto& name = file.dimensions()[static_cast<std::size_t>(dimension)].name;
    const auto* variable = coordinates_of(file, dimension);
    if (variable == nullptr) {
        auto length = refuse_angles_and_levels(file, name, lower_case(name), {});
        return length.map([&] { return kind_of_name(lower_case(name)); });
    }
    const auto stated = stated_kind(file, *variable);
    if (stated == AxisKind::Time)
        return stated;
    auto standard = lower_case(file.text(*variable, "standard_name"));
    if (standard.empty())
        standard = lower_case(variable->name);
    if (auto length = refuse_angles_and_levels(file, variable->name, standard,
                                               lower_case(file.text(*variable, "units")));
        !length)
        return tl::unexpected(length.error());
    if (stated != AxisKind::Unknown)
        return stated;
    for (const auto& each : {kind_of_name(standard), kind_of_name(lower_case(name)),
                             kind_of_coordinate(lower_case(variable->name))})
        if (each != AxisKind::Unknown)
            return each;
    return AxisKind::Unknown;
}

namespace {

// Says whether the coordinates attribute of a variable names this one.
bool is_coordinate(const NetcdfFile& file, const std::string& name) {
    return std::ranges::any_of(file.variables(), [&](const NetcdfVariable& variable) {
        std::istringstream words(file.text(variable, "coordinates"));
        return std::find(std::istream_iterator<std::string>(words), {}, name) !=
               std::istream_iterator<std::string>();
    });
}

} // namespace

const NetcdfVariable* time_of_all(const NetcdfFile& file) {
    const NetcdfVariable* dated = nullptr;
    const NetcdfVariable* named = nullptr;
    std::size_t several = 0;
    for (const auto& variable : file.variables()) {
        if (!has_numbers(variable) || std::ranges::any_of(variable.dimensions, [&](int dimension) {
                return file.dimensions()[static_cast<std::size_t>(dimension)].length != 1;
            }))
            continue;
        const auto standard = lower_case(file.text(variable, "standard_name"));
        if (standard == "time")
            return &variable;
        if (!standard.empty()) // forecast_reference_time
            continue;
        if (kind_of_name(lower_case(variable.name)) == AxisKind::Time) {
            named = named == nullptr ? &variable : named;
        } else if (stated_kind(file, variable) == AxisKind::Time ||
                   (is_coordinate(file, variable.name) &&
                    factor_to_si(file.text(variable, "units"), Quantity::Time))) {
            dated = &variable;
            ++several;
        }
    }
    return named != nullptr ? named : several == 1 ? dated : nullptr;
}

core::Result<NetcdfAxis> read_axis(const NetcdfFile& file, int dimension) {
    const auto& [name, length] = file.dimensions()[static_cast<std::size_t>(dimension)];
    NetcdfAxis axis;
    axis.dimension = dimension;
    const auto* variable = coordinates_of(file, dimension);
    if (variable == nullptr) {
        axis.numbered = true;
        for (std::size_t i = 0; i < length; ++i)
            axis.nodes.push_back(static_cast<double>(i));
        return axis;
    }
    auto nodes = file.read(*variable);
    if (!nodes)
        return tl::unexpected(nodes.error());
    axis.nodes = std::move(*nodes);
    axis.units = file.text(*variable, "units");
    axis.by_name = says_depth(file, *variable, axis.nodes);
    axis.down = axis.by_name || lower_case(file.text(*variable, "positive")) == "down";
    if (axis.down)
        std::transform(axis.nodes.begin(), axis.nodes.end(), axis.nodes.begin(), std::negate<>());
    axis.flipped = axis.nodes.size() > 1 && axis.nodes.front() > axis.nodes.back();
    if (axis.flipped)
        std::reverse(axis.nodes.begin(), axis.nodes.end());
    for (std::size_t i = 0; i < axis.nodes.size(); ++i)
        if (!std::isfinite(axis.nodes[i]) || (i > 0 && !(axis.nodes[i - 1] < axis.nodes[i])))
            return core::fail(Error::Code::Corrupt,
                              file.name() + " has coordinates along " + name +
                                  " that neither increase nor decrease, or are missing");
    return axis;
}

} // namespace wakesurf::importer
