// The files of a Plot3D dataset, found by the rule in files/formats.hpp, and the layout of each. The format does not state ascii
// or binary, byte order, Fortran records, one grid or several, precision and blanking: they follow from the exact length of the
// file, or the file is refused. P. Walatka et al., PLOT3D User's Manual, NASA TM-101067 (1990), chapter 8.
#pragma once

#include "importer/sources/series/file_series.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
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

/// Returns a number as Fortran writes it, 1.0D+00 or 0.123-101 where the exponent has three digits, with the E before the exponent that other readers expect; other words stay as they are.
std::string usual_number(std::string_view word);

/// Rewrites a file of such numbers as one of usual ones, in memory: its path is valid as long as this lives.
/// It is the file's own path if no number differs, or if there is no memory.
class UsualNumbers {
  public:
    explicit UsualNumbers(std::string path);
    ~UsualNumbers();

    UsualNumbers(const UsualNumbers&) = delete;
    UsualNumbers& operator=(const UsualNumbers&) = delete;

    const std::string& path() const { return path_; }

  private:
    std::string path_;
    int memory_ = -1;
};

} // namespace wakesurf::importer
