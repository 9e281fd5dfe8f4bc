// A flow that is known everywhere and differs between time-steps, written into grids and compared with a
// reader's output; and refusals.
#pragma once

#include "importer/base/source.hpp"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

namespace wakesurf::tests {

inline std::array<double, 3> known_velocity(const double* p, int step) {
    return {1.0 + p[0] + 10.0 * step, 2.0 * p[1] - step, p[2] + p[0] * step};
}

inline double known_pressure(const double* p, int step) {
    return 3.0 + p[0] - p[1] + 7.0 * step;
}

inline std::array<double, 3> cell_centre(vtkDataSet& data, vtkIdType cell) {
    std::array<double, 3> out{};
    auto* nodes = data.GetCell(cell)->GetPoints();
    for (vtkIdType i = 0; i < nodes->GetNumberOfPoints(); ++i)
        for (int c = 0; c < 3; ++c)
            out[static_cast<std::size_t>(c)] +=
                nodes->GetPoint(i)[c] / static_cast<double>(nodes->GetNumberOfPoints());
    return out;
}

/// Adds point arrays U and p, cell array T (the pressure at the mean of a cell's nodes).
inline void put_known_flow(vtkDataSet& data, int step) {
    const auto array = [](const char* name, int components) {
        auto out = vtkSmartPointer<vtkDoubleArray>::New();
        out->SetName(name);
        out->SetNumberOfComponents(components);
        return out;
    };
    auto u = array("U", 3);
    auto p = array("p", 1);
    auto t = array("T", 1);
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
        u->InsertNextTuple(known_velocity(data.GetPoint(i), step).data());
        p->InsertNextValue(known_pressure(data.GetPoint(i), step));
    }
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i)
        t->InsertNextValue(known_pressure(cell_centre(data, i).data(), step));
    data.GetPointData()->AddArray(u);
    data.GetPointData()->AddArray(p);
    data.GetCellData()->AddArray(t);
}

constexpr double known_tolerance = 1e-6; // the precision of float32 files for values up to 10

inline void expect_vector(vtkDataSet& data, const char* name, int step) {
    vtkDataArray* found = data.GetPointData()->GetArray(name);
    ASSERT_NE(found, nullptr) << name;
    ASSERT_EQ(found->GetNumberOfTuples(), data.GetNumberOfPoints());
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
        const auto wanted = known_velocity(data.GetPoint(i), step);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(found->GetComponent(i, c), wanted[static_cast<std::size_t>(c)],
                        known_tolerance * (1.0 + std::abs(wanted[static_cast<std::size_t>(c)])))
                << name << " at node " << i << " of step " << step;
    }
}

inline void expect_known_flow(vtkDataSet& data, int step) {
    expect_vector(data, "U", step);
    vtkDataArray* t = data.GetCellData()->GetArray("T");
    ASSERT_NE(t, nullptr);
    ASSERT_EQ(t->GetNumberOfTuples(), data.GetNumberOfCells());
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i)
        ASSERT_NEAR(t->GetTuple1(i), known_pressure(cell_centre(data, i).data(), step),
                    known_tolerance * 100)
            << "cell " << i << " of step " << step;
}

inline const std::vector<core::FieldInfo>& known_fields() {
    using Source = core::FieldInfo::Source;
    static const std::vector<core::FieldInfo> fields{{"U", 3, Source::Point, {0, 0}, {}},
                                                     {"T", 1, Source::Cell, {0, 0}, {}}};
    return fields;
}

inline const core::FieldInfo* field_named(const importer::Source& source, const std::string& name) {
    for (const auto& field : source.description().fields)
        if (field.name == name)
            return &field;
    return nullptr;
}

/// Reads all time-steps, forwards and then backwards: a reader must not return the time-step it read before.
inline void expect_known_series(importer::Source& source, const std::vector<double>& times) {
    ASSERT_EQ(source.description().times, times);
    for (int pass = 0; pass < 2; ++pass)
        for (std::size_t i = 0; i < times.size(); ++i) {
            const std::size_t step = pass == 0 ? i : times.size() - 1 - i;
            const auto read = source.read(step, known_fields());
            ASSERT_TRUE(read.has_value()) << read.error().message;
            for (const auto& block : read->blocks)
                expect_known_flow(*block, static_cast<int>(step));
        }
}

