// What the methods on every type of record share: a list, a deletion, and a setter that may be meant for one revision only.
#pragma once

#include "server/rpc/author.hpp"
#include "server/rpc/method.hpp"
#include "server/rpc/session_choice.hpp"
#include "server/rpc/stale_revision.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace wakesurf::server {

/// The answer to a deletion: {seq}
void reply_with_seq(Reply reply, const Session& session);

/// {NAME: all of them}
void list_records(const Call& call,
                  const std::optional<std::string>& session,
                  Reply reply,
                  const char* name,
                  nlohmann::json (*all)(const Session& session));

/// A type of record as its methods name, find, tell and delete it.
template <class Record>
struct RecordHandlers {
    const char* type; ///< the member with its id
    core::Result<Record> (Session::*find)(const std::string& id) const;
    nlohmann::json (*text)(const Record& record);
    core::Result<void> (Session::*erase)(const std::string& id, const Author& author);

    /// Why an edit is refused that was meant for another revision.
    std::optional<protocol::RpcFault> stale(const Session& session,
                                            const std::optional<std::string>& id,
                                            std::optional<std::uint64_t> if_rev) const {
        const auto now = id ? (session.*find)(*id) : core::fail(core::Error::Code::NotFound, type);
        return now ? stale_revision(if_rev, now->rev, text(*now)) : std::nullopt;
    }

    /// `parameters`: session, gesture and ifRev, beside the id.
    template <class Parameters>
    void remove(const Call& call,
                const Parameters& parameters,
                const std::string& id,
                Reply reply) const {
        const auto session = choose_session(call, parameters.session);
        if (!session)
            return reply.fault(session.error());
        if (const auto refused = stale(**session, id, parameters.if_rev))
            return reply.fault(*refused);
        const Author author = author_of(call, **session, parameters.gesture);
        if (const auto done = ((**session).*erase)(id, author); !done)
            return reply.fault(done.error());
        reply_with_seq(std::move(reply), **session);
    }
};

} // namespace wakesurf::server
