#include "importer/sources/netcdf/netcdf_axes.hpp"

#include "importer/base/lower_case.hpp"
#include "importer/fields/physical_units.hpp"
#include "importer/fields/velocity_choice.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

template <std::size_t N>
bool is_one_of(const std::string& text, const std::array<std::string_view, N>& list) {
    return std::find(list.begin(), list.end(), text) != list.end();
}

AxisKind kind_of_name(const std::string& name) {
    constexpr std::array<std::string_view, 4> time{"time", "t", "times", "timestep"};
    constexpr std::array<std::string_view, 6> z{"z", "depth", "height", "altitude", "level", "lev"};
    if (is_one_of(name, time))
        return AxisKind::Time;
    if (is_one_of(name, z))
        return AxisKind::Z;
    return name == "x" ? AxisKind::X : name == "y" ? AxisKind::Y : AxisKind::Unknown;
}

// Classifies a coordinate variable by its name, which models choose freely: x, xh, x_c, zu_3d, x_position.
AxisKind kind_of_coordinate(const std::string& name) {
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

using Triple = std::array<int, 3>;

struct Candidate {
    Triple dimensions{-1, -1, -1};
    std::optional<int> time;
    std::vector<std::string> variables;
};

class GridSearch {
  public:
    explicit GridSearch(const NetcdfFile& file) : file_(file) {}

    // Prefers a grid with a velocity; of several, the one of most variables.

    core::Result<Candidate> run() {
        for (const auto& variable : file_.variables())
            if (auto looked = look_at(variable); !looked)
                return tl::unexpected(looked.error());
        if (candidates_.empty() && curvilinear_)
            return core::fail(
                Error::Code::Unsupported,
                file_.name() + " has curvilinear coordinates: " + *curvilinear_,
                "interpolate the data to a grid whose x, y and z are one-dimensional, "
                "or write .vts files");
        if (candidates_.empty() && flat_)
            return core::fail(Error::Code::Unsupported,
                              file_.name() + " is not three-dimensional: " + *flat_ +
                                  " is a plane of values",
                              "extrude it by two cells or more first");
        if (candidates_.empty())
            return core::fail(
                Error::Code::Unsupported, file_.name() + " has no variable over x, y and z",
                "name the dimensions x, y, z, or write a variable along each of them that has its "
                "coordinates and an axis attribute");
        const auto rank = [](const Candidate& one) {
            return std::pair(has_velocity(one), one.variables.size());
        };
        const auto& best = std::max_element(candidates_.begin(), candidates_.end(),
                                            [&](const auto& a, const auto& b) {
                                                return rank(a.second) < rank(b.second);
                                            })
                               ->second;
        if (auto together = check_velocities(); !together && !has_velocity(best))
            return tl::unexpected(together.error());
        return best;
    }

  private:
    static bool has_velocity(const Candidate& candidate) {
        std::vector<core::FieldInfo> fields;
        for (const auto& name : candidate.variables)
            fields.push_back({name, 1, core::FieldInfo::Source::Point, {0.0, 0.0}, {}});
        return choose_velocity(fields, {}).has_value();
    }

    core::Result<void> look_at(const NetcdfVariable& variable) {
        if (variable.type == NC_CHAR || variable.type == NC_STRING || variable.type > NC_STRING ||
            variable.dimensions.size() < 2)
            return {};
        Candidate here;
        bool unknown = false;
        std::vector<std::size_t> lengths;
        for (const int dimension : variable.dimensions) {
            const auto length = file_.dimensions()[static_cast<std::size_t>(dimension)].length;
            auto kind = axis_kind(file_, dimension);
            if (!kind)
                return variable.dimensions.size() < 3 ? core::Result<void>()
                                                      : tl::unexpected(kind.error());
            if (*kind == AxisKind::Time && !here.time)
                here.time = dimension;
            else if (*kind == AxisKind::Time)
                unknown = true;
            else if (*kind == AxisKind::Unknown && length == 1)
                continue;
            else if (*kind == AxisKind::Unknown ||
                     here.dimensions[static_cast<std::size_t>(*kind)] >= 0)
                unknown = true;
            else
                here.dimensions[static_cast<std::size_t>(*kind)] = dimension;
        }
        const auto axes = std::count_if(here.dimensions.begin(), here.dimensions.end(),
                                        [](int d) { return d >= 0; });
        if (unknown) {
            if (const auto names = file_.text(variable, "coordinates"); !names.empty())
                curvilinear_ = names;
            return {};
        }
        if (axes == 2)
            flat_ = variable.name;
        if (axes != 3)
            return {};
        auto& found = candidates_[here.dimensions];
        found.dimensions = here.dimensions;
        if (found.time && here.time && found.time != here.time)
            return core::fail(Error::Code::Unsupported,
                              file_.name() + " has two times: that of " + variable.name +
                                  " is not that of " + found.variables.front(),
                              "write the variables of either time to a file of their own");
        found.time = found.time ? found.time : here.time;
        found.variables.push_back(variable.name);
        return {};
    }

    // Refuses u, v and w on nodes of their own: together they are a velocity nowhere.
    core::Result<void> check_velocities() const {
        std::vector<std::pair<std::string, Triple>> found;
        for (const auto& [dimensions, candidate] : candidates_)
            for (const auto& name : candidate.variables)
                if (const auto short_name = lower_case(name);
                    short_name == "u" || short_name == "v" || short_name == "w")
                    found.emplace_back(name, dimensions);
        for (const auto& [name, dimensions] : found)
            if (dimensions != found.front().second)
                return core::fail(Error::Code::Unsupported,
                                  file_.name() + " has a staggered grid: " + found.front().first +
                                      " and " + name + " are on different dimensions",
                                  "interpolate the velocity to common nodes first");
        return {};
    }

    const NetcdfFile& file_;
    std::map<Triple, Candidate> candidates_;
    std::optional<std::string> flat_;
    std::optional<std::string> curvilinear_;
};

// Converts lengths to metres; `units` of an axis keeps what the file said. Error: Unsupported (an axis that
// is no length), Io.
core::Result<void> convert_axes(const NetcdfFile& file, NetcdfGrid& grid) {
    if (auto known = check_units_known(); !known)
        return known;
    for (auto& axis : grid.axes) {
        const auto factor = factor_to_si(axis.units, Quantity::Length);
        const bool angle = axis.units.starts_with("rad") || axis.units.starts_with("arc");
        if (!factor && is_unit(axis.units) && (angle || !is_plain_number(axis.units)))
            return core::fail(Error::Code::Unsupported,
                              file.name() + ": " +
                                  file.dimensions()[static_cast<std::size_t>(axis.dimension)].name +
                                  " is in " + axis.units + ", which is not a length",
                              "interpolate the data to a Cartesian grid in metres first");
        axis.factor = factor.value_or(1.0);
        for (double& node : axis.nodes)
            node *= axis.factor;
        if (!std::isfinite(axis.nodes.front()) || !std::isfinite(axis.nodes.back()) ||
            std::adjacent_find(axis.nodes.begin(), axis.nodes.end(), std::greater_equal<>()) !=
                axis.nodes.end())
            return core::fail(Error::Code::Corrupt,
                              file.name() + " has coordinates along " +
                                  file.dimensions()[static_cast<std::size_t>(axis.dimension)].name +
                                  " that are too large or too close together when they are "
                                  "converted from " +
                                  axis.units + " to metres");
        axis.known = factor.has_value();
    }
    return {};
}

} // namespace

