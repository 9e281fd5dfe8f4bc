// Scalar fields of a dataset, stored or derived from its velocity, at the vertices of a surface, for
// exports.
#pragma once

#include "core/surface/measures/field_mean.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "server/data/open_dataset.hpp"

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Checks the fields. Error: NotFound for fields that are neither stored nor derived, listing those that are.
/// @param parameter  that names them
core::Result<void> check_fields(const LoadedDataset& dataset,
                                const std::vector<std::string>& fields,
                                std::string_view parameter = "fields");

/// Returns each named field, with a value a vertex, at the time in `times`. Names of the velocity,
/// deformation, approximated and error are accepted: every export has them. Error: as check_fields and
/// reading.
core::Result<protocol::MeshScalars> surface_scalars(const LoadedDataset& dataset,
                                                    const core::QuadComplex& mesh,
                                                    const std::vector<double>& times,
                                                    const std::vector<std::string>& fields,
                                                    const std::stop_token& stop);

/// Returns fields whose means over a surface can be taken; the velocity's is that of its magnitude. Sampling
/// them reports what surface_scalars does. The dataset must outlive them. Error: as check_fields.
core::Result<std::vector<core::AveragedField>>
averaged_fields(const LoadedDataset& dataset,
                const std::vector<std::string>& fields,
                std::string_view parameter = "fields");

} // namespace wakesurf::server
