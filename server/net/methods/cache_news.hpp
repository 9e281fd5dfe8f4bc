// The time-steps of a dataset that are in memory: cache.status says which when asked, and cache.patched tells
// everybody what has changed, a few times a second.
#pragma once

#include "core/dataset/time_step_cache.hpp"
#include "server/base/loop.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace wakesurf::server {

/// Returns the state's name in the API.
const char* name_of(core::StepState state);

/// Tells of the caches that it watches. Loop thread only; caches may change on any thread.
class CacheNews {
  public:
    using Announce = std::function<void(const std::string& message)>;

    /// REQUIRES: the loop outlives every cache watched.
    CacheNews(Loop& loop, Announce announce);
    ~CacheNews();
    CacheNews(const CacheNews&) = delete;
    CacheNews& operator=(const CacheNews&) = delete;

    /// From now on, of this cache of the dataset and no earlier one.
    void watch(const std::string& dataset, const std::shared_ptr<core::TimeStepCache>& cache);

  private:
    struct Watched;
    void changed(const std::shared_ptr<Watched>& watched);

    Loop& loop_;
    Announce announce_;
    std::map<std::string, std::shared_ptr<Watched>> watched_;
};

} // namespace wakesurf::server
