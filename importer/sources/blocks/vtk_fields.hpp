// The common code of readers of all formats: the pieces of what VTK read, the fields they carry, and the
// selection of those.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <vtkDataArraySelection.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace wakesurf::importer {

/// Holds one data set of a composite one.
struct Leaf {
    /// The names of the blocks from the root down to this one, "" for a block without a name.
    std::vector<std::string> path;
    vtkSmartPointer<vtkDataSet> data;

    const std::string& name() const; ///< Returns the last name of `path`, or "".
};

/// Returns the data sets with at least one cell in `data`, in VTK's order; a data set itself is one leaf
/// without a path.
std::vector<Leaf> leaves_of(vtkDataObject* data);

/// Adds the fields of `data` to `fields`: point data, then cell data, with their finite ranges (of the
/// magnitude for several components). If a field is there (same name, source and components), its range is
/// widened instead, so that blocks add up. Ghost marks, ids that VTK adds, and arrays without a name or of
/// text are no fields.
void add_fields(vtkDataSet& data, std::vector<core::FieldInfo>& fields);

struct WantedArrays {
    bool all = false;
    std::vector<core::FieldInfo> fields;
};

/// Enables the wanted arrays of what a reader offers as `source` (point or cell data), and ghost marks;
/// disables all others.
void select_arrays(vtkDataArraySelection& offered,
                   core::FieldInfo::Source source,
                   const WantedArrays& wanted);

/// Checks that `data` has all `fields`. Error: NotFound naming `file` and the first missing field; Corrupt if
/// it has another number of components, or of values than there are points or cells.
core::Result<void> require_fields(vtkDataSet& data,
                                  const std::vector<core::FieldInfo>& fields,
                                  const std::string& file);

/// Removes all arrays but `fields` and ghost marks: readers also return arrays that were not selected.
void keep_only(vtkDataSet& data, const std::vector<core::FieldInfo>& fields);

} // namespace wakesurf::importer
