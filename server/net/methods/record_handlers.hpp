// The shared part of the methods on every type of record: a list, a deletion, and a setter that may be meant
// for one revision only.
#pragma once

#include "server/net/methods/caller.hpp"
#include "server/net/methods/records_json.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace wakesurf::server {

/// Answers a deletion: {seq}
void reply_with_seq(Reply reply, const Session& session);

/// Returns a fault that carries the current record, or nothing where its revision is the one that `ifRev`
/// expects.
std::optional<protocol::RpcFault> stale_revision(std::optional<std::uint64_t> expected,
                                                 std::uint64_t rev,
                                                 const nlohmann::json& record);

/// Says how the methods on a type of record name and set it.
template <class R, class Setting>
struct RecordHandlers {
    const char* type; ///< the member with its id
    core::Result<R> (Session::*put)(const Setting& setting, const Author& author);

    /// Says why an edit is refused that was meant for another revision.
    std::optional<protocol::RpcFault> stale(const Session& session,
                                            const std::optional<std::string>& id,
                                            std::optional<std::uint64_t> if_rev) const {
        const R* const now = id ? session.records().find<R>(*id) : nullptr;
        return now != nullptr ? stale_revision(if_rev, now->rev, protocol::record_json(*now))
                              : std::nullopt;
    }

    /// Sets the record `id`, or a new one, and answers {TYPE, rev, seq}.
    void set(const Call& call,
             const Setting& setting,
             const std::optional<std::string>& id,
             Reply reply) const {
        const auto session = choose_session(call, setting.session);
        if (!session)
            return reply.fault(session.error());
        if (const auto refused = stale(**session, id, setting.if_rev))
            return reply.fault(*refused);
        const auto record =
            ((**session).*put)(setting, author_of(call, **session, setting.gesture));
        if (!record)
            return reply.fault(record.error());
        reply.result(
            {{type, key_of(*record).id}, {"rev", record->rev}, {"seq", (*session)->seq()}});
    }

    /// Deletes the record `id`. `parameters` have session, gesture and ifRev beside the id.
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
        if (const auto done = (*session)->remove({type_of_record<R>, id}, author); !done)
            return reply.fault(done.error());
        reply_with_seq(std::move(reply), **session);
    }
};

/// Answers {NAME: all records of the type}.
template <class R>
void list_records(const Call& call,
                  const std::optional<std::string>& named,
                  Reply reply,
                  const char* name) {
    const auto session = choose_session(call, named);
    if (!session)
        return reply.fault(session.error());
    reply.result({{name, all_json<R>(**session)}});
}

} // namespace wakesurf::server
