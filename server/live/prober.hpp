// Answers probe.sample and dataset.suggest from the compute threads.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/suggestion/scene_suggestion.hpp"
#include "server/data/datasets.hpp"
#include "server/data/probe.hpp"
#include "server/live/compute/background.hpp"

#include <functional>
#include <memory>
#include <stop_token>
#include <string>

namespace wakesurf::server {

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
