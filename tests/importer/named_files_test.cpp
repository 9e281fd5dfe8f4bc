// Files that a source names beside, above or far from its folder, and folders of links: the person who names the source on a command
// line has them read; --confined keeps a stranger's source in its folder.
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/known_flow.hpp"

#include <vtkMultiBlockDataSet.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLMultiBlockDataWriter.h>

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

} // namespace
} // namespace wakesurf::importer::named_files_test
