// An attribute of an element, as VTK's own reader of XML hands it out.
#pragma once

#include <vtkXMLDataElement.h>

#include <string>

namespace wakesurf::importer {

/// Empty where there is none.
inline std::string xml_attribute(vtkXMLDataElement& element, const char* name) {
    const char* text = element.GetAttribute(name);
    return text == nullptr ? std::string() : std::string(text);
}

} // namespace wakesurf::importer
