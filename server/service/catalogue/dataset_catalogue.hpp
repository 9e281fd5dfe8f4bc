// The datasets a server offers: a fixed list from the command line, imported in the background where needed.
// A client names them by id and never sees a path.
#pragma once

#include "server/service/catalogue/import_lanes.hpp"
#include "server/service/catalogue/served_dataset.hpp"

#include <chrono>
#include <condition_variable>
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

/// Thread safety: every call may come from any thread.
class DatasetCatalogue {
  public:
    /// Is told that a dataset's status changed, without the catalogue's lock: from an import thread, or the
    /// thread that stops or starts it.
    using Listener = std::function<void(const std::string& dataset)>;

    /// Resolves the arguments and starts to import what needs it, `options.lanes` sources at a time; after
    /// that sources and stores are looked at every `options.watch_period`: time-steps a running simulation
    /// has written since are imported, and what was computed again, or replaced, is opened again.
    /// `options.cache`'s budget is for all datasets together. Error: what resolve_dataset and open_flow
    /// report.
    static core::Result<std::unique_ptr<DatasetCatalogue>>
    open(const std::vector<std::string>& arguments, OpenOptions options, Listener listener);
    /// Ends a running import; its store stays usable.
    ~DatasetCatalogue();
    DatasetCatalogue(const DatasetCatalogue&) = delete;
    DatasetCatalogue& operator=(const DatasetCatalogue&) = delete;

    std::vector<DatasetStatus> list() const;

    /// Error: NotFound.
    core::Result<DatasetStatus> status(std::string_view dataset) const;

    /// Usable from its first time-step on. Error: NotFound for an unknown id and while nothing is imported
    /// yet, else what made the import fail.
    core::Result<std::shared_ptr<const LoadedDataset>> find(std::string_view dataset) const;

    /// Ends the import of a dataset that is not ready yet, under way or in turn; the store stays usable.
    /// False when there is none, as of one that only grows.
    bool stop_import(std::string_view dataset);

    /// Begins an import that was stopped again, where it ended. False when it was not stopped.
    bool start_import(std::string_view dataset);

    /// The families in its store are others than they were: find() and status() have them from now on. Reads
    /// a small file.
    void look_for_families(std::string_view dataset);

    /// Imports a dataset of which nothing is there, as its velocity was not clear, with this one. Once that
    /// has worked, later servers take it as well, as long as they have the same folder of stores and no
    /// --velocity. Does nothing where it is shown with that velocity already. Error: NotFound;
    /// InvalidArgument for a store or a built-in flow, and where the dataset is shown with another velocity:
    /// nobody's flow changes under their surfaces.
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
    void work(const std::stop_token& stop);
    Entry* take_next(const std::stop_token& stop);
    void attend(Entry& entry, const std::stop_token& stop);
    void import_one(Entry& entry, const std::stop_token& stop);
    void look_at_store(Entry& entry);
    core::Result<void>
    run_import(Entry& entry, const std::filesystem::path& folder, const std::stop_token& stop);
    core::Result<void> import_within(Entry& entry,
                                     const std::filesystem::path& folder,
                                     std::size_t lanes,
                                     const std::stop_token& stop);
    bool due(Entry& entry) const;

    OpenOptions options_;
    Listener listener_;
    mutable std::mutex
        mutex_; ///< guards the entries but for what a thread has of one; their number is fixed
    std::condition_variable_any again_; ///< there may be something to do
    std::uint64_t news_ = 0;            ///< reasons to look whether there is
    std::vector<std::unique_ptr<Entry>> entries_;
    std::optional<ImportLanes> lanes_;
    std::vector<std::jthread> importers_; ///< last: stopped and joined before anything else goes
};

} // namespace wakesurf::server
