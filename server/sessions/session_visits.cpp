// A session as its list shows it: who comes and goes, what it is called, what it looks like.
#include "server/sessions/session.hpp"

#include <utility>

namespace wakesurf::server {

core::Result<Joined> Session::join(const Arrival& arrival, Observer& observer) {
    auto joined = participants_.join(arrival, observer);
    if (joined) {
        profile_.arrived({joined->you.id, joined->you.name, joined->you.colour});
        keep_profile();
        attendance_.seen();
    }
    return joined;
}

void Session::leave(const Observer& observer) {
    participants_.leave(observer);
    somebody_went();
}

void Session::lose(const Observer& observer) {
    participants_.lose(observer);
    somebody_went();
}

/// Notes that a client went. A client that only reloads the page finds the session as it was.
void Session::somebody_went() {
    profile_.used();
    keep_profile();
    attendance_.seen();
}

bool Session::somebody() const {
    bool found = !participants_.present().empty();
    builds_.for_each([&](const LiveSurface& each) { found = found || each.looked_at(); });
    return found;
}

/// Stops a clock that no client looks at: it would have surfaces computed for ever, and what they keep
/// belongs to others.
void Session::rest() {
    clock_.pause();
    builds_.for_each([](LiveSurface& each) { each.put_to_rest(); });
}

/// Computes again from the beginning what was being computed; the rest is built when a client looks.
void Session::resume() {
    builds_.for_each([](LiveSurface& each) { each.resume(); });
}

void Session::rename(std::string name) {
    name_ = std::move(name);
    profile_.made_on_purpose();
    announce({SessionName{id_, name_, units_}});
}

void Session::set_units(protocol::SessionUnits units) {
    units_ = std::move(units);
    profile_.edited();
    announce({SessionName{id_, name_, units_}});
}

void Session::set_thumbnail(std::string base64) {
    thumbnail_ = std::move(base64);
    if (services_.journal != nullptr)
        services_.journal->write(id_, {entry_of_thumbnail(thumbnail_)});
}

void Session::made_on_purpose() {
    profile_.made_on_purpose();
    keep_profile();
}

void Session::keep_profile() {
    auto entry = profile_.due();
    if (services_.journal != nullptr && entry)
        services_.journal->write(id_, {std::move(*entry)});
}

} // namespace wakesurf::server
