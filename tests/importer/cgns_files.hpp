// CGNS files for tests, written with the CGNS library.
#pragma once

#include "tests/importer/known_flow.hpp"
#include "tests/support/temporary_folder.hpp"

#include <vtk_cgns.h>
// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::tests {

enum class Pointers { Written, Missing };

/// The numbers of boundary elements, and their count.
struct Boundary {
    bool last = true;
    bool between = false; ///< others are between the cells
    bool mixed = false;   ///< a section of elements of several types
    cgsize_t count = 1;
};

struct Contents {
    std::vector<double> times{0.25, 0.5, 2};
    std::string vector = "Velocity"; ///< its components get X, Y and Z
    bool structured = true;
    bool adf = false;
    Pointers pointers = Pointers::Written;
    bool at_cells = false;
    int first_step = 0; ///< which known flow the first time-step is
    CGNS_ENUMT(LengthUnits_t) length = CGNS_ENUMV(LengthUnitsNull);         ///< of the base
    CGNS_ENUMT(LengthUnits_t) of_coordinates = CGNS_ENUMV(LengthUnitsNull); ///< of their node
    bool solid = false;  ///< the second zone has a temperature only, and the first a pressure
    Boundary boundary{}; ///< elements of an unstructured zone that are no cells
    std::optional<float> version{}; ///< of the CGNS library that wrote it, by its own word
};

inline void ok(int status) {
    ASSERT_EQ(status, CG_OK) << cg_get_error();
}

// Writes the solution of one zone at one step: the vector at the vertices, T in the cells.
inline void
write_solution(int file, int zone, vtkDataSet& data, const Contents& contents, int step) {
    const std::string n = std::to_string(step);
    int solution = 0;
    int field = 0;
    ok(cg_sol_write(file, 1, zone, ("Flow" + n).c_str(),
                    contents.at_cells ? CGNS_ENUMV(CellCenter) : CGNS_ENUMV(Vertex), &solution));
    const vtkIdType count = contents.at_cells ? data.GetNumberOfCells() : data.GetNumberOfPoints();
    const std::vector<double> level(static_cast<std::size_t>(count), 300.0);
    if (contents.solid)
        ok(cg_field_write(file, 1, zone, solution, CGNS_ENUMV(RealDouble),
                          zone == 2 ? "Temperature" : "Pressure", level.data(), &field));
    for (std::size_t c = 0; c < 3 && !(contents.solid && zone == 2); ++c) {
        std::vector<double> values;
        for (vtkIdType i = 0; i < count; ++i)
            values.push_back(
                contents.at_cells
                    ? known_velocity(cell_centre(data, i).data(), contents.first_step + step)[c]
                    : known_velocity(data.GetPoint(i), contents.first_step + step)[c]);
        ok(cg_field_write(file, 1, zone, solution, CGNS_ENUMV(RealDouble),
                          (contents.vector + "XYZ"[c]).c_str(), values.data(), &field));
    }
    std::vector<double> density(static_cast<std::size_t>(count), 1.25);
    ok(cg_field_write(file, 1, zone, solution, CGNS_ENUMV(RealDouble), "Density", density.data(),
                      &field));
}

inline int write_zone(int file, const std::string& name, vtkStructuredGrid& grid) {
    std::array<int, 3> n{};
    grid.GetDimensions(n.data());
    const std::array<cgsize_t, 9> size{n[0], n[1], n[2], n[0] - 1, n[1] - 1, n[2] - 1, 0, 0, 0};
    int zone = 0;
    ok(cg_zone_write(file, 1, name.c_str(), size.data(), CGNS_ENUMV(Structured), &zone));
    return zone;
}

inline int
write_zone(int file, const std::string& name, vtkUnstructuredGrid& grid, const Boundary& boundary) {
    const std::array<cgsize_t, 3> size{grid.GetNumberOfPoints(), grid.GetNumberOfCells(), 0};
    int zone = 0;
    ok(cg_zone_write(file, 1, name.c_str(), size.data(), CGNS_ENUMV(Unstructured), &zone));
    const std::array<std::pair<int, CGNS_ENUMT(ElementType_t)>, 4> types{
        {{VTK_HEXAHEDRON, CGNS_ENUMV(HEXA_8)},
         {VTK_WEDGE, CGNS_ENUMV(PENTA_6)},
         {VTK_PYRAMID, CGNS_ENUMV(PYRA_5)},
         {VTK_TETRA, CGNS_ENUMV(TETRA_4)}}};
    cgsize_t next = 1;
    int section = 0;
    int sections = 0;
    const auto write_boundary = [&] {
        const std::string floor = "Floor" + std::to_string(sections++);
        std::vector<cgsize_t> nodes;
        std::vector<cgsize_t> offsets{0};
        for (cgsize_t i = 0; i < boundary.count; ++i) {
            if (boundary.mixed)
                nodes.push_back(CGNS_ENUMV(QUAD_4));
            nodes.insert(nodes.end(), {1, 2, 10, 9}); // no cell
            offsets.push_back(static_cast<cgsize_t>(nodes.size()));
        }
        const cgsize_t last = next + boundary.count - 1;
        ok(boundary.mixed
               ? cg_poly_section_write(file, 1, zone, floor.c_str(), CGNS_ENUMV(MIXED), next, last,
                                       0, nodes.data(), offsets.data(), &section)
               : cg_section_write(file, 1, zone, floor.c_str(), CGNS_ENUMV(QUAD_4), next, last, 0,
                                  nodes.data(), &section));
        next = last + 1;
    };
    if (!boundary.last)
        write_boundary();
    for (const auto& [vtk, cgns] : types) {
        std::vector<cgsize_t> nodes;
        const cgsize_t first = next;
        for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i) {
            if (grid.GetCellType(i) != vtk)
                continue;
            ++next;
            for (vtkIdType k = 0; k < grid.GetCell(i)->GetNumberOfPoints(); ++k)
                nodes.push_back(grid.GetCell(i)->GetPointId(static_cast<int>(k)) + 1);
        }
        std::string elements = std::to_string(vtk);
        elements.insert(0, 1, 'E');
        ok(cg_section_write(file, 1, zone, elements.c_str(), cgns, first, next - 1, 0, nodes.data(),
                            &section));
        if (boundary.between)
            write_boundary();
    }
    if (boundary.last)
        write_boundary();
    return zone;
}

