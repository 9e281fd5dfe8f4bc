// What is told of files on which a library fails: one sentence, whatever the library printed, without folders, addresses and
// names of C++ (six formats, each with one byte in many places changed).
#include "tests/importer/cgns_files.hpp"
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/netcdf_files.hpp"
#include "tests/support/ensight_text.hpp"
#include "tests/support/foam_files.hpp"

#include <vtkExodusIIWriter.h>
#include <vtk_exodusII.h>

#include <regex>

namespace wakesurf::importer::library_words_test {
namespace {

class LibraryWords : public Import {
  protected:
    // Describes what is there; whatever is told must be fit for a person. Returns whether something was told.
    bool expect_fit(const fs::path& source, const std::string& what) const {
        const auto outcome = import({"--describe", source});
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 1) << what << ": " << outcome.status;
        if (outcome.status == 0) {
            EXPECT_EQ(outcome.errors, "") << what;
            return false;
        }
        const std::string& words = outcome.errors;
        EXPECT_TRUE(words.starts_with("wakesurf-import: ")) << what << ": " << words;
        EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << what << ": " << words;
        EXPECT_LT(words.size(), 600u) << what << ": " << words;
        static const std::regex unfit(
            R"((^|[ '"(:])/\w|0x[0-9a-f]|vector::|std::|basic_string|\.cxx|unexpected:)");
        EXPECT_FALSE(std::regex_search(words, unfit)) << what << ": " << words;
        EXPECT_EQ(words.find(folder_.path().string()), std::string::npos) << what << ": " << words;
        return true;
    }

    // With a byte changed in `count` places of the file, and cut off in as many.
    void expect_fit_of_damaged(const fs::path& source, const fs::path& file, std::size_t count) {
        ASSERT_FALSE(expect_fit(source, "whole"));
        const std::string whole = read_file(file);
        std::size_t told = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = (2 * i + 1) * whole.size() / (2 * count);
            std::string text = whole;
            for (std::size_t k = at; k < std::min(at + 3, text.size()); ++k)
                text[k] = static_cast<char>(text[k] ^ 0x5a);
            write_file(file, text);
            told += expect_fit(source, "changed at " + std::to_string(at)) ? 1 : 0;
            write_file(file, whole.substr(0, at));
            told += expect_fit(source, "cut at " + std::to_string(at)) ? 1 : 0;
        }
        EXPECT_GT(told, 0u) << "no damage was noticed: this test tries nothing";
        write_file(file, whole);
    }
};

TEST_F(LibraryWords, AreFitForVtkFiles) {
    const auto file = put("flow.vti", sample_vti().text());
    expect_fit_of_damaged(file, file, 6);
    const auto legacy = put("noise.vtk", "# vtk DataFile Version 3.0\nnoise\nASCII\nDATASET "
                                         "STRUCTURED_POINTS\nDIMENSIONS 3 x 3\nfrobnicate\n");
    EXPECT_TRUE(expect_fit(legacy, "noise"));
}

TEST_F(LibraryWords, AreFitForCgns) {
    for (const bool adf : {false, true}) {
        Contents contents;
        contents.adf = adf;
        contents.times = {1};
        write_cgns(folder_ / "flow.cgns", contents);
        expect_fit_of_damaged(folder_ / "flow.cgns", folder_ / "flow.cgns", 6);
    }
}

TEST_F(LibraryWords, AreFitForNetcdf) {
    for (const int format : {0, NC_NETCDF4}) {
        Flow flow;
        flow.format = format;
        write_flow(folder_ / "flow.nc", flow);
        expect_fit_of_damaged(folder_ / "flow.nc", folder_ / "flow.nc", 6);
    }
}

TEST_F(LibraryWords, AreFitForExodus) {
    ex_opts(0); // the writer's library prints by itself
    const auto mesh = sample_mesh();
    put_known_flow(*mesh, 0);
    auto writer = vtkSmartPointer<vtkExodusIIWriter>::New();
    writer->SetInputData(mesh);
    const fs::path file = folder_ / "flow.exo";
    writer->SetFileName(file.c_str());
    writer->Write();
    expect_fit_of_damaged(file, file, 6);
}

TEST_F(LibraryWords, AreFitForEnsight) {
    EnsightText mesh(EnsightEncoding::Text);
    for (const char* line : {"a mesh", "of a test", "node id assign", "element id assign", "part"})
        mesh.line(line);
    mesh.integers({1});
    for (const char* line : {"box", "block"})
        mesh.line(line);
    mesh.integers({3, 3, 3});
    EnsightText velocity(EnsightEncoding::Text);
    for (const char* line : {"velocity", "part"})
        velocity.line(line);
    velocity.integers({1});
    velocity.line("block");
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> along;
        for (int n = 0; n < 27; ++n)
            along.push_back(static_cast<float>(axis == 0 ? n % 3 : axis == 1 ? n / 3 % 3 : n / 9));
        mesh.numbers(along);
        velocity.numbers(along);
    }
    put("flow.geo", mesh.text());
    put("flow.vel", velocity.text());
    const auto file = put("flow.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: flow.geo\n"
                                       "VARIABLE\nvector per node: U flow.vel\n");
    expect_fit_of_damaged(file, file, 4);
    expect_fit_of_damaged(file, folder_ / "flow.geo", 4);
    expect_fit_of_damaged(file, folder_ / "flow.vel", 4);
}

TEST_F(LibraryWords, AreFitForOpenfoam) {
    const auto mesh = foam_block_mesh({});
    FoamField velocity;
    for (const int cell : mesh.cells)
        velocity.values.push_back({0.5 * cell, 1.0, 2.0});
    const fs::path place = folder_ / "case";
    write_foam_mesh(place / "constant", mesh);
    write_foam_field(place / "0", mesh, velocity);
    write_file(place / "case.foam", "");
    for (const char* name : {"constant/polyMesh/owner", "constant/polyMesh/faces",
                             "constant/polyMesh/boundary", "0/U"})
        expect_fit_of_damaged(place / "case.foam", place / name, 3);
}

// A server tells its errors to everybody with a link.
TEST_F(LibraryWords, AreApartFromErrorsThatOthersAreTold) {
    const auto file =
        put("u.vtk",
            "# vtk DataFile Version 3.0\nu\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
            "ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 8\nVECTORS U frobnicate\n1 0 0\n");
    const auto together = import({"--describe", file});
    ASSERT_NE(together.errors.find("frobnicate"), std::string::npos) << together.errors;
    const auto apart = import({"--describe", file, "--told-to-others"});
    const auto own = apart.errors.find("wakesurf-import: ");
    ASSERT_NE(own, std::string::npos) << apart.errors;
    EXPECT_TRUE(apart.errors.starts_with("library: ")) << apart.errors;
    EXPECT_NE(apart.errors.substr(0, own).find("frobnicate"), std::string::npos) << apart.errors;
    EXPECT_EQ(apart.errors.substr(own).find("frobnicate"), std::string::npos) << apart.errors;
}

} // namespace
} // namespace wakesurf::importer::library_words_test
