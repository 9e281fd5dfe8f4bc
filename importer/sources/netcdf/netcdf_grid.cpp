#include "importer/sources/netcdf/netcdf_grid.hpp"

#include "importer/base/text.hpp"
#include "importer/fields/physical_units.hpp"
#include "importer/sources/blocks/plane_slab.hpp"
#include "importer/sources/netcdf/netcdf_conventions.hpp"
#include "store/velocity_names.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

using Names = std::vector<std::string>;

bool is_field(const NetcdfVariable& variable) {
    return has_numbers(variable) && variable.dimensions.size() > 2;
}

std::set<int> dimensions_in_space(const NetcdfFile& file, const std::string& name) {
    std::set<int> out;
    for (const int dimension : file.variable(name)->dimensions)
        if (const auto kind = axis_kind(file, dimension); !kind || *kind != AxisKind::Time)
            out.insert(dimension);
    return out;
}

std::string and_listed(const Names& names) {
    std::string out;
    for (std::size_t i = 0; i < names.size(); ++i)
        out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return out;
}

// Returns the components of each velocity, or u, v and w where one of them is missing.
std::vector<Names> velocities_of(const NetcdfFile& file) {
    std::vector<core::FieldInfo> fields;
    Names names;
    Names plain;
    for (const auto& variable : file.variables()) {
        if (!is_field(variable))
            continue;
        fields.push_back({variable.name, 1, core::FieldInfo::Source::Point, {}, {}});
        names.push_back(variable.name);
        const auto name = lower_case(variable.name);
        if (name == "u" || name == "v" || name == "w")
            plain.push_back(variable.name);
    }
    std::vector<Names> out;
    for (const auto& parts : stated_velocities(file, names, false))
        out.emplace_back(parts.begin(), parts.end());
    for (const auto& parts : store::velocity_components(fields, core::FieldInfo::Source::Point))
        out.push_back({parts[0].name, parts[1].name, parts[2].name});
    out.push_back(plain);
    return out;
}

// Names an unstructured mesh by the variable that describes it. (UGRID conventions 1.0)
std::optional<std::string> unstructured_mesh(const NetcdfFile& file) {
    for (const auto& variable : file.variables())
        if (file.text(variable, "cf_role") == "mesh_topology")
            return "UGRID: " + variable.name;
    const auto has = [&](const char* name) {
        return std::ranges::find(file.dimensions(), name, &NetcdfDimension::name) !=
               file.dimensions().end();
    };
    if (has("nCells") && has("nEdges") && has("nVertices"))
        return "MPAS";
    return std::nullopt;
}

// Lists a variable's dimensions, to tell which is taken for no axis.
std::string place_of(const NetcdfFile& file, const NetcdfVariable& variable) {
    Names names;
    for (const int dimension : variable.dimensions)
        names.push_back(file.dimensions()[static_cast<std::size_t>(dimension)].name);
    return variable.name + " is over " + and_listed(names);
}

// Returns the error of a velocity whose components, by their standard names or their own, are on nodes of their own: together
// they are a velocity nowhere. None if there is no such velocity.
std::optional<Error> staggered_velocity(const NetcdfFile& file) {
    for (const auto& parts : velocities_of(file))
        if (std::ranges::any_of(parts, [&](const std::string& name) {
                return dimensions_in_space(file, name) != dimensions_in_space(file, parts.front());
            }))
            return Error{Error::Code::Unsupported,
                         file.name() + " has a staggered grid: " + and_listed(parts) +
                             " are on different dimensions",
                         "interpolate the velocity to common nodes first"};
    return std::nullopt;
}

