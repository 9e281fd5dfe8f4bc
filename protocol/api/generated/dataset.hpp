// Made by protocol/api/generate from dataset.schema.json: do not edit.
// Datasets: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"
#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/generated/shared.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Holds the parameters of dataset.list.
struct DatasetList : NoParameters {
    static constexpr std::string_view method = "dataset.list";
};

/// Holds the parameters of dataset.describe.
struct DatasetDescribe {
    static constexpr std::string_view method = "dataset.describe";

    /// an id from dataset.list
    std::string dataset;
};

/// Holds the parameters of dataset.open.
struct DatasetOpen {
    static constexpr std::string_view method = "dataset.open";

    /// an id from dataset.list
    std::string dataset;
    /// how long to wait, at most; 0: do not wait (ms)
    std::uint64_t timeout_ms = 600000;
    /// velocity of files in which it is not clear, by name: a vector, three scalars `u,v,w`, or a
    /// momentum and its density; empty: by the names of the fields. For editors; it is kept beside
    /// the imported data. `velocities` of a dataset that failed lists what could be meant
    std::string velocity;
    /// on a WebSocket: $/progress reports the progress of the work with this token
    std::optional<std::string> work_done_token;
};

/// Holds the parameters of dataset.suggest.
struct DatasetSuggest {
    static constexpr std::string_view method = "dataset.suggest";

    /// an id from dataset.list
    std::string dataset;
};

/// Holds the parameters of cache.status.
struct CacheStatus {
    static constexpr std::string_view method = "cache.status";

    /// an id from dataset.list
    std::string dataset;
};

/// Holds the parameters of probe.sample.
struct ProbeSample {
    static constexpr std::string_view method = "probe.sample";

    /// an id from dataset.list
    std::string dataset;
    /// points to sample (the dataset's unit of length)
    std::vector<core::Vec3> points;
    /// simulation time, in the dataset's range (the dataset's unit of time)
    double time = 0.0;
    /// name of the velocity, or names of scalar fields; if left out, the velocity
    std::vector<std::string> fields;
};

void read(CheckedJson& in, DatasetDescribe& out);
void read(CheckedJson& in, DatasetOpen& out);
void read(CheckedJson& in, DatasetSuggest& out);
void read(CheckedJson& in, CacheStatus& out);
void read(CheckedJson& in, ProbeSample& out);

nlohmann::json suggested_surface_json(const core::SurfaceParameters& record);
nlohmann::json suggested_rake_json(const core::Rake& record);

} // namespace wakesurf::protocol
