#include "server/sessions/people/participants.hpp"

#include "core/base/plain_text.hpp"
#include "server/base/limits.hpp"
#include "server/base/numbered_id.hpp"
#include "server/sessions/records/colours.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace wakesurf::server {

std::string free_name(const std::string& name,
                      std::size_t longest,
                      const std::function<bool(const std::string&)>& taken) {
    std::string candidate = name;
    for (std::size_t number = 2; taken(candidate); ++number) {
        const std::string suffix = " " + std::to_string(number);
        candidate = core::display_name(name, longest - suffix.size()) + suffix;
    }
    return candidate;
}

using core::Error;
using core::fail;
namespace member = protocol::member;

namespace {

protocol::ParticipantRecord record_of(const Participant& place) {
    return {place.id,
            place.name,
            place.colour,
            std::string(name(place.role)),
            place.observer != nullptr,
            place.presence};
}

bool opens(const SecretDigest& token, const Participant& place) {
    return same_digest(place.token, token) || (place.former && same_digest(*place.former, token));
}

/// Takes over a value where it was given and is another; the bit of what changed.
template <class T>
unsigned take(std::optional<T>& mine, const protocol::Nullable<T>& now, unsigned bit) {
    if (!now.given || mine == now.value)
        return 0;
    mine = now.value;
    return bit;
}

} // namespace

Participants::Participants(
    std::string session, Loop& loop, Entropy& entropy, Journal* journal, UnixTime unix_time)
    : session_(std::move(session)), loop_(loop), entropy_(entropy), journal_(journal),
      unix_time_(std::move(unix_time)),
      events_(
          loop,
          [this] {
              const std::size_t told = std::max<std::size_t>(present_.size(), 1);
              return std::max<std::size_t>(limits::presence_entries / told, 1);
          },
          [this](const PresenceEvents::Batch& batch) { return tell(batch); }) {}

core::Result<Joined> Participants::join(const Arrival& arrival, Observer& observer) {
    const SecretDigest token = secret_digest(arrival.resume_token);
    const auto same = [&](const Participant& each) { return opens(token, each); };
    if (const Participant* mine = find(observer); mine != nullptr && !same(*mine))
        leave(observer);
    const bool here = std::any_of(present_.begin(), present_.end(), same);
    const std::size_t most =
        limits::participants - (arrival.identity.grant.empty() ? 0 : limits::for_hosts.sockets);
    if (!here && present_.size() >= most)
        return core::over_limit(most, "the session has reached its limit of participants",
                                "wait until someone leaves, or create another session");
    Joined joined{take_place(token), arrival.resume_token, false};
    Participant& place = joined.you;
    joined.returned = !place.id.empty();
    joined.same_life = joined.returned && !place.restored && same_digest(place.token, token);
    if (joined.same_life)
        place.former.reset(); // it has got the new one
    else if (joined.returned)
        joined.resume_token = renew_token(place, token);
    if (place.id.empty()) {
        joined.resume_token = random_hex(entropy_, 16);
        place.token = secret_digest(joined.resume_token);
        place.id = "p" + std::to_string(next_++);
        place.name = "guest " + place.id.substr(1);
        place.colour = free_colour();
    }
    // The role of a place is for the person who came by that link, not for another that learnt the resume
    // token.
    if (!joined.returned || place.grant != arrival.identity.grant) {
        place.role = arrival.identity.role;
        place.role_set = false;
    }
    place.grant = arrival.identity.grant;
    const std::string wanted = core::display_name(arrival.name, limits::name_bytes);
    place.name = free_name(wanted.empty() ? place.name : wanted, limits::name_bytes,
                           [this](const std::string& each) { return taken(each); });
    if (!arrival.colour.empty())
        place.colour = arrival.colour;
    Observer* const before = std::exchange(place.observer, &observer);
    present_.push_back(place);
    keep(place);
    if (before != nullptr && before != &observer)
        before->sent_away(Farewell::Displaced);
    events_.changed(place.id, member::person | protocol::said(place.presence));
    return joined;
}

/// Clients know by it that what they remember was told by another life of the server.
std::string Participants::renew_token(Participant& place, const SecretDigest& shown) {
    std::string token = random_hex(entropy_, 16);
    place.former = shown;
    place.token = secret_digest(token);
    place.restored = false;
    return token;
}

/// Takes it out of the lists; returns a place without an id where there is none.
Participant Participants::take_place(const SecretDigest& token) {
    Participant place;
    const auto same = [&](const Participant& each) { return opens(token, each); };
    if (const auto here = std::find_if(present_.begin(), present_.end(), same);
        here != present_.end()) {
        place = std::move(*here);
        present_.erase(here);
    }
    const auto away = std::find_if(absent_.begin(), absent_.end(),
                                   [&](const Absent& each) { return same(each.place); });
    if (away != absent_.end()) {
        place = std::move(away->place);
        absent_.erase(away);
    }
    return place;
}

