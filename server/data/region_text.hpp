// A plane or a box as people write it, on the command line and in addresses: plane:x,y,z:nx,ny,nz or box:x,y,z:x,y,z.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/measures/region.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Reads x,y,z: three finite numbers.
std::optional<core::Vec3> point_of(std::string_view text);

/// @param option  what it is called in messages
/// Error: InvalidArgument: for anything else, a normal of no length, a box of no volume.
core::Result<core::Region> parse_region(const std::string& text, const std::string& option);

} // namespace wakesurf::server
