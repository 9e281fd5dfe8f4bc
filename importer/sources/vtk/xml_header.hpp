// Checks of one of VTK's XML files that VTK does not make: it would fill in or leave out data without a
// message.
#pragma once

#include "core/base/result.hpp"
#include "importer/sources/series/file_series.hpp"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>

#include <cstdint>

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

} // namespace wakesurf::importer
