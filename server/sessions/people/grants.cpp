#include "server/sessions/people/grants.hpp"

#include "server/base/limits.hpp"
#include "server/base/numbered_id.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

// Timers stand still while the machine sleeps, and the clock does not.
constexpr std::chrono::milliseconds longest_wait = std::chrono::minutes(1);

} // namespace

Role Grant::newcomers() const {
    Role least = role;
    for (const auto& [participant, set] : lowered)
        least = std::min(least, set);
    return least;
}

Grants::Grants(GrantServices services) : services_(std::move(services)) {}

core::Result<Grants::Made> Grants::make(const std::string& session,
                                        Role role,
                                        std::optional<std::chrono::seconds> expires_in,
                                        const LinkMaker& maker) {
    if (of(session).size() >= limits::grants)
        return core::over_limit(limits::grants,
                                "a session may have at most " + std::to_string(limits::grants) +
                                    " share links",
                                "revoke some with `session.unshare`");
    const auto longest = longest_of(maker.grant);
    if (longest && (!expires_in || *expires_in > *longest))
        return fail(Error::Code::InvalidArgument,
                    "`expiresIn` must be at most " + std::to_string(longest->count()) +
                        ": a link cannot outlive the link that made it",
                    "leave it out, and the new link ends with yours");
    Grant link{{}, session, role};
    if (const Grant* parent = grant(maker.grant))
        link.copier = parent->copier; // a copy's links count for its maker
    return add(std::move(link), expires_in, maker);
}

core::Result<Grants::Made> Grants::make_for_copy(const std::string& copy, const LinkMaker& by) {
    const Grant* const parent = grant(by.grant);
    Grant link{{}, copy, Role::Editor};
    link.copier = parent != nullptr && !parent->copier.empty() ? parent->copier : by.grant;
    return add(std::move(link), longest_of(by.grant), by);
}

core::Result<Grants::Made>
Grants::add(Grant link, std::optional<std::chrono::seconds> expires_in, const LinkMaker& maker) {
    if (const Grant* parent = grant(maker.grant)) {
        link.lineage = parent->lineage;
        link.lineage.push_back(parent->id);
    }
    if (link.lineage.size() > limits::grant_depth)
        return core::over_limit(limits::grant_depth,
                                "a chain of links, each made by the one before, may have at most " +
                                    std::to_string(limits::grant_depth),
                                "ask someone with the server's token for one");
    std::string key = random_hex(services_.entropy, 32);
    const std::uint64_t number = next_++;
    link.id = "g" + std::to_string(number);
    link.maker = maker.name;
    Entry& entry = entries_[link.id];
    entry.grant = std::move(link);
    entry.digest = secret_digest(key);
    entry.number = number;
    if (expires_in) {
        entry.grant.expires = services_.wall_clock() + expires_in->count();
        entry.end = services_.clock.now() + *expires_in;
    }
    keep(entry);
    schedule();
    return Made{entry.grant, std::move(key)};
}

/// Lists those in force, oldest first.
template <class Fits>
std::vector<Grant> Grants::those(Fits fits) const {
    std::vector<const Entry*> found;
    for (const auto& [id, entry] : entries_)
        if (in_force(entry) && fits(entry.grant))
            found.push_back(&entry);
    std::sort(found.begin(), found.end(),
              [](const Entry* a, const Entry* b) { return a->number < b->number; });
    std::vector<Grant> out;
    for (const Entry* each : found)
        out.push_back(each->grant);
    return out;
}

std::vector<Grant> Grants::of(const std::string& session) const {
    return those([&](const Grant& each) { return each.session == session; });
}

std::vector<Grant> Grants::copies(const std::string& id) const {
    return those([&](const Grant& each) {
        return !each.copier.empty() && (id.empty() || each.copier == id);
    });
}

std::vector<Grant> Grants::descendants(const std::string& id) const {
    return those([&](const Grant& each) {
        return std::find(each.lineage.begin(), each.lineage.end(), id) != each.lineage.end();
    });
}

