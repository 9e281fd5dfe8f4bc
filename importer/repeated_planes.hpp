// A source whose flow repeats along some axes, and whose grid ends a spacing before the first plane of nodes would come
// again: that plane is added.
#pragma once

#include "importer/base/source.hpp"
#include "importer/fields/field_choice.hpp"

namespace wakesurf::importer {

/// Looks at the velocity at the first and the last of the time-steps, where the source is one image or rectilinear
/// grid with values at its points, and puts a source that adds planes in the place of it, if any is missing. Returns
/// the note, which says along which axes. Error: as Source::read; InvalidArgument, beginning with the option, where
/// the flow does not repeat, or Unsupported where the spacing is uneven.
/// @param name  of the first time-step
core::Result<std::string> add_repeated_planes(std::unique_ptr<Source>& source,
                                              const std::vector<std::size_t>& steps,
                                              const FieldChoice& choice,
                                              const core::PeriodicAxes& axes,
                                              const std::string& name);

} // namespace wakesurf::importer
