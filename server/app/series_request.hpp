// What the command `surface` is to write of the states of a surface: an animation in one file, numbers in one file, or
// a file a time.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/surface_parameters.hpp"
#include "server/data/series_times.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

struct Series {
    /// What is made of the states.
    enum class Form { Files, Animation, Numbers };
    Form form = Form::Files;
    std::optional<SeriesTimes> times{};
};

inline constexpr std::size_t most_files = 10000;

/// Reads -o and --times; nothing where they name one file of one time. Error: InvalidArgument.
core::Result<std::optional<Series>> read_series(const std::string& output,
                                                const std::string& times);

/// Returns the times, from the first to the last that EVERY leads to. Where none were asked for: of an animation evenly
/// from `from` to `to`, of numbers `to` alone. Error: InvalidArgument for times outside `from` to `to`, against their direction, or too
/// many.
core::Result<std::vector<double>> times_of(const Series& series,
                                           const core::SurfaceParameters& parameters);

/// Returns the name of a file: the pattern with its number. REQUIRES: read_series took the pattern.
std::filesystem::path name_in(const std::string& pattern, std::size_t number);

} // namespace wakesurf::server
