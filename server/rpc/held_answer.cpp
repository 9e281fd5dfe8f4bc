#include "server/rpc/held_answer.hpp"

#include "server/service/base/journal.hpp"

#include <nlohmann/json.hpp>

#include <memory>
#include <utility>

namespace wakesurf::server {

Reply held_until_settled(Reply reply, Journal& journal) {
    auto kept = std::make_shared<Reply>(std::move(reply));
    return Reply([kept, &journal](const nlohmann::json* result, const protocol::RpcFault* fault) {
        if (fault != nullptr)
            return kept->fault(*fault);
        journal.settled([kept, answer = *result](const core::Result<void>& outcome) mutable {
            if (answer.is_object()) {
                answer["durable"] = outcome.has_value();
                if (!outcome)
                    answer["hint"] = outcome.error().message + ": " + outcome.error().hint;
            }
            kept->result(answer);
        });
    });
}

} // namespace wakesurf::server
