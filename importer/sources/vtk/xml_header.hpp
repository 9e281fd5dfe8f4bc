// The header of one of VTK's XML files: what VTK does not check of it, where it would fill in or leave out data without a message,
// and the time, read without the rest of the file: series have thousands of files.
#pragma once

#include "core/base/result.hpp"
#include "importer/sources/series/file_series.hpp"
#include "importer/sources/series/series_times.hpp"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace wakesurf::importer {

struct XmlHeader {
    std::string type; ///< ImageData, PUnstructuredGrid, vtkMultiBlockDataSet, ...
    vtkSmartPointer<vtkXMLDataElement> root; ///< owns `primary`
    vtkXMLDataElement* primary = nullptr;    ///< the element named as the type
    std::int64_t appended = 0;               ///< where offsets into appended data count from
    bool cut = false;                        ///< the file ends behind a tag, before its elements do
};

/// Parses all but appended data. REQUIRES: a VtkMessages lives. Error: Io, Corrupt (empty, cut off, not XML,
/// not VTK's). @param listing  the file only lists others: one that is cut off behind a tag is read as well
core::Result<XmlHeader> read_xml_header(const ListedFile& file, bool listing = false);

/// Checks that Origin, Spacing and Direction are numbers if they are given; pieces cover the extent exactly
/// (VTK leaves other nodes uninitialized); piece sizes are numbers; there is one time-step. Error: Corrupt,
/// Unsupported (several time-steps in one file: VTK would read the first for each).
core::Result<void> check_xml_header(const XmlHeader& header, const std::string& name);

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