std::optional<std::chrono::seconds> Grants::longest_of(const std::string& grant) const {
    const auto found = entries_.find(grant);
    if (found == entries_.end() || !found->second.end)
        return std::nullopt;
    const auto left =
        std::chrono::floor<std::chrono::seconds>(*found->second.end - services_.clock.now());
    return std::max(left, std::chrono::seconds(1));
}

core::Result<void>
Grants::revoke(const std::string& session, const std::string& id, bool children) {
    const auto found = entries_.find(id);
    if (found == entries_.end() || found->second.grant.session != session)
        return fail(Error::Code::NotFound,
                    "the session has no share link `" + id.substr(0, 64) + "`",
                    "`session.shares` lists them");
    const char* const reason = "the share link was revoked";
    for (const Grant& each : descendants(id))
        if (children || each.copier == id)
            end(each.id, reason);
    end(id, reason);
    return {};
}

std::size_t Grants::end_all(const std::string& reason) {
    std::size_t count = 0;
    while (!entries_.empty()) {
        count += expired(entries_.begin()->second) ? 0 : 1;
        end(entries_.begin()->first, reason);
    }
    schedule();
    return count;
}

void Grants::seat(const std::string& id,
                  const std::string& participant,
                  const std::string& person) {
    const auto found = entries_.find(id);
    if (found == entries_.end() || person.empty())
        return;
    auto& people = found->second.people;
    if (people.size() >= limits::seated && !people.contains(participant)) {
        const auto spare = std::find_if(people.begin(), people.end(), [&](const auto& each) {
            return !found->second.grant.lowered.contains(each.first);
        });
        people.erase(spare);
    }
    people[participant] = person;
}

std::vector<std::string> Grants::others_of(const std::string& id,
                                           const std::string& participant) const {
    std::vector<std::string> out;
    const auto found = entries_.find(id);
    if (found == entries_.end() || !found->second.people.contains(participant))
        return out;
    const auto& people = found->second.people;
    for (const auto& [other, person] : people)
        if (other != participant && person == people.at(participant))
            out.push_back(other);
    return out;
}

std::optional<Role> Grants::least_of(const std::string& id, const std::string& person) const {
    std::optional<Role> least;
    const auto found = entries_.find(id);
    if (found == entries_.end())
        return least;
    for (const auto& [participant, role] : found->second.grant.lowered)
        if (const auto who = found->second.people.find(participant);
            who != found->second.people.end() && who->second == person)
            least = std::min(least.value_or(role), role);
    return least;
}

void Grants::set_role(const std::string& id, const std::string& participant, Role role) {
    const auto found = entries_.find(id);
    if (found == entries_.end())
        return;
    Grant& grant = found->second.grant;
    if (role >= grant.role) {
        grant.lowered.erase(participant);
        for (const std::string& other : others_of(id, participant))
            grant.lowered.erase(other);
    } else if (grant.lowered.contains(participant) || grant.lowered.size() < limits::lowered)
        grant.lowered[participant] = role;
    else // it stays lowered as long as there is this link
        grant.lowered[std::string()] = std::min(grant.newcomers(), role);
    keep(found->second);
}

std::optional<Identity> Grants::find(std::string_view key) const {
    const SecretDigest digest = secret_digest(key);
    const Entry* match = nullptr;
    for (const auto& [id, entry] : entries_)
        if (same_digest(entry.digest, digest))
            match = &entry;
    if (match == nullptr || !in_force(*match))
        return std::nullopt;
    return identity(match->grant.id);
}

std::optional<Identity> Grants::identity(const std::string& id) const {
    const Grant* const link = grant(id);
    if (link == nullptr)
        return std::nullopt;
    return Identity{link->newcomers(), link->session, id, link->copier};
}

std::optional<SecretDigest> Grants::digest(const std::string& id) const {
    const auto found = entries_.find(id);
    return found == entries_.end() || !in_force(found->second)
               ? std::nullopt
               : std::optional(found->second.digest);
}

const Grant* Grants::grant(const std::string& id) const {
    const auto found = entries_.find(id);
    return found == entries_.end() || !in_force(found->second) ? nullptr : &found->second.grant;
}

void Grants::attend(const std::string& id, GrantHolder& holder) {
    if (const auto found = entries_.find(id); found != entries_.end())
        found->second.holders.insert(&holder);
}

