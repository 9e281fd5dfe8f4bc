// How a Plot3D file is laid out. The format does not say: ascii or binary, byte order, Fortran records, one grid or
// several, precision and blanking follow from the exact length of the file, or the file is refused.
// P. Walatka et al., PLOT3D User's Manual, NASA TM-101067 (1990), chapter 8.
#pragma once

#include "importer/sources/series/file_series.hpp"

#include <array>

namespace wakesurf::importer {

struct Plot3dLayout {
    bool ascii = false;
    bool big_endian = false;
    bool records = false; ///< each write stands between two lengths, as Fortran does it
    bool several = false; ///< the file begins with the number of grids
    bool doubles = false;
    bool blanking = false;
    std::vector<std::array<int, 3>> blocks; ///< nodes along i, j, k
};

/// Error: Io, Corrupt (no layout has the length of the file), Unsupported (a layout in the plane has).
core::Result<Plot3dLayout> grid_layout(const ListedFile& grid);

/// The file has the length a solution on the grid has, and says the same numbers of nodes. Returns the time of its header.
/// Error: Io, Corrupt.
core::Result<double> check_solution(const ListedFile& solution, const Plot3dLayout& grid);

} // namespace wakesurf::importer
