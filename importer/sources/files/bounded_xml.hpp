// VTK's XML parser with a bound on nesting: it builds and takes apart its tree by recursion, and some 100,000
// elements in each other end the process.
#pragma once

#include "core/base/result.hpp"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <istream>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::importer {

/// Returns the content of a stream, parsed as far as it is XML; without a root element if it is none. The
/// parser keeps the stream. Error: Corrupt (elements nested too deeply). REQUIRES: a VtkMessages lives.
core::Result<vtkSmartPointer<vtkXMLDataParser>> parse_xml(std::istream& in,
                                                          const std::string& file);

/// Returns the text of a file that was cut off, or is still written, up to its last whole tag and with the
/// elements closed that are open there; empty if none is.
std::optional<std::string> closed_xml(std::string_view text);

/// Returns an attribute of an element as VTK hands it out; empty if it is missing.
inline std::string xml_attribute(vtkXMLDataElement& element, const char* name) {
    const char* text = element.GetAttribute(name);
    return text == nullptr ? std::string() : std::string(text);
}

} // namespace wakesurf::importer
