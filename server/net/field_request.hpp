// What addresses of a field's values have in common, as slice.bin and lines.bin: ?field=p&time=2.5
#pragma once

#include "core/base/result.hpp"
#include "server/data/open_dataset.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Error: InvalidArgument, naming the parameter.
core::Result<double> read_field_time(const std::string& text, std::string_view name = "time");

/// Returns the time to sample at. Error: InvalidArgument where the flow has several and none is given.
core::Result<double> time_of(std::optional<double> asked, const LoadedDataset& dataset);

/// Returns the field. @param name  empty: the velocity. Error: NotFound, saying what there is.
core::Result<NodeField> field_of(const std::string& name, const LoadedDataset& dataset);

} // namespace wakesurf::server
