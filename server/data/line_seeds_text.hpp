// Seeds of streamlines as people write them, on the command line and in addresses.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/lines/line_seeds.hpp"

#include <string>

namespace wakesurf::server {

/// Reads line:x,y,z:x,y,z, plane:x,y,z:x,y,z:x,y,z, sphere:x,y,z:radius, walls:distance or along. Not checked against a domain.
/// @param option  what it is called in messages. Error: InvalidArgument.
core::Result<core::LineSeeds> parse_line_seeds(const std::string& text, const std::string& option);

/// The same of whoever gave the seeds, every number with all its digits.
std::string line_seeds_text(const core::LineSeeds& seeds);

} // namespace wakesurf::server
