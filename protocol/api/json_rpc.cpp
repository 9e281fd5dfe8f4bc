#include "protocol/api/json_rpc.hpp"

#include "core/base/machine_memory.hpp"
#include "protocol/api/base/json_text.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

RpcCall refuse(RpcId id, RpcCode code, std::string message, std::string hint) {
    RpcCall call;
    call.id = std::move(id);
    call.refused = RpcFault{code, std::move(message), std::move(hint), {}, {}};
    return call;
}

RpcCall refuse(RpcId id, std::string message) {
    return refuse(std::move(id), RpcCode::InvalidRequest, std::move(message),
                  R"(send {"jsonrpc":"2.0","id":1,"method":"server.info","params":{}})");
}

bool may_be_id(const json& value) {
    return value.is_string() || value.is_number() || value.is_null();
}

RpcCall parse_call(const json& value) {
    if (!value.is_object())
        return refuse(RpcId(null_id), "a request must be an object");
    const auto id = value.find("id");
    if (id != value.end() && !may_be_id(*id))
        return refuse(RpcId(null_id), "`id` must be a string, a number or null");
    // The specification's own example answers {"foo": "boo"} with a null id although there is none to echo.
    const RpcId echo = id == value.end() ? RpcId(null_id) : json_text(*id);
    const auto version = value.find("jsonrpc");
    if (version == value.end() || *version != "2.0")
        return refuse(echo, "`jsonrpc` must be \"2.0\"");
    const auto method = value.find("method");
    if (method == value.end() || !method->is_string())
        return refuse(echo, "`method` must be a string");
    const auto parameters = value.find("params");
    if (parameters != value.end() && !parameters->is_structured())
        return refuse(echo, "`params` must be an object");
    RpcCall call;
    call.method = method->get<std::string>();
    call.parameters = std::make_shared<const json>(parameters == value.end() ? json::object()
                                                                             : json(*parameters));
    if (id != value.end())
        call.id = echo;
    return call;
}

} // namespace

RpcFault fault_of(const core::Error& error) {
    using Code = core::Error::Code;
    RpcFault fault{RpcCode::DatasetError, error.message, error.hint, {}, {}};
    switch (error.code) {
    case Code::NotFound:
        fault.code = RpcCode::NotFound;
        break;
    case Code::InvalidArgument:
        fault.code = RpcCode::InvalidParameters;
        break;
    case Code::Unsupported:
        fault.code = RpcCode::InvalidParameters;
        fault.kind = "unsupported";
        break;
    case Code::OutOfDomain:
        fault.code = RpcCode::OutsideDomain;
        break;
    case Code::OutOfTime:
        fault.code = RpcCode::OutsideTimeRange;
        break;
    case Code::OverLimit:
        fault.code = RpcCode::OverLimit;
        fault.detail = std::make_shared<const json>(
            json{{"limit", error.limit.value_or(core::machine_memory())}});
        break;
    case Code::Cancelled:
        fault.code = RpcCode::Cancelled;
        break;
    case Code::Corrupt:
    case Code::Io:
        break;
    }
    return fault;
}

RpcMessage parse_rpc(std::string_view text, const RpcLimits& limits) {
    const auto value = parse_json(text, {limits.message_bytes, limits.depth});
    if (!value) {
        const bool limit = value.error().code == core::Error::Code::OverLimit;
        const bool sound = value.error().code != core::Error::Code::Corrupt;
        return {
            false,
            {refuse(RpcId(null_id), sound ? RpcCode::InvalidRequest : RpcCode::ParseError,
                    value.error().message, limit ? "send smaller messages" : value.error().hint)}};
    }
    if (!value->is_array())
        return {false, {parse_call(*value)}};
    if (value->empty())
        return {false, {refuse(RpcId(null_id), "a batch must have at least one request")}};
    if (value->size() > limits.batch)
        return {false,
                {refuse(RpcId(null_id), RpcCode::InvalidRequest,
                        "a batch may have at most " + std::to_string(limits.batch) + " requests",
                        "send several batches")}};
    RpcMessage message{true, {}};
    for (const json& entry : *value)
        message.calls.push_back(parse_call(entry));
    return message;
}

std::string rpc_result(std::string_view id, const json& result) {
    return rpc_result_of(id, json_text(result));
}

std::string rpc_result_of(std::string_view id, std::string_view result) {
    return std::string(R"({"jsonrpc":"2.0","id":)")
               .append(id)
               .append(R"(,"result":)")
               .append(result) +
           "}";
}

std::string rpc_error(std::string_view id, const RpcFault& fault) {
    json data = fault.detail && fault.detail->is_object() ? *fault.detail : json::object();
    data["kind"] = fault.kind.empty() ? std::string(kind_of(fault.code)) : fault.kind;
    data["hint"] = fault.hint;
    const json error{{"code", static_cast<int>(fault.code)},
                     {"message", fault.message},
                     {"data", std::move(data)}};
    return R"({"jsonrpc":"2.0","id":)" + std::string(id) + R"(,"error":)" + json_text(error) + "}";
}

std::string rpc_notification(std::string_view method, const json& parameters) {
    return R"({"jsonrpc":"2.0","method":)" + json_text(json(method)) + R"(,"params":)" +
           json_text(parameters) + "}";
}

std::string rpc_batch(const std::vector<std::string>& answers) {
    std::string out;
    for (const std::string& answer : answers)
        (out += out.empty() ? '[' : ',') += answer;
    return out.empty() ? out : out + "]";
}

} // namespace wakesurf::protocol
