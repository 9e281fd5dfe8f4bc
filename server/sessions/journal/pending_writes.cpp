#include "server/sessions/journal/pending_writes.hpp"

#include <utility>

namespace wakesurf::server {

namespace {

template <class Records>
void erase_session(Records& records, const std::string& session) {
    const auto first = records.lower_bound(StoredKey{session, {}, {}});
    auto last = first;
    while (last != records.end() && last->first.session == session)
        ++last;
    records.erase(first, last);
}

} // namespace

void PendingWrites::write(const std::string& session, std::vector<JournalEntry> entries) {
    for (JournalEntry& each : entries)
        records[{session, std::move(each.type), std::move(each.id)}] = std::move(each.record);
}

void PendingWrites::set_aside(const std::string& session, std::vector<KeptAside> refused) {
    for (KeptAside& each : refused) {
        StoredKey key{session, each.type, each.id};
        aside.insert_or_assign(std::move(key), std::move(each));
    }
}

void PendingWrites::remove(const std::string& session) {
    erase_session(records, session);
    erase_session(aside, session);
    removed.insert(session);
}

void PendingWrites::follow(PendingWrites older) {
    for (const std::string& session : removed) {
        erase_session(older.records, session);
        erase_session(older.aside, session);
    }
    records.merge(older.records); // present records are newer
    aside.merge(older.aside);
    removed.merge(older.removed);
}

void PendingWrites::drop_needless(const std::map<StoredKey, std::uint64_t>& stored) {
    std::erase_if(records,
                  [&](const auto& each) { return !each.second && !stored.contains(each.first); });
}

} // namespace wakesurf::server
