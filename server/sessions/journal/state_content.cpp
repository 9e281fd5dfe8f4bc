#include "server/sessions/journal/state_content.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace wakesurf::server {

using core::Error;

namespace {

std::string count_text(std::int64_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Sums up the findings in both ways: an altered digest is not a missing row, nor is an altered record.
struct Found {
    std::map<std::string, RowSum> as_written;
    std::map<std::string, RowSum> as_read;

    void add(const std::string& session, std::uint64_t written, std::uint64_t read) {
        for (const std::string& of : {session, std::string()}) {
            as_written[of].add(written);
            as_read[of].add(read);
        }
    }
};

void take_row(const Statement& row, std::int64_t now, StateContent& into, Found& found) {
    StoredKey key{row.text(0), row.text(1), row.text(2)};
    std::string json = row.text(3);
    const std::uint64_t read = row_digest(key, json);
    const auto written = static_cast<std::uint64_t>(row.number(4));
    found.add(key.session, written, read);
    if (written == read) {
        into.sessions[key.session].push_back({key.type, key.id, std::move(json)});
        into.digests.emplace(std::move(key), read);
        return;
    }
    const std::string why = key.type + (key.id.empty() ? "" : " " + key.id.substr(0, 64)) +
                            ": damaged on the disk: its checksum does not match";
    into.damaged.push_back({key.session, {key.type, key.id, why, now}, std::move(json)});
}

/// Returns an empty content of the file's layout.
core::Result<StateContent> of_layout(Database& database) {
    return layout_of(database).map([](int layout) {
        StateContent out;
        out.layout = layout;
        return out;
    });
}

core::Result<void> read_aside(Database& database, StateContent& into) {
    auto query =
        database.prepare("SELECT session, type, id, why, since, json FROM aside ORDER BY rowid");
    if (!query)
        return tl::unexpected(query.error());
    auto row = query->step();
    for (; row && *row; row = query->step())
        into.aside.push_back({query->text(0),
                              {query->text(1), query->text(2), query->text(3), query->number(4)},
                              query->text(5)});
    return row.map([](bool) {});
}

core::Result<void> read_head(Database& database, StateContent& into) {
    auto query = database.prepare("SELECT id, commits, writer FROM head");
    if (!query)
        return tl::unexpected(query.error());
    const auto row = query->step();
    if (!row)
        return tl::unexpected(row.error());
    if (*row)
        into.head = {query->number(0), query->number(1), query->text(2)};
    else
        into.faults.push_back("its head is missing");
    return {};
}

core::Result<std::map<std::string, RowSum>> read_sums(Database& database) {
    std::map<std::string, RowSum> sums;
    auto query = database.prepare("SELECT session, records, digest FROM sums");
    if (!query)
        return tl::unexpected(query.error());
    auto row = query->step();
    for (; row && *row; row = query->step())
        sums[query->text(0)] = {query->number(1), static_cast<std::uint64_t>(query->number(2))};
    if (!row)
        return tl::unexpected(row.error());
    return sums;
}

void compare_sums(const std::map<std::string, RowSum>& expected, Found& found, StateContent& into) {
    std::set<std::string> names;
    for (const auto& [name, sum] : expected)
        names.insert(name);
    for (const auto& [name, sum] : found.as_written)
        names.insert(name);
    for (const std::string& name : names) {
        const auto there = expected.find(name);
        const RowSum wanted = there == expected.end() ? RowSum{} : there->second;
        const RowSum& written = found.as_written[name];
        if (wanted == written || wanted == found.as_read[name])
            continue;
        const std::string of =
            name.empty() ? "of all sessions" : "of session `" + name.substr(0, 64) + "`";
        const std::int64_t gone = wanted.records - written.records;
        into.faults.push_back(gone > 0
                                  ? count_text(gone, "record") + " " + of +
                                        (gone == 1 ? " is" : " are") + " missing"
                                  : "the records " + of + " differ from those that were written");
    }
}

} // namespace

std::map<std::string, RowSum> StateContent::sums() const {
    std::map<std::string, RowSum> out;
    for (const auto& [key, digest] : digests) {
        out[key.session].add(digest);
        out[{}].add(digest);
    }
    return out;
}

core::Result<StateContent> read_content(Database& database, std::int64_t now) {
    auto begun = of_layout(database);
    if (!begun || begun->layout == 0)
        return begun;
    StateContent out = std::move(*begun);
    const auto verdict = database.text("PRAGMA integrity_check(1)");
    if (!verdict)
        return tl::unexpected(verdict.error());
    if (*verdict != "ok")
        out.faults.push_back("its structure is broken");
    auto query = database.prepare("SELECT session, type, id, json, digest FROM records");
    if (!query)
        return tl::unexpected(query.error());
    Found found;
    auto row = query->step();
    for (; row && *row; row = query->step())
        take_row(*query, now, out, found);
    if (!row)
        return tl::unexpected(row.error());
    const auto sums = read_sums(database);
    if (!sums)
        return tl::unexpected(sums.error());
    compare_sums(*sums, found, out);
    if (auto done = read_head(database, out); !done)
        return tl::unexpected(done.error());
    if (auto done = read_aside(database, out); !done)
        return tl::unexpected(done.error());
    return out;
}

Error damage_error(const StateContent& content) {
    std::string text = "sessions.sqlite in the state folder is damaged";
    for (std::size_t i = 0; i < std::min<std::size_t>(content.faults.size(), 3); ++i)
        text += (i == 0 ? ": " : "; ") + content.faults[i];
    return {Error::Code::Corrupt, std::move(text), Database::way_out};
}

// Reads rows by their numbers: this needs only the pages on the way to a row, so that those behind a broken
// page are reached.
core::Result<StateContent> salvage_content(Database& database, std::int64_t now) {
    auto begun = of_layout(database);
    if (!begun || begun->layout == 0)
        return begun;
    StateContent out = std::move(*begun);
    std::int64_t last = 0;
    for (const char* query : {"SELECT max(rowid) FROM records", "SELECT sum(records) FROM sums"})
        if (const auto number = database.number(query))
            last = std::max(last, *number);
    constexpr std::int64_t beyond = 100'000; // without the last page the largest number is unknown
    constexpr std::int64_t most = 100'000'000;
    last = std::min(last + beyond, most);
    Found found;
    auto query =
        database.prepare("SELECT session, type, id, json, digest FROM records WHERE rowid=?1");
    if (!query)
        return tl::unexpected(query.error());
    for (std::int64_t number = 1; number <= last; ++number) {
        query->reset();
        query->bind(1, number);
        if (const auto row = query->step(); row && *row)
            take_row(*query, now, out, found);
    }
    if (const auto sums = read_sums(database))
        compare_sums(*sums, found, out);
    else
        out.faults.push_back("the journal's record of what was saved is missing");
    if (!read_head(database, out) || !read_aside(database, out))
        out.faults.push_back("records kept aside cannot be read to the end");
    return out;
}

} // namespace wakesurf::server
