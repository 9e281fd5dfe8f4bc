// Fields that are kept with the data, families and means, made and removed on the compute threads, for callers
// of family.make, mean.make and so on.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/work_done.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/live/compute/background.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Runs one after another for each dataset. Everybody is told that a dataset has others by the catalogue's
/// listener. Loop thread only.
class KeptFieldJobs {
  public:
    /// Loop and pool outlive the work, the catalogue outlives this.
    KeptFieldJobs(Loop& loop,
                  ComputePool& pool,
                  DatasetCatalogue& catalogue,
                  const core::MemoryAccount& account);

    /// Stops what is running, and waits until it has let go of the catalogue.
    ~KeptFieldJobs();

    KeptFieldJobs(const KeptFieldJobs&) = delete;
    KeptFieldJobs& operator=(const KeptFieldJobs&) = delete;

    /// Makes or removes fields of an open dataset. Returns what the caller is told.
    using Make = std::function<core::Result<nlohmann::json>(
        const LoadedDataset& dataset, const std::stop_token& stop, const core::WorkPart& work)>;

    struct Work {
        std::string what; ///< for refusals: "this family"
        Make make;
        std::stop_token unwanted{};             ///< stops this one
        std::shared_ptr<core::WorkDone> done{}; ///< told how far it is
    };

    /// Calls `answer` on the loop. Error: as of DatasetCatalogue::find and `make`.
    void run(const std::string& dataset,
             Work work,
             std::function<void(core::Result<nlohmann::json>)> answer);

  private:
    struct Shared;
    class Turn;

    Loop& loop_;
    ComputePool& pool_;
    core::MemoryAccount account_;
    std::shared_ptr<Shared> shared_;
};

} // namespace wakesurf::server