// Returns the error of a file without a variable over x, y and z.
Error why_no_grid(const NetcdfFile& file) {
    const auto unsupported = [&](const std::string& message, const std::string& hint) {
        return Error{Error::Code::Unsupported, file.name() + " " + message, hint};
    };
    if (file.variable("PH") != nullptr && file.variable("PHB") != nullptr)
        return unsupported(
            "is a WRF file: U, V and W are on the faces of its cells, and the heights of "
            "these are (PH + PHB) / 9.81",
            "interpolate U, V and W to common nodes at fixed heights, as wrf-python "
            "does (getvar of ua, va, wa, z; then interplevel), and write them over "
            "x, y and z in metres");
    if (const auto mesh = unstructured_mesh(file))
        return unsupported("has an unstructured mesh (" + *mesh +
                               "), which is not read from NetCDF",
                           "interpolate the velocity to a grid over x, y and z in metres, or write "
                           "the mesh as .vtu files, one a time-step");
    for (const auto& variable : file.variables())
        if (const auto names = file.text(variable, "coordinates");
            is_field(variable) && names.find(' ') != std::string::npos)
            return unsupported("has curvilinear coordinates: " + names,
                               "interpolate the data to a grid whose x, y and z are "
                               "one-dimensional, or write .vts files");
    if (auto staggered = staggered_velocity(file))
        return *staggered;
    const NetcdfVariable* most = nullptr; // of the most dimensions in space
    std::size_t dimensions = 0;
    for (const auto& variable : file.variables())
        if (const std::size_t here = dimensions_in_space(file, variable.name).size();
            has_numbers(variable) && here >= dimensions) {
            most = &variable;
            dimensions = here;
        }
    if (dimensions == 2)
        return unsupported("has no velocity: " + most->name + " is a plane of values",
                           "write both components in the plane, u and v, or name them with "
                           "standard names");
    if (most != nullptr && dimensions == 4)
        for (const int dimension : most->dimensions) {
            const auto& [name, length] = file.dimensions()[static_cast<std::size_t>(dimension)];
            const auto kind = axis_kind(file, dimension);
            if (length == 3 && kind && *kind == AxisKind::Unknown)
                return unsupported("has no variable over x, y and z alone: " +
                                       place_of(file, *most),
                                   "if " + name +
                                       " has the components of a velocity, call it component; "
                                       "else write one of them to a file of its own");
        }
    return unsupported(
        "has no variable over x, y and z" + (most == nullptr ? "" : ": " + place_of(file, *most)),
        "name the dimensions x, y, z, or write a variable along each of them that has its "
        "coordinates and an axis attribute");
}

using Triple = std::array<int, 3>;

struct Candidate {
    Triple dimensions{-1, -1, -1};
    std::optional<int> time;
    std::vector<NetcdfGridVariable> variables;

    /// Returns the axis that a plane lacks; -1 in space.
    int across() const {
        const auto none = std::ranges::find(dimensions, -1);
        return none == dimensions.end() ? -1 : static_cast<int>(none - dimensions.begin());
    }
};

// A dimension of 3 may also be one of three runs, so it counts by its name or by the variable's.
bool is_of_components(const std::string& dimension, const std::string& variable) {
    constexpr auto names = std::to_array<std::string_view>(
        {"component", "components", "comp",       "ncomp", "ncomponents", "vector_component",
         "vector",    "vec",        "nvec",       "dim",   "ndim",        "dims",
         "dimension", "xyz",        "uvw",        "three", "d3",          "space",
         "spatial",   "direction",  "directions", "axis",  "axes",        "coord",
         "coords",    "coordinate"});
    const auto meaning = store::meaning_of_vector(variable);
    return std::ranges::find(names, lower_case(last_of_path(dimension))) != names.end() ||
           (variable.size() > 1 &&
            (meaning == store::VectorName::Velocity || meaning == store::VectorName::Momentum));
}

class GridSearch {
  public:
    GridSearch(const NetcdfFile& file, const std::string& wish) : file_(file), wish_(wish) {}