void Grants::leave(const std::string& id, GrantHolder& holder) {
    if (const auto found = entries_.find(id); found != entries_.end())
        found->second.holders.erase(&holder);
}

core::Result<void>
Grants::restore(const std::string& session, const std::string& id, std::string_view record) {
    const auto kept = protocol::parse_grant(record);
    if (!kept)
        return tl::unexpected(kept.error());
    const auto number = number_of(id, "g");
    const auto role = role_named(kept->role);
    const auto digest = read_digest(kept->digest);
    std::map<std::string, Role> lowered;
    for (const auto& [participant, word] : kept->lowered)
        if (const auto set = role_named(word))
            lowered[participant] = *set;
    if (!number || !role || !digest || lowered.size() != kept->lowered.size())
        return fail(Error::Code::Corrupt, "a saved share link is damaged",
                    "make a new one with `session.share`");
    next_ = std::max(next_, *number + 1);
    Entry entry{{id, session, *role, kept->expires, kept->maker, kept->lineage, std::move(lowered),
                 kept->copier},
                *digest,
                {},
                *number,
                {}};
    if (kept->expires) {
        const auto most = static_cast<std::int64_t>(limits::grant_seconds);
        const std::int64_t now = services_.wall_clock();
        const std::int64_t until = std::clamp(*kept->expires, now - 1, now + most);
        entry.end = services_.clock.now() + std::chrono::seconds(until - now);
    }
    const bool over = expired(entry);
    entries_[id] = std::move(entry);
    if (over)
        end(id, {});
    schedule();
    return {};
}

void Grants::forget(const std::string& session) {
    std::vector<std::string> ids;
    for (const auto& [id, entry] : entries_)
        if (entry.grant.session == session)
            ids.push_back(id);
    for (const std::string& id : ids)
        end(id, "the session is gone");
    suspended_.erase(session);
}

void Grants::suspend(const std::string& session) {
    suspended_.insert(session);
    for (auto& [id, entry] : entries_)
        if (entry.grant.session == session)
            for (GrantHolder* holder : std::exchange(entry.holders, {}))
                holder->grant_ended("the session was deleted");
}

void Grants::resume(const std::string& session) {
    suspended_.erase(session);
}

bool Grants::expired(const Entry& entry) const {
    return entry.end && services_.clock.now() >= *entry.end;
}

bool Grants::in_force(const Entry& entry) const {
    return !expired(entry) && !suspended_.contains(entry.grant.session);
}

void Grants::end(const std::string& id, const std::string& reason) {
    const auto node = entries_.extract(id);
    if (services_.journal != nullptr)
        services_.journal->write(node.mapped().grant.session, {{"grant", id, std::nullopt}});
    for (GrantHolder* holder : node.mapped().holders)
        holder->grant_ended(reason);
}

void Grants::end_expired() {
    std::vector<std::string> ids;
    for (const auto& [id, entry] : entries_)
        if (expired(entry))
            ids.push_back(id);
    for (const std::string& id : ids)
        end(id, "the share link has expired");
    schedule();
}

void Grants::schedule() {
    timer_.reset();
    std::optional<Time> next;
    for (const auto& [id, entry] : entries_)
        if (entry.end && (!next || *entry.end < *next))
            next = entry.end;
    if (!next)
        return;
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(*next - services_.clock.now());
    timer_ = services_.loop.after(std::clamp(wait, std::chrono::milliseconds::zero(), longest_wait),
                                  [this] { end_expired(); });
}

void Grants::keep(const Entry& entry) {
    if (services_.journal == nullptr)
        return;
    const Grant& grant = entry.grant;
    protocol::GrantRecord record{std::string(name(grant.role)),
                                 digest_text(entry.digest),
                                 grant.expires,
                                 grant.maker,
                                 grant.lineage,
                                 {},
                                 grant.copier};
    for (const auto& [participant, role] : grant.lowered)
        record.lowered[participant] = name(role);
    services_.journal->write(grant.session, {{"grant", grant.id, protocol::record_text(record)}});
}

} // namespace wakesurf::server
