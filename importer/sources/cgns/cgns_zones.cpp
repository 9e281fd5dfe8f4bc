
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/cgns/cgns_file.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

// Reads points and cells of a zone of a CGNS file with the CGNS library.

// Knows cells with straight edges; returns 0 for all others.
int vtk_cell_of(CGNS_ENUMT(ElementType_t) type) {
    return type == CGNS_ENUMV(TETRA_4)   ? VTK_TETRA
           : type == CGNS_ENUMV(PYRA_5)  ? VTK_PYRAMID
           : type == CGNS_ENUMV(PENTA_6) ? VTK_WEDGE
           : type == CGNS_ENUMV(HEXA_8)  ? VTK_HEXAHEDRON
           : type == CGNS_ENUMV(TRI_3)   ? VTK_TRIANGLE
           : type == CGNS_ENUMV(QUAD_4)  ? VTK_QUAD
                                         : 0;
}

class MeshReader {
  public:
    explicit MeshReader(const CgnsZone& at) : at_(at) {}

    core::Result<vtkSmartPointer<vtkDataSet>> read() {
        int grids = 0;
        if (cg_ngrids(at_.file, at_.base, at_.zone, &grids) != CG_OK)
            return cgns_damage(at_.name);
        if (grids > 1)
            return core::fail(Error::Code::Unsupported,
                              at_.name + " has " + std::to_string(grids) +
                                  " meshes for one zone: it moves",
                              "only meshes that do not move can be read");
        return at_.structured ? read_structured() : read_unstructured();
    }

  private:
    std::array<cgsize_t, 3> nodes_along() const {
        return {at_.size[0], at_.size[1], at_.dimension == 3 ? at_.size[2] : 1};
    }

    core::Result<vtkSmartPointer<vtkPoints>> read_points() {
        const auto along = nodes_along();
        const auto count = at_.structured ? along[0] * along[1] * along[2] : at_.size[0];
        auto points = vtkSmartPointer<vtkPoints>::New();
        points->SetDataTypeToDouble();
        points->SetNumberOfPoints(count);
        points->GetData()->Fill(0.0);
        std::vector<double> axis(static_cast<std::size_t>(count));
        for (int c = 0; c < at_.space; ++c) {
            const std::string coordinate = std::string("Coordinate") + "XYZ"[c];
            if (cg_coord_read(at_.file, at_.base, at_.zone, coordinate.c_str(),
                              CGNS_ENUMV(RealDouble), cgns_first.data(), at_.size.data(),
                              axis.data()) != CG_OK)
                return cgns_damage(at_.name);
            for (cgsize_t i = 0; i < count; ++i)
                points->GetData()->SetComponent(i, c, axis[static_cast<std::size_t>(i)]);
        }
        return points;
    }

    core::Result<vtkSmartPointer<vtkDataSet>> read_structured() {
        return read_points().map([&](const auto& points) {
            auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
            const auto along = nodes_along();
            grid->SetDimensions(static_cast<int>(along[0]), static_cast<int>(along[1]),
                                static_cast<int>(along[2]));
            grid->SetPoints(points);
            return vtkSmartPointer<vtkDataSet>(grid);
        });
    }

    core::Result<vtkSmartPointer<vtkDataSet>> read_unstructured() {
        const auto points = read_points();
        if (!points)
            return tl::unexpected(points.error());
        auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
        grid->SetPoints(*points);
        grid->AllocateEstimate(at_.size[1], 8);
        int sections = 0;
        if (cg_nsections(at_.file, at_.base, at_.zone, &sections) != CG_OK)
            return cgns_damage(at_.name);
        std::map<cgsize_t, int> by_number;
        for (int section = 1; section <= sections; ++section) {
            CgnsName name{};
            CGNS_ENUMT(ElementType_t) type{};
            std::array<cgsize_t, 2> range{};
            int boundary = 0;
            int parents = 0;
            if (cg_section_read(at_.file, at_.base, at_.zone, section, name.data(), &type,
                                &range[0], &range[1], &boundary, &parents) != CG_OK)
                return cgns_damage(at_.name);
            by_number[range[0]] = section;
        }
        for (const auto& [first, section] : by_number)
            if (auto added = add_section(section, *grid); !added)
                return tl::unexpected(added.error());
        if (grid->GetNumberOfCells() != at_.size[1])
            return core::fail(Error::Code::Corrupt,
                              at_.name + " says that a zone has " + std::to_string(at_.size[1]) +
                                  " cells, and has " + std::to_string(grid->GetNumberOfCells()));
        return vtkSmartPointer<vtkDataSet>(grid);
    }

