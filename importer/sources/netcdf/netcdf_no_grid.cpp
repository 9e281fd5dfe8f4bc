#include "importer/sources/netcdf/netcdf_no_grid.hpp"

#include "importer/base/lower_case.hpp"
#include "importer/sources/netcdf/netcdf_axes.hpp"
#include "importer/sources/netcdf/netcdf_velocity.hpp"
#include "store/velocity_names.hpp"

#include <algorithm>
#include <set>

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

} // namespace

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

} // namespace wakesurf::importer
