#include "server/sessions/journal/database.hpp"

#include <sqlite3.h>

#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

const char* const Database::way_out =
    "`wakesurf state check DIR` says what is there; `wakesurf state restore DIR BACKUP` puts a "
    "backup "
    "in its place (with `--damaged` and the file itself: what can still be read of it); to start "
    "afresh, move sessions.* away";

namespace {

/// Returns an error in our words: SQLite's may name files.
tl::unexpected<Error> failure(int code) {
    switch (code & 0xff) {
    case SQLITE_FULL:
        return fail(Error::Code::Io, "the disk with the sessions is full", "free some space on it");
    case SQLITE_READONLY:
        return fail(Error::Code::Io, "the sessions cannot be written: read-only",
                    "make the state folder and its disk writable");
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_AUTH:
        return fail(Error::Code::Io, "sessions.sqlite in the state folder cannot be opened",
                    "check that this user can read and write the folder and its files");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return fail(Error::Code::Io, "another program has sessions.sqlite open",
                    "close it, or give this server another folder with --state");
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
    case SQLITE_ERROR: // our statements are correct, so the tables are not ours
        return fail(Error::Code::Corrupt,
                    std::string("sessions.sqlite in the state folder is damaged: ") +
                        sqlite3_errstr(code & 0xff),
                    Database::way_out);
    case SQLITE_NOMEM:
        return fail(Error::Code::OverLimit, "there is not enough memory to write the sessions",
                    "give the server more");
    default:
        return fail(Error::Code::Io,
                    std::string("the disk with the sessions failed: ") + sqlite3_errstr(code),
                    "see the system's log");
    }
}

} // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

void Statement::bind(int at, std::string_view text) {
    sqlite3_bind_text64(statement_.get(), at, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8);
}

void Statement::bind(int at, std::int64_t number) {
    sqlite3_bind_int64(statement_.get(), at, number);
}

core::Result<bool> Statement::step() {
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW || code == SQLITE_DONE)
        return code == SQLITE_ROW;
    return failure(sqlite3_extended_errcode(sqlite3_db_handle(statement_.get())));
}

std::string Statement::text(int at) const {
    const auto* bytes =
        static_cast<const char*>(sqlite3_column_blob(statement_.get(), at)); // before its length
    return {bytes == nullptr ? "" : bytes,
            static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), at))};
}

std::int64_t Statement::number(int at) const {
    return sqlite3_column_int64(statement_.get(), at);
}

void Statement::reset() {
    sqlite3_reset(statement_.get());
    sqlite3_clear_bindings(statement_.get());
}

void Database::Close::operator()(sqlite3* database) const {
    sqlite3_close(database);
}

core::Result<Database> Database::open(const std::string& file, const char* vfs) {
    Database out;
    sqlite3* handle = nullptr;
    const int code =
        sqlite3_open_v2(file.c_str(), &handle,
                        SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, vfs);
    out.database_.reset(handle);
    if (code != SQLITE_OK)
        return failure(code);
    sqlite3_extended_result_codes(handle, 1);
    return out;
}

void Database::fold_log_on_close(bool fold) {
    sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, fold ? 0 : 1, nullptr);
}

core::Result<void> Database::copy_to(const std::string& file, const char* vfs) {
    auto copy = open(file, vfs);
    if (!copy)
        return tl::unexpected(copy.error());
    sqlite3_backup* const backup =
        sqlite3_backup_init(copy->database_.get(), "main", database_.get(), "main");
    if (backup == nullptr)
        return failure(sqlite3_extended_errcode(copy->database_.get()));
    const int stepped = sqlite3_backup_step(backup, -1);
    const int finished = sqlite3_backup_finish(backup);
    if (stepped != SQLITE_DONE)
        return failure(finished == SQLITE_OK ? stepped : finished);
    // Makes one file, without a log; this also syncs it.
    return copy->run("PRAGMA journal_mode=DELETE");
}

core::Result<void> Database::run(const char* statements) {
    const int code = sqlite3_exec(database_.get(), statements, nullptr, nullptr, nullptr);
    if (code != SQLITE_OK)
        return failure(code);
    return {};
}

core::Result<Statement> Database::prepare(const char* statement) {
    sqlite3_stmt* handle = nullptr;
    const int code = sqlite3_prepare_v2(database_.get(), statement, -1, &handle, nullptr);
    if (code != SQLITE_OK)
        return failure(code);
    return Statement(handle);
}

core::Result<Statement> Database::first_row(const char* query) {
    auto statement = prepare(query);
    if (!statement)
        return statement;
    const auto row = statement->step();
    if (!row)
        return tl::unexpected(row.error());
    if (!*row)
        return failure(SQLITE_CORRUPT);
    return statement;
}

core::Result<std::int64_t> Database::number(const char* query) {
    return first_row(query).map([](const Statement& row) { return row.number(0); });
}

core::Result<std::string> Database::text(const char* query) {
    return first_row(query).map([](const Statement& row) { return row.text(0); });
}

} // namespace wakesurf::server
