#include "server/import/sources/cgns/cgns_survey.hpp"

#include "server/import/progress_marks.hpp"

#include <vtk_cgns.h>
// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace wakesurf::server {

using core::Error;

namespace {

using Name = std::array<char, 34>; // CGNS names have 32 characters

class CgnsFile {
  public:
    explicit CgnsFile(const std::filesystem::path& path)
        : sound_(cg_open(path.c_str(), CG_MODE_READ, &id_) == CG_OK) {}

    ~CgnsFile() {
        if (sound_)
            cg_close(id_);
    }

    CgnsFile(const CgnsFile&) = delete;
    CgnsFile& operator=(const CgnsFile&) = delete;

    bool sound() const { return sound_; }

    int id() const { return id_; }

  private:
    int id_ = 0;
    bool sound_ = false;
};

class Survey {
  public:
    Survey(const ListedFile& file, int id) : name_(file.name), id_(id) {}

    core::Result<CgnsSurvey> run() {
        int bases = 0;
        if (cg_nbases(id_, &bases) != CG_OK)
            return damaged();
        bool solid = false;
        for (int base = 1; base <= bases; ++base) {
            Name name{};
            int cells = 0;
            int space = 0;
            if (cg_base_read(id_, base, name.data(), &cells, &space) != CG_OK)
                return damaged();
            solid = solid || cells == 3;
            if (cells != 3)
                continue;
            if (auto looked = look_at_base(base); !looked)
                return tl::unexpected(looked.error());
        }
        if (!solid)
            return core::fail(Error::Code::Unsupported,
                              name_ + " is not three-dimensional: no base has cells in space",
                              "extrude it by two cells or more first");
        auto units = read_cgns_units(id_, name_);
        if (!units)
            return tl::unexpected(units.error());
        out_.units = std::move(*units);
        return std::move(out_);
    }

  private:
    tl::unexpected<Error> damaged() const {
        return core::fail(Error::Code::Corrupt,
                          name_ + " is damaged or not what it says it is (CGNS: " + cg_get_error() +
                              ")");
    }

    core::Result<void> look_at_base(int base) {
        Name name{};
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
            if (auto looked = look_at_zone(base, zone, status == CG_OK ? steps : 0); !looked)
                return looked;
        return {};
    }

    core::Result<std::vector<double>> read_times(int base, int steps) {
        int arrays = 0;
        if (steps < 0 || cg_goto(id_, base, "BaseIterativeData_t", 1, "end") != CG_OK ||
            cg_narrays(&arrays) != CG_OK)
            return damaged();
        for (int i = 1; i <= arrays; ++i) {
            Name name{};
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

    core::Result<void> look_at_zone(int base, int zone, int steps) {
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
        if (auto ordered = check_sections(base, zone, solutions); !ordered)
            return ordered;
        if (*pointers >= 0)
            return {};
        std::map<int, std::string> at;
        for (int i = 1; i <= solutions; ++i) {
            Name name{};
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

    // VTK's reader takes values of cells for those of all elements up to the last cell, boundary or not, and gives up.
    core::Result<void> check_sections(int base, int zone, int solutions) {
        CGNS_ENUMT(ZoneType_t) type{};
        int sections = 0;
        if (cg_zone_type(id_, base, zone, &type) != CG_OK)
            return damaged();
        if (type != CGNS_ENUMV(Unstructured))
            return {};
        if (cg_nsections(id_, base, zone, &sections) != CG_OK)
            return damaged();
        std::map<cgsize_t, std::pair<std::string, bool>>
            by_number; // whether they are of the boundary
        for (int i = 1; i <= sections; ++i) {
            Name name{};
            CGNS_ENUMT(ElementType_t) element{};
            std::array<cgsize_t, 2> range{};
            int boundary = 0;
            int parents = 0;
            if (cg_section_read(id_, base, zone, i, name.data(), &element, &range[0], &range[1],
                                &boundary, &parents) != CG_OK)
                return damaged();
            const bool flat = element <= CGNS_ENUMV(QUAD_9) && element >= CGNS_ENUMV(NODE);
            by_number[range[0]] = {name.data(), flat};
        }
        bool of_cells = false;
        for (int i = 1; i <= solutions; ++i) {
            Name name{};
            CGNS_ENUMT(GridLocation_t) location{};
            if (cg_sol_info(id_, base, zone, i, name.data(), &location) != CG_OK)
                return damaged();
            of_cells = of_cells || location == CGNS_ENUMV(CellCenter);
        }
        const bool cells_follow =
            !by_number.empty() && by_number.begin()->second.second &&
            std::any_of(by_number.begin(), by_number.end(),
                        [](const auto& section) { return !section.second.second; });
        if (!of_cells || !cells_follow)
            return {};
        return core::fail(
            Error::Code::Unsupported,
            name_ + " has values in cells, and numbers its boundary section " +
                by_number.begin()->second.first +
                " before the cells: this version of VTK's reader cannot read that",
            "number the elements of cells from 1 and those of boundaries behind them, or "
            "write the values at the vertices");
    }

    // How many solutions the zone's FlowSolutionPointers name; -1 where it has none.
    core::Result<int> solution_pointers(int base, int zone) {
        Name name{};
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
        return core::fail(Error::Code::Corrupt, file.name + " is damaged or not what it says it is "
                                                            "(the CGNS library cannot open it)");
    return Survey(file, opened.id()).run();
}

} // namespace wakesurf::server
