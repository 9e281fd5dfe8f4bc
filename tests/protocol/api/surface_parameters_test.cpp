#include "protocol/api/generated/surface.hpp"
#include "protocol/api/openrpc.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::protocol::surface_parameters_test {

namespace {

using nlohmann::json;

json asked(const char* kind, const json& more = json::object()) {
    json out{{"rake", "r1"}, {"dataset", "d"}, {"kind", kind}, {"from", 1.0}, {"to", 4.0}};
    out.update(more);
    return out;
}

SurfaceSetting read(const json& parameters) {
    const auto setting = parse_call<SurfaceSetting>(parameters);
    EXPECT_TRUE(setting) << setting.error().message;
    return setting.value();
}

std::string fault(const json& parameters) {
    const auto setting = parse_call<SurfaceSetting>(parameters);
    return setting ? "" : setting.error().message;
}

json echo(const json& parameters) {
    auto setting = read(parameters);
    setting.parameters.from = setting.from.value_or(0.0);
    return written(SurfaceRecord{"s1", 1, 1, setting.rake, setting.rake2, setting.dataset,
                                 setting.parameters, setting.twin, setting.fields});
}

} // namespace

TEST(SurfaceParameters, ReadsWhatStreakAndTimeSurfacesHave) {
    const auto streak = read(asked("streak", {{"releaseUntil", 2.5}}));
    EXPECT_EQ(streak.parameters.kind, core::SurfaceKind::Streak);
    EXPECT_EQ(streak.parameters.release_until, 2.5);
    const auto swept = read(asked("time", {{"sweep", {0, -1, 0.5}}}));
    EXPECT_EQ(swept.parameters.kind, core::SurfaceKind::Time);
    EXPECT_EQ(swept.parameters.sweep, core::Vec3(0, -1, 0.5));
    EXPECT_EQ(read(asked("time", {{"rake2", "r2"}})).rake2, "r2");
    const auto fine = read(asked("path", {{"merge", 0.0}, {"angle", 180}}));
    EXPECT_EQ(fine.parameters.merge, 0.0);
    EXPECT_EQ(fine.parameters.angle, 180.0);
}

TEST(SurfaceParameters, TakesNullAndNothingForTheDefaults) {
    const auto plain = read(asked("streak", {{"releaseUntil", nullptr}, {"sweep", nullptr}}));
    EXPECT_FALSE(plain.parameters.release_until);
    EXPECT_FALSE(plain.parameters.sweep);
    EXPECT_FALSE(plain.rake2);
    EXPECT_EQ(plain.parameters.merge, core::SurfaceParameters{}.merge);
    EXPECT_EQ(plain.parameters.angle, core::SurfaceParameters{}.angle);
}

TEST(SurfaceParameters, HaveTheDefaultsThatAreDescribed) {
    const json left_out = echo(asked("stream"));
    std::size_t compared = 0;
    const json document = json::parse(openrpc_document(""));
    for (const json& method : document["methods"])
        for (const json& each : method["params"]) {
            const std::string name = each["name"];
            if (method["name"] != "surface.set" || !each["schema"].contains("default") ||
                name == "default")
                continue;
            EXPECT_EQ(left_out.at(name), each["schema"]["default"]) << name;
            ++compared;
        }
    EXPECT_EQ(compared, 9u);
}

TEST(SurfaceParameters, TheRecordSaysAllThatWasAskedForAndNothingElse) {
    const json streak = asked("streak", {{"releaseUntil", 2.5}, {"merge", 0.5}, {"angle", 5.0}});
    const json record = echo(streak);
    for (const auto& [name, value] : streak.items())
        EXPECT_EQ(record[name], value) << name;
    EXPECT_FALSE(record.contains("sweep"));
    EXPECT_FALSE(record.contains("rake2"));
    EXPECT_EQ(echo(asked("time", {{"sweep", {0, 1, 0}}}))["sweep"], json::parse("[0.0,1.0,0.0]"));
    const json between = echo(asked("time", {{"rake2", "r2"}}));
    EXPECT_EQ(between["rake2"], "r2");
    EXPECT_EQ(between["merge"], 0.35);
    EXPECT_EQ(between["angle"], 20.0);
    EXPECT_FALSE(between.contains("releaseUntil"));
}

TEST(SurfaceParameters, NamesTheParameterThatIsWrong) {
    const std::vector<std::pair<json, std::string>> cases{
        {asked("stream", {{"fields", {"a", "b", "c", "d", "e", "f"}}}),
         "`fields` must be a list of at most 5 names"},
        {asked("sheet"), "`kind`"},
        {asked("streak", {{"releaseUntil", "2"}}), "`releaseUntil`"},
        {asked("streak", {{"releaseUntil", 1e300}}), "`releaseUntil`"},
        {asked("time", {{"sweep", 2}}), "`sweep`"},
        {asked("time", {{"sweep", {1, 2}}}), "`sweep`"},
        {asked("time", {{"sweep", {1, 2, 1e300}}}), "`sweep`"},
        {asked("time", {{"rake2", 7}}), "`rake2`"},
        {asked("time", {{"merge", 0.51}}), "`merge`"},
        {asked("time", {{"angle", -1}}), "`angle`"},
        {asked("time", {{"angle", 0}}), "`angle` must be a number greater than 0"},
        {asked("time", {{"sweeps", {1, 2, 3}}}), "`sweeps`"},
    };
    for (const auto& [parameters, name] : cases)
        EXPECT_TRUE(fault(parameters).starts_with(name)) << fault(parameters) << parameters;
}

} // namespace wakesurf::protocol::surface_parameters_test
