// What stands behind the `?` of a request's target.
#pragma once

#include "core/base/result.hpp"

#include <map>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// `time=2.5&draco=false` by name, percent signs resolved; empty for none. Error: InvalidArgument for what has no `=`, a name twice, or
/// a percent sign without two digits.
core::Result<std::map<std::string, std::string>> url_query(std::string_view text);

} // namespace wakesurf::server
