// The author of an edit: what undo, leases and annotations need to know of a caller.
#pragma once

#include <string>

namespace wakesurf::server {

struct Author {
    /// A participant's id; `script`, or `script:` and the share link's id, for a caller that has not joined
    /// the session. Empty: the server itself, which has no history.
    std::string participant;
    std::string name; ///< for people
    /// Which of their gestures an edit is part of: those of one are one step of undo. Empty: it is one by
    /// itself.
    std::string gesture{};
    /// The page puts something there to begin with: no edit of a participant, so undo does not turn it.
    bool default_scene = false;

    bool operator==(const Author&) const = default;
};

} // namespace wakesurf::server
