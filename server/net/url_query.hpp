// The query of a request's target, behind its `?`.
#pragma once

#include "core/base/result.hpp"

#include <map>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Parses `time=2.5&draco=false` into values by name, percent signs resolved; empty for an empty text. Error:
/// InvalidArgument for a part without `=`, a name twice, or a percent sign without two digits.
core::Result<std::map<std::string, std::string>> url_query(std::string_view text);

} // namespace wakesurf::server
