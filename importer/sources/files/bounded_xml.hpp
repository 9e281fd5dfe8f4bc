// VTK's XML parser with a bound on nesting: it builds and takes apart its tree by recursion, and some 100,000 elements in each
// other end the process.
#pragma once

#include "core/base/result.hpp"

#include <vtkSmartPointer.h>
#include <vtkXMLDataParser.h>

#include <istream>
#include <string>

namespace wakesurf::importer {

/// What the stream holds, parsed as far as it is XML; without a root element where it is none. The parser keeps the stream.
/// Error: Corrupt (elements nested too deeply). REQUIRES: a VtkMessages lives.
core::Result<vtkSmartPointer<vtkXMLDataParser>> parse_xml(std::istream& in,
                                                          const std::string& file);

} // namespace wakesurf::importer
