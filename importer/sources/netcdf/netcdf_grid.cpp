#include "importer/sources/netcdf/netcdf_grid.hpp"

#include "importer/base/lower_case.hpp"
#include "importer/base/notes.hpp"
#include "importer/fields/physical_units.hpp"
#include "importer/sources/blocks/plane_slab.hpp"
#include "importer/sources/netcdf/netcdf_no_grid.hpp"
#include "importer/sources/netcdf/netcdf_velocity.hpp"
#include "store/velocity_names.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

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
            if (auto looked = look_at(variable); !looked)
                return tl::unexpected(looked.error());
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

    core::Result<void> look_at(const NetcdfVariable& variable) {
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
