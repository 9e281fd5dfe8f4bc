#include "server/sessions/journal/state_opening.hpp"

#include "server/sessions/journal/state_folder.hpp"

#include <array>
#include <ctime>
#include <filesystem>
#include <random>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

std::string writer_of(const StateOptions& options) {
    return options.writer.empty() ? WAKESURF_VERSION : options.writer;
}

core::Result<void>
begin_file(Database& database, const StateOptions& options, StateContent& content) {
    content.layout = state_layout;
    content.head = {fresh_state_id(), 0, writer_of(options)};
    return make_tables(database, content.head);
}

/// Makes a copy beside the file, named with the version that wrote it and the time; never overwritten, never
/// deleted.
core::Result<void>
keep_copy(Database& database, const StateOptions& options, const StateContent& content) {
    const std::filesystem::path file(options.file);
    const std::string copy = (file.parent_path() / ("sessions-" + content.head.writer + "-" +
                                                    time_in_name(options.now()) + ".sqlite"))
                                 .string();
    auto made = options.vfs == nullptr ? make_private_file(copy) : core::Result<void>();
    auto done = made.and_then([&] { return database.copy_to(copy, options.vfs); });
    if (std::error_code ignored; made && !done)
        std::filesystem::remove(copy, ignored); // a part of it is no copy
    if (!done)
        done.error().message = "sessions.sqlite cannot be copied before this version changes it: " +
                               done.error().message;
    return done;
}

core::Result<void> renew(Database& database, const StateOptions& options, StateContent& content) {
    const std::string writer = writer_of(options);
    if (content.head.writer == writer)
        return {};
    if (auto kept = keep_copy(database, options, content); !kept)
        return kept;
    content.head.writer = writer;
    return put_head(database, content.head);
}

core::Result<void> keep_damaged_aside(Database& database, StateContent& content) {
    if (content.damaged.empty())
        return {};
    auto done = database.run("BEGIN IMMEDIATE");
    auto forget = database.prepare("DELETE FROM records WHERE session=?1 AND type=?2 AND id=?3");
    if (!forget)
        return tl::unexpected(forget.error());
    for (const AsideRow& each : content.damaged) {
        done = done.and_then([&] { return put_aside(database, each); });
        forget->reset();
        forget->bind(1, each.session);
        forget->bind(2, each.label.type);
        forget->bind(3, each.label.id);
        if (done)
            done = forget->step().map([](bool) {});
    }
    forget->reset();
    auto sums = content.sums();
    sums[{}]; // also without records
    for (const AsideRow& each : content.damaged)
        sums[each.session];
    for (const auto& [name, sum] : sums)
        done =
            done.and_then([&, &name = name, &sum = sum] { return put_sum(database, name, sum); });
    return done.and_then([&] { return database.run("COMMIT"); });
}

core::Result<StateContent>
take_over(Database& database, const StateOptions& options, const CommitMark& mark) {
    auto content = read_content(database, options.now());
    if (!content)
        return content;
    if (!content->faults.empty())
        return tl::unexpected(damage_error(*content));
    auto done = check_mark(*content, mark.read());
    if (content->layout == 0)
        done = done.and_then([&] { return begin_file(database, options, *content); });
    else
        done = done.and_then([&] { return renew(database, options, *content); }).and_then([&] {
            return keep_damaged_aside(database, *content);
        });
    if (!done)
        return tl::unexpected(done.error());
    return content;
}

} // namespace

core::Result<OpenedState> open_state(const StateOptions& options, const CommitMark& mark) {
    auto database = Database::open(options.file, options.vfs);
    if (!database)
        return tl::unexpected(database.error());
    database->fold_log_on_close(false);
    // Exclusive before the first access: the log's index is then in memory, not in a mapped file, where a
    // write is a signal when the disk is full.
    if (auto alone = database->run("PRAGMA locking_mode=EXCLUSIVE; PRAGMA synchronous=FULL");
        !alone)
        return tl::unexpected(alone.error());
    auto content = take_over(*database, options, mark);
    if (!content)
        return tl::unexpected(content.error());
    // Reading opens the log: a checkpoint before that is SQLITE_LOCKED after an integrity check (SQLite
    // 3.40).
    if (auto logs = database->run("PRAGMA journal_mode=WAL").and_then([&] {
            return database->number("SELECT commits FROM head");
        });
        !logs)
        return tl::unexpected(logs.error());
    database->fold_log_on_close(true);
    return OpenedState{std::move(*database), std::move(*content)};
}

core::Result<void> check_mark(const StateContent& content,
                              const std::optional<CommitMark::Value>& marked) {
    if (!marked)
        return {};
    if (content.layout == 0 && marked->commits > 0)
        return fail(Error::Code::Corrupt,
                    "sessions.sqlite in the state folder is empty or gone, although " +
                        std::to_string(marked->commits) + " changes were saved in it",
                    Database::way_out);
    if (content.layout == 0 || marked->id != content.head.id ||
        marked->commits <= content.head.commits)
        return {};
    return fail(Error::Code::Corrupt,
                "of the changes saved in sessions.sqlite the last " +
                    std::to_string(marked->commits - content.head.commits) +
                    " are missing: its log was damaged or removed, or it is an older copy",
                Database::way_out);
}

std::string time_in_name(std::int64_t unix_time) {
    const auto seconds = static_cast<std::time_t>(unix_time);
    std::tm parts{};
    ::gmtime_r(&seconds, &parts);
    std::array<char, 32> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", &parts)};
}

std::int64_t fresh_state_id() {
    std::random_device random;
    const std::uint64_t high = random();
    return static_cast<std::int64_t>((high << 32 | random()) >> 1 | 1);
}

} // namespace wakesurf::server
