// What VTK does not check in a .vti before it reads it, and then fills in or leaves out without a word.
#pragma once

#include "core/base/result.hpp"
#include "server/import/series.hpp"

namespace wakesurf::server {

/// The file is not cut off, its Origin, Spacing and Direction are numbers where they are given, and its pieces cover
/// its extent exactly (VTK leaves other nodes as memory happened to be). REQUIRES: a VtkMessages lives.
/// Error: Io, Corrupt.
core::Result<void> check_image_header(const SeriesFile& file);

} // namespace wakesurf::server
