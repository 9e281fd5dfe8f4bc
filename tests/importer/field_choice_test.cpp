#include "importer/fields/field_choice.hpp"
#include "importer/fields/velocity_choice.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace wakesurf::importer::field_choice_test {
namespace {

using core::FieldInfo;
using Fields = std::vector<FieldInfo>;

FieldInfo point(const std::string& name, int components) {
    return {name, components, FieldInfo::Source::Point, {}, {}};
}

FieldInfo cell(const std::string& name, int components) {
    return {name, components, FieldInfo::Source::Cell, {}, {}};
}

std::string velocity(const Fields& fields, const std::string& wish = {}) {
    const auto choice = choose_fields(fields, {{}, wish});
    return choice ? choice->velocity_name : "refused: " + choice.error().message;
}

std::vector<std::string> stems(const Fields& fields, const std::vector<std::string>& wanted = {}) {
    std::vector<std::string> out;
    const auto choice = choose_fields(fields, {wanted, {}}).value();
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

TEST(FieldChoice, TellsAScalarOfTheCellsFromOneOfThePoints) {
    const Fields fields{cell("p", 1), point("U", 3), point("p", 1), cell("T", 1)};
    const auto names = [&](std::vector<std::string> wanted) {
        std::vector<std::string> out;
        for (const ChosenScalar& each : choose_fields(fields, {std::move(wanted), {}})->scalars)
            out.push_back(each.stored.name +
                          (each.field.source == FieldInfo::Source::Cell ? " of cells" : ""));
        return out;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names({}), (Names{"p", "p (cells) of cells", "T of cells"}));
    EXPECT_EQ(names({"p"}), (Names{"p"}));
    EXPECT_EQ(names({"p (cells)"}), (Names{"p (cells) of cells"}));
}

TEST(FieldChoice, TakesANameThatNoFieldHasToTellThemApart) {
    const Fields fields{cell("p", 1), point("U", 3), point("p", 1), point("p (cells)", 1)};
    EXPECT_EQ(told_apart(fields[0], fields), "p (cells 2)");
    EXPECT_EQ(choose_fields(fields, {})->scalars.size(), 3u);
    // A vector is stored as its magnitude, which has another name.
    const Fields vector{cell("p", 1), point("U", 3), point("p", 3)};
    EXPECT_EQ(told_apart(vector[0], vector), "p");
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
    const auto named = choose_fields(fields, {{"U", "F"}, {}}).value();
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
    EXPECT_NE(velocity({point("Momentum", 3)}, "Momentum").find("momentum is not velocity"),
              std::string::npos);
    EXPECT_EQ(
        velocity({point("Momentum", 3), point("Density", 1), point("B", 3)}, "Momentum,Density"),
        "Momentum / Density");
}

TEST(FieldChoice, ListsTheCandidatesWhereItIsNotClear) {
    const std::string refusal = velocity({point("wind", 3), point("B", 3)});
    EXPECT_NE(refusal.find("wind (3 components, point), B (3 components, point)"),
              std::string::npos)
        << refusal;
    EXPECT_EQ(velocity({point("wind", 3), point("B", 3)}, "B"), "B");
    EXPECT_NE(velocity({point("vorticity", 3)}).find("there is vorticity"), std::string::npos);
    EXPECT_EQ(velocity({point("vorticity", 3)}, "vorticity"), "vorticity"); // someone says so
    EXPECT_EQ(velocity({point("a", 1), point("b", 1), point("c", 1)}, "b, c,a"), "b, c, a");
}

TEST(FieldChoice, OffersWhatCanBeChosenTheLikeliestFirst) {
    const Fields fields{point("Grid_Velocity", 3), cell("U.air", 3), cell("U.water", 3),
                        cell("Momentum", 3),       point("vx1", 1),  point("vx2", 1),
                        point("vx3", 1),           cell("p", 1),     cell("Density", 1)};
    const std::vector<std::string> offered{"U.air", "U.water", "vx1,vx2,vx3", "Momentum,Density",
                                           "Grid_Velocity"};
    EXPECT_EQ(velocity_candidates(fields), offered);
    for (const auto& wish : offered)
        EXPECT_TRUE(choose_velocity(fields, wish).has_value()) << wish;
    EXPECT_TRUE(velocity_candidates({point("p", 1), point("Momentum", 3)}).empty());
}

TEST(FieldChoice, NeverTakesTheVelocityOfSomethingElseForTheFluids) {
    for (const char* const other : {"Grid_Velocity",
                                    "gridVelocity",
                                    "GRIDVEL",
                                    "mesh velocity",
                                    "Umesh",
                                    "U_mesh",
                                    "Angular_Velocity",
                                    "friction velocity",
                                    "FrictionVelocity",
                                    "velocity_wall",
                                    "wall_velocity",
                                    "velocity_rms",
                                    "VelocityGradient",
                                    "VelocityX_mean",
                                    "mean_velocity_x",
                                    "UxMean",
                                    "sound velocity",
                                    "UPrime",
                                    "slip_velocity",
                                    "solid velocity",
                                    "velocity_x",
                                    "group_velocity",
                                    "particle_velocity",
                                    "moving frame velocity"}) {
        EXPECT_EQ(velocity({point("Density", 1), point("Momentum", 3), point(other, 3)}),
                  "Momentum / Density")
            << other;
        EXPECT_EQ(velocity({point(other, 3), cell("U", 3)}), "U") << other;
        EXPECT_TRUE(velocity({point(other, 3), point("p", 1)}).starts_with("refused:")) << other;
        EXPECT_EQ(velocity({point(other, 3), point("p", 1)}, other), other) << "someone says so";
    }
    for (const char* const other : {"Relative_Velocity", "velocity_mean", "UMean", "B"})
        EXPECT_EQ(velocity({point("rho", 1), point("rhoU", 3), point(other, 3)}), "rhoU / rho")
            << other;
}

TEST(FieldChoice, SaysSoWhereItTakesWhatIsNotSurelyTheFluids) {
    for (const char* const name : {"Relative_Velocity", "UMean", "B"}) {
        EXPECT_EQ(choose_fields({point(name, 3)})->note,
                  std::string(name) + " is taken for the velocity, though its name does not say "
                                      "that it is the fluid's: choose with --velocity if it is "
                                      "another");
        EXPECT_EQ(choose_fields({point(name, 3)}, {{}, name})->note, "") << "someone says so";
    }
    for (const char* const name : {"U", "velocity", "Flow_Velocity", "U.air"})
        EXPECT_EQ(choose_fields({point(name, 3)})->note, "") << name;
}

TEST(FieldChoice, AsksWhereTwoPhasesCouldBeMeant) {
    for (const auto& [one, other] : {std::pair{"U.air", "U.water"},
                                     {"U.air", "U.particles"},
                                     {"gas velocity", "LiquidVelocity [m/s]"},
                                     {"velocity_1", "velocity_2"}}) {
        const Fields fields{cell(one, 3), cell(other, 3), cell("p", 1)};
        const auto refused = choose_fields(fields);
        ASSERT_FALSE(refused.has_value()) << one;
        EXPECT_EQ(refused.error().message, std::string("several fields could be the velocity: ") +
                                               one + " (3 components, cell), " + other +
                                               " (3 components, cell)");
        EXPECT_EQ(refused.error().hint, "choose one with --velocity NAME, or three scalars with "
                                        "--velocity U,V,W");
        EXPECT_EQ(velocity(fields, other), other);
    }
}

TEST(FieldChoice, KnowsTheUsualNamesOfComponents) {
    const std::vector<std::array<const char*, 3>> usual{
        {"U", "V", "W"},
        {"v1", "v2", "v3"},
        {"vel1", "vel2", "vel3"},
        {"velx", "vely", "velz"},
        {"vx1", "vx2", "vx3"},
        {"x_velocity", "y_velocity", "z_velocity"},
        {"X Velocity", "Y Velocity", "Z Velocity"},
        {"Velocity[i]", "Velocity[j]", "Velocity[k]"},
        {"Velocity[i] (m/s)", "Velocity[j] (m/s)", "Velocity[k] (m/s)"},
        {"Velocity[0]", "Velocity[1]", "Velocity[2]"},
        {"Velocity:0", "Velocity:1", "Velocity:2"},
        {"u_x", "u_y", "u_z"},
        {"velocity_u", "velocity_v", "velocity_w"},
        {"u_component_of_wind", "v_component_of_wind", "w_component_of_wind"},
        {"UX", "UY", "UZ"}};
    for (const auto& [x, y, z] : usual) {
        const std::string joined = std::string(x) + ", " + y + ", " + z;
        EXPECT_EQ(velocity({cell("p", 1), cell(z, 1), cell(y, 1), cell(x, 1)}), joined);
    }
    EXPECT_EQ(velocity({point("rho", 1), point("mom1", 1), point("mom2", 1), point("mom3", 1)}),
              "mom1, mom2, mom3 / rho");
    EXPECT_EQ(velocity({point("dens", 1), point("XMomentum", 1), point("YMomentum", 1),
                        point("ZMomentum", 1)}),
              "XMomentum, YMomentum, ZMomentum / dens");
    for (const char* const statistic : {"u_mean", "u'", "u_rms", "uu", "grid_u"})
        EXPECT_TRUE(
            velocity({point(statistic, 1), point("v", 1), point("w", 1)}).starts_with("refused:") ||
            std::string(statistic) == "u'")
            << statistic;
    const Fields both{point("u", 1), point("v", 1), point("w", 1),
                      point("U", 1), point("V", 1), point("W", 1)};
    EXPECT_EQ(velocity(both), "refused: several fields could be the velocity: u, v, w or U, V, W");
    EXPECT_EQ(velocity(both, "U,V,W"), "U, V, W");
}

TEST(FieldChoice, TakesWhatIsAskedForOrSaysWhyNot) {
    const Fields fields{point("U", 3), cell("U", 3),  point("Momentum", 3), point("rho", 1),
                        cell("p", 1),  point("T", 1), point("a,b", 3)};
    EXPECT_EQ(velocity(fields, "Momentum"), "Momentum / rho");
    EXPECT_EQ(velocity(fields, "Momentum,rho"), "Momentum / rho");
    EXPECT_EQ(velocity(fields, "a,b"), "a,b");
    const auto words = [&](const std::string& wish) {
        const auto refused = choose_fields(fields, {{}, wish});
        return refused ? std::string() : refused.error().message + " (" + refused.error().hint;
    };
    EXPECT_NE(words("V").find("there is no field V; there is U (3 components, point)"),
              std::string::npos);
    EXPECT_NE(words("T").find("no velocity is made of T (1 component, point)"), std::string::npos);
    EXPECT_NE(words("T,rho").find("no velocity is made of"), std::string::npos);
    EXPECT_NE(words("T,rho,p").find("all at points or all in cells"), std::string::npos);
    const auto kept = choose_fields(fields, {{"T", "a,b"}, "Momentum"}).value();
    EXPECT_EQ(kept.velocity_name, "Momentum / rho");
    EXPECT_EQ(kept.scalars.size(), 2u) << "--fields keeps, and chooses no velocity";
    EXPECT_EQ(choose_fields(fields, {{"a,b"}, {}})->velocity_name, "U");
}

TEST(FieldChoice, StoresScalarsUnderNamesOfTheirOwn) {
    const Fields fields{point("U", 3),         point("p", 1), cell("p", 1),
                        point("Velocity", 1),  point("P", 1), point("mask", 1),
                        point("T (total)", 1), point("R", 6)};
    EXPECT_EQ(stems(fields),
              (std::vector<std::string>{"p", "velocity-2", "p-2", "t-total", "p-cells"}));
    EXPECT_EQ(stems(fields, {"P"}), (std::vector<std::string>{"p"}));
    EXPECT_EQ(stems(fields, {"U"}).size(), 5u);
    const auto choice = choose_fields(fields, {});
    EXPECT_EQ(choice->mask->name, "mask");
    EXPECT_EQ(choice->scalars[0].field.source, FieldInfo::Source::Point);
    EXPECT_NE(choice->note.find("R"), std::string::npos);
}

} // namespace
} // namespace wakesurf::importer::field_choice_test
