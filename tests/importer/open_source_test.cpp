// Which reader a path gets.
#include "importer/sources/open_source.hpp"
#include "tests/importer/vtk_files.hpp"
#include "tests/support/foam_files.hpp"

namespace wakesurf::importer::open_source_test {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

using OpenSource = VtkFiles;

TEST_F(OpenSource, TakesAnOpenFoamCaseForOneDataset) {
    const FoamMesh mesh = foam_block_mesh({{3, 3, 3}, false});
    const fs::path folder = folder_ / "cavity";
    write_foam_mesh(folder / "constant", mesh);
    FoamField field;
    field.values.assign(27, {1.0, 2.0, 3.0});
    for (const char* time : {"0.5", "1"})
        write_foam_field(folder / time, mesh, field);
    write_file(folder / "cavity.foam", "");
    write_step("cavity/post.vtu", *sample_mesh(), 0); // beside the case, not instead of it
    for (const auto& path : {folder, folder / "", folder / "cavity.foam", folder_.path()}) {
        const auto source = open_source(path);
        ASSERT_TRUE(source.has_value()) << path << ": " << source.error().message;
        EXPECT_EQ((*source)->description().times, (std::vector<double>{0.5, 1}));
    }
}

TEST_F(OpenSource, TellsGridsOfTheSameExtensionByWhatTheyHold) {
    const auto grid = folder_ / "grid.g";
    write_file(grid, "1 2 3 ");
    expect_failure(open_source(grid), Error::Code::NotFound,
                   "no solutions beside grid.g"); // Plot3D
    write_file(grid, "CDF\1 cut off");
    const auto exodus = open_source(grid);
    ASSERT_FALSE(exodus.has_value());
    EXPECT_EQ(exodus.error().code, Error::Code::Corrupt);
}

TEST_F(OpenSource, ListsTheFormatsThatCanBeRead) {
    write_file(folder_ / "flow.plt", "#!TDV112");
    const auto source = open_source(folder_ / "flow.plt");
    expect_failure(source, Error::Code::Unsupported, "flow.plt is of a format that cannot be read");
    for (const char* format : {"OpenFOAM", ".case", ".exo", ".cgns", ".nc", ".q", ".vtu", ".pvd"})
        EXPECT_NE(source.error().hint.find(format), std::string::npos) << format;
    expect_failure(open_source(folder_ / "gone.cgns"), Error::Code::NotFound, "gone.cgns");
    write_file(folder_ / "empty.cgns", "");
    expect_failure(open_source(folder_ / "empty.cgns"), Error::Code::Corrupt,
                   "empty.cgns is empty");
}

} // namespace
} // namespace wakesurf::importer::open_source_test
