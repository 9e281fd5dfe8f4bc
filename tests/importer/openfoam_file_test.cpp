// What the importer itself reads of OpenFOAM's files.
#include "importer/sources/openfoam/openfoam_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace wakesurf::importer::openfoam_file_test {
namespace {

using namespace tests;

TEST(OpenfoamFile, WritesUnitsAsPeopleDo) {
    EXPECT_EQ(foam_unit("[0 1 -1 0 0 0 0]"), "m/s");
    EXPECT_EQ(foam_unit("[0 2 -2 0 0 0 0]"), "m2/s2");
    EXPECT_EQ(foam_unit("[1 -1 -2 0 0 0 0]"), "Pa");
    EXPECT_EQ(foam_unit("[1 -3 0 0 0]"), "kg/m3");
    EXPECT_EQ(foam_unit("[1 1 -3 -1 0 0 0]"), "kg m/(s3 K)");
    EXPECT_EQ(foam_unit("[0 0 -1 0 0 0 0]"), "1/s");
    EXPECT_EQ(foam_unit("[0 0.5 0 0 0 0 0]"), "m0.5");
    EXPECT_EQ(foam_unit("[0 0 0 0 0 0 0]"), "");
    EXPECT_EQ(foam_unit("[m s^-1]"), "m/s");
    EXPECT_EQ(foam_unit("[kg m^-1 s^-2]"), "Pa");
    EXPECT_EQ(foam_unit("[Pa]"), "Pa");
    EXPECT_EQ(foam_unit("[furlong s^-1]"), "");
    EXPECT_EQ(foam_unit(""), "");
}

TEST(OpenfoamFile, ReadsHeadersAmongComments) {
    const TemporaryFolder folder;
    write_file(folder / "U",
               "/* FoamFile class no; */ // class no;\nFoamFile\n{ version 2.0; // object no;\n"
               "class\tvolVectorField;\nobject U; }\ndimensions\n   [0 1 -1 0 0 0 0];\n");
    const auto header = read_foam_header(folder / "U");
    ASSERT_TRUE(header.has_value());
    EXPECT_EQ(header->type, "volVectorField");
    EXPECT_EQ(header->object, "U");
    EXPECT_EQ(header->unit, "m/s");
    write_file(folder / "other", "hello");
    EXPECT_FALSE(read_foam_header(folder / "other").has_value());
    EXPECT_FALSE(read_foam_header(folder / "none").has_value());
}

TEST(OpenfoamFile, FindsDirectivesOutsideOfCommentsAndQuotes) {
    const TemporaryFolder folder;
    const auto found = [&](const std::string& text) {
        write_file(folder / "points", text);
        return has_directive(folder / "points");
    };
    const std::string head = "FoamFile\n{\n class vectorField; format ascii;\n}\n";
    EXPECT_TRUE(found(head + "#include \"other\"\n"));
    EXPECT_TRUE(found("#inputMode merge\n" + head));
    EXPECT_TRUE(found("FoamFile\n{\n#include \"other\"\n}\n"));
    EXPECT_TRUE(found(head + "2\n(\n(0 0 0)\n#include \"other\"\n)\n"));
    EXPECT_TRUE(found(head + "1{#calc \"1\"}"));
    EXPECT_TRUE(found(head + std::string(70000, ' ') + "/* ) */(#include \"other\")"));
    EXPECT_FALSE(found(head + "// #include \"other\"\n/* #calc */ \"#calc\" 1((0 0 0))"));
    EXPECT_FALSE(found(head + "a#include { type wall; } #1 # \n"));
    const std::string binary = "FoamFile { format binary; }\n";
    EXPECT_FALSE(found(binary + "1( #calc)"));
    EXPECT_TRUE(found(binary + "#include \"other\" 1( )"));
    EXPECT_FALSE(has_directive(folder / "none"));
}

TEST(OpenfoamFile, FindsWhatItsHeaderIncludes) {
    const TemporaryFolder folder;
    const auto found = [&](const std::string& text) {
        write_file(folder / "U", text);
        return has_include_in_header(folder / "U");
    };
    EXPECT_TRUE(found("FoamFile\n{\n#include \"other\"\n}\n"));
    EXPECT_TRUE(found("#sinclude \"other\"\n"));
    EXPECT_TRUE(found("FoamFile { format binary; (#includeIfPresent \"other\" }"));
    EXPECT_FALSE(found("FoamFile\n{\n}\n#include \"flow\"\n"));
    EXPECT_FALSE(found("#notes of a person\n"));
}

TEST(OpenfoamFile, ReadsPatchesWithListsInThem) {
    const TemporaryFolder folder;
    write_file(folder / "boundary",
               "FoamFile { class polyBoundaryMesh; object boundary; }\n2\n(\n"
               "inlet { type patch; nFaces 4; startFace 9; }\n"
               "body { type wall; inGroups 2(wall other); nFaces 1; startFace 13; }\n)\n");
    const auto patches = read_foam_patches(folder / "boundary", "boundary");
    ASSERT_TRUE(patches.has_value());
    ASSERT_EQ(patches->size(), 2u);
    EXPECT_EQ((*patches)[0].name, "inlet");
    EXPECT_EQ((*patches)[0].type, "patch");
    EXPECT_EQ((*patches)[1].name, "body");
    EXPECT_EQ((*patches)[1].type, "wall");
    write_file(folder / "boundary", "FoamFile { object boundary; }\n1\n(\ninlet { type patch;");
    EXPECT_EQ(read_foam_patches(folder / "boundary", "boundary").error().code,
              core::Error::Code::Corrupt);
}

} // namespace
} // namespace wakesurf::importer::openfoam_file_test
