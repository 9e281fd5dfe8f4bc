// The values of a scalar field at the nodes of a dataset: stored ones, or derived from the velocity.
#pragma once

#include "core/base/result.hpp"
#include "core/field/flow.hpp"
#include "core/field/velocity_gradient.hpp"
#include "store/store_scalars.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>

namespace wakesurf::server {

struct NodeField {
    enum class Source : std::uint8_t { Scalar, Speed, VelocityComponent, Gradient };

    std::string name;
    Source source = Source::Scalar;
    std::size_t index = 0; ///< of the scalar, of the component, or of the derived field

    bool operator==(const NodeField&) const = default;
};

/// Finds a field; a stored one goes before a derived one. Error: NotFound, listing the fields.
/// @param velocity  the name of the dataset's
/// @param of_files  as no_such_field() has it
core::Result<NodeField> find_node_field(const store::StoreScalars& scalars,
                                        const std::string& velocity,
                                        const std::string& name,
                                        std::span<const core::FieldInfo> of_files = {});

/// Computes one value a node at a time, linear between time-steps; NaN for missing values, also in obstacles.
/// Error: Cancelled, as reading and sampling.
/// @param out  as many as there are nodes
core::Result<void> node_values(const NodeField& field,
                               const core::Flow& flow,
                               const store::StoreReader& store,
                               const store::StoreScalars& scalars,
                               double time,
                               std::span<float> out,
                               const std::stop_token& stop);

} // namespace wakesurf::server
