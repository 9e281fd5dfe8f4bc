// A rake as the command line writes it: "x,y,z x,y,z ...".
#pragma once

#include "core/base/result.hpp"
#include "core/surface/rake.hpp"

#include <cstdint>
#include <string_view>

namespace wakesurf::server {

/// Two points make a line, more a polyline. Error: InvalidArgument, naming the point that is wrong.
core::Result<core::Rake> parse_rake(std::string_view text, std::uint32_t seeds);

} // namespace wakesurf::server
