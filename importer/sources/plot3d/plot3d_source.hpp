// Plot3D: a grid file and one solution ("q") file a time-step, all in one folder. What belongs together is told by names:
// the grid `name.xyz` (.x, .g, .grd, .p3d too) and the solutions `name.q`, `name_0001.q`, `name_0002.q`, ...; where no
// solution begins with the grid's name and there is one grid only, the numbered solutions of the folder. A .p3d file may
// also be a text as ParaView reads it: {"filenames": [{"time": 0.5, "xyz": "name.xyz", "q": "name_0001.q"}, ...]}.
#pragma once

#include "importer/base/source.hpp"

namespace wakesurf::importer {

/// By extension: of a grid, of a solution, or .p3d.
bool is_plot3d(const std::filesystem::path& path);

/// Each grid of the file is a block, the cells of blanked nodes marked. Fields: Momentum, Density, StagnationEnergy and the Velocity VTK
/// makes of the first two. Times are those of the solutions' headers where they rise, else 0, 1, 2, ... Reads the
/// first time-step. Error: as open_source.
core::Result<std::unique_ptr<Source>> open_plot3d(const std::filesystem::path& path,
                                                  const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
