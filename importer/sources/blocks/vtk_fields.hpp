// What the readers of all formats share: the pieces of what VTK read, the fields they carry, and which of
// them are asked for.
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

/// One data set of a composite one.
struct Leaf {
    std::vector<std::string>
        path; ///< names of the blocks from the root down to it, "" where a block has none
    vtkSmartPointer<vtkDataSet> data;

    const std::string& name() const; ///< the last of `path`, or ""
};

/// Returns the data sets with at least one cell in `data`, in VTK's order; a data set itself is one leaf
/// without a path.
std::vector<Leaf> leaves_of(vtkDataObject* data);

/// Adds the fields of `data` to `fields`: point data, then cell data, with their finite ranges (of the
/// magnitude for several components). A field that is there (same name, source and components) has its range
/// widened instead, so that blocks add up. Ghost marks, ids VTK adds and arrays without a name or of text are
/// no fields.
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

/// Checks that they are there. Error: NotFound naming `file` and the first of `fields` that `data` does not
/// have; Corrupt where it has another number of components, or of values than there are points or cells.
core::Result<void> require_fields(vtkDataSet& data,
                                  const std::vector<core::FieldInfo>& fields,
                                  const std::string& file);

/// Removes all arrays but `fields` and ghost marks: what a reader returns unasked.
void keep_only(vtkDataSet& data, const std::vector<core::FieldInfo>& fields);

} // namespace wakesurf::importer
