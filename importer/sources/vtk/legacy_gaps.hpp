// Numbers that are none, as text in legacy files: "nan" and "inf", which VTK's reader takes for damage.
#pragma once

#include <vtkDataSet.h>

#include <istream>
#include <optional>
#include <string>

namespace wakesurf::importer {

/// The text with a mark in place of every such word among numbers; nothing where there are none, which is found without keeping the text.
std::optional<std::string> with_marked_gaps(std::istream& in);

/// Puts NaN where the marks are, in points and fields.
void unmark_gaps(vtkDataSet& data);

} // namespace wakesurf::importer
