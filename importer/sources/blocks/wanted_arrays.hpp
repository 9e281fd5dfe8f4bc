// Which arrays of a file are to be read.
#pragma once

#include "importer/sources/blocks/vtk_fields.hpp"

namespace wakesurf::importer {

struct WantedArrays {
    bool all = false;
    std::vector<core::FieldInfo> fields;
};

/// Enables the wanted arrays of what a reader offers as `source`, disables all others.
inline void select_arrays(vtkDataArraySelection& offered,
                          core::FieldInfo::Source source,
                          const WantedArrays& wanted) {
    if (wanted.all)
        offered.EnableAllArrays();
    else
        enable_only(offered, source, wanted.fields);
}

} // namespace wakesurf::importer
