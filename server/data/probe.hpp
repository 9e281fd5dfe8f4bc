// A dataset's fields at points and one time.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/field/flow.hpp"
#include "store/store_scalars.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct ProbeRequest {
    std::vector<core::Vec3> points;
    double time = 0.0;
    std::vector<std::string>
        fields; ///< the velocity as vectors, any other as find_node_field; empty: the velocity
};

struct ProbeField {
    std::string name;
    std::vector<core::Vec3> vectors; ///< of the velocity, NaN outside; else empty
    std::vector<float> scalars;      ///< NaN outside
};

struct ProbeResult {
    std::vector<bool> inside; ///< in the fluid
    std::vector<ProbeField> fields;
};

/// A dataset, opened in one way or another.
struct ProbedData {
    const core::DatasetInfo& info;
    const core::Flow& flow;
    const store::StoreScalars* scalars; ///< null for a built-in flow
};

/// Interpolates like the engine, linear in time; what is made of the velocity as core::sample_field does. Blocks while time-steps load.
/// Error: OutOfTime, NotFound (a field), that of reading.
core::Result<ProbeResult>
probe(const ProbedData& data, const ProbeRequest& request, const std::stop_token& stop);

} // namespace wakesurf::server
