// Made by protocol/api/generate from dataset.schema.json: do not edit.
// Datasets: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "core/base/vec3.hpp"
#include "protocol/api/checked_json.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Parameters of dataset.list: Lists the datasets that this server serves.
struct DatasetList {
    static constexpr std::string_view method = "dataset.list";
};

void read(CheckedJson& in, DatasetList& out);

/// Parameters of dataset.describe: Returns the grid, times, fields and lattice of one dataset, in
/// the shape of `wakesurf info --json`, and the names that `fields` of surface.set accepts.
struct DatasetDescribe {
    static constexpr std::string_view method = "dataset.describe";

    /// an id from dataset.list
    std::string dataset;

    bool operator==(const DatasetDescribe&) const = default;
};

void read(CheckedJson& in, DatasetDescribe& out);

/// Parameters of dataset.open: Returns once a dataset is imported. An import that was stopped goes
/// on where it ended. $/cancelRequest ends the waiting, and the import with it if no one else waits
/// for it. A lost connection does not end an import. The state is `importing` if `timeoutMs` ran
/// out, and `incomplete` if the import ended before the last time-step.
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

    bool operator==(const DatasetOpen&) const = default;
};

void read(CheckedJson& in, DatasetOpen& out);

/// Parameters of dataset.suggest: Returns a rake and the parameters of a surface of each kind to
/// begin with, found in the data: the rake stands ahead of a body that the flow meets, else where
/// the flow turns, else where it enters. All surfaces are shown at the same time. Reads one or two
/// time-steps.
struct DatasetSuggest {
    static constexpr std::string_view method = "dataset.suggest";

    /// an id from dataset.list
    std::string dataset;

    bool operator==(const DatasetSuggest&) const = default;
};

void read(CheckedJson& in, DatasetSuggest& out);

/// Parameters of cache.status: Reports which time-steps of a dataset are in memory.
struct CacheStatus {
    static constexpr std::string_view method = "cache.status";

    /// an id from dataset.list
    std::string dataset;

    bool operator==(const CacheStatus&) const = default;
};

void read(CheckedJson& in, CacheStatus& out);

/// Parameters of probe.sample: Returns the values of fields at points and one time, interpolated as
/// at the vertices of surfaces.
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

    bool operator==(const ProbeSample&) const = default;
};

void read(CheckedJson& in, ProbeSample& out);

} // namespace wakesurf::protocol
