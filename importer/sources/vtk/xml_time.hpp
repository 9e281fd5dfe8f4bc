// The time one of VTK's XML files carries, read without the rest of the file: series have thousands of files.
#pragma once

#include "importer/sources/series/file_series.hpp"
#include "importer/sources/series/series_times.hpp"
#include "importer/sources/vtk/xml_header.hpp"

#include <array>
#include <optional>
#include <utility>

namespace wakesurf::importer {

/// The names of arrays of the field data that state the time; the preferred ones stand last.
inline constexpr std::array<std::pair<const char*, std::optional<double> StatedTime::*>, 7>
    time_arrays{{{"cycle", &StatedTime::cycle},
                 {"Cycle", &StatedTime::cycle},
                 {"CYCLE", &StatedTime::cycle}, // VisIt
                 {"time", &StatedTime::time},
                 {"Time", &StatedTime::time},
                 {"TIME", &StatedTime::time},
                 {"TimeValue", &StatedTime::time}}}; // ParaView

/// Returns time and cycle of the field data, of any type of number. REQUIRES: a VtkMessages lives; a message
/// of VTK is an error too. Error: Corrupt (one that cannot be read).
core::Result<StatedTime> xml_time(const ListedFile& file);

} // namespace wakesurf::importer
