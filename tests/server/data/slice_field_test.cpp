// The velocity across a plane, and which fields may be subtracted from each other.
#include "server/data/slice_field.hpp"

#include <gtest/gtest.h>

#include <variant>

namespace wakesurf::server::slice_field_test {

namespace {

core::DatasetInfo
data(const std::string& name, const std::string& velocity, const std::string& unit) {
    core::DatasetInfo info;
    info.name = name;
    info.velocity = velocity;
    info.length_unit = "m";
    info.bounds = {core::Vec3(0.0), core::Vec3(1.0)};
    core::FieldInfo field;
    field.name = velocity;
    field.components = 3;
    field.unit = unit;
    info.fields = {field};
    return info;
}

std::string
refusal(const std::string& field, const core::DatasetInfo& from, const core::DatasetInfo& other) {
    const auto found = subtracted_field(field, from, other, nullptr, {0, 0, 1});
    return found ? "" : found.error().message;
}

} // namespace

TEST(SubtractedField, IsTheVelocityOfTheOtherDataWhateverItIsCalled) {
    const auto found =
        subtracted_field("U", data("a", "U", "m/s"), data("b", "velocity", ""), nullptr, {0, 0, 1});
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_TRUE(std::holds_alternative<core::SpeedField>(*found));
}

TEST(SliceField, HasTheVelocityAcrossAPlaneWhereNoFieldHasThatName) {
    const auto across = slice_field("velocity_normal", data("a", "U", ""), nullptr, {0, 3, 4});
    ASSERT_TRUE(across) << across.error().message;
    EXPECT_LT(
        glm::length(std::get<core::VelocityAlong>(*across).direction - core::Vec3(0, 0.6, 0.8)),
        1e-15);
    const auto speed =
        slice_field("velocity_normal", data("a", "velocity_normal", ""), nullptr, {0, 3, 4});
    ASSERT_TRUE(speed);
    EXPECT_TRUE(std::holds_alternative<core::SpeedField>(*speed));
}

TEST(SubtractedField, IsRefusedWhereItIsNotThereOrMeansSomethingElse) {
    const core::DatasetInfo a = data("a", "U", "m/s");
    EXPECT_NE(refusal("p", a, data("b", "U", "m/s")).find("in b, "), std::string::npos);
    EXPECT_EQ(refusal("U", a, data("b", "U", "km/h")), "U is in m/s in a and in km/h in b");
    EXPECT_EQ(refusal("vorticity", a, data("b", "U", "km/h")),
              "the velocity is in m/s in a and in km/h in b");
    core::DatasetInfo fast = data("b", "U", "m/s");
    fast.time_unit = "ms";
    core::DatasetInfo slow = a;
    slow.time_unit = "s";
    EXPECT_EQ(refusal("U", slow, fast), "times are in s in a and in ms in b");
    core::DatasetInfo small = data("b", "U", "m/s");
    small.length_unit = "mm";
    EXPECT_EQ(refusal("U", a, small), "lengths are in m in a and in mm in b");
    core::DatasetInfo beside = data("b", "U", "m/s");
    beside.bounds = {core::Vec3(2.0), core::Vec3(3.0)};
    EXPECT_EQ(refusal("U", a, beside), "a and b have no place in common");
}

} // namespace wakesurf::server::slice_field_test
