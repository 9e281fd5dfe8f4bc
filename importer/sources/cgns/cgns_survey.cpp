
#include "core/base/result.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/fields/physical_units.hpp"
#include "importer/sources/cgns/cgns_file.hpp"

#include <vtk_cgns.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

// The units of length that a CGNS file states for its coordinates and for its velocities: DimensionalUnits_t
// of an array, or of what it lies in. (CGNS Standard Interface Data Structures 4.2, sections 2.4 and 4.3;
// times are always in seconds there.)

using Name = std::array<char, 34>; // CGNS names have 32 characters
using Length = CGNS_ENUMT(LengthUnits_t);

// Returns what holds inside a node: what it states itself, else what holds around it.
struct Scope {
    std::optional<Length> length;
    bool dimensional = true;

    // Returns the scope of the node that cg_goto went to.
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

    void read() {
        int bases = 0;
        cg_nbases(id_, &bases);
        for (int base = 1; base <= bases; ++base) {
            if (cg_goto(id_, base, "end") != CG_OK)
                continue;
            const Scope scope = Scope().inside();
            int zones = 0;
            cg_nzones(id_, base, &zones);
            for (int zone = 1; zone <= zones; ++zone)
                read_zone(base, zone, scope);
        }
    }

    std::set<std::string> coordinates; ///< units; empty text where none is stated
    std::set<std::string> velocities;

  private:
    void read_zone(int base, int zone, const Scope& around) {
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
            read_solution(base, zone, solution, scope);
    }

    void read_solution(int base, int zone, int solution, const Scope& around) {
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

// Returns factor 1 if one of the two states no unit, or both the same. Error: Unsupported (zones in different
// units), Io. @param id  as the CGNS library opened the file
core::Result<CgnsUnits> read_cgns_units(int id, const std::string& file) {
    Units found(id);
    found.read();
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

class Survey {
  public:
    Survey(const ListedFile& file, int id) : name_(file.name), id_(id) {}

    core::Result<CgnsSurvey> run() {
        int bases = 0;
        if (cg_nbases(id_, &bases) != CG_OK)
            return damaged();
        std::vector<int> dimensions;
        for (int base = 1; base <= bases; ++base) {
            CgnsName name{};
            int cells = 0;
            int space = 0;
            if (cg_base_read(id_, base, name.data(), &cells, &space) != CG_OK)
                return damaged();
            dimensions.push_back(cells);
        }
        out_.dimension = std::ranges::find(dimensions, 3) == dimensions.end() ? 2 : 3;
        if (std::ranges::find(dimensions, out_.dimension) == dimensions.end())
            return core::fail(Error::Code::Unsupported,
                              name_ + " has no base with cells in space or in a plane");
        for (int base = 1; base <= bases; ++base)
            if (dimensions[static_cast<std::size_t>(base - 1)] == out_.dimension)
                if (auto sound = survey_base(base); !sound)
                    return tl::unexpected(sound.error());
        auto units = read_cgns_units(id_, name_);
        if (!units)
            return tl::unexpected(units.error());
        out_.units = std::move(*units);
        return std::move(out_);
    }

  private:
    tl::unexpected<Error> damaged() const { return cgns_damage(name_); }

    core::Result<void> survey_base(int base) {
        CgnsName name{};
        int steps = 0;
        const int status = cg_biter_read(id_, base, name.data(), &steps);
        if (status != CG_OK && status != CG_NODE_NOT_FOUND)
            return damaged();
        if (status == CG_OK) {
            auto times = read_times(base, steps);
            if (!times)
                return tl::unexpected(times.error());
            if (!out_.times.empty() && *times != out_.times)
                return core::fail(Error::Code::Unsupported,
                                  name_ + " has bases with different times");
            out_.times = std::move(*times);
        }
        int zones = 0;
        if (cg_nzones(id_, base, &zones) != CG_OK)
            return damaged();
        for (int zone = 1; zone <= zones; ++zone)
            if (auto sound = survey_zone(base, zone, status == CG_OK ? steps : 0); !sound)
                return sound;
        return {};
    }

    core::Result<std::vector<double>> read_times(int base, int steps) {
        int arrays = 0;
        if (steps < 0 || cg_goto(id_, base, "BaseIterativeData_t", 1, "end") != CG_OK ||
            cg_narrays(&arrays) != CG_OK)
            return damaged();
        for (int i = 1; i <= arrays; ++i) {
            CgnsName name{};
            CGNS_ENUMT(DataType_t) type{};
            int rank = 0;
            std::array<cgsize_t, 12> size{};
            if (cg_array_info(i, name.data(), &type, &rank, size.data()) != CG_OK)
                return damaged();
            if (std::string(name.data()) != "TimeValues")
                continue;
            if (rank != 1 || size[0] != steps)
                return core::fail(Error::Code::Corrupt, name_ + " has " + std::to_string(size[0]) +
                                                            " times for " + std::to_string(steps) +
                                                            " time-steps");
            std::vector<double> times(static_cast<std::size_t>(steps));
            if (cg_array_read_as(i, CGNS_ENUMV(RealDouble), times.data()) != CG_OK)
                return damaged();
            if (!std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); }))
                return core::fail(Error::Code::Corrupt, name_ + " has a time that is not finite");
            return times;
        }
        return std::vector<double>();
    }

