#include "server/rpc/openrpc.hpp"

#include "server/rpc/method_examples.hpp"
#include "server/rpc/result_schemas.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace wakesurf::server {

using nlohmann::json;
using protocol::RpcCode;

namespace {

struct KnownError {
    RpcCode code;
    const char*
        message; ///< what the code says in general; an answer's own message says what happened
};

/// Those of the envelope (parse error, invalid request, unknown method) belong to no method.
constexpr std::array known_errors{
    KnownError{RpcCode::InvalidParameters,
               "a parameter is missing, unknown, malformed or out of range"},
    KnownError{RpcCode::Internal, "a fault of the server; its log has the details"},
    KnownError{RpcCode::Cancelled, "the work was replaced by a newer edit, or cancelled"},
    KnownError{RpcCode::Stale, "ifRev is not the record's revision"},
    KnownError{RpcCode::Unauthenticated, "no valid token"},
    KnownError{RpcCode::NotPermitted, "the role does not allow it"},
    KnownError{RpcCode::NotFound, "there is no such session, record or dataset"},
    KnownError{RpcCode::Leased, "someone else is dragging the rake"},
    KnownError{RpcCode::OutsideDomain,
               "outside the dataset's domain; the message says by how much"},
    KnownError{RpcCode::OutsideTimeRange, "outside the dataset's times"},
    KnownError{RpcCode::OverLimit, "more than the server grants"},
    KnownError{RpcCode::DatasetError, "the data are unreadable or damaged"},
};

bool takes(const Method& method, std::string_view parameter) {
    return std::any_of(method.parameters.begin(), method.parameters.end(),
                       [&](const Parameter& each) { return each.name == parameter; });
}

bool may_answer(const Method& method, RpcCode code) {
    switch (code) {
    case RpcCode::Stale:
        return takes(method, "ifRev");
    case RpcCode::Leased:
        return method.traits.edits && takes(method, "rake");
    case RpcCode::NotFound:
        return takes(method, "session") || takes(method, "dataset") ||
               takes(method, "subscription");
    case RpcCode::OutsideDomain:
        return takes(method, "points") || takes(method, "rake");
    case RpcCode::OutsideTimeRange:
        return takes(method, "time") || takes(method, "from");
    case RpcCode::DatasetError:
        return takes(method, "dataset") || takes(method, "surface");
    case RpcCode::OverLimit:
        return method.traits.edits || takes(method, "timeoutMs") || takes(method, "points");
    default:
        return true;
    }
}

json errors_json(const Method& method) {
    json list = json::array();
    for (const KnownError& each : known_errors)
        if (may_answer(method, each.code))
            list.push_back(
                {{"$ref", "#/components/errors/" + std::string(protocol::kind_of(each.code))}});
    return list;
}

json shared_errors() {
    json errors = json::object();
    for (const KnownError& each : known_errors)
        errors[std::string(protocol::kind_of(each.code))] = {
            {"code", static_cast<int>(each.code)},
            {"message", each.message},
            {"data", {{"kind", protocol::kind_of(each.code)}, {"hint", "what to do about it"}}}};
    return errors;
}

const char* role_name(Role role) {
    return role == Role::Host ? "host" : role == Role::Editor ? "editor" : "viewer";
}

json parameter_json(const Parameter& parameter) {
    return {{"name", parameter.name},
            {"required", parameter.required},
            {"description", parameter.about},
            {"schema", json::parse(parameter.schema)}};
}

/// Parameters in the order of the method's, as by position would be.
json example_json(const Method& method, const json& example) {
    json parameters = json::array();
    for (const Parameter& each : method.parameters)
        if (const auto value = example["params"].find(each.name); value != example["params"].end())
            parameters.push_back({{"name", each.name}, {"value", *value}});
    return {{"name", method.name},
            {"params", std::move(parameters)},
            {"result", {{"name", "result"}, {"value", example["result"]}}}};
}

json method_json(const Method& method, const json& examples) {
    json parameters = json::array();
    // Required ones come first, as the specification asks.
    for (const bool required : {true, false})
        for (const Parameter& each : method.parameters)
            if (each.required == required)
                parameters.push_back(parameter_json(each));
    json out = {
        {"name", method.name},
        {"summary", method.about},
        {"tags", json::array({{{"name", method.name.substr(0, method.name.find_first_of("./"))}}})},
        {"paramStructure", "by-name"},
        {"params", std::move(parameters)},
        {"result",
         {{"name", "result"}, {"description", method.result}, {"schema", result_schema(method)}}},
        {"errors", errors_json(method)},
        {"x-leastRole", role_name(method.traits.least)},
        {"x-websocketOnly", method.traits.websocket_only}};
    if (const auto example = examples.find(method.name); example != examples.end())
        out["examples"] = json::array({example_json(method, *example)});
    return out;
}

} // namespace

std::string openrpc_document(const std::vector<Method>& methods) {
    json list = json::array();
    const json examples = method_examples();
    for (const Method& each : methods)
        list.push_back(method_json(each, examples));
    return json{
        {"openrpc", "1.3.2"},
        {"info",
         {{"title", "wakesurf"},
          {"version", WAKESURF_VERSION},
          {"description",
           "Integral surfaces of flows, computed where the data are. Calls go to /rpc (POST) and "
           "/ws "
           "(WebSocket) of the server that gave this document; `data` of errors is a "
           "components/schemas/ErrorData."}}},
        // Not `servers`: the specification has whole addresses there, and a server does not know all of its own.
        {"x-paths", {{"http", "/rpc"}, {"websocket", "/ws"}}},
        {"methods", std::move(list)},
        {"components", {{"schemas", shared_schemas()}, {"errors", shared_errors()}}}}
        .dump();
}

} // namespace wakesurf::server
