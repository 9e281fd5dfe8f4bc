// One served dataset: the state of its import, and its open data.
#pragma once

#include "server/data/open_dataset.hpp"
#include "store/import_progress.hpp"
#include "store/store_manifest.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Detects changes on disk of a dataset's source: a simulation that is still running, or was run again.
/// Unrelated files and folders beside it are not read, however many there are.
class SourceWatch {
  public:
    /// @param source  a file, a folder or a pattern; or a store's folder, whose manifest and checksums are
    /// checked
    SourceWatch(std::filesystem::path source, bool is_store);

    /// Marks the beginning of an import, or of opening a store: later changes count.
    void begin();

    /// Sets the files of a finished import. Without any, everything in the source's folder and its folders
    /// counts.
    void made_from(const store::StoreSource& files);

    /// Says whether anything has changed since begin(). Checks what all time-steps share, the first and the
    /// newest ones, and a part of the others, in rotation: at most `most_files_checked` files.
    bool changed();

    static constexpr std::size_t most_files_checked = 1024;

    /// Returns the number of files and folders checked so far.
    std::uint64_t files_checked() const { return files_checked_; }

  private:
    struct Stamp {
        std::uint64_t size = 0;
        std::int64_t modified = 0; ///< nanoseconds since 1970; 0: missing

        bool operator==(const Stamp&) const = default;
    };

    Stamp stamp(const std::filesystem::path& path);
    std::uint64_t listing();
    bool differs(const std::filesystem::path& path);
    void find_indices();
    void take_folders(const std::filesystem::path& file,
                      std::map<std::filesystem::path, Stamp>& into);

    std::filesystem::path source_;
    std::filesystem::path folder_;
    bool is_store_;
    std::map<std::filesystem::path, Stamp> known_; ///< as they were at begin(), or later
    /// Files that list others, which a reader does not name.
    std::vector<std::filesystem::path> indices_;
    /// The files that are checked every time.
    std::vector<std::filesystem::path> always_;
    std::vector<std::filesystem::path> others_; ///< the rest
    std::size_t next_ = 0;                      ///< of others_
    /// The sum of a listing, if the files are not known.
    std::optional<std::uint64_t> listing_;
    bool unsure_ = false; ///< a folder was unknown at begin(): it may have changed before
    std::uint64_t files_checked_ = 0;
};

/// Names the state. Stopped: by the last client that waited for the import; earlier time-steps can be used.
/// Incomplete: it ended before the last time-step, as on a full disk; earlier ones can be used, and `error`
/// says why and what to do.
enum class DatasetState { Importing, Ready, Failed, Stopped, Incomplete };

/// The names of the states for clients and monitors, in the order of DatasetState.
inline constexpr std::array<std::string_view, 5> dataset_state_names{"importing", "ready", "failed",
                                                                     "stopped", "incomplete"};

struct DatasetStatus {
    std::string dataset; ///< id: a slug of the name, unique
    std::string name;
    DatasetState state = DatasetState::Importing;
    std::size_t steps_ready = 0;
    std::size_t steps_total = 0; ///< 0 while unknown
    double progress = 0.0;       ///< of the import, 0..1
    /// The estimated time until the import ends, in s; empty while unknown.
    std::optional<double> remaining;
    std::vector<std::string> families; ///< names of those stored beside its data
    std::vector<std::string> means;    ///< names of the fields of means stored there
    /// The text that identifies its values (store::ValueMarks); empty: a built-in flow.
    std::string values;
    /// The velocities to choose from (choose_velocity), if it failed because its velocity is not clear.
    std::vector<std::string> velocities;
    /// The reason why it failed or is incomplete; if it is ready, why a later check failed.
    std::optional<core::Error> error;
};

/// Handles one dataset. Methods are for the thread that owns it (`busy`), but for state(), taken_now() and
/// refresh_kept_fields().
class ServedDataset {
  public:
    /// The end of an import. Stopped: the caller that stops and starts it sets the state.
    enum class Ending { Whole, Stopped };

    /// @param guard  of the state that other threads read; each method locks it
    ServedDataset(std::mutex& guard, StoreOptions options)
        : guard_(guard), options_(std::move(options)) {}

    DatasetState state() const;
    command::SourceOptions taken_now() const;

    /// Opens the present store; keeps the open one if it is the same series, of the same values.
    core::Result<LoadedDataset> reopened(const std::filesystem::path& folder);
    /// Shows the result of a stopped or earlier import.
    void show_what_is_there(const std::filesystem::path& folder);
    /// Ends an import that failed.
    void give_up(const std::filesystem::path& folder, const core::Error& error);
    /// Shows progress. Returns false if there is nothing new.
    bool show(const store::ImportProgress& progress, const std::filesystem::path& folder);
    void finish(core::Result<LoadedDataset> opened, Ending how = Ending::Whole);
    /// Reads the families and means that are in the store now. For any thread, one at a time.
    void refresh_kept_fields();

    DatasetArgument argument;
    command::SourceOptions taken; ///< its velocity guarded as the status is
    DatasetStatus status;
    std::shared_ptr<const LoadedDataset> open;
    std::stop_source running; ///< its import under way
    bool busy = false;        ///< a thread owns it
    bool begun = false;
    /// It is not checked before this time.
    std::chrono::steady_clock::time_point rests_until{};
    // The members below belong to the thread that owns it.
    std::optional<SourceWatch> watch;
    bool failed = false;   ///< its last import
    unsigned failures = 0; ///< in a row, of the same source
    unsigned polls = 0;    ///< since
    bool compared = false; ///< the import's output has been compared with the open data

    /// Logs each once, like errors. They may quote any file, so clients are not told.
    void log_library_words(std::string_view words);

  private:
    void notice_replacement();
    /// REQUIRES: the lock.
    void name_kept_fields();
    /// REQUIRES: the lock.
    void keep_error(const core::Error& error);

    std::mutex& guard_;
    StoreOptions options_;
    std::string library_words_; ///< logged last
};

} // namespace wakesurf::server
