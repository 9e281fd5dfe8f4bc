// A rake as the command line writes it: "x,y,z x,y,z ...".
#pragma once

#include "core/base/result.hpp"
#include "core/surface/rake.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// @param kind  a word of rake.set; empty: two points make a line, more a polyline
/// Error: InvalidArgument, naming the option and the point that is wrong, or what points a rake of that kind has.
core::Result<core::Rake> parse_rake(std::string_view text,
                                    std::uint32_t seeds,
                                    const std::string& option = "--rake",
                                    std::string_view kind = {});

/// x,y,z. Error: InvalidArgument for anything but three finite numbers.
core::Result<core::Vec3> parse_vector(std::string_view text, const std::string& option);

} // namespace wakesurf::server
