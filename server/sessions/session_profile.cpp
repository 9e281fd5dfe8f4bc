#include "server/sessions/session_profile.hpp"

#include "protocol/api/utc_text.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

namespace {

/// Is the least time between two writings of when a session was last edited; seconds.
constexpr std::int64_t coarse = 60;

std::int64_t time_of(const UnixTime& unix_time) {
    return std::clamp<std::int64_t>(unix_time(), 0, protocol::last_utc_second);
}

} // namespace

ProfileKeeper::ProfileKeeper(UnixTime unix_time) : unix_time_(std::move(unix_time)) {
    value_.created = value_.last_used = time_of(unix_time_);
}

void ProfileKeeper::restore(protocol::SessionProfile kept) {
    value_ = std::move(kept);
    kept_at_ = value_.last_used;
    changed_ = false;
}

void ProfileKeeper::arrived(protocol::SessionPerson person) {
    auto& people = value_.people;
    std::erase_if(people, [&](const auto& each) {
        return each.participant == person.participant || each.name == person.name;
    });
    people.insert(people.begin(), std::move(person));
    people.resize(std::min(people.size(), protocol::most_session_people));
    used();
}

void ProfileKeeper::used() {
    value_.last_used = time_of(unix_time_);
    changed_ = true;
}

void ProfileKeeper::edited() {
    value_.last_used = time_of(unix_time_);
    changed_ = changed_ || !value_.edited || value_.last_used - kept_at_ >= coarse;
    value_.edited = true;
}

void ProfileKeeper::made_on_purpose() {
    changed_ = changed_ || !value_.on_purpose;
    value_.on_purpose = true;
}

void ProfileKeeper::copied(const std::string& session, const std::string& name) {
    value_.copy_of = session;
    value_.copy_name = name;
    changed_ = true;
}

void ProfileKeeper::deleted(std::optional<std::int64_t> when) {
    changed_ = changed_ || value_.deleted != when;
    value_.deleted = when;
}

std::string ProfileKeeper::data(const std::string& dataset) const {
    const auto found = value_.data.find(dataset);
    return found == value_.data.end() ? std::string() : found->second;
}

void ProfileKeeper::set_data(const std::string& dataset, std::string values) {
    if (value_.data.size() >= protocol::most_session_datasets && !value_.data.contains(dataset))
        value_.data.erase(value_.data.begin());
    value_.data[dataset] = std::move(values);
    changed_ = true;
}

std::optional<JournalEntry> ProfileKeeper::due() {
    if (!std::exchange(changed_, false))
        return std::nullopt;
    kept_at_ = value_.last_used;
    return entry();
}

JournalEntry ProfileKeeper::entry() const {
    return {"profile", "", protocol::record_text(value_)};
}

} // namespace wakesurf::server
