#include "server/session/participants.hpp"

#include "server/limits.hpp"

#include <algorithm>

namespace wakesurf::server {

core::Result<Participant>
Participants::join(std::string name, const std::string& resume_token, Observer& observer) {
    leave(observer);
    Participant place = place_for(resume_token);
    if (present_.size() >= limits::participants)
        return core::fail(core::Error::Code::OverLimit,
                          "the session has as many participants as it may have",
                          "wait until somebody leaves, or create another session");
    if (!name.empty())
        place.name = std::move(name);
    place.observer = &observer;
    present_.push_back(place);
    return place;
}

Participant Participants::place_for(const std::string& resume_token) {
    const auto same = [&](const Participant& each) { return each.resume_token == resume_token; };
    if (const auto found = std::find_if(present_.begin(), present_.end(), same);
        found != present_.end()) {
        Participant place = *found;
        present_.erase(found);
        return place;
    }
    if (const auto found = std::find_if(gone_.begin(), gone_.end(), same); found != gone_.end()) {
        Participant place = *found;
        gone_.erase(found);
        return place;
    }
    const std::string number = std::to_string(next_++);
    return {"p" + number, "guest " + number, random_hex(entropy_, 16), nullptr};
}

void Participants::leave(const Observer& observer) {
    const auto found = std::find_if(present_.begin(), present_.end(), [&](const Participant& each) {
        return each.observer == &observer;
    });
    if (found == present_.end())
        return;
    gone_.push_back(*found);
    gone_.back().observer = nullptr;
    present_.erase(found);
    if (gone_.size() > limits::participants)
        gone_.pop_front();
}

} // namespace wakesurf::server
