#include "server/sessions/journal/state_store.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <utility>

namespace wakesurf::server {

core::Result<StoredSessions> StoredSessions::open(const std::filesystem::path& path) {
    auto folder = StateFolder::hold(path);
    if (!folder)
        return tl::unexpected(folder.error());
    auto store = StateStore::open(folder->file());
    if (!store)
        return tl::unexpected(store.error());
    StateStore::Loaded found = store->take_loaded();
    StoredSessions out{std::move(*folder), std::move(*store), std::move(found.sessions), {}, {}};
    const auto sort = [&](std::vector<AsideRow>& rows, auto& into) {
        for (AsideRow& each : rows) {
            into[each.session].push_back(std::move(each.label));
            out.sessions.try_emplace(each.session);
        }
    };
    sort(found.aside, out.aside);
    sort(found.damaged, out.damaged);
    return out;
}

using core::Error;
using core::fail;

core::Result<StateStore> StateStore::open(StateOptions options) {
    StateStore store(std::move(options));
    auto found = store.connect();
    if (!found)
        return tl::unexpected(found.error());
    store.loaded_ = std::move(*found);
    return store;
}

std::optional<StateStore::Identity> StateStore::identity_of(const std::string& file) {
    struct stat found {};

    if (::stat(file.c_str(), &found) != 0)
        return std::nullopt;
    return Identity{found.st_dev, found.st_ino};
}

core::Result<StateStore::Loaded> StateStore::connect() {
    auto opened = open_state(options_, mark_);
    if (!opened)
        return tl::unexpected(opened.error());
    database_ = std::move(opened->database);
    StateContent& content = opened->content;
    log_is_new_ = false;
    log_identity_.reset();
    lost_ = false;
    identity_ = options_.vfs == nullptr ? identity_of(options_.file) : std::nullopt;
    head_ = content.head;
    sums_ = content.sums();
    stored_ = std::move(content.digests);
    return Loaded{std::move(content.sessions), std::move(content.aside),
                  std::move(content.damaged)};
}

bool StateStore::in_place() const {
    if (!database_ || !identity_)
        return true;
    return identity_of(options_.file) == identity_ &&
           (!log_identity_ || identity_of(options_.file + "-wal") == log_identity_);
}

core::Result<void> StateStore::apply(PendingWrites& changes) {
    core::Result<void> done;
    if (lost_)
        done = put_back();
    else if (!database_)
        done = connect().map([](const Loaded&) {});
    if (done && !log_is_new_)
        done = begin_log();
    if (done && in_place())
        done = write(changes);
    if (done && !in_place()) {
        lost_ = true;
        done = fail(Error::Code::Io,
                    "the state folder, or the sessions' file in it, was deleted or replaced",
                    "leave it alone while the server runs; what was deleted is written again");
    }
    if (!done) {
        stored_.merge(going_);
        changes.drop_needless(stored_);
        held_ = false; // closing the file writes to it
        if (!lost_)
            database_.reset();
    }
    going_.clear();
    return done;
}

// Restores the name of the file, which is still open and complete.
core::Result<void> StateStore::put_back() {
    namespace fs = std::filesystem;
    const fs::path path(options_.file);
    const auto there = identity_of(options_.file);
    if (there && there != identity_)
        return fail(
            Error::Code::Io, "another file was put in place of the sessions' file",
            "stop the server to use that file, or remove it to have the sessions of this server "
            "saved again");
    if (!there) {
        std::error_code error;
        if (!fs::exists(path.parent_path(), error)) {
            folder_.reset();
            auto held = StateFolder::hold(path.parent_path());
            if (!held)
                return tl::unexpected(held.error());
            folder_.emplace(std::move(*held));
            fs::remove(path, error); // it is empty
        }
        const std::string copy = options_.file + ".again";
        fs::remove(copy, error);
        auto done =
            make_private_file(copy).and_then([&] { return database_->copy_to(copy, nullptr); });
        if (!done)
            return done;
        fs::remove(options_.file + "-wal", error);
        fs::rename(copy, path, error);
        if (error)
            return fail(Error::Code::Io,
                        "the sessions' file cannot be put back: " + error.message(),
                        "make the state folder writable");
        database_->fold_log_on_close(false);
    }
    database_.reset();
    mark_.close();
    return connect().map([](const Loaded&) {});
}

// After a sync that failed, or was never made, the log may not be on the disk, nor what is appended to it:
// everything moves to the file itself, and the log starts again.
core::Result<void> StateStore::begin_log() {
    auto begun = database_->run("PRAGMA wal_checkpoint(TRUNCATE)");
    log_is_new_ = begun.has_value();
    log_identity_ = identity_ ? identity_of(options_.file + "-wal") : std::nullopt;
    return begun;
}

core::Result<void> StateStore::hold() {
    if (!database_ || lost_)
        return fail(Error::Code::Io, "the sessions cannot be written at the moment", "try again");
    auto held = database_->run("PRAGMA wal_autocheckpoint=0; PRAGMA wal_checkpoint(TRUNCATE)");
    held_ = held.has_value();
    return held;
}

bool StateStore::release() {
    if (database_)
        static_cast<void>(database_->run("PRAGMA wal_autocheckpoint=1000"));
    return std::exchange(held_, false);
}

/// Adds a row to the sum, or removes it.
void StateStore::count(const StoredKey& key, std::optional<std::uint64_t> digest) {
    const auto before = stored_.find(key);
    for (RowSum* sum : {&sums_[key.session], &sums_[{}]}) {
        if (before != stored_.end())
            sum->take(before->second);
        if (digest)
            sum->add(*digest);
    }
    if (digest)
        stored_.insert_or_assign(key, *digest);
    else if (before != stored_.end())
        going_.insert(stored_.extract(before));
}

core::Result<void> StateStore::forget(const std::string& session) {
    for (auto each = stored_.lower_bound({session, {}, {}});
         each != stored_.end() && each->first.session == session;)
        count(StoredKey((each++)->first), std::nullopt);
    for (const char* text :
         {"DELETE FROM records WHERE session=?1", "DELETE FROM aside WHERE session=?1"}) {
        auto statement = database_->prepare(text);
        if (!statement)
            return tl::unexpected(statement.error());
        statement->bind(1, session);
        if (auto done = statement->step(); !done)
            return tl::unexpected(done.error());
    }
    return {};
}

core::Result<void> StateStore::move_aside(const StoredKey& key, const KeptAside& label) {
    auto find =
        database_->prepare("SELECT json FROM records WHERE session=?1 AND type=?2 AND id=?3");
    if (!find)
        return tl::unexpected(find.error());
    find->bind(1, key.session);
    find->bind(2, key.type);
    find->bind(3, key.id);
    const auto there = find->step();
    if (!there)
        return tl::unexpected(there.error());
    if (!*there)
        return {};
    if (auto put = put_aside(*database_, {key.session, label, find->text(0)}); !put)
        return put;
    find->reset();
    return change(key, std::nullopt);
}

core::Result<void> StateStore::change(const StoredKey& key,
                                      const std::optional<std::string>& json) {
    if (json) {
        const std::uint64_t digest = row_digest(key, *json);
        count(key, digest);
        return put_row(*database_, key, *json, digest);
    }
    count(key, std::nullopt);
    auto erase = database_->prepare("DELETE FROM records WHERE session=?1 AND type=?2 AND id=?3");
    if (!erase)
        return tl::unexpected(erase.error());
    erase->bind(1, key.session);
    erase->bind(2, key.type);
    erase->bind(3, key.id);
    return erase->step().map([](bool) {});
}

core::Result<void> StateStore::write_sums(const std::set<std::string>& sessions) {
    core::Result<void> done;
    for (const std::string& session : sessions)
        if (done)
            done = put_sum(*database_, session, sums_[session]);
    std::erase_if(sums_,
                  [](const auto& each) { return each.second.records == 0 && !each.first.empty(); });
    return done;
}

// After a failure these counts are read again from the file.
core::Result<void> StateStore::write(const PendingWrites& changes) {
    if (changes.empty())
        return {};
    auto done = database_->run("BEGIN IMMEDIATE");
    std::set<std::string> touched{{}};
    for (const std::string& session : changes.removed) {
        touched.insert(session);
        done = done.and_then([&] { return forget(session); });
    }
    for (const auto& [key, label] : changes.aside) {
        touched.insert(key.session);
        if (done)
            done = move_aside(key, label);
    }
    for (const auto& [key, json] : changes.records) {
        touched.insert(key.session);
        if (done)
            done = change(key, json);
    }
    StateHead next = head_;
    ++next.commits;
    done = done.and_then([&] { return write_sums(touched); })
               .and_then([&] { return put_head(*database_, next); })
               .and_then([&] { return database_->run("COMMIT"); });
    if (!done)
        return done;
    head_ = next;
    if (identity_ && !log_identity_) // the log was made by this transaction
        log_identity_ = identity_of(options_.file + "-wal");
    if (options_.vfs == nullptr)
        mark_.write({head_.id, head_.commits});
    return {};
}

} // namespace wakesurf::server