bool Participants::taken(const std::string& name) const {
    return std::any_of(present_.begin(), present_.end(),
                       [&](const Participant& each) { return each.name == name; }) ||
           std::any_of(absent_.begin(), absent_.end(),
                       [&](const Absent& each) { return each.shown && each.place.name == name; });
}

/// Returns the colour of the palette that the fewest have.
std::string Participants::free_colour() const {
    ColourCount count;
    for (const Participant& each : present_)
        count.add(each.colour);
    for (const Absent& each : absent_)
        if (each.shown)
            count.add(each.place.colour);
    return count.rarest();
}

/// Returns null where the participant is not connected here.
std::optional<Participant> Participants::take_out(const Observer& observer) {
    const auto found = std::find_if(present_.begin(), present_.end(), [&](const Participant& each) {
        return each.observer == &observer;
    });
    if (found == present_.end())
        return std::nullopt;
    Participant place = std::move(*found);
    present_.erase(found);
    return place;
}

void Participants::leave(const Observer& observer) {
    auto place = take_out(observer);
    if (!place)
        return;
    const std::string id = place->id;
    const std::int64_t now = unix_time_();
    keep(*place, now);
    put_away(std::move(*place), now, false);
    events_.left(id);
}

void Participants::lose(const Observer& observer) {
    auto place = take_out(observer);
    if (!place)
        return;
    const std::string id = place->id;
    const std::int64_t now = unix_time_();
    keep(*place, now);
    put_away(std::move(*place), now, true);
    events_.changed(id, member::connected);
}

void Participants::put_away(Participant place, std::int64_t left, bool show) {
    place.observer = nullptr;
    if (!show)
        place.presence = {};
    Absent absent{std::move(place), left, nullptr};
    if (show)
        absent.shown = loop_.after(limits::absence, [this, id = absent.place.id] { hide(id); });
    const auto later = std::find_if(absent_.rbegin(), absent_.rend(),
                                    [&](const Absent& each) { return each.left <= left; });
    absent_.insert(later.base(), std::move(absent));
    trim();
}

void Participants::hide(const std::string& id) {
    const auto found = std::find_if(absent_.begin(), absent_.end(),
                                    [&](const Absent& each) { return each.place.id == id; });
    if (found == absent_.end() || !found->shown)
        return;
    found->shown.reset();
    found->place.presence = {};
    events_.left(id);
}

