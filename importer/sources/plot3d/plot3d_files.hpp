// The files of a Plot3D dataset; the rule is in files/formats.hpp.
#pragma once

#include "importer/sources/series/file_series.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct Plot3dStep {
    ListedFile grid;
    ListedFile solution;
    std::optional<double> time; ///< of the text that lists the files, or of the name
};

struct Plot3dFiles {
    std::string name;
    std::vector<std::filesystem::path> index; ///< the text that lists the others, if there is one
    std::vector<Plot3dStep> steps;            ///< at least one
    std::string note{};                       ///< where their times are from, if that is not plain
};

/// Decides by the extension.
bool is_plot3d_grid(const std::filesystem::path& path);

/// Finds the files from one of them: the grid, a solution, a pattern of solutions, or a .p3d text. Error:
/// NotFound (no grid, no solutions), InvalidArgument (several grids), Corrupt, Io.
/// @param alone  takes of a numbered series only the solution that is named
core::Result<Plot3dFiles> find_plot3d_files(const std::filesystem::path& path, bool alone);

} // namespace wakesurf::importer
