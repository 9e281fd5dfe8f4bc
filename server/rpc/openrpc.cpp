#include "server/rpc/openrpc.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

json parameter_json(const Parameter& parameter) {
    return {{"name", parameter.name},
            {"required", parameter.required},
            {"description", parameter.about},
            {"schema", json::parse(parameter.schema)}};
}

json method_json(const Method& method) {
    json parameters = json::array();
    for (const Parameter& each : method.parameters)
        parameters.push_back(parameter_json(each));
    return {{"name", method.name},
            {"summary", method.about},
            {"paramStructure", "by-name"},
            {"params", std::move(parameters)},
            {"result",
             {{"name", "result"},
              {"description", method.result},
              {"schema", json::parse(method.traits.result_schema)}}},
            {"x-websocketOnly", method.traits.websocket_only}};
}

} // namespace

std::string openrpc_document(const std::vector<Method>& methods) {
    json list = json::array();
    for (const Method& each : methods)
        list.push_back(method_json(each));
    return json{{"openrpc", "1.3.2"},
                {"info", {{"title", "wakesurf"}, {"version", WAKESURF_VERSION}}},
                {"methods", std::move(list)}}
        .dump();
}

} // namespace wakesurf::server
