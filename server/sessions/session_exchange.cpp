#include "server/sessions/session_exchange.hpp"

#include "core/base/plain_text.hpp"
#include "protocol/api/utc_text.hpp"
#include "server/base/limits.hpp"
#include "server/base/secret.hpp"
#include "server/sessions/people/grants.hpp"
#include "server/sessions/records/record_room.hpp"
#include "server/sessions/session_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace wakesurf::server {

namespace {

void restore_links(const std::string& id,
                   const std::vector<JournalEntry>& entries,
                   Grants& grants,
                   std::vector<RefusedEntry>& refused) {
    for (const JournalEntry& each : entries)
        if (each.type == "grant" && each.record)
            if (auto done = grants.restore(id, each.id, *each.record); !done)
                refused.push_back(refused_entry(each, std::move(done.error())));
}

} // namespace

RestoredSessions restore_sessions(const std::map<std::string, std::vector<JournalEntry>>& kept,
                                  SessionDirectory& sessions,
                                  Grants& grants) {
    RestoredSessions out;
    for (const auto& [id, entries] : kept) {
        const RestoreReport report = sessions.restore(id, id, entries);
        ++out.sessions;
        out.records += report.restored;
        std::vector<RefusedEntry> refused;
        restore_links(id, entries, grants, refused);
        if (sessions.trash().find(id) != nullptr)
            grants.suspend(id); // what of it cannot be used is put aside once it is brought back
        const auto session = sessions.find(id);
        if (!session)
            continue;
        (*session)->set_aside(refused);
        for (const KeptAside& each : (*session)->kept_aside())
            out.refused.push_back({id, each});
    }
    return out;
}

using core::Error;
using core::fail;

namespace {

/// Writes what the fingerprint covers: coordinates to single precision, so that a store of either precision
/// has the same.
std::string identity_of(const core::DatasetInfo& info) {
    const auto& [lo, hi] = info.bounds;
    std::string out = fmt::format("{} {} {} {} {} {} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {}",
                                  static_cast<int>(info.grid), info.dimensions[0],
                                  info.dimensions[1], info.dimensions[2], info.points, info.cells,
                                  lo.x, lo.y, lo.z, hi.x, hi.y, hi.z, info.velocity);
    if (info.grid == core::GridKind::Analytic)
        out += " " + info.name;
    for (const core::FieldInfo& each : info.fields)
        if (!each.kept()) // it can be made of the same data again
            out += fmt::format(";{}:{}", each.name, each.components);
    return out;
}

/// Marks a dataset so that it is told from others of its name: by mesh and fields, and by its values, of
/// which a growing simulation changes none.
protocol::DatasetMark mark_of(const OpenDataset& dataset) {
    const core::DatasetInfo& info = dataset.info;
    protocol::DatasetMark mark;
    mark.dataset = info.dataset;
    mark.name = info.name;
    mark.fingerprint = digest_text(secret_digest(identity_of(info)));
    if (dataset.store != nullptr)
        mark.values = dataset.store->values();
    mark.steps = info.times.size();
    if (!info.times.empty()) {
        mark.first = info.times.front();
        mark.last = info.times.back();
    }
    mark.bounds = info.bounds;
    return mark;
}

std::string list_of(const std::set<std::string>& ids) {
    std::string out;
    for (const std::string& each : ids)
        out += (out.empty() ? "" : ", ") + each;
    return out;
}

std::map<std::string, std::set<std::string>> surfaces_by_dataset(const SessionRecords& records) {
    std::map<std::string, std::set<std::string>> out;
    for (const auto& [id, surface] : records.all<protocol::SurfaceRecord>())
        for (const auto& dataset :
             {std::optional(surface.dataset), surface.twin ? surface.twin->dataset : std::nullopt})
            if (dataset)
                out[*dataset].insert(id);
    return out;
}

/// A file is untrusted input, even if it looks like one of ours.
core::Error as_input(core::Error error) {
    if (error.code == Error::Code::Corrupt)
        error.code = Error::Code::InvalidArgument;
    return error;
}

} // namespace

