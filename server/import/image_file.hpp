// One .vti file -> values: the grid, the arrays it holds, and the velocity and mask chosen from them.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/dataset/uniform_grid.hpp"
#include "server/import/field_choice.hpp"
#include "server/import/series.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace wakesurf::server {

struct ImageDescription {
    core::UniformGrid grid;
    std::vector<core::FieldInfo> fields; ///< with ranges
    std::optional<double> time;          ///< its TimeValue field data
};

struct ImageStep {
    core::UniformGrid grid;
    std::vector<float> velocity;     ///< xyz interleaved, x fastest; 0 in the solid
    std::vector<std::uint8_t> fluid; ///< 1 fluid, 0 solid; empty without a mask
};

/// Reads all arrays. Error: Corrupt, Unsupported (2-D, rotated), Io.
core::Result<ImageDescription> describe_image(const SeriesFile& file);

/// The time a file carries itself, if any; reads no arrays.
core::Result<std::optional<double>> image_time(const SeriesFile& file);

/// Reads the chosen arrays. Error: as describe_image; NotFound where an array is missing; Corrupt for velocities
/// that are not finite at a fluid node and masks with values other than 0 and 1.
core::Result<ImageStep> read_image(const SeriesFile& file, const FieldChoice& choice);

/// Lowest and highest speed over the fluid nodes.
std::array<double, 2> speed_range(const std::vector<float>& velocity,
                                  const std::vector<std::uint8_t>& fluid);

} // namespace wakesurf::server
