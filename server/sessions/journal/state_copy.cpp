#include "server/sessions/journal/state_copy.hpp"

#include "server/base/unix_time.hpp"
#include "server/sessions/journal/backup_coordinator.hpp"
#include "server/sessions/journal/commit_mark.hpp"
#include "server/sessions/journal/database.hpp"
#include "server/sessions/journal/state_folder.hpp"
#include "server/sessions/journal/state_opening.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;
namespace fs = std::filesystem;

namespace {

constexpr int tries = 5; ///< while a server runs whose disk fails

fs::path with(const fs::path& path, const char* end) {
    return path.string() + end;
}

/// A folder for this user alone, removed with everything in it.
class ScratchFolder {
  public:
    static core::Result<ScratchFolder> make(const fs::path& in) {
        std::string name = (in / "wakesurf-state-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            return fail(Error::Code::Io,
                        "a copy cannot be made: " + std::generic_category().message(errno),
                        "free disk space for another file of this size");
        return ScratchFolder(name);
    }

    ~ScratchFolder() {
        std::error_code ignored;
        if (!path_.empty())
            fs::remove_all(path_, ignored);
    }

    ScratchFolder(ScratchFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

    ScratchFolder& operator=(ScratchFolder&&) = delete;

    fs::path file() const { return path_ / "sessions.sqlite"; }

  private:
    explicit ScratchFolder(fs::path path) : path_(std::move(path)) {}

    fs::path path_;
};

std::optional<CommitMark::Value> mark_of(const fs::path& folder) {
    return CommitMark((folder / "sessions.sqlite.commits").string()).read();
}

core::Result<void> copy_one(const fs::path& from, const fs::path& to) {
    std::error_code error;
    if (fs::copy_file(from, to, fs::copy_options::overwrite_existing, error))
        return {};
    return fail(Error::Code::Io, "the sessions' file cannot be copied: " + error.message(),
                "check that this user can read it, and that there is space for a copy");
}

/// Copies the file, and its log if there is one.
core::Result<void> copy_with_log(const fs::path& from, const fs::path& to) {
    std::error_code error;
    if (!fs::exists(from, error))
        return fail(Error::Code::NotFound, "there is no such sessions file",
                    "name a state folder's sessions.sqlite, or a backup of it");
    auto done = copy_one(from, to);
    if (done && fs::exists(with(from, "-wal"), error))
        done = copy_one(with(from, "-wal"), with(to, "-wal"));
    return done;
}

core::Result<void> copy_of_running(const fs::path& folder, const fs::path& to) {
    for (int attempt = 0; attempt < tries; ++attempt) {
        auto hold = BackupLock::ask(folder);
        if (!hold)
            return tl::unexpected(hold.error());
        if (auto copied = copy_one(folder / "sessions.sqlite", to); !copied)
            return copied;
        if (hold->finish())
            return {};
    }
    return fail(Error::Code::Io, "the disk with the sessions failed while they were copied",
                "see the server's log");
}

/// Copies a folder as it is now, even if a server uses it.
core::Result<void> copy_of(const fs::path& folder, const fs::path& to) {
    const auto held = StateFolder::hold_existing(folder);
    if (held)
        return copy_with_log(folder / "sessions.sqlite", to);
    if (held.error().code != Error::Code::OverLimit)
        return tl::unexpected(held.error());
    return copy_of_running(folder, to);
}

/// Opens a private copy. Its log becomes part of it.
core::Result<Database> open_copy(const fs::path& copy) {
    return Database::open(copy.string(), nullptr).and_then([](Database&& database) {
        return database.run("PRAGMA locking_mode=EXCLUSIVE; PRAGMA journal_mode=DELETE").map([&] {
            return std::move(database);
        });
    });
}

/// Returns everything readable, and what is wrong with it.
core::Result<StateVerdict> verdict_of(const fs::path& copy,
                                      const std::optional<CommitMark::Value>& marked) {
    auto database = Database::open(copy.string(), nullptr);
    if (!database)
        return tl::unexpected(database.error());
    static_cast<void>(database->run("PRAGMA locking_mode=EXCLUSIVE"));
    const std::int64_t now = unix_seconds();
    auto content = read_content(*database, now);
    if (content && content->faults.empty()) {
        StateVerdict verdict{std::move(*content), {}};
        if (const auto whole = check_mark(verdict.content, marked); !whole)
            verdict.fault = whole.error();
        return verdict;
    }
    if (!content && content.error().code == Error::Code::Unsupported)
        return tl::unexpected(content.error());
    Error fault = content ? damage_error(*content) : content.error();
    auto rest = salvage_content(*database, now);
    return StateVerdict{rest ? std::move(*rest) : StateContent{}, std::move(fault)};
}

core::Result<void> write_content(const fs::path& file, StateContent& content) {
    auto database = Database::open(file.string(), nullptr);
    if (!database)
        return tl::unexpected(database.error());
    content.head = {fresh_state_id(), 1, WAKESURF_VERSION};
    content.layout = state_layout;
    auto done = make_tables(*database, content.head).and_then([&] {
        return database->run("BEGIN IMMEDIATE");
    });
    for (const auto& [session, entries] : content.sessions)
        for (const JournalEntry& each : entries)
            if (done) {
                const StoredKey key{session, each.type, each.id};
                done = put_row(*database, key, *each.record, content.digests.at(key));
            }
    for (const auto* rows : {&content.aside, &content.damaged})
        for (const AsideRow& each : *rows)
            if (done)
                done = put_aside(*database, each);
    auto sums = content.sums();
    sums[{}]; // also without records
    for (const auto& [name, sum] : sums)
        if (done)
            done = put_sum(*database, name, sum);
    return done.and_then([&] { return database->run("COMMIT"); });
}

/// Replaces the file by a new one and renames the old one; returns its new name, or empty.
core::Result<std::string> exchange(const fs::path& folder, const fs::path& fresh) {
    const fs::path file = folder / "sessions.sqlite";
    const std::string name = "sessions-replaced-" + time_in_name(unix_seconds()) + ".sqlite";
    std::error_code error;
    const bool there = fs::exists(file, error) && fs::file_size(file, error) > 0;
    if (there && fs::exists(folder / name, error))
        return fail(Error::Code::Io, "the sessions were already replaced within this second",
                    "try again");
    if (there)
        fs::rename(file, folder / name, error);
    if (!error && fs::exists(with(file, "-wal")))
        fs::rename(with(file, "-wal"), with(folder / name, "-wal"), error);
    if (!error)
        fs::rename(fresh, file, error);
    if (error)
        return fail(Error::Code::Io, "the sessions cannot be put in place: " + error.message(),
                    "check that this user can write to the state folder");
    fs::remove(with(file, ".commits"), error);
    const int place = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    ::fsync(place);
    ::close(place);
    return there ? name : std::string();
}

} // namespace

core::Result<StateVerdict> check_state(const fs::path& folder) {
    auto scratch = ScratchFolder::make(fs::temp_directory_path());
    if (!scratch)
        return tl::unexpected(scratch.error());
    const auto marked = mark_of(folder);
    if (auto copied = copy_of(folder, scratch->file()); !copied)
        return tl::unexpected(copied.error());
    return verdict_of(scratch->file(), marked);
}

core::Result<StateContent> back_up_state(const fs::path& folder, const fs::path& file) {
    std::error_code error;
    if (fs::exists(file, error))
        return fail(Error::Code::InvalidArgument, "a file with this name already exists",
                    "name another file: a backup never overwrites one");
    auto scratch = ScratchFolder::make(file.has_parent_path() ? file.parent_path() : fs::path("."));
    if (!scratch)
        return tl::unexpected(scratch.error());
    const fs::path copy = scratch->file();
    const auto marked = mark_of(folder);
    auto done = make_private_file(copy.string()).and_then([&] { return copy_of(folder, copy); });
    if (!done)
        return tl::unexpected(done.error());
    auto verdict = verdict_of(copy, marked);
    if (!verdict)
        return tl::unexpected(verdict.error());
    if (verdict->fault)
        return tl::unexpected(*verdict->fault);
    // A single file without a log, on the disk before it gets its name.
    auto whole = open_copy(copy).map([](Database&&) {});
    if (!whole)
        return tl::unexpected(whole.error());
    const int written = ::open(copy.c_str(), O_RDONLY | O_CLOEXEC);
    ::fsync(written);
    ::close(written);
    fs::permissions(copy, fs::perms::owner_read | fs::perms::owner_write, error);
    if (::link(copy.c_str(), file.c_str()) != 0) // unlike rename, never replaces a file
        return fail(Error::Code::Io,
                    "the backup cannot be named: " + std::generic_category().message(errno),
                    "name another file");
    return std::move(verdict->content);
}

core::Result<RestoredState>
restore_state(const fs::path& folder, const fs::path& file, bool damaged) {
    std::error_code error;
    if (!fs::exists(file, error))
        return fail(Error::Code::NotFound, "there is no such sessions file",
                    "name a state folder's sessions.sqlite, or a backup of it");
    const bool made_folder = fs::create_directories(folder, error);
    if (made_folder)
        fs::permissions(folder, fs::perms::owner_all, error);
    auto held = StateFolder::hold_existing(folder);
    if (!held) {
        if (held.error().code == Error::Code::OverLimit)
            held.error() = {Error::Code::OverLimit,
                            "a running server keeps its sessions in this folder",
                            "stop it, restore, and start it again"};
        return tl::unexpected(held.error());
    }
    auto scratch = ScratchFolder::make(folder);
    if (!scratch)
        return tl::unexpected(scratch.error());
    if (auto copied = copy_with_log(file, scratch->file()); !copied)
        return tl::unexpected(copied.error());
    auto verdict = verdict_of(scratch->file(), std::nullopt);
    if (!verdict)
        return tl::unexpected(verdict.error());
    if (verdict->fault && !damaged)
        return tl::unexpected(
            Error{verdict->fault->code, "the file to restore: " + verdict->fault->message,
                  "restore another one, or restore what can be read of this one with --damaged"});
    RestoredState out{std::move(verdict->content), {}, made_folder};
    const fs::path fresh = with(scratch->file(), ".new");
    auto replaced = make_private_file(fresh.string())
                        .and_then([&] { return write_content(fresh, out.content); })
                        .and_then([&] { return exchange(folder, fresh); });
    if (!replaced)
        return tl::unexpected(replaced.error());
    out.replaced = std::move(*replaced);
    return out;
}

} // namespace wakesurf::server
