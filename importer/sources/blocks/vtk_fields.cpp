#include "importer/sources/blocks/vtk_fields.hpp"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkInformation.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

constexpr std::array<FieldInfo::Source, 2> sources{FieldInfo::Source::Point,
                                                   FieldInfo::Source::Cell};

vtkDataSetAttributes& attributes_of(vtkDataSet& data, FieldInfo::Source source) {
    if (source == FieldInfo::Source::Point)
        return *data.GetPointData();
    return *data.GetCellData();
}

bool is_ghost_mark(std::string_view name) {
    return name == vtkDataSetAttributes::GhostArrayName();
}

void collect(vtkDataObject* data, std::vector<std::string> path, std::vector<Leaf>& out) {
    if (auto* set = vtkDataSet::SafeDownCast(data)) {
        if (set->GetNumberOfCells() > 0)
            out.push_back({std::move(path), set});
        return;
    }
    auto* tree = vtkDataObjectTree::SafeDownCast(data);
    if (tree == nullptr)
        return;
    const auto children = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    children->VisitOnlyLeavesOff();
    children->TraverseSubTreeOff();
    children->SkipEmptyNodesOn();
    for (children->InitTraversal(); !children->IsDoneWithTraversal(); children->GoToNextItem()) {
        const char* name = nullptr;
        if (children->HasCurrentMetaData() != 0)
            name = children->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME());
        auto below = path;
        below.emplace_back(name == nullptr ? "" : name);
        collect(children->GetCurrentDataObject(), std::move(below), out);
    }
}

void add(FieldInfo field, std::vector<FieldInfo>& fields) {
    const auto known = std::find_if(fields.begin(), fields.end(), [&](const FieldInfo& other) {
        return other.name == field.name && other.source == field.source &&
               other.components == field.components;
    });
    if (known == fields.end())
        fields.push_back(std::move(field));
    else
        known->range = {std::min(known->range[0], field.range[0]),
                        std::max(known->range[1], field.range[1])};
}

} // namespace

const std::string& Leaf::name() const {
    static const std::string none;
    return path.empty() ? none : path.back();
}

std::vector<Leaf> leaves_of(vtkDataObject* data) {
    std::vector<Leaf> out;
    collect(data, {}, out);
    return out;
}

void add_fields(vtkDataSet& data, std::vector<FieldInfo>& fields) {
    for (const auto source : sources) {
        vtkDataSetAttributes& attributes = attributes_of(data, source);
        for (int i = 0; i < attributes.GetNumberOfArrays(); ++i) {
            vtkDataArray* array = attributes.GetArray(i);
            if (array == nullptr || array->GetName() == nullptr ||
                is_ghost_mark(array->GetName()) || array == attributes.GetGlobalIds() ||
                array == attributes.GetPedigreeIds())
                continue;
            FieldInfo field{array->GetName(), array->GetNumberOfComponents(), source, {}, {}};
            double range[2] = {0.0, 0.0};
            array->GetFiniteRange(range, field.components == 1 ? 0 : -1);
            if (range[0] <= range[1])
                field.range = {range[0], range[1]};
            add(std::move(field), fields);
        }
    }
}

void select_arrays(vtkDataArraySelection& offered,
                   FieldInfo::Source source,
                   const WantedArrays& wanted) {
    if (wanted.all) {
        offered.EnableAllArrays();
        return;
    }
    offered.DisableAllArrays();
    const char* ghosts = vtkDataSetAttributes::GhostArrayName(); // blanked whatever is asked for
    if (offered.ArrayExists(ghosts) != 0)
        offered.EnableArray(ghosts);
    for (const auto& field : wanted.fields)
        if (field.source == source)
            offered.EnableArray(field.name.c_str());
}

core::Result<void>
require_fields(vtkDataSet& data, const std::vector<FieldInfo>& fields, const std::string& file) {
    for (const auto& field : fields) {
        vtkDataArray* array = attributes_of(data, field.source).GetArray(field.name.c_str());
        if (array == nullptr)
            return core::fail(Error::Code::NotFound, file + " has no field " + field.name);
        if (array->GetNumberOfComponents() != field.components)
            return core::fail(Error::Code::Corrupt,
                              field.name + " of " + file + " has " +
                                  std::to_string(array->GetNumberOfComponents()) +
                                  " components, the first time-step's has " +
                                  std::to_string(field.components));
        const bool at_points = field.source == FieldInfo::Source::Point;
        const vtkIdType wanted = at_points ? data.GetNumberOfPoints() : data.GetNumberOfCells();
        if (array->GetNumberOfTuples() != wanted)
            return core::fail(Error::Code::Corrupt, field.name + " of " + file + " has " +
                                                        std::to_string(array->GetNumberOfTuples()) +
                                                        " values, but there are " +
                                                        std::to_string(wanted) +
                                                        (at_points ? " points" : " cells"));
    }
    return {};
}

void keep_only(vtkDataSet& data, const std::vector<FieldInfo>& fields) {
    for (const auto source : sources) {
        vtkDataSetAttributes& attributes = attributes_of(data, source);
        for (int i = attributes.GetNumberOfArrays() - 1; i >= 0; --i) {
            const char* name = attributes.GetAbstractArray(i)->GetName();
            const bool kept =
                name != nullptr &&
                (is_ghost_mark(name) ||
                 std::any_of(fields.begin(), fields.end(), [&](const FieldInfo& field) {
                     return field.source == source && field.name == name;
                 }));
            if (!kept)
                attributes.RemoveArray(i);
        }
    }
}

} // namespace wakesurf::importer
