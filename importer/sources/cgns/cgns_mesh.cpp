#include "importer/sources/cgns/cgns_mesh.hpp"

#include <vtkDataArray.h>
#include <vtkPoints.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <map>

namespace wakesurf::importer {

using core::Error;

namespace {

// Of cells with straight edges; 0 for all others.
int vtk_cell_of(CGNS_ENUMT(ElementType_t) type) {
    return type == CGNS_ENUMV(TETRA_4)   ? VTK_TETRA
           : type == CGNS_ENUMV(PYRA_5)  ? VTK_PYRAMID
           : type == CGNS_ENUMV(PENTA_6) ? VTK_WEDGE
           : type == CGNS_ENUMV(HEXA_8)  ? VTK_HEXAHEDRON
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
    core::Result<vtkSmartPointer<vtkPoints>> read_points() {
        const auto count = at_.structured ? at_.size[0] * at_.size[1] * at_.size[2] : at_.size[0];
        auto points = vtkSmartPointer<vtkPoints>::New();
        points->SetDataTypeToDouble();
        points->SetNumberOfPoints(count);
        std::vector<double> axis(static_cast<std::size_t>(count));
        for (int c = 0; c < 3; ++c) {
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
            grid->SetDimensions(static_cast<int>(at_.size[0]), static_cast<int>(at_.size[1]),
                                static_cast<int>(at_.size[2]));
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
        if (!mixed && !is_volume(type))
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

    // Takes its nodes from `next` on.
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
        const int cell = vtk_cell_of(type);
        if (is_volume(type) && cell == 0)
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

} // namespace

core::Result<vtkSmartPointer<vtkDataSet>> read_cgns_mesh(const CgnsZone& zone) {
    return MeshReader(zone).read();
}

} // namespace wakesurf::importer
