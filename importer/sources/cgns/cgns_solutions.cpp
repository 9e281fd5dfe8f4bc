#include "importer/sources/cgns/cgns_solutions.hpp"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <map>
#include <set>

namespace wakesurf::importer {

using core::FieldInfo;

namespace {

class SolutionReader {
  public:
    SolutionReader(const CgnsZone& at, std::optional<std::size_t> step, const WantedArrays& wanted)
        : at_(at), step_(step), wanted_(wanted) {}

    core::Result<void> add_all(vtkDataSet& data) {
        const auto now = solutions_now();
        int solutions = 0;
        if (!now)
            return tl::unexpected(now.error());
        if (cg_nsols(at_.file, at_.base, at_.zone, &solutions) != CG_OK)
            return cgns_damage(at_.name);
        for (int solution = 1; solution <= solutions; ++solution) {
            CgnsName name{};
            CGNS_ENUMT(GridLocation_t) location{};
            if (cg_sol_info(at_.file, at_.base, at_.zone, solution, name.data(), &location) !=
                CG_OK)
                return cgns_damage(at_.name);
            const bool in_cells = location == CGNS_ENUMV(CellCenter);
            if ((!now->empty() && !now->contains(name.data())) ||
                (!in_cells && location != CGNS_ENUMV(Vertex)))
                continue;
            if (auto added = add_solution(solution, in_cells, data); !added)
                return added;
        }
        return {};
    }

  private:
    // Those that count at this time-step.
    core::Result<std::set<std::string>> solutions_now() {
        std::set<std::string> out;
        CgnsName name{};
        int arrays = 0;
        if (!step_ || cg_ziter_read(at_.file, at_.base, at_.zone, name.data()) != CG_OK)
            return out;
        if (cg_goto(at_.file, at_.base, "Zone_t", at_.zone, "ZoneIterativeData_t", 1, "end") !=
                CG_OK ||
            cg_narrays(&arrays) != CG_OK)
            return cgns_damage(at_.name);
        for (int i = 1; i <= arrays; ++i) {
            CGNS_ENUMT(DataType_t) type{};
            int rank = 0;
            std::array<cgsize_t, 12> size{};
            if (cg_array_info(i, name.data(), &type, &rank, size.data()) != CG_OK)
                return cgns_damage(at_.name);
            const std::string array = name.data();
            if (!array.starts_with("FlowSolution") || !array.ends_with("Pointers") || rank != 2 ||
                type != CGNS_ENUMV(Character) || size[0] != 32 ||
                size[1] <= static_cast<cgsize_t>(*step_))
                continue;
            std::string names(static_cast<std::size_t>(size[0] * size[1]), ' ');
            if (cg_array_read(i, names.data()) != CG_OK)
                return cgns_damage(at_.name);
            const std::string one = names.substr(32 * *step_, 32);
            out.insert(one.substr(0, one.find_last_not_of(std::string(" \0", 2)) + 1));
        }
        return out;
    }

    core::Result<void> add_solution(int solution, bool in_cells, vtkDataSet& data) {
        int fields = 0;
        if (cg_nfields(at_.file, at_.base, at_.zone, solution, &fields) != CG_OK)
            return cgns_damage(at_.name);
        std::set<std::string> names;
        for (int field = 1; field <= fields; ++field) {
            CgnsName name{};
            CGNS_ENUMT(DataType_t) type{};
            if (cg_field_info(at_.file, at_.base, at_.zone, solution, field, &type, name.data()) !=
                CG_OK)
                return cgns_damage(at_.name);
            names.insert(name.data());
        }
        std::map<std::string, std::vector<std::string>> arrays; // and their components
        for (const auto& name : names) {
            const std::string stem = name.substr(0, name.size() - (name.empty() ? 0 : 1));
            const bool vector = name.find_last_of("XYZ") == stem.size() && !stem.empty() &&
                                names.contains(stem + "X") && names.contains(stem + "Y") &&
                                names.contains(stem + "Z");
            arrays[vector ? stem : name].push_back(name); // X, Y, Z, since names are in order
        }
        for (const auto& [name, components] : arrays) {
            const auto source = in_cells ? FieldInfo::Source::Cell : FieldInfo::Source::Point;
            if (!wanted_.all && std::none_of(wanted_.fields.begin(), wanted_.fields.end(),
                                             [&, &array = name](const FieldInfo& field) {
                                                 return field.name == array &&
                                                        field.source == source;
                                             }))
                continue;
            if (auto added = add_array(solution, name, components, in_cells, data); !added)
                return added;
        }
        return {};
    }

    core::Result<void> add_array(int solution,
                                 const std::string& name,
                                 const std::vector<std::string>& components,
                                 bool in_cells,
                                 vtkDataSet& data) {
        const vtkIdType count = in_cells ? data.GetNumberOfCells() : data.GetNumberOfPoints();
        const auto* const last = at_.size.data() + (in_cells ? at_.structured ? 3 : 1 : 0);
        const auto array = vtkSmartPointer<vtkDoubleArray>::New();
        array->SetName(name.c_str());
        array->SetNumberOfComponents(static_cast<int>(components.size()));
        array->SetNumberOfTuples(count);
        std::vector<double> values(static_cast<std::size_t>(count));
        for (std::size_t c = 0; c < components.size(); ++c) {
            if (cg_field_read(at_.file, at_.base, at_.zone, solution, components[c].c_str(),
                              CGNS_ENUMV(RealDouble), cgns_first.data(), last,
                              values.data()) != CG_OK)
                return cgns_damage(at_.name);
            for (vtkIdType i = 0; i < count; ++i)
                array->SetComponent(i, static_cast<int>(c), values[static_cast<std::size_t>(i)]);
        }
        (in_cells ? static_cast<vtkFieldData*>(data.GetCellData()) : data.GetPointData())
            ->AddArray(array);
        return {};
    }

    const CgnsZone& at_;
    std::optional<std::size_t> step_;
    const WantedArrays& wanted_;
};

} // namespace

core::Result<void> add_cgns_solutions(const CgnsZone& zone,
                                      std::optional<std::size_t> step,
                                      const WantedArrays& wanted,
                                      vtkDataSet& data) {
    return SolutionReader(zone, step, wanted).add_all(data);
}

} // namespace wakesurf::importer
