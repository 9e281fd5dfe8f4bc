// Values of OpenFOAM's fields in each form that OpenFOAM and people write.
#include "importer/sources/openfoam/openfoam_reader.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace wakesurf::importer::openfoam_values_test {
namespace {

using Values = std::vector<float>;

class OpenfoamValues : public testing::Test {
  protected:
    core::Result<FoamValues> read(const std::string& text, int components = 3) const {
        tests::write_file(folder_ / "U", text);
        return read_foam_values(folder_ / "U", "0/U", components);
    }

    tests::TemporaryFolder folder_;
};

std::string header(const std::string& lines = "") {
    return "/* OpenFOAM { */\nFoamFile\n{\n    version 2.0; // {\n    " + lines +
           "\n    object U;\n}\ndimensions [m s^-1];\n";
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

TEST_F(OpenfoamValues, AreReadInEachFormOfTextThatListsHave) {
    for (const auto& [words, expected] : std::vector<std::pair<std::string, Values>>{
             {"uniform (1 -2 3e-1)", {1.0F, -2.0F, 0.3F}},
             {"nonuniform List<vector> 2((1 2 3) (4 5 6))", {1, 2, 3, 4, 5, 6}},
             {"nonuniform List<vector>\n2\n(\n(1 2 3)\n(4 5 6)\n)\n", {1, 2, 3, 4, 5, 6}},
             {"nonuniform List<vector> 700{(1 2 3)}", {1, 2, 3}}}) {
        const auto values =
            read(header("format ascii;") + "internalField " + words + ";\nboundaryField\n{\n}\n");
        ASSERT_TRUE(values.has_value()) << words << ": " << values.error().message;
        EXPECT_EQ(values->inside, expected) << words;
    }
}

TEST_F(OpenfoamValues, OfPatchesAreThoseOfTheEntryValueAndZeroWithoutSlip) {
    const auto values = read(header() + R"(internalField uniform (0 0 1);
boundaryField
{
    still { type noSlip; }
    inlet { type mixed; refValue uniform (7 7 7); value uniform (1 0 0); valueFraction uniform 1; }
    "side.*" { type zeroGradient; }
    list { type fixedValue; value nonuniform List<vector> 2((1 2 3) (4 5 6)); }
    empty { type calculated; value nonuniform 0(); }
    coded { type fixedValue; value uniform (2 0 0); inner { value uniform 5; } }
}
// ************************************************************************* //
)");
    ASSERT_TRUE(values.has_value()) << values.error().message;
    EXPECT_EQ(values->patches, (std::map<std::string, Values>{{"still", {0, 0, 0}},
                                                              {"inlet", {1, 0, 0}},
                                                              {"list", {1, 2, 3, 4, 5, 6}},
                                                              {"empty", {}},
                                                              {"coded", {2, 0, 0}}}));
}

TEST_F(OpenfoamValues, AreReadFromBinaryFilesOfEitherPrecisionWhateverStandsBetween) {
    const std::string tensors = bytes_of(std::vector<double>(18, 0.25));
    const std::string labels = bytes_of(std::vector<std::int64_t>(2, 0x7d7d7d7d7d7d7d7d)); // "}}}"
    const std::string behind = ";\nboundaryField\n{\n wall { type a; t nonuniform List<tensor> 2(";
    for (const bool single : {false, true}) {
        const std::string arch = single ? "scalar=32" : "scalar=64";
        const std::string numbers = single ? bytes_of(std::vector<float>{1, 2, 3, 4, 5, 6})
                                           : bytes_of(std::vector<double>{1, 2, 3, 4, 5, 6});
        const std::string between = single ? bytes_of(std::vector<float>(18, 0.25F)) : tensors;
        const auto values =
            read(header("format binary; arch \"LSB;label=64;" + arch + "\";") +
                 "internalField nonuniform List<vector> 2\n(" + numbers + ")" + behind + between +
                 "); l nonuniform List<label> 2(" + labels + "); value uniform (0 0 0); } }\n");
        ASSERT_TRUE(values.has_value()) << arch << ": " << values.error().message;
        EXPECT_EQ(values->inside, (Values{1, 2, 3, 4, 5, 6})) << arch;
        EXPECT_EQ(values->patches, (std::map<std::string, Values>{{"wall", {0, 0, 0}}})) << arch;
    }
}

TEST_F(OpenfoamValues, ThatAreNotThereOrOfAnotherKindAreRefusedByName) {
    const std::string rest = ";\nboundaryField\n{\n}\n";
    for (const std::string words :
         {"uniform 1", "nonuniform List<scalar> 3(1 2 3)", "nonuniform",
          "nonuniform List<vector> 3((1 2 3) (4 5 6))", "nonuniform List<vector> 99999999999999(",
          "nonuniform List<vector> 18446744073709551615((1 2 3))", "nonuniform List<vector> -1()",
          "nonuniform List<vector> 1((1 2 x))", "nonuniform List<vector> 0()"}) {
        for (const std::string format : {"format ascii;", "format binary;"}) {
            const auto refused = read(header(format) + "internalField " + words + rest);
            if (format == "format binary;" && words.starts_with("uniform") && refused)
                continue;
            ASSERT_FALSE(refused.has_value()) << words;
            EXPECT_EQ(refused.error().message,
                      "0/U ends too early or is not a field of 3 numbers a cell")
                << words;
        }
    }
    const auto other = read(header("format binary; arch \"MSB;label=32;scalar=64\";") +
                            "internalField uniform (1 2 3)" + rest);
    ASSERT_FALSE(other.has_value());
    EXPECT_EQ(other.error().message, "0/U is binary, of a machine with the other order of bytes");
    EXPECT_FALSE(read("").has_value());
    EXPECT_FALSE(read_foam_values(folder_ / "none", "0/none", 3).has_value());
}

TEST_F(OpenfoamValues, BeyondAnyNumberAreInfiniteAndBelowAnyAreZero) {
    const auto values = read(header() + "internalField uniform (1e999 -1e999 1e-999);\n");
    ASSERT_TRUE(values.has_value()) << values.error().message;
    EXPECT_EQ(values->inside, (Values{HUGE_VALF, -HUGE_VALF, 0.0F}));
}

TEST_F(OpenfoamValues, ByTheNameOfOthersAreRefusedAsSuch) {
    for (const char* const words :
         {"uniform $U0", "$U0", "uniform ($speed 0 0)", "uniform (1 0 ${w})", "#include \"values\"",
          "nonuniform #include \"values\"", "uniform #calc \"1\""}) {
        const auto values = read(header() + "U0 (1 0 0);\ninternalField " + words + ";\n");
        ASSERT_FALSE(values.has_value()) << words;
        EXPECT_EQ(values.error().message,
                  "0/U has values by the name of others ($...) or by a directive (#include, #calc "
                  "...), which are not looked up");
    }
    const auto on_patch = read(header() + "internalField uniform (1 0 0);\nboundaryField\n{\n    "
                                          "inlet { type fixedValue; value $internalField; }\n}\n");
    EXPECT_TRUE(on_patch.has_value());
    EXPECT_NE(read(header() + "internalField uniform (1 0").error().message.find("ends too early"),
              std::string::npos);
}

} // namespace
} // namespace wakesurf::importer::openfoam_values_test
