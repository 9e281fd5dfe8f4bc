#include "server/import/field_choice.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::field_choice_test {
namespace {

using core::FieldInfo;
using Fields = std::vector<FieldInfo>;

FieldInfo point(const std::string& name, int components) {
    return {name, components, FieldInfo::Source::Point, {}, {}};
}

FieldInfo cell(const std::string& name, int components) {
    return {name, components, FieldInfo::Source::Cell, {}, {}};
}

std::string velocity(const Fields& fields, const std::vector<std::string>& wanted = {}) {
    const auto choice = choose_fields(fields, wanted);
    return choice ? choice->velocity_name : "refused: " + choice.error().message;
}

std::vector<std::string> stems(const Fields& fields, const std::vector<std::string>& wanted = {}) {
    std::vector<std::string> out;
    const auto choice = choose_fields(fields, wanted).value();
    for (const auto& scalar : choice.scalars)
        out.push_back(scalar.stored.stem);
    return out;
}

TEST(FieldChoice, PrefersTheVelocityToItsAverages) {
    EXPECT_EQ(velocity({point("UMean", 3), point("U", 3), point("vorticity", 3)}), "U");
    EXPECT_EQ(velocity({point("B", 3), point("Velocity", 3)}), "Velocity");
    EXPECT_EQ(velocity({point("velocity_mean", 3), point("flow velocity [m/s]", 3)}),
              "flow velocity [m/s]");
    EXPECT_EQ(velocity({point("UMean", 3), point("p", 1)}), "UMean");
    EXPECT_EQ(velocity({point("B", 3), cell("U", 3)}), "U");
    EXPECT_EQ(velocity({cell("U", 3), point("U", 3)}), "U");
    EXPECT_EQ(choose_fields({cell("U", 3), point("U", 3)}, {})->velocity.arrays[0].source,
              FieldInfo::Source::Point);
}

TEST(FieldChoice, TellsWhichOfTwoFieldsOfOneNameItLeavesOut) {
    EXPECT_EQ(choose_fields({cell("U", 3), point("U", 3), point("R", 6)}, {})->note,
              "left out, since a store holds one vector: U of the cells, R");
}

TEST(FieldChoice, StoresOtherVectorsAsTheirMagnitudes) {
    const Fields fields{point("U", 3), cell("vorticity", 3), point("p", 1), cell("B", 3),
                        point("B", 3)};
    const auto choice = choose_fields(fields, {}).value();
    std::vector<std::string> names;
    for (const ChosenScalar& each : choice.scalars)
        names.push_back(each.stored.name + (each.is_magnitude() ? " of " : " is ") +
                        each.field.name);
    EXPECT_EQ(names, (std::vector<std::string>{"p is p", "B magnitude of B",
                                               "vorticity magnitude of vorticity"}));
    EXPECT_EQ(choice.scalars[1].field.source, FieldInfo::Source::Point);
    EXPECT_EQ(stems(fields), (std::vector<std::string>{"p", "b-magnitude", "vorticity-magnitude"}));
    EXPECT_EQ(choice.note, "stored as magnitudes, since a store holds one vector: B, vorticity; "
                           "left out, since a store holds one vector: B of the cells");
    EXPECT_EQ(stems(fields, {"U", "vorticity"}), (std::vector<std::string>{"vorticity-magnitude"}));
    EXPECT_EQ(stems(fields, {"U", "p"}), (std::vector<std::string>{"p"}));
}

TEST(FieldChoice, KeepsAScalarThatIsNamedAsTheMagnitudeOfAVector) {
    const Fields fields{point("U", 3), point("F", 3), cell("F magnitude", 1), point("B", 3)};
    const auto choice = choose_fields(fields, {}).value();
    ASSERT_EQ(choice.scalars.size(), 2u);
    EXPECT_EQ(choice.scalars[0].stored.name, "B magnitude");
    EXPECT_EQ(choice.scalars[1].stored.name, "F magnitude");
    EXPECT_EQ(choice.scalars[1].field.name, "F magnitude");
    EXPECT_FALSE(choice.scalars[1].is_magnitude());
    EXPECT_EQ(choice.note, "stored as magnitudes, since a store holds one vector: B; "
                           "left out, since a store holds one vector: F");
    const auto named = choose_fields(fields, {"U", "F"}).value();
    ASSERT_EQ(named.scalars.size(), 1u);
    EXPECT_EQ(named.scalars[0].field.name, "F") << "someone who names the vector means it";
}

TEST(FieldChoice, JoinsThreeComponentsInTheirOrder) {
    for (const auto& names :
         std::vector<std::vector<std::string>>{{"w", "u", "v"},
                                               {"vz", "vx", "vy"},
                                               {"velocity_z", "velocity_x", "velocity_y"},
                                               {"VelocityZ", "VelocityX", "VelocityY"},
                                               {"w_velocity", "u_velocity", "v_velocity"}}) {
        const Fields fields{point(names[0], 1), point(names[1], 1), point(names[2], 1),
                            point("p", 1)};
        EXPECT_EQ(velocity(fields), names[1] + ", " + names[2] + ", " + names[0]);
        EXPECT_EQ(stems(fields), (std::vector<std::string>{"p"}));
    }
    EXPECT_EQ(velocity({point("u", 1), cell("v", 1), point("w", 1)}).substr(0, 8), "refused:");
}

TEST(FieldChoice, NeverTakesAMomentumForAVelocity) {
    EXPECT_EQ(velocity({point("Momentum", 3), point("Density", 1)}), "Momentum / Density");
    EXPECT_EQ(velocity({cell("rhoU", 3), cell("rho", 1)}), "rhoU / rho");
    EXPECT_EQ(velocity({point("MomentumX", 1), point("MomentumY", 1), point("MomentumZ", 1),
                        point("Density", 1)}),
              "MomentumX, MomentumY, MomentumZ / Density");
    EXPECT_EQ(velocity({point("Momentum", 3), point("Density", 1), point("Velocity", 3)}),
              "Velocity");
    EXPECT_NE(velocity({point("Momentum", 3)}).find("no field is a velocity"), std::string::npos);
    EXPECT_NE(velocity({point("Momentum", 3)}, {"Momentum"}).find("momentum is not velocity"),
              std::string::npos);
    EXPECT_EQ(velocity({point("Momentum", 3), point("Density", 1), point("B", 3)},
                       {"Momentum", "Density"}),
              "Momentum / Density");
}

TEST(FieldChoice, ListsTheCandidatesWhereItIsNotClear) {
    const std::string refusal = velocity({point("wind", 3), point("B", 3)});
    EXPECT_NE(refusal.find("wind (3 components, point), B (3 components, point)"),
              std::string::npos)
        << refusal;
    EXPECT_EQ(velocity({point("wind", 3), point("B", 3)}, {"B"}), "B");
    EXPECT_NE(velocity({point("vorticity", 3)}).find("there is vorticity"), std::string::npos);
    EXPECT_EQ(velocity({point("vorticity", 3)}, {"vorticity"}), "vorticity"); // someone says so
    EXPECT_EQ(velocity({point("a", 1), point("b", 1), point("c", 1)}, {"b", "c", "a"}), "b, c, a");
}

TEST(FieldChoice, StoresScalarsUnderNamesOfTheirOwn) {
    const Fields fields{point("U", 3),         point("p", 1), cell("p", 1),
                        point("Velocity", 1),  point("P", 1), point("mask", 1),
                        point("T (total)", 1), point("R", 6)};
    EXPECT_EQ(stems(fields), (std::vector<std::string>{"p", "velocity-2", "p-2", "t-total"}));
    EXPECT_EQ(stems(fields, {"P"}), (std::vector<std::string>{"p"}));
    EXPECT_EQ(stems(fields, {"U"}).size(), 4u);
    const auto choice = choose_fields(fields, {});
    EXPECT_EQ(choice->mask->name, "mask");
    EXPECT_EQ(choice->scalars[0].field.source, FieldInfo::Source::Point);
    EXPECT_NE(choice->note.find("R"), std::string::npos);
}

} // namespace
} // namespace wakesurf::server::field_choice_test
