// What /openrpc.json says of a parameter is what the dispatcher asks of it: every one is tried with values beyond its description.
#include "server/net/methods/dispatcher.hpp"
#include "server/net/methods/method.hpp"
#include "tests/support/server/hand_clock.hpp"
#include "tests/support/server/no_datasets.hpp"
#include "tests/support/server/noted_wire.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server::described_parameters_test {

using nlohmann::json;

namespace {

bool takes(const json& schema, const char* type) {
    const json types = schema.value("type", json());
    return types == type || (types.is_array() && std::ranges::find(types, type) != types.end());
}

/// Something that keeps the description.
json sound(const json& schema) {
    if (schema.contains("enum"))
        return schema["enum"].front();
    if (takes(schema, "string"))
        return "x";
    if (takes(schema, "number") || takes(schema, "integer"))
        return schema.value("minimum", json(1));
    if (takes(schema, "boolean"))
        return false;
    if (!takes(schema, "array"))
        return json::object();
    json list = json::array();
    for (std::size_t i = 0; i < schema.value("minItems", std::size_t{0}); ++i)
        list.push_back(sound(schema["items"]));
    return list;
}

/// What does not keep it.
std::vector<json> beyond(const json& schema) {
    std::vector<json> wrong;
    if (schema.contains("enum"))
        wrong.emplace_back("no such word");
    if (schema.contains("maximum"))
        wrong.emplace_back(2.0 * schema["maximum"].get<double>() + 1.0);
    if (schema.contains("minimum")) {
        const double least = schema["minimum"].get<double>();
        wrong.emplace_back(least - std::abs(least) - 1.0);
    }
    if (schema.contains("exclusiveMinimum"))
        wrong.push_back(schema["exclusiveMinimum"]);
    if (schema.contains("maxLength"))
        wrong.emplace_back(std::string(schema["maxLength"].get<std::size_t>() + 1, 'x'));
    if (schema.value("minLength", 0) > 0)
        wrong.emplace_back("");
    if (schema.contains("pattern"))
        wrong.emplace_back("#12345");
    if (schema.contains("maxItems"))
        wrong.emplace_back(
            std::vector<json>(schema["maxItems"].get<std::size_t>() + 1, sound(schema["items"])));
    if (!takes(schema, "boolean"))
        wrong.emplace_back(true);
    else
        wrong.emplace_back("yes");
    return wrong;
}

struct DescribedParameters : testing::Test {
    json answer(const std::string& method, const json& parameters) {
        tests::NotedWire line;
        Client client(line, identity, grants);
        const json message{
            {"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", parameters}};
        std::optional<std::string> out;
        dispatcher.dispatch(message.dump(), identity, &client,
                            [&](std::string text) { out = std::move(text); });
        return json::parse(out.value_or(R"({"result":"later"})"));
    }

    HandClock clock;
    HandLoop loop{clock};
    ComputePool pool{1};
    Prober prober{loop, pool};
    tests::NoDatasets datasets;
    SystemEntropy entropy;
    Grants grants{{loop, clock, entropy, [] { return std::int64_t{0}; }}};
    SessionDirectory sessions{{loop, pool, datasets, entropy}};
    Identity identity{};
    Dispatcher dispatcher{
        method_table(),
        {sessions, datasets, [] { return json::array(); }, prober, grants, clock, loop},
        {std::size_t{1} << 20}};
};

} // namespace

TEST_F(DescribedParameters, AreRefusedBeyondTheirDescriptionUnderTheirNames) {
    identity.role = Role::Host;
    std::size_t tried = 0;
    const json document = json::parse(dispatcher.document());
    for (const json& method : document["methods"])
        for (const json& parameter : method["params"])
            for (const json& wrong : beyond(parameter["schema"])) {
                json given = json::object();
                for (const json& other : method["params"])
                    if (other["required"])
                        given[other["name"].get<std::string>()] = sound(other["schema"]);
                const auto name = parameter["name"].get<std::string>();
                given[name] = wrong;
                const json refused = answer(method["name"], given);
                const std::string what =
                    method["name"].get<std::string>() + " " + given.dump().substr(0, 200);
                ASSERT_TRUE(refused.contains("error")) << what;
                EXPECT_EQ(refused["error"]["code"], -32602) << what << refused;
                EXPECT_TRUE(
                    refused["error"]["message"].get<std::string>().starts_with("`" + name + "`"))
                    << what << refused["error"]["message"];
                ++tried;
            }
    EXPECT_GT(tried, 200u);
}

} // namespace wakesurf::server::described_parameters_test
