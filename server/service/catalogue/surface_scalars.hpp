// Scalar fields of a dataset, stored or derived from its velocity, at the vertices of a surface, for
// exports.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "server/service/catalogue/open_dataset.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Error: NotFound for fields that are neither stored nor derived, saying what there is.
core::Result<void> check_fields(const LoadedDataset& dataset,
                                const std::vector<std::string>& fields);

/// Each named field, with a value a vertex, at the time in `times`. The velocity, deformation, approximated
/// and error may be named too: every export has them. Error: as check_fields, and what reading reports.
core::Result<protocol::MeshScalars> surface_scalars(const LoadedDataset& dataset,
                                                    const core::QuadComplex& mesh,
                                                    const std::vector<double>& times,
                                                    const std::vector<std::string>& fields,
                                                    const std::stop_token& stop);

} // namespace wakesurf::server
