// Times as people write them, on the command line and in addresses: FIRST:LAST:EVERY.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/surface_parameters.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Times FIRST:LAST:EVERY.
struct SeriesTimes {
    double first = 0.0;
    double last = 0.0;
    double every = 0.0; ///< above 0
};

/// @param option  what they are called in messages, as of times_in. Error: InvalidArgument.
core::Result<SeriesTimes> read_times(const std::string& text, const std::string& option);

/// Returns the times, from the first to the last that EVERY leads to. Error: InvalidArgument for times outside `from` to
/// `to`, against their direction, or more than `most`.
core::Result<std::vector<double>> times_in(const SeriesTimes& times,
                                           const core::SurfaceParameters& parameters,
                                           std::size_t most,
                                           const std::string& option);

/// Returns so many times, evenly from `from` to `to`. REQUIRES: 2 or more.
std::vector<double> even_times(const core::SurfaceParameters& parameters, std::size_t count);

} // namespace wakesurf::server
