// Which files a Plot3D dataset is made of; the rule is in plot3d_source.hpp.
#pragma once

#include "importer/sources/series/file_series.hpp"

namespace wakesurf::importer {

struct Plot3dStep {
    ListedFile grid;
    ListedFile solution;
    std::optional<double> time; ///< of the text that lists the files
};

struct Plot3dFiles {
    std::string name;
    std::vector<std::filesystem::path> index; ///< the text that lists the others, if there is one
    std::vector<Plot3dStep> steps;            ///< at least one
};

bool is_plot3d_grid(const std::filesystem::path& path);

/// `path`: the grid, a solution, a pattern of solutions, or a .p3d text. Error: NotFound (no grid, no solutions),
/// @param alone  of a numbered series only the solution that is named
/// InvalidArgument (several grids), Corrupt, Io.
core::Result<Plot3dFiles> find_plot3d_files(const std::filesystem::path& path, bool alone);

} // namespace wakesurf::importer
