// Files that a source names beside, above or far from its folder, and folders of links: the person who names the source on a command
// line has them read; --confined keeps a stranger's source in its folder.
#include "importer/base/limited_rights.hpp"
#include "tests/importer/cgns_files.hpp"
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/known_flow.hpp"
#include "tests/support/foam_files.hpp"

#include <sys/stat.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include <cstdlib>

namespace wakesurf::importer::named_files_test {
namespace {

class NamedFiles : public Import {
  protected:
    void SetUp() override {
        fs::create_directories(folder_ / "scratch");
        fs::create_directories(folder_ / "case");
        for (int step = 0; step < 3; ++step) {
            auto image = sample_image();
            put_known_flow(*image, step);
            auto writer = vtkSmartPointer<vtkXMLImageDataWriter>::New();
            writer->SetFileName(scratch(step).c_str());
            writer->SetInputData(image);
            ASSERT_EQ(writer->Write(), 1);
        }
    }

    fs::path scratch(int step) const {
        return folder_ / "scratch" / ("s_" + std::to_string(step) + ".vti");
    }

    // Reads all three time-steps, and names no folder on the way.
    void expect_open_only_to_the_owner(const std::string& name) {
        const auto outcome = run(name);
        EXPECT_EQ(outcome.status, 0) << name << ": " << outcome.errors;
        EXPECT_EQ(manifest().layout.times.size(), 3u) << name;
        EXPECT_TRUE(manifest().complete);
        for (const auto& line : outcome.lines)
            EXPECT_EQ(line.find(folder_.path().string()), std::string::npos) << line;
        fs::remove_all(store());
        expect_refusal(name, "lies outside of its folder", {"--confined"});
    }
};

TEST_F(NamedFiles, OfACollectionMayLieAnywhere) {
    put("case/up.pvd", pvd_text({{"0", "../scratch/s_0.vti"},
                                 {"1", "../scratch/s_1.vti"},
                                 {"2", "../scratch/s_2.vti"}}));
    expect_open_only_to_the_owner("case/up.pvd");
    put("case/absolute.pvd", pvd_text({{"0", scratch(0)}, {"1", scratch(1)}, {"2", scratch(2)}}));
    expect_open_only_to_the_owner("case/absolute.pvd");
    put("case/far.vti.series", R"({"file-series-version": "1.0", "files": [)"
                               R"({"name": "../scratch/s_0.vti", "time": 0},)"
                               R"({"name": "../scratch/s_1.vti", "time": 1},)"
                               R"({"name": "../scratch/s_2.vti", "time": 2}]})");
    expect_open_only_to_the_owner("case/far.vti.series");
}

TEST_F(NamedFiles, MayBeLinks) {
    for (int step = 0; step < 3; ++step)
        fs::create_symlink("../scratch/s_" + std::to_string(step) + ".vti",
                           folder_ / "case" / ("link_" + std::to_string(step) + ".vti"));
    expect_open_only_to_the_owner("case");
    expect_open_only_to_the_owner("case/link_*.vti");
    expect_open_only_to_the_owner("case/link_1.vti");
}

TEST_F(NamedFiles, ThatAreNotThereAreToldWithoutTheirFolder) {
    put("case/gone.pvd", pvd_text({{"0", folder_ / "scratch/none.vti"}}));
    expect_refusal("case/gone.pvd", "gone.pvd names none.vti, which does not exist");
}

// Each of the commands of `wakesurf` is on a command line; a link keeps the name that it is given by.
TEST_F(NamedFiles, OfALinkToAFileAreThoseBesideTheLink) {
    for (const int step : {0, 2})
        fs::create_symlink(scratch(step),
                           folder_ / "case" / ("link_" + std::to_string(step) + ".vti"));
    std::string text;
    const auto info = run_child(server_program(), {"info", folder_ / "case/link_0.vti"}, 0,
                                [&](std::string_view line) { text.append(line).append("\n"); }, {});
    EXPECT_EQ(info->exit_status, 0) << info->errors;
    EXPECT_NE(text.find("times     2 from 0 to 1"), std::string::npos) << text;
    const auto refused =
        run_child(server_program(), {"info", folder_ / "case/link_0.vti", "--confined"}, 0,
                  [](std::string_view) {}, {});
    EXPECT_EQ(refused->exit_status, 1);
    EXPECT_NE(refused->errors.find("lies outside"), std::string::npos) << refused->errors;
}

TEST_F(NamedFiles, OfTheServerArePrivateInAnyCase) {
    const std::string secret = "--secret=" + (folder_ / "scratch").string();
    put("case/up.pvd", pvd_text({{"0", "../scratch/s_0.vti"}}));
    expect_refusal("case/up.pvd", "up.pvd names s_0.vti, which is private to the server", {secret});
    fs::create_symlink("../scratch/s_0.vti", folder_ / "case/link_0.vti");
    expect_refusal("case/link_0.vti", "link_0.vti is a file, which is private to the server",
                   {secret});
    ASSERT_EQ(::setenv("WAKESURF_STATE", (folder_ / "scratch").c_str(), 1), 0);
    expect_refusal("case/up.pvd", "which is private to the server");
    ::unsetenv("WAKESURF_STATE");
    EXPECT_EQ(run("scratch/s_0.vti", {secret}).status, 0) << "named by the owner";
}

class NamedByCases : public Import {
  protected:
    void SetUp() override {
        const auto mesh = foam_block_mesh({});
        FoamField velocity;
        for (const int cell : mesh.cells)
            velocity.values.push_back({0.5 * cell, 1.0, 2.0});
        for (const char* place : {"case", "other"}) {
            write_foam_mesh(folder_ / place / "constant", mesh);
            for (const char* time : {"0", "1"})
                write_foam_field(folder_ / place / time, mesh, velocity);
        }
        write_file(folder_ / "token", word + "\n");
        whole_ = read_file(folder_ / "case/1/U");
    }