template <class T>
void expect_failure(const core::Result<T>& result,
                    core::Error::Code code,
                    const std::string& words) {
    ASSERT_FALSE(result.has_value()) << words;
    EXPECT_EQ(static_cast<int>(result.error().code), static_cast<int>(code))
        << result.error().message;
    EXPECT_NE(result.error().message.find(words), std::string::npos) << result.error().message;
    EXPECT_EQ(result.error().message.find("/tmp/"), std::string::npos) << result.error().message;
}

inline vtkSmartPointer<vtkImageData> sample_image(int nx = 4, int ny = 5, int nz = 6) {
    auto out = vtkSmartPointer<vtkImageData>::New();
    out->SetDimensions(nx, ny, nz);
    out->SetOrigin(-1.0, 0.5, 2.0);
    out->SetSpacing(0.5, 0.25, 1.0);
    return out;
}

/// States a time in the file only where one is given.
inline void write_timed_image(vtkImageData& image,
                              const std::filesystem::path& file,
                              std::optional<double> time) {
    auto stated = vtkSmartPointer<vtkDoubleArray>::New();
    stated->SetName("TimeValue");
    stated->InsertNextValue(time.value_or(0.0));
    if (time)
        image.GetFieldData()->AddArray(stated);
    auto writer = vtkSmartPointer<vtkXMLImageDataWriter>::New();
    writer->SetFileName(file.c_str());
    writer->SetInputData(&image);
    ASSERT_EQ(writer->Write(), 1);
}

inline vtkSmartPointer<vtkRectilinearGrid> sample_rectilinear() {
    auto out = vtkSmartPointer<vtkRectilinearGrid>::New();
    out->SetDimensions(4, 5, 6);
    const auto axis = [](int n, double power) {
        auto values = vtkSmartPointer<vtkDoubleArray>::New();
        for (int i = 0; i < n; ++i)
            values->InsertNextValue(std::pow(i, power));
        return values;
    };
    out->SetXCoordinates(axis(4, 1.5));
    out->SetYCoordinates(axis(5, 2.0));
    out->SetZCoordinates(axis(6, 0.5));
    return out;
}

/// Returns a sheared and stretched grid, from `x0` on.
inline vtkSmartPointer<vtkStructuredGrid> sample_structured(double x0 = 0.0) {
    auto out = vtkSmartPointer<vtkStructuredGrid>::New();
    out->SetDimensions(4, 5, 6);
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    for (int k = 0; k < 6; ++k)
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 4; ++i)
                points->InsertNextPoint(x0 + i + 0.1 * j, j + 0.05 * k * k, k + 0.1 * i);
    out->SetPoints(points);
    return out;
}

/// Returns two hexahedra, a wedge, a pyramid and a tetrahedron.
inline vtkSmartPointer<vtkUnstructuredGrid> sample_mesh(double x0 = 0.0) {
    auto out = vtkSmartPointer<vtkUnstructuredGrid>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 4; ++i)
                points->InsertNextPoint(x0 + i, j, k); // 4 along x, 2 along y and z
    points->InsertNextPoint(x0 - 1.0, 0.5, 0.5);       // 16
    points->InsertNextPoint(x0 - 1.0, 2.0, 0.5);       // 17
    out->SetPoints(points);
    const auto add = [&](int type, std::vector<vtkIdType> nodes) {
        out->InsertNextCell(type, static_cast<vtkIdType>(nodes.size()), nodes.data());
    };
    add(VTK_HEXAHEDRON, {0, 1, 5, 4, 8, 9, 13, 12});
    add(VTK_HEXAHEDRON, {1, 2, 6, 5, 9, 10, 14, 13});
    add(VTK_WEDGE, {2, 3, 6, 10, 11, 14});
    add(VTK_PYRAMID, {0, 4, 12, 8, 16});
    add(VTK_TETRA, {4, 12, 16, 17});
    return out;
}

} // namespace wakesurf::tests
