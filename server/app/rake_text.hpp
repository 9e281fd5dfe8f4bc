// A rake on the command line: "x,y,z x,y,z ...", or a file of its points.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/rake.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Parses a rake. A word with the extension of a file names one, which the importer reads. Error:
/// InvalidArgument, naming the option and the wrong point, or the points that a rake of that kind has; that of
/// read_rake_with_import_process.
/// @param kind  a word of rake.set; empty: two points make a line, more a polyline
core::Result<core::Rake> parse_rake(std::string_view text,
                                    std::uint32_t seeds,
                                    const std::string& option = "--rake",
                                    std::string_view kind = {});

/// Parses x,y,z. Error: InvalidArgument for anything but three finite numbers.
core::Result<core::Vec3> parse_vector(std::string_view text, const std::string& option);

} // namespace wakesurf::server