    core::Result<void> survey_zone(int base, int zone, int steps) {
        const auto pointers = solution_pointers(base, zone);
        if (!pointers)
            return tl::unexpected(pointers.error());
        if (*pointers >= 0 && *pointers != steps)
            return core::fail(Error::Code::Corrupt, name_ + " names " + std::to_string(*pointers) +
                                                        " solutions for " + std::to_string(steps) +
                                                        " time-steps");
        int solutions = 0;
        if (cg_nsols(id_, base, zone, &solutions) != CG_OK)
            return damaged();
        if (auto sound = survey_mesh(base, zone); !sound)
            return sound;
        if (*pointers >= 0)
            return {};
        std::map<int, std::string> at;
        for (int i = 1; i <= solutions; ++i) {
            CgnsName name{};
            CGNS_ENUMT(GridLocation_t) location{};
            if (cg_sol_info(id_, base, zone, i, name.data(), &location) != CG_OK)
                return damaged();
            int fields = 0;
            if (cg_nfields(id_, base, zone, i, &fields) != CG_OK)
                return damaged();
            if (fields == 0)
                continue;
            const auto [other, added] = at.emplace(static_cast<int>(location), name.data());
            if (!added)
                return core::fail(Error::Code::Unsupported,
                                  name_ + " has several solutions at one place, " + other->second +
                                      " and " + name.data() + ", without saying when",
                                  "write FlowSolutionPointers for them, or one solution per file");
        }
        return {};
    }

    // VTK's reader takes elements for cells by their numbers, up to the count of cells, and expects cells to
    // begin with 1.
    core::Result<void> survey_mesh(int base, int zone) {
        CgnsName name{};
        CGNS_ENUMT(ZoneType_t) type{};
        std::array<cgsize_t, 9> size{};
        int sections = 0;
        if (cg_zone_type(id_, base, zone, &type) != CG_OK ||
            cg_zone_read(id_, base, zone, name.data(), size.data()) != CG_OK)
            return damaged();
        const bool structured = type == CGNS_ENUMV(Structured);
        std::uint64_t nodes = 1;
        for (std::size_t i = 0; i < (structured ? static_cast<std::size_t>(out_.dimension) : 1);
             ++i) {
            if (size[i] < 0)
                return core::fail(Error::Code::Corrupt, name_ + " has a zone of negative size");
            nodes *= static_cast<std::uint64_t>(size[i]);
            if (auto fits = check_claim(name_, nodes, 3 * sizeof(double)); !fits)
                return fits;
        }
        if (structured)
            return {};
        if (cg_nsections(id_, base, zone, &sections) != CG_OK)
            return damaged();
        for (int i = 1; i <= sections; ++i) {
            CGNS_ENUMT(ElementType_t) element{};
            std::array<cgsize_t, 2> range{};
            int boundary = 0;
            int parents = 0;
            if (cg_section_read(id_, base, zone, i, name.data(), &element, &range[0], &range[1],
                                &boundary, &parents) != CG_OK)
                return damaged();
            const auto elements =
                static_cast<std::uint64_t>(range[1]) - static_cast<std::uint64_t>(range[0]);
            if (auto fits = check_claim(name_, elements, sizeof(cgsize_t)); !fits)
                return fits;
            if (element == CGNS_ENUMV(NGON_n) || element == CGNS_ENUMV(NFACE_n))
                return {};
            if (element == CGNS_ENUMV(MIXED)) {
                std::array<cgsize_t, 256> first{};
                std::array<cgsize_t, 2> offsets{};
                if (cg_poly_elements_partial_read(id_, base, zone, i, range[0], range[0],
                                                  first.data(), offsets.data(), nullptr) != CG_OK)
                    return damaged();
                element = static_cast<CGNS_ENUMT(ElementType_t)>(first[0]);
            }
            const cgsize_t cells = size[1];
            out_.cells_have_other_numbers =
                out_.cells_have_other_numbers ||
                (has_dimension(element, out_.dimension) ? range[1] > cells : range[0] <= cells);
        }
        return {};
    }

    // Returns the number of solutions that the zone's FlowSolutionPointers name; -1 without any.
    core::Result<int> solution_pointers(int base, int zone) {
        CgnsName name{};
        const int status = cg_ziter_read(id_, base, zone, name.data());
        if (status == CG_NODE_NOT_FOUND)
            return -1;
        int arrays = 0;
        if (status != CG_OK ||
            cg_goto(id_, base, "Zone_t", zone, "ZoneIterativeData_t", 1, "end") != CG_OK ||
            cg_narrays(&arrays) != CG_OK)
            return damaged();
        for (int i = 1; i <= arrays; ++i) {
            CGNS_ENUMT(DataType_t) type{};
            int rank = 0;
            std::array<cgsize_t, 12> size{};
            if (cg_array_info(i, name.data(), &type, &rank, size.data()) != CG_OK)
                return damaged();
            if (std::string(name.data()) == "FlowSolutionPointers")
                return rank == 2 ? static_cast<int>(size[1]) : 0;
        }
        return -1;
    }

    std::string name_;
    int id_ = 0;
    CgnsSurvey out_;
};

} // namespace

core::Result<CgnsSurvey> survey_cgns(const ListedFile& file) {
    made_progress();
    const CgnsFile opened(file.path);
    if (!opened.sound())
        return core::fail(Error::Code::Corrupt,
                          file.name + " is damaged, or not the kind of file that it claims to be "
                                      "(the CGNS library cannot open it)");
    return Survey(file, opened.id()).run();
}

} // namespace wakesurf::importer
