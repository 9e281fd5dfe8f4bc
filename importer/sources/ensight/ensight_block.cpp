#include "importer/sources/ensight/ensight_block.hpp"

#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>

#include <array>

namespace wakesurf::importer {

using core::Error;

namespace {

vtkSmartPointer<vtkFloatArray> array_of(const std::vector<float>& values) {
    auto out = vtkSmartPointer<vtkFloatArray>::New();
    out->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), out->GetPointer(0));
    return out;
}

core::Result<vtkSmartPointer<vtkDataSet>>
curvilinear(EnsightStream& in, const int* nodes, std::size_t total) {
    auto values = vtkSmartPointer<vtkFloatArray>::New();
    values->SetNumberOfComponents(3);
    for (int axis = 0; axis < 3; ++axis) {
        const auto along = in.numbers(total);
        if (!along)
            return tl::unexpected(along.error());
        values->SetNumberOfTuples(static_cast<vtkIdType>(total));
        for (std::size_t i = 0; i < total; ++i)
            values->SetTypedComponent(static_cast<vtkIdType>(i), axis, (*along)[i]);
    }
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(values);
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(nodes);
    grid->SetPoints(points);
    return vtkSmartPointer<vtkDataSet>(grid);
}

core::Result<vtkSmartPointer<vtkDataSet>> rectilinear(EnsightStream& in, const int* nodes) {
    std::array<vtkSmartPointer<vtkFloatArray>, 3> axes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto along = in.numbers(static_cast<std::size_t>(nodes[axis]));
        if (!along)
            return tl::unexpected(along.error());
        axes[axis] = array_of(*along);
    }
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    grid->SetDimensions(nodes);
    grid->SetXCoordinates(axes[0]);
    grid->SetYCoordinates(axes[1]);
    grid->SetZCoordinates(axes[2]);
    return vtkSmartPointer<vtkDataSet>(grid);
}

core::Result<vtkSmartPointer<vtkDataSet>> uniform(EnsightStream& in, const int* nodes) {
    const auto origin = in.numbers(3);
    const auto spacing = origin ? in.numbers(3) : origin;
    if (!spacing)
        return tl::unexpected(spacing.error());
    auto grid = vtkSmartPointer<vtkImageData>::New();
    grid->SetDimensions(nodes);
    grid->SetOrigin((*origin)[0], (*origin)[1], (*origin)[2]);
    grid->SetSpacing((*spacing)[0], (*spacing)[1], (*spacing)[2]);
    return vtkSmartPointer<vtkDataSet>(grid);
}

} // namespace

core::Result<vtkSmartPointer<vtkDataSet>> read_ensight_block(EnsightStream& in,
                                                             const std::string& shape) {
    const auto says = [&](const char* word) { return shape.find(word) != std::string::npos; };
    if (says("range") || says("ghost"))
        return core::fail(Error::Code::Unsupported,
                          "a part is a '" + shape + "', which cannot be read",
                          "write whole blocks without ghost cells");
    const auto nodes = in.integers(3);
    if (!nodes)
        return tl::unexpected(nodes.error());
    constexpr std::size_t most = std::size_t{1} << 40;
    std::size_t total = 1;
    for (const auto along : *nodes) {
        if (along < 1 || static_cast<std::size_t>(along) > most / total)
            return in.damaged("a block has " + std::to_string(along) + " nodes along one side");
        total *= static_cast<std::size_t>(along);
    }
    auto grid = says("uniform")       ? uniform(in, nodes->data())
                : says("rectilinear") ? rectilinear(in, nodes->data())
                                      : curvilinear(in, nodes->data(), total);
    if (!grid || !says("iblanked"))
        return grid;
    const auto marks = in.integers(total);
    if (!marks)
        return tl::unexpected(marks.error());
    auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(static_cast<vtkIdType>(total));
    for (std::size_t i = 0; i < total; ++i)
        ghosts->SetValue(static_cast<vtkIdType>(i),
                         (*marks)[i] == 0 ? vtkDataSetAttributes::HIDDENPOINT : 0);
    (*grid)->GetPointData()->AddArray(ghosts);
    return grid;
}

} // namespace wakesurf::importer
