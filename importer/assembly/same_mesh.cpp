#include "importer/assembly/same_mesh.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstring>

namespace wakesurf::importer {

namespace {

bool equal(vtkDataArray* a, vtkDataArray* b) {
    if (a == b)
        return true;
    if (a == nullptr || b == nullptr || a->GetNumberOfTuples() != b->GetNumberOfTuples() ||
        a->GetNumberOfComponents() != b->GetNumberOfComponents())
        return false;
    const vtkIdType count = a->GetNumberOfValues();
    if (a->GetDataType() == b->GetDataType() && a->HasStandardMemoryLayout() &&
        b->HasStandardMemoryLayout() && count > 0 &&
        std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                    static_cast<std::size_t>(count * a->GetDataTypeSize())) == 0)
        return true;
    for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
        for (int c = 0; c < a->GetNumberOfComponents(); ++c)
            if (a->GetComponent(i, c) != b->GetComponent(i, c))
                return false;
    return true;
}

vtkDataArray* marks(vtkDataSetAttributes& attributes) {
    return attributes.GetArray(vtkDataSetAttributes::GhostArrayName());
}

bool equal(vtkPoints* a, vtkPoints* b) {
    return a == b || (a != nullptr && b != nullptr && equal(a->GetData(), b->GetData()));
}

bool equal(vtkCellArray* a, vtkCellArray* b) {
    return a == b || (a != nullptr && b != nullptr &&
                      equal(a->GetConnectivityArray(), b->GetConnectivityArray()) &&
                      equal(a->GetOffsetsArray(), b->GetOffsetsArray()));
}

bool equal(vtkImageData& a, vtkImageData& b) {
    return std::equal(a.GetExtent(), a.GetExtent() + 6, b.GetExtent()) &&
           std::equal(a.GetOrigin(), a.GetOrigin() + 3, b.GetOrigin()) &&
           std::equal(a.GetSpacing(), a.GetSpacing() + 3, b.GetSpacing()) &&
           std::equal(a.GetDirectionMatrix()->GetData(), a.GetDirectionMatrix()->GetData() + 9,
                      b.GetDirectionMatrix()->GetData());
}

bool equal(vtkRectilinearGrid& a, vtkRectilinearGrid& b) {
    return equal(a.GetXCoordinates(), b.GetXCoordinates()) &&
           equal(a.GetYCoordinates(), b.GetYCoordinates()) &&
           equal(a.GetZCoordinates(), b.GetZCoordinates());
}

bool equal(vtkStructuredGrid& a, vtkStructuredGrid& b) {
    int along_a[3];
    int along_b[3];
    a.GetDimensions(along_a);
    b.GetDimensions(along_b);
    return std::equal(along_a, along_a + 3, along_b) && equal(a.GetPoints(), b.GetPoints());
}

bool equal(vtkUnstructuredGrid& a, vtkUnstructuredGrid& b) {
    return equal(a.GetPoints(), b.GetPoints()) && equal(a.GetCells(), b.GetCells()) &&
           equal(a.GetCellTypesArray(), b.GetCellTypesArray()) &&
           equal(a.GetFaces(), b.GetFaces()) && equal(a.GetFaceLocations(), b.GetFaceLocations());
}

template <class Kind>
bool both(vtkDataSet& a, vtkDataSet& b) {
    auto* first = Kind::SafeDownCast(&a);
    auto* second = Kind::SafeDownCast(&b);
    return first != nullptr && second != nullptr && equal(*first, *second);
}

} // namespace

bool same_block(vtkDataSet& a, vtkDataSet& b) {
    return a.GetNumberOfPoints() == b.GetNumberOfPoints() &&
           a.GetNumberOfCells() == b.GetNumberOfCells() &&
           equal(marks(*a.GetPointData()), marks(*b.GetPointData())) &&
           equal(marks(*a.GetCellData()), marks(*b.GetCellData())) &&
           (both<vtkImageData>(a, b) || both<vtkRectilinearGrid>(a, b) ||
            both<vtkStructuredGrid>(a, b) || both<vtkUnstructuredGrid>(a, b));
}

void share_mesh(vtkDataSet& from, vtkDataSet& to) {
    if (auto* source = vtkPointSet::SafeDownCast(&from), *target = vtkPointSet::SafeDownCast(&to);
        source != nullptr && target != nullptr)
        target->SetPoints(source->GetPoints());
    if (auto* source = vtkUnstructuredGrid::SafeDownCast(&from),
        *target = vtkUnstructuredGrid::SafeDownCast(&to);
        source != nullptr && target != nullptr)
        target->SetCells(source->GetCellTypesArray(), source->GetCells(),
                         source->GetFaceLocations(), source->GetFaces());
}

std::vector<vtkSmartPointer<vtkDataSet>> without_values(BlockList blocks) {
    std::vector<vtkSmartPointer<vtkDataSet>> out;
    for (const auto& block : blocks) {
        auto copy = vtkSmartPointer<vtkDataSet>::Take(block->NewInstance());
        copy->CopyStructure(block);
        if (auto* hidden = marks(*block->GetPointData()))
            copy->GetPointData()->AddArray(hidden);
        if (auto* hidden = marks(*block->GetCellData()))
            copy->GetCellData()->AddArray(hidden);
        out.push_back(std::move(copy));
    }
    return out;
}

bool same_mesh(BlockList a, BlockList b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return same_block(*x, *y); });
}

} // namespace wakesurf::importer
