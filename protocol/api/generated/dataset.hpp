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

/// Parameters of dataset.list: The datasets this server serves.
struct DatasetList {
    static constexpr std::string_view method = "dataset.list";
};

void read(CheckedJson& in, DatasetList& out);

/// Parameters of dataset.describe: Grid, times, fields and lattice of one dataset, in the shape of
/// `wakesurf info --json`, and what `fields` of surface.set may name.
struct DatasetDescribe {
    static constexpr std::string_view method = "dataset.describe";

    /// an id from dataset.list
    std::string dataset;

    bool operator==(const DatasetDescribe&) const = default;
};

void read(CheckedJson& in, DatasetDescribe& out);

/// Parameters of dataset.open: Answers once a dataset is imported; an import that was stopped goes
/// on where it ended. $/cancelRequest ends the waiting, and the import with it when no one else
/// waits; a connection that is lost ends no import. The state is importing when timeoutMs ran out,
/// and incomplete where the import ended before the last time-step.
struct DatasetOpen {
    static constexpr std::string_view method = "dataset.open";

    /// an id from dataset.list
    std::string dataset;
    /// patience; 0: no waiting (ms)
    std::uint64_t timeout_ms = 600000;
    /// on a WebSocket: $/progress with this token tells how far the work is
    std::optional<std::string> work_done_token;

    bool operator==(const DatasetOpen&) const = default;
};

void read(CheckedJson& in, DatasetOpen& out);

/// Parameters of cache.status: Which time-steps of a dataset are in memory.
struct CacheStatus {
    static constexpr std::string_view method = "cache.status";

    /// an id from dataset.list
    std::string dataset;

    bool operator==(const CacheStatus&) const = default;
};

void read(CheckedJson& in, CacheStatus& out);

/// Parameters of probe.sample: Fields at points and one time, interpolated as the surfaces'
/// vertices are.
struct ProbeSample {
    static constexpr std::string_view method = "probe.sample";

    /// an id from dataset.list
    std::string dataset;
    /// where (the dataset's unit of length)
    std::vector<core::Vec3> points;
    /// in the dataset's range (the dataset's unit of time)
    double time = 0.0;
    /// the velocity's name or scalars; left out: the velocity
    std::vector<std::string> fields;

    bool operator==(const ProbeSample&) const = default;
};

void read(CheckedJson& in, ProbeSample& out);

} // namespace wakesurf::protocol
