#include "server/net/shared_files.hpp"

#include "server/base/limits.hpp"
#include "server/base/log_text.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdint>
#include <list>
#include <map>
#include <mutex>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace wakesurf::server {

namespace {

/// Counts a file's memory until its last reader releases it.
File counted_file(std::string bytes, core::MemoryAccount::Share share) {
    struct Counted {
        std::string bytes;
        core::MemoryAccount::Share share;
    };

    const auto counted = std::make_shared<Counted>(Counted{std::move(bytes), std::move(share)});
    return {counted, &counted->bytes};
}

/// Finished files, the most recently used first. Thread-safe: any thread may need memory.
class FileCache {
  public:
    File find(const std::string& tag) {
        const std::lock_guard lock(mutex_);
        const auto found = std::ranges::find(entries_, tag, &Entry::tag);
        if (found == entries_.end())
            return nullptr;
        entries_.splice(entries_.begin(), entries_, found);
        return found->file;
    }

    void keep(const std::string& tag, File file) {
        std::vector<File> gone; // destroyed outside of the lock
        const std::lock_guard lock(mutex_);
        if (file->size() > limits::kept_download_bytes)
            return;
        bytes_ += file->size();
        entries_.push_front({tag, std::move(file)});
        while (bytes_ > limits::kept_download_bytes || entries_.size() > limits::kept_downloads)
            gone.push_back(drop_last());
    }

    /// A file that is still being read is released by its last reader.
    void give_back(std::size_t wanted) {
        std::vector<File> gone;
        std::size_t free = 0;
        const std::lock_guard lock(mutex_);
        while (!entries_.empty() && free < wanted) {
            const bool read = entries_.back().file.use_count() > 1;
            gone.push_back(drop_last());
            free += read ? 0 : gone.back()->size();
        }
    }

  private:
    struct Entry {
        std::string tag;
        File file;
    };

    File drop_last() {
        File last = std::move(entries_.back().file);
        bytes_ -= last->size();
        entries_.pop_back();
        return last;
    }

    std::mutex mutex_;
    std::list<Entry> entries_;
    std::size_t bytes_ = 0;
};

struct Waiter {
    SharedFiles::Done done;
    std::optional<std::stop_callback<std::function<void()>>> gone;
};

/// A file that is being made.
struct Flight {
    std::stop_source stop;
    std::map<std::uint64_t, Waiter> waiters;
};

} // namespace

struct SharedFiles::State {
    Loop& loop;
    ComputePool& pool;
    const core::MemoryAccount* account;
    const std::shared_ptr<FileCache> kept = std::make_shared<FileCache>();
    /// The registration for reclaiming memory; null: it is never reclaimed.
    std::shared_ptr<void> asked =
        account == nullptr
            ? nullptr
            : account->on_need(core::ReclaimOrder::Downloads,
                               [cache = kept](std::size_t wanted) { cache->give_back(wanted); });
    std::map<std::string, std::shared_ptr<Flight>> flights{}; ///< by tag
    std::uint64_t next = 0;

    void
    leave(const std::string& tag, const std::shared_ptr<Flight>& flight, std::uint64_t ticket) {
        // The stop callback, which is running, lives until the loop's next iteration.
        auto waiter = std::make_shared<std::map<std::uint64_t, Waiter>::node_type>(
            flight->waiters.extract(ticket));
        loop.post([waiter] {});
        if (!flight->waiters.empty())
            return;
        flight->stop.request_stop();
        if (const auto found = flights.find(tag); found != flights.end() && found->second == flight)
            flights.erase(found);
    }

    void made(const std::string& tag,
              const std::shared_ptr<Flight>& flight,
              const core::Result<File>& file) {
        if (const auto found = flights.find(tag); found != flights.end() && found->second == flight)
            flights.erase(found);
        if (file)
            kept->keep(tag, *file);
        for (auto& [ticket, waiter] : std::exchange(flight->waiters, {})) {
            waiter.gone.reset();
            waiter.done(file);
        }
    }
};

SharedFiles::SharedFiles(Loop& loop, ComputePool& pool, const core::MemoryAccount* account)
    : state_(new State{loop, pool, account}) {}

SharedFiles::~SharedFiles() {
    for (auto& [tag, flight] : std::exchange(state_->flights, {})) {
        flight->stop.request_stop();
        flight->waiters.clear();
    }
}

std::size_t SharedFiles::making() const {
    return state_->flights.size();
}

void SharedFiles::get(const std::string& tag,
                      const std::string& asker,
                      Make make,
                      const std::stop_token& gone,
                      Done done,
                      PriorityClass priority) {
    if (const File kept = state_->kept->find(tag))
        return done(kept);
    auto& flight = state_->flights[tag];
    const bool first = !flight;
    if (first)
        flight = std::make_shared<Flight>();
    const std::uint64_t ticket = state_->next++;
    Waiter& waiter = flight->waiters[ticket];
    waiter.done = std::move(done);
    if (first)
        state_->pool.run(
            asker, priority,
            [flight, make = std::move(make), tag, weak = std::weak_ptr(state_),
             &loop = state_->loop, account = state_->account] {
                core::MemoryAccount::Share share = account != nullptr
                                                       ? account->open(core::MemoryUse::Downloads)
                                                       : core::MemoryAccount::Share{};
                auto file = std::make_shared<core::Result<File>>(core::fail(
                    core::Error::Code::OverLimit, "there is not enough memory for this file",
                    "try again later, or ask for a surface of fewer quads"));
                try {
                    auto bytes = make(flight->stop.get_token(), share);
                    if (bytes)
                        share.set(bytes->size());
                    *file = std::move(bytes).map([&](std::string&& made) {
                        return counted_file(std::move(made), std::move(share));
                    });
                } catch (const std::bad_alloc&) { // reported above
                } catch (
                    const std::exception& error) { // an exception of a library ends this file only
                    spdlog::error("making a file failed: {}", without_paths(error.what()));
                    *file = core::fail(core::Error::Code::Io,
                                       "making the file failed inside the server",
                                       "the server's log has the details");
                }
                loop.post([weak, flight, tag, file] {
                    if (const auto state = weak.lock())
                        state->made(tag, flight, *file);
                });
            });
    // Comes last: it may fire at once.
    if (gone.stop_possible())
        waiter.gone.emplace(gone, [weak = std::weak_ptr(state_), tag, flight = flight, ticket] {
            if (const auto state = weak.lock())
                state->leave(tag, flight, ticket);
        });
}

} // namespace wakesurf::server