    // The velocity with other words behind its internalField.
    void put_inside(const std::string& words) const {
        const auto at = whole_.find("internalField");
        put("case/1/U", whole_.substr(0, at) + "internalField " + words + ";\n" +
                            whole_.substr(whole_.find("boundaryField", at)));
    }

    const std::string word = "Zx9365tokenOfTheServer";
    std::string whole_;
};

TEST_F(NamedByCases, AreNotReadForTheValuesOfAField) {
    const std::string file = "\"" + (folder_ / "token").string() + "\"";
    for (const std::string& words :
         {"nonuniform #include " + file, "nonuniform List<vector> #include " + file,
          "#include " + file, "uniform #calc " + file, std::string("#codeStream { }")}) {
        put_inside(words);
        expect_refusal("case", "by a directive (#include, #calc ...), which are not looked up");
        EXPECT_EQ(run("case").errors.find(word), std::string::npos) << words;
        fs::remove_all(store());
    }
}

TEST_F(NamedByCases, AreNotReadForAMesh) {
    for (const char* name : {"points", "faces", "owner", "neighbour", "boundary"}) {
        const std::string file = std::string("case/constant/polyMesh/") + name;
        const std::string sound = read_file(folder_ / file);
        auto text = sound;
        text.insert(text.find('}') + 1, "\n#include \"" + (folder_ / "token").string() + "\"\n");
        put(file, text);
        expect_refusal("case", std::string(name) + " has a directive (#include ...)");
        put(file, sound);
    }
    EXPECT_EQ(run("case").status, 0);
}

TEST_F(NamedByCases, AreNotReadForTheHeaderOfAnyFieldOrForSettings) {
    ASSERT_EQ(::mkfifo((folder_ / "fifo").c_str(), 0600), 0); // whoever opens it waits
    const std::string directive = "\n#include \"" + (folder_ / "fifo").string() + "\"\n";
    auto header = whole_;
    header.insert(header.find('{') + 1, directive);
    for (const char* name : {"case/0/W", "case/1/W", "case/1/lagrangian/cloud/positions"}) {
        fs::create_directories((folder_ / name).parent_path());
        put(name, header);
        expect_refusal("case", "has an #include, which is not followed", {"--survey=10"});
        fs::remove(folder_ / name);
    }
    fs::create_directories(folder_ / "case/system");
    put("case/system/controlDict", header + directive);
    put("case/constant/polyMesh/cellZones", header);
    EXPECT_EQ(run("case", {"--survey=10"}).status, 0);
}

TEST_F(NamedByCases, MayBeLinksOnlyForWhoTrustsThem) {
    for (const char* name :
         {"1", "1/U", "constant", "constant/polyMesh", "constant/polyMesh/points"}) {
        const fs::path place = folder_ / "case" / name;
        const fs::path aside = folder_ / "aside";
        fs::rename(place, aside);
        fs::create_symlink(folder_ / "other" / name, place);
        EXPECT_EQ(run("case").status, 0) << name;
        EXPECT_EQ(manifest().layout.times.size(), 2u) << name;
        fs::remove_all(store());
        expect_refusal("case", "which lies outside of its folder", {"--confined"});
        expect_refusal("case", "which is private to the server",
                       {"--secret=" + (folder_ / "other").string()});
        fs::remove(place);
        fs::rename(aside, place);
    }
    fs::create_symlink("1", folder_ / "case/2");
    EXPECT_EQ(run("case", {"--confined"}).status, 0) << "a link within the folder";
    EXPECT_EQ(manifest().layout.times.size(), 3u);
}

// Links in files of HDF5 are followed by its library, which asks nobody.
TEST_F(NamedByCases, AreLinksOfALibraryOnlyForWhoTrustsThem) {
    if (!kernel_has_landlock())
        GTEST_SKIP() << "this kernel has no Landlock";
    fs::create_directories(folder_ / "cgns");
    Contents contents;
    contents.times = {1};
    write_cgns(folder_ / "cgns/flow.cgns", contents);
    fs::copy(folder_ / "cgns/flow.cgns", folder_ / "other/flow.cgns");
    int file = 0;
    ok(cg_open((folder_ / "cgns/flow.cgns").c_str(), CG_MODE_MODIFY, &file));
    std::array<char, 33> base{};
    std::array<char, 33> zone{};
    std::array<int, 2> dimensions{};
    std::array<cgsize_t, 9> size{};
    ok(cg_base_read(file, 1, base.data(), &dimensions[0], &dimensions[1]));
    ok(cg_zone_read(file, 1, 1, zone.data(), size.data()));
    ok(cg_goto(file, 1, zone.data(), 0, nullptr));
    ok(cg_delete_node("Flow0"));
    ok(cg_link_write("Flow0", (folder_ / "other/flow.cgns").c_str(),
                     (std::string("/") + base.data() + "/" + zone.data() + "/Flow0").c_str()));
    ok(cg_close(file));
    const auto trusted = run("cgns/flow.cgns");
    EXPECT_EQ(trusted.status, 0) << trusted.errors;
    fs::remove_all(store());
    EXPECT_EQ(run("cgns/flow.cgns", {"--confined"}).status, 1);
    EXPECT_EQ(run("cgns/flow.cgns", {"--secret=" + (folder_ / "other").string()}).status, 1);
}

} // namespace
} // namespace wakesurf::importer::named_files_test
