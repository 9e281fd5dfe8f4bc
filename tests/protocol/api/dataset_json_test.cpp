#include "protocol/api/base/json_text.hpp"
#include "protocol/api/dataset_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace wakesurf::protocol::dataset_json_test {
namespace {

using nlohmann::json;

core::DatasetInfo sample_info() {
    core::DatasetInfo info;
    info.dataset = "cylinder-2";
    info.name = "cylinder";
    info.reader = "vtkXMLImageDataReader (pvd)";
    info.bounds = {{-1, -2, 0}, {1.0 / 3.0, 2, 0.1}};
    info.dimensions = {3, 4, 5};
    info.spacing = {0.1, 0.2, 1e-3};
    info.points = 60;
    info.cells = 24;
    info.times = {0.1, 0.2, 0.30000000000000004};
    info.fields = {{"U", 3, core::FieldInfo::Source::Cell, {0.25, 1.5}, "m/s"},
                   {"mask", 1, core::FieldInfo::Source::Point, {0, 1}, "", false, false}};
    info.velocity = "U";
    info.why = "the only one";
    info.obstacle = true;
    info.bytes_per_step = 720;
    info.finest_spacing = 1e-3;
    info.length_unit = "m";
    info.time_unit = "s";
    return info;
}

TEST(DatasetJson, HasTheMembersOfTheContract) {
    const json value = written(sample_info());
    for (const char* name :
         {"dataset", "name", "reader", "grid", "bounds", "points", "cells", "times", "steady",
          "fields", "velocity", "why", "obstacle", "bytesPerStep"})
        EXPECT_TRUE(value.contains(name)) << name;
    EXPECT_EQ(value["bounds"], json({-1, 1.0 / 3.0, -2, 2, 0, 0.1}));
    EXPECT_EQ(value["grid"], "uniform");
    EXPECT_EQ(value["fields"][0], json({{"name", "U"},
                                        {"components", 3},
                                        {"source", "cell"},
                                        {"range", {0.25, 1.5}},
                                        {"unit", "m/s"}}));
    EXPECT_FALSE(value["fields"][1].contains("unit"));
}

TEST(DatasetJson, ReadsBackWhatItWrites) {
    for (const auto kind : {core::GridKind::Uniform, core::GridKind::Analytic}) {
        auto info = sample_info();
        info.grid = kind;
        const json value = written(info);
        const json through_text = parse_json(json_text(value), {}).value();
        const auto back = parse_kept<core::DatasetInfo>(through_text);
        ASSERT_TRUE(back.has_value()) << back.error().message;
        EXPECT_EQ(written(*back), value);
        EXPECT_EQ(back->times, info.times);
        EXPECT_EQ(back->length_unit, "m");
        EXPECT_EQ(back->time_unit, "s");
    }
}

TEST(DatasetJson, SaysThatARangeIsNotKnown) {
    auto info = sample_info();
    info.fields[0].range.fill(std::numeric_limits<double>::quiet_NaN());
    const json told = parse_json(json_text(written(info)), {}).value();
    EXPECT_EQ(told["fields"][0]["range"], json({nullptr, nullptr}));
    const auto back = parse_kept<core::DatasetInfo>(told);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(std::isnan(back->fields[0].range[0]) && std::isnan(back->fields[0].range[1]));
    json half = told;
    half["fields"][0]["range"] = {0.5, nullptr};
    EXPECT_FALSE(parse_kept<core::DatasetInfo>(half));
}

TEST(DatasetJson, NamesTheMemberThatIsMissingOrWrong) {
    const json good = written(sample_info());
    for (const auto& [name, value] : good.items()) {
        if (name == "dimensions" || name == "spacing" || name == "finestSpacing" ||
            name == "lengthUnit" || name == "timeUnit")
            continue;
        json missing = good;
        missing.erase(name);
        const auto error = parse_kept<core::DatasetInfo>(missing);
        ASSERT_FALSE(error.has_value()) << name;
        EXPECT_NE(error.error().message.find("`" + name + "`"), std::string::npos)
            << error.error().message;
        json wrong = good;
        wrong[name] = json::object({{"surprise", 1}});
        EXPECT_FALSE(parse_kept<core::DatasetInfo>(wrong).has_value()) << name;
    }
}

TEST(DatasetJson, RefusesNumbersThatDoNotFit) {
    const auto refused = [](const char* name, const json& value) {
        json info = written(sample_info());
        info[name] = value;
        return !parse_kept<core::DatasetInfo>(info).has_value();
    };
    EXPECT_TRUE(refused("points", -1));
    EXPECT_TRUE(refused("points", 1.5));
    EXPECT_TRUE(refused("bounds", {1, 2, 3}));
    EXPECT_TRUE(refused("bounds", {1, 2, 3, 4, 5, "6"}));
    EXPECT_TRUE(refused("dimensions", {1e300, 1, 1}));
    EXPECT_TRUE(refused("dimensions", {-1, 1, 1}));
    EXPECT_TRUE(refused("times", {1, nullptr}));
    EXPECT_TRUE(refused("grid", "hexagonal"));
    EXPECT_FALSE(parse_kept<core::DatasetInfo>(json(3)).has_value());
}

} // namespace
} // namespace wakesurf::protocol::dataset_json_test
