#include "server/rpc/author.hpp"

namespace wakesurf::server {

Author author_of(const Call& call, Session& session) {
    if (call.client != nullptr)
        for (const Participant& each : session.participants().present())
            if (each.observer == call.client)
                return {each.id, each.name};
    return {"script", "a script"};
}

bool is_host(const Call&) {
    return true; // every caller has the server's own token
}

} // namespace wakesurf::server