inline void write_coordinates(int file, int zone, vtkDataSet& data) {
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<double> values;
        for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
            values.push_back(data.GetPoint(i)[c]);
        int coordinate = 0;
        ok(cg_coord_write(file, 1, zone, CGNS_ENUMV(RealDouble),
                          (std::string("Coordinate") + "XYZ"[c]).c_str(), values.data(),
                          &coordinate));
    }
}

inline void write_pointers(int file, int zone, std::size_t steps) {
    ok(cg_ziter_write(file, 1, zone, "ZoneIterativeData"));
    ok(cg_goto(file, 1, "Zone_t", zone, "ZoneIterativeData_t", 1, "end"));
    std::string names(32 * steps, ' ');
    for (std::size_t i = 0; i < steps; ++i)
        names.replace(32 * i, 5, "Flow" + std::to_string(i));
    const std::array<cgsize_t, 2> size{32, static_cast<cgsize_t>(steps)};
    ok(cg_array_write("FlowSolutionPointers", CGNS_ENUMV(Character), 2, size.data(), names.data()));
}

// The library writes its own version as a number of 32 bits; HDF5 would notice the change by a checksum.
// REQUIRES: adf.
inline void claim_version(const std::filesystem::path& path, float version) {
    float own = 0;
    int file = 0;
    ok(cg_open(path.c_str(), CG_MODE_READ, &file));
    ok(cg_version(file, &own));
    ok(cg_close(file));
    std::string bytes = read_file(path);
    const std::string from(reinterpret_cast<const char*>(&own), sizeof(own));
    const std::string to(reinterpret_cast<const char*>(&version), sizeof(version));
    const auto at = bytes.find(from);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, to.size(), to);
    write_file(path, bytes);
}

inline void write_units(CGNS_ENUMT(LengthUnits_t) length) {
    ok(cg_dataclass_write(CGNS_ENUMV(Dimensional)));
    ok(cg_units_write(CGNS_ENUMV(Kilogram), length, CGNS_ENUMV(Second), CGNS_ENUMV(Kelvin),
                      CGNS_ENUMV(Degree)));
}

inline void write_cgns(const std::filesystem::path& path, const Contents& contents) {
    std::filesystem::remove(path);
    ok(cg_set_file_type(contents.adf ? CG_FILE_ADF : CG_FILE_HDF5));
    int file = 0;
    int base = 0;
    ok(cg_open(path.c_str(), CG_MODE_WRITE, &file));
    ok(cg_base_write(file, "Base", 3, 3, &base));
    if (contents.length != CGNS_ENUMV(LengthUnitsNull)) {
        ok(cg_goto(file, base, "end"));
        write_units(contents.length);
    }
    if (!contents.times.empty()) {
        ok(cg_biter_write(file, base, "TimeIterValues", static_cast<int>(contents.times.size())));
        ok(cg_goto(file, base, "BaseIterativeData_t", 1, "end"));
        const auto steps = static_cast<cgsize_t>(contents.times.size());
        ok(cg_array_write("TimeValues", CGNS_ENUMV(RealDouble), 1, &steps, contents.times.data()));
    }
    for (int block = 0; block < 2; ++block) {
        const std::string name = "Zone" + std::to_string(block);
        vtkSmartPointer<vtkDataSet> data;
        int zone = 0;
        if (contents.structured) {
            auto grid = sample_structured(20.0 * block);
            zone = write_zone(file, name, *grid);
            data = grid;
        } else {
            auto grid = sample_mesh(20.0 * block);
            zone = write_zone(file, name, *grid, contents.boundary);
            data = grid;
        }
        write_coordinates(file, zone, *data);
        if (contents.of_coordinates != CGNS_ENUMV(LengthUnitsNull)) {
            ok(cg_goto(file, base, "Zone_t", zone, "GridCoordinates_t", 1, "end"));
            write_units(contents.of_coordinates);
        }
        const auto steps = std::max<std::size_t>(contents.times.size(), 1);
        for (std::size_t step = 0; step < steps; ++step)
            write_solution(file, zone, *data, contents, static_cast<int>(step));
        if (contents.pointers == Pointers::Written && !contents.times.empty())
            write_pointers(file, zone, steps);
    }
    ok(cg_close(file));
    if (contents.version)
        claim_version(path, *contents.version);
}

} // namespace wakesurf::tests