    core::Result<void> add_section(int section, vtkUnstructuredGrid& grid) {
        CgnsName name{};
        CGNS_ENUMT(ElementType_t) type{};
        std::array<cgsize_t, 2> range{};
        int boundary = 0;
        int parents = 0;
        cgsize_t numbers = 0;
        if (cg_section_read(at_.file, at_.base, at_.zone, section, name.data(), &type, &range[0],
                            &range[1], &boundary, &parents) != CG_OK ||
            cg_ElementDataSize(at_.file, at_.base, at_.zone, section, &numbers) != CG_OK)
            return cgns_damage(at_.name);
        const bool mixed = type == CGNS_ENUMV(MIXED);
        if (!mixed && !has_dimension(type, at_.dimension))
            return {};
        const auto count = range[1] - range[0] + 1;
        std::vector<cgsize_t> nodes(static_cast<std::size_t>(numbers));
        std::vector<cgsize_t> offsets(static_cast<std::size_t>(mixed ? count + 1 : 0));
        const int read =
            mixed ? cg_poly_elements_read(at_.file, at_.base, at_.zone, section, nodes.data(),
                                          offsets.data(), nullptr)
                  : cg_elements_read(at_.file, at_.base, at_.zone, section, nodes.data(), nullptr);
        if (read != CG_OK)
            return cgns_damage(at_.name);
        std::size_t next = 0;
        for (cgsize_t i = 0; i < count; ++i) {
            if (mixed && next < nodes.size())
                type = static_cast<CGNS_ENUMT(ElementType_t)>(nodes[next++]);
            if (auto added = add_cell(type, nodes, next, grid); !added)
                return added;
        }
        return {};
    }

    // Reads the cell's nodes from `next` on.
    core::Result<void> add_cell(CGNS_ENUMT(ElementType_t) type,
                                const std::vector<cgsize_t>& nodes,
                                std::size_t& next,
                                vtkUnstructuredGrid& grid) {
        int count = 0;
        if (type < CGNS_ENUMV(NODE) || type >= NofValidElementTypes ||
            cg_npe(type, &count) != CG_OK || count <= 0 ||
            nodes.size() - next < static_cast<std::size_t>(count))
            return core::fail(Error::Code::Corrupt,
                              at_.name +
                                  " is damaged: it has elements of no type, or without nodes");
        std::array<vtkIdType, 8> ids{};
        const bool wanted = has_dimension(type, at_.dimension);
        const int cell = wanted ? vtk_cell_of(type) : 0;
        if (wanted && cell == 0)
            return core::fail(Error::Code::Unsupported,
                              at_.name + " has curved cells (" + cg_ElementTypeName(type) + ")",
                              "write cells with straight edges");
        for (std::size_t i = 0; cell != 0 && i < static_cast<std::size_t>(count); ++i) {
            ids.at(i) = nodes[next + i] - 1;
            if (ids.at(i) < 0 || ids.at(i) >= at_.size[0])
                return core::fail(Error::Code::Corrupt,
                                  at_.name + " is damaged: a cell has nodes that are not there");
        }
        if (cell != 0)
            grid.InsertNextCell(cell, count, ids.data());
        next += static_cast<std::size_t>(count);
        return {};
    }

    const CgnsZone& at_;
};

// Returns cells in the order of their numbers, without the elements of boundaries. Error: Corrupt,
// Unsupported (curved cells, polyhedra, a mesh that moves).
core::Result<vtkSmartPointer<vtkDataSet>> read_cgns_mesh(const CgnsZone& zone) {
    return MeshReader(zone).read();
}

// Reads values of a zone of a CGNS file, at nodes and in cells, with the CGNS library.

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
    // Returns the names of the solutions that count at this time-step.
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
        const auto* const last =
            at_.size.data() + (in_cells ? at_.structured ? at_.dimension : 1 : 0);
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

// Names fields as vtkCGNSReader does: VelocityX, Y and Z are Velocity. @param step  its index among the times
// of the file; empty if it has none. @param data  as read_cgns_mesh returned it. Error: Corrupt.
core::Result<void> add_cgns_solutions(const CgnsZone& zone,
                                      std::optional<std::size_t> step,
                                      const WantedArrays& wanted,
                                      vtkDataSet& data) {
    return SolutionReader(zone, step, wanted).add_all(data);
}

} // namespace

core::Result<std::vector<Leaf>> read_cgns_zones(const ListedFile& file,
                                                int dimension,
                                                std::optional<std::size_t> step,
                                                const WantedArrays& wanted) {
    const CgnsFile opened(file.path);
    int bases = 0;
    if (!opened.sound() || cg_nbases(opened.id(), &bases) != CG_OK)
        return cgns_damage(file.name);
    std::vector<Leaf> out;
    for (int base = 1; base <= bases; ++base) {
        CgnsName base_name{};
        int cells = 0;
        int space = 0;
        int zones = 0;
        if (cg_base_read(opened.id(), base, base_name.data(), &cells, &space) != CG_OK ||
            cg_nzones(opened.id(), base, &zones) != CG_OK)
            return cgns_damage(file.name);
        for (int zone = 1; cells == dimension && zone <= zones; ++zone) {
            CgnsZone at{file.name, opened.id(), base, zone, cells, std::min(space, 3)};
            CgnsName name{};
            CGNS_ENUMT(ZoneType_t) type{};
            if (cg_zone_read(at.file, base, zone, name.data(), at.size.data()) != CG_OK ||
                cg_zone_type(at.file, base, zone, &type) != CG_OK)
                return cgns_damage(file.name);
            at.structured = type == CGNS_ENUMV(Structured);
            auto mesh = read_cgns_mesh(at);
            if (!mesh)
                return tl::unexpected(mesh.error());
            if (auto added = add_cgns_solutions(at, step, wanted, **mesh); !added)
                return tl::unexpected(added.error());
            out.push_back({{base_name.data(), name.data()}, std::move(*mesh)});
        }
    }
    return out;
}

} // namespace wakesurf::importer