// CF names the coordinate variable as its dimension; other models do not. Then it is the one variable along
// the dimension that states that it is an axis, or, if none does, the one named like one.
const NetcdfVariable* coordinates_of(const NetcdfFile& file, int dimension) {
    const auto along = [&](const NetcdfVariable& variable) {
        return variable.dimensions == std::vector<int>{dimension} && variable.type != NC_CHAR &&
               variable.type != NC_STRING;
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
    if (lower_case(file.text(*variable, "positive")) == "down")
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

core::Result<NetcdfGrid> find_grid(const NetcdfFile& file) {
    auto found = GridSearch(file).run();
    if (!found)
        return tl::unexpected(found.error());
    NetcdfGrid grid{{}, found->time, std::move(found->variables)};
    for (std::size_t i = 0; i < 3; ++i) {
        auto axis = read_axis(file, found->dimensions[i]);
        if (!axis)
            return tl::unexpected(axis.error());
        if (axis->nodes.size() < 3)
            return core::fail(Error::Code::Unsupported,
                              file.name() + " is not three-dimensional: it has " +
                                  std::to_string(axis->nodes.size()) + " nodes along " + "xyz"[i],
                              "extrude it by two cells or more first");
        grid.axes[i] = std::move(*axis);
    }
    if (auto converted = convert_axes(file, grid); !converted)
        return tl::unexpected(converted.error());
    return grid;
}

} // namespace wakesurf::importer
