// The JSON-RPC 2.0 envelope: text -> calls, outcomes -> text. Knows no method; the server's method table
// does. Twin: web-client/src/protocol/jsonRpc.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/api/generated/errors.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

struct RpcLimits {
    std::size_t message_bytes = std::size_t{64} << 10;
    std::size_t depth = 32;
    std::size_t batch = 64;
};

/// Holds everything an error answer carries: `data` always has kind and hint, and the members of `detail` if
/// there are any.
struct RpcFault {
    RpcCode code = RpcCode::Internal;
    std::string message;
    std::string hint;
    std::string kind;                             ///< empty: the code's own, see kind_of
    std::shared_ptr<const nlohmann::json> detail; ///< an object, or nothing
};

/// Returns the answer for an error of the engine or of a dataset. Over a limit, data.limit is the most there
/// may be; where memory ran out, the machine's, in bytes.
RpcFault fault_of(const core::Error& error);

/// Is an id as the JSON text it came in: a string, a number or null. It is only ever echoed.
using RpcId = std::string;
inline constexpr std::string_view null_id = "null";

struct RpcCall {
    std::string method;
    /// Holds an object or an array; an empty object when they are left out.
    std::shared_ptr<const nlohmann::json> parameters;
    std::optional<RpcId> id;         ///< nothing: a notification, never answered
    std::optional<RpcFault> refused; ///< not a valid request: answer this fault to `id`
};

struct RpcMessage {
    bool batch = false; ///< the answers go into one array
    std::vector<RpcCall> calls;
};

/// Takes a message apart. Text that is not JSON, too long or too deep, an empty batch and one above the limit
/// give one refused call outside any batch, as section 6 of the specification asks.
RpcMessage parse_rpc(std::string_view text, const RpcLimits& limits);

std::string rpc_result(std::string_view id, const nlohmann::json& result);
/// Takes the result as JSON text.
std::string rpc_result_of(std::string_view id, std::string_view result);
std::string rpc_error(std::string_view id, const RpcFault& fault);
std::string rpc_notification(std::string_view method, const nlohmann::json& parameters);

/// Returns one array of answers; the empty string when there is none, because then nothing at all is sent.
std::string rpc_batch(const std::vector<std::string>& answers);

} // namespace wakesurf::protocol
