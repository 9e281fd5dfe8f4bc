#include "importer/sources/netcdf/netcdf_velocity.hpp"

#include "importer/base/lower_case.hpp"
#include "importer/fields/physical_units.hpp"

#include <algorithm>
#include <array>
#include <map>
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

} // namespace wakesurf::importer
