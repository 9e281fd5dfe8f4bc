// Finds the scalars that a surface's vertices carry behind speed, s and t: the names in `fields`, found in
// a dataset and sampled on a mesh.
#pragma once

#include "core/base/result.hpp"
#include "core/field/flow.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/wire/wire_mesh.hpp"
#include "store/store_scalars.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct OpenDataset;

struct SurfaceField {
    enum class Source : std::uint8_t {
        Scalar,
        Speed,
        VelocityComponent,
        NormalComponent,
        Deformation,
        Approximated,
        Error,
        IntervalError,
        TwinDistance,
        TwinLag,
        Gradient
    };

    std::string name;
    Source source = Source::Scalar;

    bool operator==(const SurfaceField&) const = default;
};

/// Lists what a surface's `fields` may name: the stored scalars and families, the velocity, what the engine
/// derives.
std::vector<std::string> field_names(const OpenDataset& dataset);

/// Finds a stored scalar, the velocity for its magnitude, or what the engine derives; a scalar of the
/// dataset goes before what is derived. Error: InvalidArgument, saying what there is.
core::Result<SurfaceField> find_field(const OpenDataset& dataset, const std::string& name);

/// Leaves out names that were there before. Error: as find_field.
core::Result<std::vector<std::string>> fields_once(const OpenDataset& dataset,
                                                   const std::vector<std::string>& names);

/// Returns those of the names that the dataset has, at most limits::fields: of a record kept from before,
/// some may not be there.
std::vector<SurfaceField> fields_there(const OpenDataset& dataset,
                                       const std::vector<std::string>& names);

bool asks_for(std::span<const SurfaceField> fields, SurfaceField::Source source);

/// Returns each field at each vertex; not finite where a stored field has no value, the velocity no
/// gradient, or the mesh no estimate of its error.
/// @param scalars  of the store that the flow is of; null for a built-in flow. One that is not there any
/// more has no value
/// @param times  one a vertex: when it is there. Asked for if a field that is sampled is among them Error:
/// Cancelled, what reading reports.
core::Result<protocol::MeshFields> sample_fields(std::span<const SurfaceField> fields,
                                                 const core::Flow& flow,
                                                 const store::StoreScalars* scalars,
                                                 const core::QuadComplex& mesh,
                                                 const std::function<std::vector<double>()>& times,
                                                 const std::stop_token& stop);

} // namespace wakesurf::server
