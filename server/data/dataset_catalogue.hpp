// The datasets of a server: a fixed list from the command line, imported in the background if needed. Clients
// name them by id and never see a path.
#pragma once

#include "server/data/served_dataset.hpp"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace wakesurf::server {

/// The number of imports at a time, and the memory for each: an equal part of the total. One that does not fit
/// into its part runs again alone, with all of it.
/// Bounds concurrent imports. Thread-safe.
class ImportLanes {
  public:
    explicit ImportLanes(std::size_t lanes) : lanes_(lanes) {}

    ImportLanes(const ImportLanes&) = delete;
    ImportLanes& operator=(const ImportLanes&) = delete;

    std::size_t lanes() const { return lanes_; }

    /// Holds a slot, or all of them, until destroyed.
    class Taken {
      public:
        Taken(ImportLanes& of, std::size_t lanes) : of_(of), lanes_(lanes) {}

        ~Taken() { of_.leave(lanes_); }

        Taken(const Taken&) = delete;
        Taken& operator=(const Taken&) = delete;

      private:
        ImportLanes& of_;
        std::size_t lanes_;
    };

    /// Waits for a slot: imports that want all slots go first. It stops waiting when `stop` fires.
    Taken one(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        left_.wait(lock, stop, [this] { return taken_ < lanes_ && alone_ == 0; });
        ++taken_;
        return {*this, 1};
    }

    Taken all(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        ++alone_;
        left_.wait(lock, stop, [this] { return taken_ == 0; });
        --alone_;
        taken_ += lanes_;
        return {*this, lanes_};
    }

  private:
    void leave(std::size_t lanes) {
        {
            const std::scoped_lock lock(mutex_);
            taken_ -= lanes;
        }
        left_.notify_all();
    }

    const std::size_t lanes_;
    std::mutex mutex_;
    std::condition_variable_any left_;
    std::size_t taken_ = 0;
    std::size_t alone_ = 0; ///< waiting for all slots
};

/// Serves the datasets. Thread-safe.
class DatasetCatalogue {
  public:
    /// Called when a dataset's status changes, without the catalogue's lock: from an import thread, or the
    /// thread that stops or starts it.
    using Listener = std::function<void(const std::string& dataset)>;

    /// Resolves the arguments and starts imports, `options.lanes` sources at a time. After that it checks
    /// sources and stores every `options.watch_period`: time-steps that a running simulation has written
    /// since are imported, and recomputed or replaced data are opened again. `options.cache`'s budget is for
    /// all datasets together. Error: as resolve_dataset and open_flow.
    static core::Result<std::unique_ptr<DatasetCatalogue>>
    open(const std::vector<std::string>& arguments, OpenOptions options, Listener listener);
    /// Ends a running import; its store stays usable.
    ~DatasetCatalogue();
    DatasetCatalogue(const DatasetCatalogue&) = delete;
    DatasetCatalogue& operator=(const DatasetCatalogue&) = delete;

    std::vector<DatasetStatus> list() const;

    /// Returns the status. Error: NotFound for an unknown id.
    core::Result<DatasetStatus> status(std::string_view dataset) const;

    /// Returns a dataset, usable from its first time-step on. Error: NotFound for an unknown id and before
    /// the first time-step, else that of the import.
    core::Result<std::shared_ptr<const LoadedDataset>> find(std::string_view dataset) const;

    /// Ends the import of a dataset that is not ready yet, running or queued; the store stays usable. Returns
    /// false without one, and for a dataset that only grows.
    bool stop_import(std::string_view dataset);

    /// Resumes an import that was stopped. Returns false if it was not stopped.
    bool start_import(std::string_view dataset);

    /// Reads the families and means in its store again, for find() and status(). Reads two small files.
    void refresh_kept_fields(std::string_view dataset);

    /// Imports, with this velocity, a dataset of which nothing is imported because its velocity was not
    /// clear. After a success later servers take it as well, as long as they have the same folder of stores
    /// and no --velocity. Does nothing if it has that velocity already. Error: NotFound; InvalidArgument for
    /// a store or a built-in flow, and if the dataset has another velocity: the flow under existing surfaces
    /// never changes.
    core::Result<void> choose_velocity(std::string_view dataset, const std::string& velocity);

  private:
    using Entry = ServedDataset;

    DatasetCatalogue(OpenOptions options, Listener listener)
        : options_(std::move(options)), listener_(std::move(listener)) {}

    core::Result<void> add(const std::string& argument);
    std::filesystem::path choice_file(const Entry& entry) const;
    std::string unused_id(const std::string& name) const;
    Entry* find_entry(std::string_view dataset) const;
    std::filesystem::path store_folder_of(const Entry& entry) const;
    std::size_t wanted_lanes() const;
    /// Threads each have one kind of data, so that a web server that says nothing keeps no others waiting.
    enum class Work { Import, OfDisk, OfWeb };
    static Work work_of(const DatasetArgument& argument);
    void work(Work kind, const std::stop_token& stop);
    Entry* take_next(Work kind, const std::stop_token& stop);
    void attend(Entry& entry, const std::stop_token& stop);
    void import_one(Entry& entry, const std::stop_token& stop);
    void check_store(Entry& entry);
    core::Result<void>
    run_import(Entry& entry, const std::filesystem::path& folder, const std::stop_token& stop);
    core::Result<void> import_within(Entry& entry,
                                     const std::filesystem::path& folder,
                                     std::size_t lanes,
                                     const std::stop_token& stop);
    bool due(Entry& entry) const;

    OpenOptions options_;
    std::stop_source closing_; ///< fired at the end, for what waits for a web server
    Listener listener_;
    /// Guards the entries, except for the part of one that a thread owns; their number is fixed.
    mutable std::mutex mutex_;
    std::condition_variable_any again_; ///< notified when there may be work
    std::uint64_t wakeups_ = 0;         ///< counts the reasons to check for work
    std::vector<std::unique_ptr<Entry>> entries_;
    std::optional<ImportLanes> lanes_;
    /// Declared last: stopped and joined before anything else is destroyed.
    std::vector<std::jthread> importers_;
};

} // namespace wakesurf::server
