// Families of stream surfaces made and removed on the compute threads, for callers of family.make and
// family.remove.
#pragma once

#include "core/base/memory_account.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/data/family_making.hpp"
#include "server/live/compute/background.hpp"

#include <functional>
#include <memory>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Runs one after another for each dataset. Everybody is told that a dataset has others by the catalogue's
/// listener. Loop thread only.
class FamilyJobs {
  public:
    /// Loop and pool outlive the work, the catalogue outlives this.
    FamilyJobs(Loop& loop,
               ComputePool& pool,
               DatasetCatalogue& catalogue,
               const core::MemoryAccount& account);

    /// Stops what is running, and waits until it has let go of the catalogue.
    ~FamilyJobs();

    FamilyJobs(const FamilyJobs&) = delete;
    FamilyJobs& operator=(const FamilyJobs&) = delete;

    /// Calls `answer` on the loop. Error: as of DatasetCatalogue::find and make_family.
    /// @param unwanted  stops this one
    /// @param done      told how far it is
    void make(const std::string& dataset,
              FamilyWish wish,
              const std::stop_token& unwanted,
              std::shared_ptr<core::WorkDone> done,
              std::function<void(core::Result<core::FamilyRecord>)> answer);

    /// Calls `answer` on the loop. Error: as of DatasetCatalogue::find and remove_family.
    void remove(const std::string& dataset,
                const std::string& name,
                std::function<void(core::Result<std::string>)> answer);

  private:
    struct Shared;
    class Work;

    Loop& loop_;
    ComputePool& pool_;
    core::MemoryAccount account_;
    std::shared_ptr<Shared> shared_;
};

} // namespace wakesurf::server
