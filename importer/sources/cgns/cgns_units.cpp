#include "importer/sources/cgns/cgns_units.hpp"

#include "importer/fields/physical_units.hpp"

#include <vtk_cgns.h>
// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <array>
#include <optional>
#include <set>
#include <string_view>

namespace wakesurf::importer {

namespace {

using Name = std::array<char, 34>; // CGNS names have 32 characters
using Length = CGNS_ENUMT(LengthUnits_t);

// What holds inside a node: what it states itself, else what holds around it.
struct Scope {
    std::optional<Length> length;
    bool dimensional = true;

    // Of the node that cg_goto went to.
    Scope inside() const {
        Scope out = *this;
        CGNS_ENUMT(MassUnits_t) mass{};
        CGNS_ENUMT(TimeUnits_t) time{};
        CGNS_ENUMT(TemperatureUnits_t) temperature{};
        CGNS_ENUMT(AngleUnits_t) angle{};
        Length here{};
        if (cg_units_read(&mass, &here, &time, &temperature, &angle) == CG_OK)
            out.length = here;
        CGNS_ENUMT(DataClass_t) kind{};
        if (cg_dataclass_read(&kind) == CG_OK)
            out.dimensional = kind == CGNS_ENUMV(Dimensional);
        return out;
    }
};

const char* unit_of(const Scope& scope) {
    if (!scope.length || !scope.dimensional)
        return "";
    switch (*scope.length) {
    case CGNS_ENUMV(Meter):
        return "meter";
    case CGNS_ENUMV(Centimeter):
        return "centimeter";
    case CGNS_ENUMV(Millimeter):
        return "millimeter";
    case CGNS_ENUMV(Foot):
        return "foot";
    case CGNS_ENUMV(Inch):
        return "inch";
    default:
        return "";
    }
}

class Units {
  public:
    explicit Units(int id) : id_(id) {}

    void look() {
        int bases = 0;
        cg_nbases(id_, &bases);
        for (int base = 1; base <= bases; ++base) {
            if (cg_goto(id_, base, "end") != CG_OK)
                continue;
            const Scope scope = Scope().inside();
            int zones = 0;
            cg_nzones(id_, base, &zones);
            for (int zone = 1; zone <= zones; ++zone)
                look_at_zone(base, zone, scope);
        }
    }

    std::set<std::string> coordinates; ///< units; empty text where none is stated
    std::set<std::string> velocities;

  private:
    void look_at_zone(int base, int zone, const Scope& around) {
        if (cg_goto(id_, base, "Zone_t", zone, "end") != CG_OK)
            return;
        const Scope scope = around.inside();
        if (cg_goto(id_, base, "Zone_t", zone, "GridCoordinates_t", 1, "end") == CG_OK) {
            const Scope grid = scope.inside();
            int count = 0;
            cg_narrays(&count);
            for (int i = 1; i <= count; ++i)
                if (cg_goto(id_, base, "Zone_t", zone, "GridCoordinates_t", 1, "DataArray_t", i,
                            "end") == CG_OK)
                    coordinates.insert(unit_of(grid.inside()));
        }
        int solutions = 0;
        cg_nsols(id_, base, zone, &solutions);
        for (int solution = 1; solution <= solutions; ++solution)
            look_at_solution(base, zone, solution, scope);
    }

    void look_at_solution(int base, int zone, int solution, const Scope& around) {
        if (cg_goto(id_, base, "Zone_t", zone, "FlowSolution_t", solution, "end") != CG_OK)
            return;
        const Scope scope = around.inside();
        int fields = 0;
        cg_nfields(id_, base, zone, solution, &fields);
        for (int field = 1; field <= fields; ++field) {
            CGNS_ENUMT(DataType_t) type{};
            Name name{};
            if (cg_field_info(id_, base, zone, solution, field, &type, name.data()) != CG_OK)
                continue;
            const std::string_view called(name.data());
            if ((called.starts_with("Velocity") || called.starts_with("Momentum")) &&
                cg_goto(id_, base, "Zone_t", zone, "FlowSolution_t", solution, "DataArray_t", field,
                        "end") == CG_OK)
                velocities.insert(unit_of(scope.inside()));
        }
    }

    int id_;
};

} // namespace

core::Result<CgnsUnits> read_cgns_units(int id, const std::string& file) {
    Units found(id);
    found.look();
    for (auto* units : {&found.coordinates, &found.velocities})
        if (units->size() > 1)
            units->erase(""); // an array without dimensions beside others
    CgnsUnits out;
    if (found.coordinates.size() > 1 || found.velocities.size() > 1)
        return core::fail(core::Error::Code::Unsupported,
                          file + " has zones or arrays in different units of length",
                          "write coordinates and velocities of all zones in metres and seconds");
    if (found.coordinates.empty() || found.velocities.empty() ||
        found.coordinates == found.velocities)
        return out;
    const std::string from = *found.coordinates.begin();
    const std::string to = *found.velocities.begin();
    if (from.empty() || to.empty()) {
        out.note = from.empty() ? "the coordinates have no unit of length: kept, and taken as " + to
                                : "the velocities have no unit of length: kept, and taken as " +
                                      from + " per second";
        return out;
    }
    if (auto known = check_units_known(); !known)
        return tl::unexpected(known.error());
    out.coordinates = factor_to_si(from, Quantity::Length).value_or(1.0) /
                      factor_to_si(to, Quantity::Length).value_or(1.0);
    out.note = "x, y, z were converted from " + from + " to " + to + ", the velocity's unit";
    return out;
}

} // namespace wakesurf::importer