    // Prefers a grid with a velocity; of several, the one of most variables.
    core::Result<NetcdfGrid> run() {
        for (const auto& variable : file_.variables())
            if (auto taken = take(variable); !taken)
                return tl::unexpected(taken.error());
        const auto with_velocity = [this](const auto& one) { return has_velocity(one.second); };
        if (std::ranges::none_of(candidates_, with_velocity) &&
            std::ranges::any_of(planes_, with_velocity))
            candidates_ = std::move(planes_);
        if (candidates_.empty())
            return tl::unexpected(why_no_grid(file_));
        const auto rank = [this](const auto& one) {
            return std::pair(has_velocity(one.second), one.second.variables.size());
        };
        const auto best =
            std::max_element(candidates_.begin(), candidates_.end(),
                             [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
        if (!has_velocity(best->second))
            if (const auto staggered = staggered_velocity(file_))
                return tl::unexpected(*staggered);
        NetcdfGrid out{{}, best->second.time, best->second.variables, {}};
        for (std::size_t i = 0; i < 3; ++i)
            out.axes[i].dimension = best->first[i];
        for (const auto& other : candidates_)
            if (has_velocity(best->second) && wish_.empty() && other.first != best->first &&
                has_velocity(other.second))
                add_note(out.note, "left out, as it is on another grid: " +
                                       other.second.variables.front().name +
                                       " and what is with it; --velocity chooses");
        return out;
    }

  private:
    bool has_velocity(const Candidate& candidate) const {
        std::vector<core::FieldInfo> fields;
        std::vector<std::string> names;
        for (const auto& [name, components] : candidate.variables) {
            fields.push_back(
                {name, components ? 3 : 1, core::FieldInfo::Source::Point, {0.0, 0.0}, {}});
            names.push_back(name);
        }
        const int across = candidate.across();
        const auto stated = stated_velocities(file_, names, across == 2);
        if (across >= 0)
            for (const auto& third : lacking_components(fields, stated, across))
                fields.push_back({third, 1, core::FieldInfo::Source::Point, {0.0, 0.0}, {}});
        const auto chosen = choose_velocity(fields, wish_, stated);
        return chosen || chosen.error().code == Error::Code::InvalidArgument;
    }

    core::Result<void> take(const NetcdfVariable& variable) {
        if (!has_numbers(variable) || variable.dimensions.size() < 2)
            return {};
        Candidate here;
        std::optional<int> components;
        for (const int dimension : variable.dimensions) {
            const auto& [name, length] = file_.dimensions()[static_cast<std::size_t>(dimension)];
            auto kind = axis_kind(file_, dimension);
            if (!kind)
                return variable.dimensions.size() < 3 ? core::Result<void>()
                                                      : tl::unexpected(kind.error());
            const auto axis = static_cast<std::size_t>(*kind);
            if (*kind == AxisKind::Unknown && length == 1)
                continue;
            if (*kind == AxisKind::Time && !here.time)
                here.time = dimension;
            else if (*kind == AxisKind::Unknown && length == 3 && !components &&
                     is_of_components(name, variable.name))
                components = dimension;
            else if (*kind == AxisKind::Time || *kind == AxisKind::Unknown ||
                     here.dimensions[axis] >= 0)
                return {};
            else
                here.dimensions[axis] = dimension;
        }
        if (std::ranges::count(here.dimensions, -1) > 1)
            return {};
        auto& found = (here.across() < 0 ? candidates_ : planes_)[here.dimensions];
        found.dimensions = here.dimensions;
        if (found.time && here.time && found.time != here.time)
            return core::fail(Error::Code::Unsupported,
                              file_.name() + " has two times: that of " + variable.name +
                                  " is not that of " + found.variables.front().name,
                              "write the variables of either time to a file of their own");
        found.time = found.time ? found.time : here.time;
        found.variables.push_back({variable.name, components});
        return {};
    }

    const NetcdfFile& file_;
    const std::string& wish_;
    std::map<Triple, Candidate> candidates_;
    std::map<Triple, Candidate> planes_; ///< grids with two axes
};

// Converts lengths to metres; `units` of an axis keeps what the file said. Error: Unsupported (an axis that
// is no length), Io.
core::Result<void> convert_axes(const NetcdfFile& file, NetcdfGrid& grid) {
    if (auto known = check_units_known(); !known)
        return known;
    for (auto& axis : grid.axes) {
        if (axis.dimension < 0)
            continue;
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

std::vector<std::string> lacking_components(const std::vector<core::FieldInfo>& fields,
                                            const std::vector<StatedComponents>& stated,
                                            int across) {
    auto out = third_components(fields, across);
    for (const auto& parts : stated)
        if (std::ranges::none_of(fields, [&](const auto& f) { return f.name == parts[2]; }) &&
            std::ranges::find(out, parts[2]) == out.end())
            out.push_back(parts[2]);
    return out;
}

core::Result<NetcdfGrid> find_grid(const NetcdfFile& file, const std::string& velocity) {
    auto grid = GridSearch(file, velocity).run();
    if (!grid)
        return grid;
    for (std::size_t i = 0; i < 3; ++i) {
        if (grid->axes[i].dimension < 0) {
            grid->axes[i].nodes = {0.0};
            continue;
        }
        const auto& [name, length] =
            file.dimensions()[static_cast<std::size_t>(grid->axes[i].dimension)];
        if (length == 0)
            return core::fail(Error::Code::Corrupt, file.name() + " has no nodes along " + name);
        auto axis = read_axis(file, grid->axes[i].dimension);
        if (!axis)
            return tl::unexpected(axis.error());
        grid->axes[i] = std::move(*axis);
    }
    if (auto converted = convert_axes(file, *grid); !converted)
        return tl::unexpected(converted.error());
    return grid;
}

} // namespace wakesurf::importer
