// Which reader a path gets.
#include "importer/sources/open_source.hpp"
#include "tests/importer/cgns_files.hpp"
#include "tests/importer/netcdf_files.hpp"
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
    write_file(folder_ / "flow.own", "1 2 3");
    const auto source = open_source(folder_ / "flow.own");
    expect_failure(source, Error::Code::Unsupported, "flow.own is of a format that cannot be read");
    for (const char* format : {"OpenFOAM", ".case", ".exo", ".cgns", ".nc", ".q", ".vtu", ".pvd"})
        EXPECT_NE(source.error().hint.find(format), std::string::npos) << format;
    expect_failure(open_source(folder_ / "gone.cgns"), Error::Code::NotFound, "gone.cgns");
    write_file(folder_ / "empty.cgns", "");
    expect_failure(open_source(folder_ / "empty.cgns"), Error::Code::Corrupt,
                   "empty.cgns is empty");
}

TEST_F(OpenSource, SaysWhatAFileOfAnotherFormatIsAndWhatToDo) {
    using namespace std::string_literals;

    struct Other {
        std::string name;
        std::string bytes;
        std::string is;
        std::string hint;
    };

    for (const auto& [name, bytes, is, hint] : std::vector<Other>{
             {"flow.plt", "#!TDV112", "binary data of Tecplot", "ParaView"},
             {"flow.szplt", "#!SZPLT", "Tecplot in sub-zones", ".plt"},
             {"flow.dat", "TITLE = \"a\"\nVARIABLES = \"X\", \"U\"\nZONE I=2\n", "text of Tecplot",
              "ParaView"},
             {"flow.cas", "(0 \"fluent13.0\")", "Fluent", "EnSight Case Gold"},
             {"flow.dat", "(0 \"Data written by Fluent\")", "Fluent", "CGNS"},
             {"flow.cas.h5", "\x89HDF\r\n\x1a\n", "Fluent", "EnSight"},
             {"flow.sim", "bytes", "STAR-CCM+", "EnSight Gold"},
             {"flow.xdmf", "<?xml version=\"1.0\"?>\n<Xdmf>", "XDMF", "ParaView"},
             {"flow.xml", "<?xml version=\"1.0\"?>\n<Xdmf>", "XDMF", "ParaView"},
             {"flow.grib", "GRIB\0\0"s, "GRIB", "NetCDF"},
             {"f0.f00001", "#std 4 8 8 8", "Nek5000", ".nek5000"},
             {"mesh.su2", "NDIME= 3\n", "a mesh of SU2", "OUTPUT_FILES"},
             {"restart_flow.dat", "\xec\x2b\x08\x00"s, "a restart of SU2", "OUTPUT_FILES"},
             {"mesh.msh", "$MeshFormat\n4.1 0 8\n", "Gmsh", "meshio"},
             {"mesh.stl", "solid body\nfacet normal 0 0 1\n", "a surface", "in the volume"},
             {"flow.h4", "\x0e\x03\x13\x01"s, "HDF4", "NetCDF"},
             {"flow.hdf", "\x0e\x03\x13\x01"s, "HDF4", "NetCDF"},
             {"flow.vdf", "<VDF>", "VAPOR", "NetCDF"},
             {"view.pvsm", "<ParaView>\n", "a state of ParaView", "Save Data"},
             {"flow.zip", "PK\x03\x04", "a zip archive", "unpack"},
             {"flow.vtu", "\x1f\x8b\x08", "packed by gzip", "unpack"},
             {"flow.nc", "GRIB\0\0"s, "GRIB", "cdo"},
             {"flow.tar", std::string(257, 'a') + "ustar", "a tar archive", "unpack"},
             {"flow.h5", "\x89HDF\r\n\x1a\n", "HDF5 with a layout of the program", ".xdmf"},
             {"flow.h5", "\x89HDF\r\n\x1a\n VTKHDF", "VTKHDF", "call it .vtkhdf"},
             {"flow.fun", "bytes", "a function file of Plot3D", ".vts"},
             {"U", "FoamFile\n{", "one file of an OpenFOAM case", "the folder of the case"},
             {"flow", "<VTKFile type=\"ImageData\">", "an ending that does not say which", ".vti"},
             {"flow.geo", "C Binary", "one file of an EnSight case", ".case"}}) {
        write_file(folder_ / name, bytes);
        const auto source = open_source(folder_ / name);
        expect_failure(source, Error::Code::Unsupported,
                       name + " is of a format that cannot be read: ");
        EXPECT_NE(source.error().message.find(is), std::string::npos) << source.error().message;
        EXPECT_NE(source.error().hint.find(hint), std::string::npos) << source.error().hint;
        fs::remove(folder_ / name);
    }
    fs::create_directory(folder_ / "plt00010");
    write_file(folder_ / "plt00010" / "Header", "HyperCLaw-V1.1\n3\n");
    expect_failure(open_source(folder_ / "plt00010"), Error::Code::Unsupported,
                   "plt00010 is of a format that cannot be read: a plotfile of AMReX");
    fs::create_directory(folder_ / "run");
    write_file(folder_ / "run" / "a.plt", "#!TDV112");
    expect_failure(open_source(folder_ / "run"), Error::Code::NotFound,
                   "run holds nothing that can be read: a.plt is of a format that cannot be read: "
                   "binary data of Tecplot");
}

TEST_F(OpenSource, KnowsNetcdfAndCgnsByWhatTheyHoldWhateverTheyAreCalled) {
    for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4})
        for (const char* const name :
             {"wrfout_d01_2020-01-01_00_00_00", "flow.dat", "flow.x", "flow.hdf"}) {
            Flow flow;
            flow.format = format;
            fs::create_directory(folder_ / "run");
            write_flow(folder_ / "run" / name, flow);
            for (const auto& path : {folder_ / "run" / name, folder_ / "run"}) {
                if (path.filename() == "run" && std::string_view(name) == "flow.x")
                    continue; // of a folder the endings are looked at first
                const auto source = open_source(path);
                ASSERT_TRUE(source.has_value()) << path << ": " << source.error().message;
                EXPECT_EQ((*source)->description().times, flow.times);
            }
            fs::remove(folder_ / "run" / name);
        }
    for (const bool adf : {false, true}) {
        write_cgns(folder_ / "flow", {.adf = adf});
        const auto source = open_source(folder_ / "flow");
        ASSERT_TRUE(source.has_value()) << source.error().message;
        EXPECT_EQ((*source)->description().times.size(), 3u);
        fs::remove(folder_ / "flow");
    }
}

} // namespace
} // namespace wakesurf::importer::open_source_test