/// Forgets participants who left too long ago, and of too many the oldest of the link by which most came,
/// first of those who are not listed any more: one link cannot take the places of others.
void Participants::trim() {
    const std::int64_t expired = unix_time_() - limits::place_kept.count();
    while (!absent_.empty() && absent_.front().left < expired)
        forget(absent_.begin());
    while (absent_.size() > limits::participants) {
        std::map<std::string_view, std::size_t> count;
        for (const Absent& each : absent_)
            ++count[each.place.grant];
        const auto most =
            std::max_element(count.begin(), count.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        const auto oldest = [&](bool shown_too) {
            return std::find_if(absent_.begin(), absent_.end(), [&](const Absent& each) {
                return each.place.grant == most->first && (shown_too || !each.shown);
            });
        };
        const auto hidden = oldest(false);
        forget(hidden == absent_.end() ? oldest(true) : hidden);
    }
}

void Participants::forget(std::deque<Absent>::iterator going) {
    const Absent gone = std::move(*going);
    absent_.erase(going);
    strike(gone.place);
    if (gone.shown)
        events_.left(gone.place.id);
}

void Participants::update(const Observer& observer, const protocol::PresenceUpdate& now) {
    for (Participant& each : present_) {
        if (each.observer != &observer)
            continue;
        protocol::Presence& mine = each.presence;
        const unsigned changed = take(mine.pointer, now.pointer, member::pointer) |
                                 take(mine.camera, now.camera, member::camera) |
                                 take(mine.dragging, now.dragging, member::dragging) |
                                 take(mine.selected, now.selected, member::selected);
        if (changed != 0)
            events_.changed(each.id, changed);
        return;
    }
}

const Participant* Participants::find(const Observer& observer) const {
    for (const Participant& each : present_)
        if (each.observer == &observer)
            return &each;
    return nullptr;
}

core::Result<Participant> Participants::find(const std::string& id) const {
    for (const Participant& each : present_)
        if (each.id == id)
            return each;
    for (const Absent& each : absent_)
        if (each.place.id == id)
            return each.place;
    return fail(Error::Code::NotFound, "the session has no participant `" + id.substr(0, 64) + "`",
                "`session.state` lists them");
}

const Participant* Participants::visible(const std::string& id) const {
    for (const Participant& each : present_)
        if (each.id == id)
            return &each;
    for (const Absent& each : absent_)
        if (each.shown && each.place.id == id)
            return &each.place;
    return nullptr;
}

Participant* Participants::known(const std::string& id) {
    for (Participant& each : present_)
        if (each.id == id)
            return &each;
    for (Absent& each : absent_)
        if (each.place.id == id)
            return &each.place;
    return nullptr;
}

void Participants::set_role(const std::string& id, Role role) {
    Participant* const place = known(id);
    place->role = role;
    place->role_set = true;
    const auto away = std::find_if(absent_.begin(), absent_.end(),
                                   [&](const Absent& each) { return each.place.id == id; });
    keep(*place, away == absent_.end() ? std::nullopt : std::optional(away->left));
    if (visible(id) != nullptr)
        events_.changed(id, member::role);
    // The one thing about oneself that others decide.
    if (place->observer != nullptr)
        place->observer->presence(protocol::presence_patched(
            session_, std::array{protocol::participant_text(record_of(*place), member::role)}, {}));
}

void Participants::remove(const std::string& id) {
    const Participant place = take_place(known(id)->token);
    strike(place);
    events_.left(id);
    if (place.observer != nullptr)
        place.observer->sent_away(Farewell::Removed);
}

std::vector<protocol::ParticipantRecord> Participants::shown() const {
    std::vector<protocol::ParticipantRecord> out;
    for (const Absent& each : absent_)
        if (each.shown)
            out.push_back(record_of(each.place));
    for (const Participant& each : present_)
        out.push_back(record_of(each));
    return out;
}

/// A participant is not told of itself here.
std::size_t Participants::tell(const PresenceEvents::Batch& batch) const {
    std::vector<std::string> ids;
    std::vector<std::string> entries;
    for (const auto& [id, members] : batch.changed)
        if (const Participant* place = visible(id)) {
            ids.push_back(id);
            entries.push_back(protocol::participant_text(record_of(*place), members));
        }
    std::string for_all;
    std::size_t bytes = 0;
    for (const Participant& each : present_) {
        const auto own = std::find(ids.begin(), ids.end(), each.id);
        if (own == ids.end()) {
            if (for_all.empty())
                for_all = protocol::presence_patched(session_, entries, batch.left);
            each.observer->presence(for_all);
            bytes += for_all.size();
        } else if (entries.size() > 1 || !batch.left.empty()) {
            auto others = entries;
            others.erase(others.begin() + (own - ids.begin()));
            const std::string message = protocol::presence_patched(session_, others, batch.left);
            each.observer->presence(message);
            bytes += message.size();
        }
    }
    return bytes;
}

JournalEntry Participants::entry_of(const Participant& place, std::optional<std::int64_t> left) {
    return {"participant", place.id,
            protocol::record_text(protocol::MembershipRecord{
                place.name, place.colour, std::string(name(place.role)), place.grant,
                digest_text(place.token), place.role_set, left,
                place.former ? digest_text(*place.former) : std::string()})};
}

void Participants::keep(const Participant& place, std::optional<std::int64_t> left) {
    if (journal_ != nullptr)
        journal_->write(session_, {entry_of(place, left)});
}

std::vector<JournalEntry> Participants::entries() const {
    std::vector<JournalEntry> out;
    for (const Participant& each : present_)
        out.push_back(entry_of(each, std::nullopt));
    for (const Absent& each : absent_)
        out.push_back(entry_of(each.place, each.left));
    return out;
}

void Participants::end() {
    journal_ = nullptr;
    for (const Participant& each : std::exchange(present_, {}))
        each.observer->sent_away(Farewell::Deleted);
}

void Participants::strike(const Participant& place) {
    if (journal_ != nullptr)
        journal_->write(session_, {{"participant", place.id, std::nullopt}});
}

core::Result<void> Participants::restore(const std::string& id, std::string_view record) {
    const auto kept = protocol::parse_membership(record);
    if (!kept)
        return tl::unexpected(kept.error());
    const auto role = role_named(kept->role);
    const auto token = read_digest(kept->digest);
    const auto number = number_of(id, "p");
    const auto former = kept->former.empty() ? std::nullopt : read_digest(kept->former);
    if (!role || !token || !number || !is_colour(kept->colour) ||
        former.has_value() == kept->former.empty())
        return fail(Error::Code::Corrupt, "a saved participant is damaged",
                    "join the session again");
    next_ = std::max(next_, *number + 1);
    Participant place;
    place.id = id;
    place.name = core::display_name(kept->name, limits::name_bytes);
    place.colour = kept->colour;
    place.role = *role;
    place.grant = kept->grant;
    place.role_set = kept->role_set;
    place.token = *token;
    place.former = former;
    place.restored = true;
    const std::int64_t left = kept->left.value_or(unix_time_());
    if (!kept->left) // connected when the server ended: when it went is not known, so it counts from now
        keep(place, left);
    put_away(std::move(place), left, false);
    return {};
}

} // namespace wakesurf::server
