#include "server/state/state_store.hpp"

#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

constexpr std::int64_t application = 0x77616b65; // `wake`

core::Result<void> make_tables(Database& database) {
    const std::string script =
        "BEGIN IMMEDIATE;"
        "CREATE TABLE records(session TEXT NOT NULL, type TEXT NOT NULL, id TEXT NOT NULL,"
        " json TEXT NOT NULL, PRIMARY KEY(session, type, id));"
        "PRAGMA application_id=" +
        std::to_string(application) +
        ";"
        "PRAGMA user_version=" +
        std::to_string(StateStore::version) +
        ";"
        "COMMIT";
    return database.run(script.c_str());
}

core::Result<void> check_layout(Database& database) {
    const auto version = database.number("PRAGMA user_version");
    if (!version)
        return tl::unexpected(version.error());
    const auto owner = database.number("PRAGMA application_id");
    if (!owner)
        return tl::unexpected(owner.error());
    const auto tables = database.number("SELECT count(*) FROM sqlite_schema");
    if (!tables)
        return tl::unexpected(tables.error());
    if (*version == 0 && *owner == 0 && *tables == 0)
        return make_tables(database);
    if (*owner != application)
        return fail(Error::Code::Unsupported,
                    "sessions.sqlite in the state folder was not made by wakesurf",
                    "give another folder with --state");
    if (*version != StateStore::version)
        return fail(Error::Code::Unsupported,
                    "sessions.sqlite in the state folder has layout " + std::to_string(*version) +
                        ", this wakesurf knows " + std::to_string(StateStore::version),
                    "use the newer wakesurf that wrote it, or another folder with --state");
    const auto verdict = database.text("PRAGMA quick_check(1)");
    if (!verdict)
        return tl::unexpected(verdict.error());
    if (*verdict != "ok")
        return fail(Error::Code::Corrupt, "sessions.sqlite in the state folder is damaged",
                    "to begin anew move sessions.sqlite* away; `sqlite3 sessions.sqlite .recover` "
                    "may save some of it");
    return {};
}

core::Result<Database> open_database(const std::string& file, const char* vfs) {
    auto database = Database::open(file, vfs);
    if (!database)
        return database;
    // Exclusive before the first access: the log's index is then kept in memory, not in a mapped file, where a write is a
    // signal when the disk is full.
    const auto ready = database->run("PRAGMA locking_mode=EXCLUSIVE; PRAGMA synchronous=FULL")
                           .and_then([&] { return check_layout(*database); })
                           .and_then([&] { return database->run("PRAGMA journal_mode=WAL"); });
    if (!ready)
        return tl::unexpected(ready.error());
    return database;
}

} // namespace

core::Result<StateStore> StateStore::open(std::string file, const char* vfs) {
    StateStore store(std::move(file), vfs);
    if (auto connected = store.connect(); !connected)
        return tl::unexpected(connected.error());
    return store;
}

core::Result<void> StateStore::connect() {
    auto database = open_database(file_, vfs_);
    if (!database)
        return tl::unexpected(database.error());
    database_ = std::move(*database);
    log_is_new_ = false;
    return read_keys();
}

core::Result<void> StateStore::read_keys() {
    std::set<StoredKey> keys;
    auto query = database_->prepare("SELECT session, type, id FROM records");
    if (!query)
        return tl::unexpected(query.error());
    auto row = query->step();
    for (; row && *row; row = query->step())
        keys.insert({query->text(0), query->text(1), query->text(2)});
    if (!row)
        return tl::unexpected(row.error());
    stored_ = std::move(keys);
    return {};
}

core::Result<std::map<std::string, std::vector<JournalEntry>>> StateStore::load() {
    std::map<std::string, std::vector<JournalEntry>> sessions;
    auto query = database_->prepare("SELECT session, type, id, json FROM records");
    if (!query)
        return tl::unexpected(query.error());
    auto row = query->step();
    for (; row && *row; row = query->step())
        sessions[query->text(0)].push_back({query->text(1), query->text(2), query->text(3)});
    if (!row)
        return tl::unexpected(row.error());
    return sessions;
}

core::Result<void> StateStore::apply(PendingWrites& changes) {
    core::Result<void> done;
    if (!database_)
        done = connect();
    if (done && !log_is_new_)
        done = begin_log();
    if (done)
        done = write(changes);
    if (!done) {
        database_.reset();
        changes.drop_needless(stored_);
    }
    return done;
}

// After a sync that failed, or was never made, what the log shows may not be on the disk, nor what is appended to it be
// found there: everything moves to the file itself, and the log begins anew.
core::Result<void> StateStore::begin_log() {
    auto begun = database_->run("PRAGMA wal_checkpoint(TRUNCATE)");
    log_is_new_ = begun.has_value();
    return begun;
}

void StateStore::erase_session_keys(const std::string& session) {
    const auto first = stored_.lower_bound({session, {}, {}});
    auto last = first;
    while (last != stored_.end() && last->session == session)
        ++last;
    stored_.erase(first, last);
}

core::Result<void> StateStore::write(const PendingWrites& changes) {
    auto forget = database_->prepare("DELETE FROM records WHERE session=?1");
    auto erase = database_->prepare("DELETE FROM records WHERE session=?1 AND type=?2 AND id=?3");
    auto put = database_->prepare("INSERT INTO records VALUES(?1, ?2, ?3, ?4)"
                                  " ON CONFLICT DO UPDATE SET json=excluded.json");
    for (const auto* statement : {&forget, &erase, &put})
        if (!*statement)
            return tl::unexpected(statement->error());
    if (auto begun = database_->run("BEGIN IMMEDIATE"); !begun)
        return begun;
    for (const std::string& session : changes.removed) {
        forget->reset();
        forget->bind(1, session);
        if (auto done = forget->step(); !done)
            return tl::unexpected(done.error());
    }
    for (const auto& [key, json] : changes.records) {
        Statement& statement = json ? *put : *erase;
        statement.reset();
        statement.bind(1, key.session);
        statement.bind(2, key.type);
        statement.bind(3, key.id);
        if (json) {
            statement.bind(4, *json);
            stored_.insert(key);
        }
        if (auto done = statement.step(); !done)
            return tl::unexpected(done.error());
    }
    for (Statement* each : {&*forget, &*erase, &*put})
        each->reset();
    if (auto done = database_->run("COMMIT"); !done)
        return done;
    for (const std::string& session : changes.removed)
        erase_session_keys(session);
    for (const auto& [key, json] : changes.records)
        json ? void(stored_.insert(key)) : void(stored_.erase(key));
    return {};
}

} // namespace wakesurf::server