SessionSnapshot snapshot_of(const Session& session, const Datasets& datasets, std::int64_t now) {
    SessionSnapshot out{session.name(), session.records(), session.clock().record(), {}, now,
                        session.units()};
    out.clock.playing = false;
    for (const auto& [id, surfaces] : surfaces_by_dataset(out.records)) {
        const auto open = datasets.open(id);
        out.datasets.push_back(open ? mark_of(*open) : protocol::DatasetMark{});
        out.datasets.back().dataset = id;
    }
    return out;
}

protocol::SessionFile file_of(const SessionSnapshot& snapshot) {
    protocol::SessionFile file;
    file.name = snapshot.name;
    file.units = snapshot.units;
    file.exported =
        protocol::utc_text(std::clamp<std::int64_t>(snapshot.taken, 0, protocol::last_utc_second));
    file.wakesurf = WAKESURF_VERSION;
    file.datasets = snapshot.datasets;
    for (const Record& each : snapshot.records.list()) {
        JournalEntry entry = entry_of(each);
        file.records.push_back({std::move(entry.type), std::move(entry.id), *entry.record});
    }
    file.records.push_back({"clock", "", *entry_of(snapshot.clock).record});
    return file;
}

core::Result<ReadSession> read_session_text(std::string_view text) {
    auto file = protocol::read_session_file(text, limits::session_file_bytes);
    if (!file && file.error().code == Error::Code::OverLimit) // asking again is of no use
        return fail(Error::Code::InvalidArgument, file.error().message,
                    "give the file of an exported session");
    if (!file)
        return tl::unexpected(as_input(file.error()));
    std::vector<JournalEntry> entries;
    for (protocol::FileRecord& each : file->records)
        entries.push_back({std::move(each.type), std::move(each.id), std::move(each.text)});
    ReadSession out{read_entries(entries), std::move(file->datasets)};
    if (!out.records.report.refused.empty())
        return tl::unexpected(as_input(std::move(out.records.report.refused.front().error)));
    if (auto room = room_in_session(out.records.records.bytes()); !room)
        return tl::unexpected(room.error());
    out.records.name = core::display_name(file->name, limits::name_bytes);
    out.records.units = {core::display_name(file->units.length, limits::unit_bytes),
                         core::display_name(file->units.time, limits::unit_bytes)};
    return out;
}

std::vector<std::string> dataset_notes(const ReadSession& read, const Datasets& datasets) {
    std::vector<std::string> notes;
    for (const auto& [id, surfaces] : surfaces_by_dataset(read.records.records)) {
        const auto open = datasets.open(id);
        const auto listed =
            std::find_if(read.datasets.begin(), read.datasets.end(),
                         [&key = id](const auto& each) { return each.dataset == key; });
        const protocol::DatasetMark theirs =
            listed == read.datasets.end() ? protocol::DatasetMark{} : *listed;
        const std::string known =
            theirs.name.empty() || theirs.name == id
                ? id
                : id + " (" + core::display_name(theirs.name, limits::name_bytes) + ")";
        if (!open) {
            notes.push_back("there is no dataset " + known + " that can be used here now: " +
                            list_of(surfaces) + " will be built when there is one");
            continue;
        }
        const protocol::DatasetMark ours = mark_of(*open);
        if (!theirs.fingerprint.empty() && theirs.fingerprint != ours.fingerprint)
            notes.push_back("the dataset " + known +
                            " here has another mesh or other fields than the one the session was "
                            "made with: " +
                            list_of(surfaces) + " may look different");
        else if (open->store != nullptr && open->store->contradicts(theirs.values))
            notes.push_back("the dataset " + known +
                            " here has other values than the one the session was made with: " +
                            list_of(surfaces) + " may look different");
        else if (theirs.steps != 0 && theirs.steps != ours.steps)
            notes.push_back("the dataset " + known + " here has " + std::to_string(ours.steps) +
                            " time-steps, not " + std::to_string(theirs.steps));
    }
    return notes;
}

} // namespace wakesurf::server
