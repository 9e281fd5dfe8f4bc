// One dataset as it is served: how its import stands, and what is open of it.
#pragma once

#include "server/service/catalogue/open_dataset.hpp"
#include "server/service/catalogue/source_watch.hpp"
#include "store/import_progress.hpp"

#include <array>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Stopped: by the last client that waited for the import; the time-steps until then can be used.
/// Incomplete: it ended before the last time-step, as on a full disk; those there can be used, and `error`
/// says why and what to do.
enum class DatasetState { Importing, Ready, Failed, Stopped, Incomplete };

/// Names the states for clients and monitors, in the order of DatasetState.
inline constexpr std::array<std::string_view, 5> dataset_state_names{"importing", "ready", "failed",
                                                                     "stopped", "incomplete"};

struct DatasetStatus {
    std::string dataset; ///< id: a slug of the name, unique
    std::string name;
    DatasetState state = DatasetState::Importing;
    std::size_t steps_ready = 0;
    std::size_t steps_total = 0;     ///< 0 while unknown
    double progress = 0.0;           ///< of the import, 0..1
    std::optional<double> remaining; ///< seconds the import will still take, once that can be told
    std::vector<std::string> families; ///< names of those that are kept beside its data
    std::string
        values; ///< what its values are told from others by (store::ValueMarks); empty: a built-in flow
    std::vector<std::string>
        velocities; ///< of one that failed as its velocity is not clear: what choose_velocity takes
    std::optional<core::Error>
        error; ///< why it failed or is incomplete; of one that is ready, why what was looked for since could not be read
};

/// Its methods are for the thread that has it (`busy`), but for state(), taken_now() and
/// look_for_families().
class ServedDataset {
  public:
    /// Is the state of an import. Stopped: the caller that stops and starts it says how the dataset stands.
    enum class Ending { Whole, Stopped };

    /// @param guard  of what others look at; it is taken by each method
    ServedDataset(std::mutex& guard, StoreOptions options)
        : guard_(guard), options_(std::move(options)) {}

    DatasetState state() const;
    command::SourceOptions taken_now() const;

    /// Opens what is in the store now; keeps what is open where that is the same series, of the same values.
    core::Result<LoadedDataset> reopened(const std::filesystem::path& folder);
    /// Of an import that was stopped, or of an earlier one.
    void show_what_is_there(const std::filesystem::path& folder);
    /// After an import that failed.
    void give_up(const std::filesystem::path& folder, const core::Error& error);
    /// False where there is nothing to tell.
    bool show(const store::ImportProgress& progress, const std::filesystem::path& folder);
    void finish(core::Result<LoadedDataset> opened, Ending how = Ending::Whole);
    /// The families that are in the store now. For any thread, one at a time.
    void look_for_families();

    DatasetArgument argument;
    command::SourceOptions taken; ///< its velocity guarded as the status is
    DatasetStatus status;
    std::shared_ptr<const LoadedDataset> open;
    std::stop_source running; ///< its import under way
    bool busy = false;        ///< a thread has it
    bool begun = false;
    std::chrono::steady_clock::time_point rests_until{}; ///< it is not looked at before
    // Of the thread that has it.
    std::optional<SourceWatch> watch;
    bool failed = false;   ///< its last import
    unsigned failures = 0; ///< in a row, of the same source
    unsigned looks = 0;    ///< since
    bool compared = false; ///< what this import writes, with what is open

  private:
    void notice_replacement();
    /// REQUIRES: the lock.
    void keep_error(const core::Error& error);

    std::mutex& guard_;
    StoreOptions options_;
};

} // namespace wakesurf::server
