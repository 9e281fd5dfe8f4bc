// Notices to people, server.notice: of the disk, of a start after crashes, of data that were replaced, and of
// records that could not be used.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/time_step_cache.hpp"
#include "server/base/loop.hpp"
#include "server/sessions/session.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Returns the state's name in the API.
const char* name_of(core::StepState state);

/// Tells of the caches that it watches. Loop thread only; caches may change on any thread.
class CacheEvents {
  public:
    using Announce = std::function<void(const std::string& message)>;

    /// REQUIRES: the loop outlives every cache watched.
    CacheEvents(Loop& loop, Announce announce);
    ~CacheEvents();
    CacheEvents(const CacheEvents&) = delete;
    CacheEvents& operator=(const CacheEvents&) = delete;

    /// From now on, of this cache of the dataset and no earlier one.
    void watch(const std::string& dataset, const std::shared_ptr<core::TimeStepCache>& cache);

  private:
    struct Watched;
    void changed(const std::shared_ptr<Watched>& watched);

    Loop& loop_;
    Announce announce_;
    std::map<std::string, std::shared_ptr<Watched>> watched_;
};

/// Returns a whole server.notice, for people. @param level  `info` or `warning`
std::string notice(std::string_view kind, std::string_view level, const std::string& text);

/// Returns the notice of kind `durableAgain`, or with an error `notDurable`: edits are not kept for now.
std::string durability_notice(const core::Result<void>& turn);

/// Says why surfaces that were brought back are not computed, after so many starts that died.
core::Error withheld(unsigned died);

/// Returns the notice that says so.
std::string careful_notice(unsigned died);

/// Returns the notice that the values of datasets are others than before. @param names  of the datasets; at
/// least one
std::string replaced_data_notice(const std::set<std::string>& names);

/// Returns the same for participants who join a session after it has happened.
std::string replaced_data_meanwhile_notice(const std::set<std::string>& names);

/// Returns the newest of the records that were kept aside, at most so many.
std::span<const KeptAside> newest_aside(const Session& session, std::size_t most);

/// Returns the notice of records that could not be used when the server started; nothing where it could use
/// all.
std::optional<std::string> kept_aside_notice(const Session& session);

} // namespace wakesurf::server
