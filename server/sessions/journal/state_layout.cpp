#include "server/sessions/journal/state_layout.hpp"

#include "server/base/secret.hpp"

#include <cstddef>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

constexpr std::int64_t application = 0x77616b65; // `wake`

constexpr const char* tables =
    "CREATE TABLE records(session TEXT NOT NULL, type TEXT NOT NULL, id TEXT NOT NULL,"
    " json TEXT NOT NULL, digest INTEGER NOT NULL, PRIMARY KEY(session, type, id));"
    "CREATE TABLE aside(session TEXT NOT NULL, type TEXT NOT NULL, id TEXT NOT NULL,"
    " json TEXT NOT NULL, why TEXT NOT NULL, since INTEGER NOT NULL);"
    "CREATE INDEX aside_sessions ON aside(session);"
    "CREATE TABLE sums(session TEXT NOT NULL PRIMARY KEY, records INTEGER NOT NULL,"
    " digest INTEGER NOT NULL);"
    "CREATE TABLE head(id INTEGER NOT NULL, commits INTEGER NOT NULL, writer TEXT NOT NULL);"
    "INSERT INTO head VALUES(0, 0, '');";

core::Result<void> once(core::Result<Statement>& statement) {
    if (!statement)
        return tl::unexpected(statement.error());
    return statement->step().map([](bool) {});
}

} // namespace

std::uint64_t row_digest(const StoredKey& key, std::string_view json) {
    std::string text;
    text.reserve(key.session.size() + key.type.size() + key.id.size() + json.size() + 32);
    for (const std::string_view part : {std::string_view(key.session), std::string_view(key.type),
                                        std::string_view(key.id), json}) {
        text += std::to_string(part.size());
        text += ':';
        text += part;
    }
    const SecretDigest digest = secret_digest(text);
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < sizeof out; ++i)
        out = out << 8 | std::to_integer<std::uint64_t>(digest[i]);
    return out;
}

core::Result<int> layout_of(Database& database) {
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
        return 0;
    if (*owner != application)
        return fail(Error::Code::Unsupported,
                    "sessions.sqlite in the state folder was not made by wakesurf",
                    "give another folder with --state");
    if (*version != state_layout)
        return fail(Error::Code::Unsupported,
                    "sessions.sqlite in the state folder has layout " + std::to_string(*version) +
                        ", this wakesurf reads " + std::to_string(state_layout),
                    "use the wakesurf that wrote it, put back an older copy with "
                    "`wakesurf state restore`, or give another folder with --state");
    return static_cast<int>(*version);
}

core::Result<void> make_tables(Database& database, const StateHead& head) {
    const std::string script = std::string("BEGIN IMMEDIATE;") + tables +
                               "PRAGMA application_id=" + std::to_string(application) +
                               ";PRAGMA user_version=" + std::to_string(state_layout);
    return database.run(script.c_str())
        .and_then([&] { return put_head(database, head); })
        .and_then([&] { return database.run("COMMIT"); });
}

core::Result<void>
put_row(Database& database, const StoredKey& key, const std::string& json, std::uint64_t digest) {
    auto put =
        database.prepare("INSERT INTO records VALUES(?1, ?2, ?3, ?4, ?5)"
                         " ON CONFLICT DO UPDATE SET json=excluded.json, digest=excluded.digest");
    if (put) {
        put->bind(1, key.session);
        put->bind(2, key.type);
        put->bind(3, key.id);
        put->bind(4, json);
        put->bind(5, static_cast<std::int64_t>(digest));
    }
    return once(put);
}

core::Result<void> put_aside(Database& database, const AsideRow& row) {
    auto put = database.prepare("INSERT INTO aside VALUES(?1, ?2, ?3, ?4, ?5, ?6)");
    if (put) {
        put->bind(1, row.session);
        put->bind(2, row.label.type);
        put->bind(3, row.label.id);
        put->bind(4, row.json);
        put->bind(5, row.label.why);
        put->bind(6, row.label.since);
    }
    return once(put);
}

core::Result<void> put_sum(Database& database, const std::string& session, const RowSum& sum) {
    auto put = database.prepare(
        sum.records == 0 && !session.empty()
            ? "DELETE FROM sums WHERE session=?1"
            : "INSERT INTO sums VALUES(?1, ?2, ?3)"
              " ON CONFLICT DO UPDATE SET records=excluded.records, digest=excluded.digest");
    if (put) {
        put->bind(1, session);
        put->bind(2, sum.records);
        put->bind(3, static_cast<std::int64_t>(sum.digest));
    }
    return once(put);
}

core::Result<void> put_head(Database& database, const StateHead& head) {
    auto put = database.prepare("UPDATE head SET id=?1, commits=?2, writer=?3");
    if (put) {
        put->bind(1, head.id);
        put->bind(2, head.commits);
        put->bind(3, head.writer);
    }
    return once(put);
}

} // namespace wakesurf::server
