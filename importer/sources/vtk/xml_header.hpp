// What VTK does not check in one of its XML files before it reads it, and then fills in or leaves out without a word.
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
};

/// Parses all but appended data. REQUIRES: a VtkMessages lives. Error: Io, Corrupt (empty, cut off, not XML, not VTK's).
core::Result<XmlHeader> read_xml_header(const ListedFile& file);

/// Origin, Spacing and Direction are numbers where they are given; pieces cover the extent exactly (VTK leaves other
/// nodes as memory happened to be); piece sizes are numbers; one time-step. Error: Corrupt, Unsupported (several
/// time-steps in one file: VTK would read the first for each).
core::Result<void> check_xml_header(const XmlHeader& header, const std::string& name);

} // namespace wakesurf::importer
