// A dataset's fields at points and one time: the answer of probe.sample.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "core/surface/suggestion/scene_suggestion.hpp"
#include "server/data/datasets.hpp"
#include "server/live/compute/background.hpp"

#include <functional>
#include <memory>
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

/// Interpolates like the engine, linear in time; what is made of the velocity as core::sample_field does. Blocks while time-steps load.
/// Error: OutOfTime, NotFound (a field), that of reading.
core::Result<ProbeResult>
probe(const OpenDataset& dataset, const ProbeRequest& request, const std::stop_token& stop);

/// Probes on the compute threads. Loop thread only.
class Prober {
  public:
    Prober(Loop& loop, ComputePool& pool) : loop_(loop), pool_(pool) {}

    /// Stops running probes; their answers are still delivered as long as the loop runs.
    ~Prober() { stop_.request_stop(); }

    Prober(const Prober&) = delete;
    Prober& operator=(const Prober&) = delete;

    /// Calls `answer` on the loop. Error: as probe.
    /// @param line      the key for taking turns in the pool
    /// @param unwanted  stops this probe
    void ask(OpenDataset dataset,
             ProbeRequest request,
             const std::string& line,
             const std::stop_token& unwanted,
             std::function<void(core::Result<ProbeResult>)> answer);

    /// Suggests a beginning for a dataset; otherwise as ask(). Error: as suggest_for.
    void suggest(OpenDataset dataset,
                 const std::string& line,
                 const std::stop_token& unwanted,
                 std::function<void(core::Result<core::SceneSuggestion>)> answer);

  private:
    Loop& loop_;
    ComputePool& pool_;
    std::stop_source stop_;
};

} // namespace wakesurf::server
