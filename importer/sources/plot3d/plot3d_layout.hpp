// The layout of a Plot3D file. The format does not state ascii or binary, byte order, Fortran records, one
// grid or several, precision and blanking: they follow from the exact length of the file, or the file is
// refused. P. Walatka et al., PLOT3D User's Manual, NASA TM-101067 (1990), chapter 8.
#pragma once

#include "importer/sources/series/file_series.hpp"

#include <array>

namespace wakesurf::importer {

struct Plot3dLayout {
    bool ascii = false;
    bool big_endian = false;
    bool records = false; ///< each write stands between two lengths, as in Fortran
    bool several = false; ///< the file begins with the number of grids
    bool doubles = false;
    bool blanking = false;
    std::vector<std::array<int, 3>> blocks; ///< nodes along i, j, k
};

/// Finds the layout. Error: Io, Corrupt (no layout has the length of the file), Unsupported (a layout in the
/// plane has).
core::Result<Plot3dLayout> grid_layout(const ListedFile& grid);

/// The four numbers before the values: Mach number, angle of attack, Reynolds number, time.
using Plot3dHeader = std::array<double, 4>;

/// Checks that the file has the length of a solution on the grid, and states the same numbers of nodes.
/// Returns the header of its first grid. Error: Io, Corrupt.
core::Result<Plot3dHeader> check_solution(const ListedFile& solution, const Plot3dLayout& grid);

} // namespace wakesurf::importer
