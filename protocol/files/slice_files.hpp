// Fields on a plane as files of the command line: .vts for ParaView, and .csv with the columns that Python's Slice.to_csv writes.
#pragma once

#include "core/surface/slice/slice_raster.hpp"

#include <span>
#include <string>

namespace wakesurf::protocol {

struct NamedRaster {
    std::string name; ///< of the field
    core::SliceRaster raster;
};

/// Returns a structured grid of the samples (VTK's XML), with NaN where a field has no value. REQUIRES: at least one raster, all of the same
/// window and size.
std::string slice_vts(std::span<const NamedRaster> fields, double time);

/// Returns a line of names, and one with the place and the values of each sample in which any field has one; a value that is not there is
/// empty. REQUIRES: as slice_vts.
std::string slice_csv(std::span<const NamedRaster> fields);

} // namespace wakesurf::protocol
