// Small files that would take all of a machine's memory or time, or crash what reads them: each ends in seconds, within its
// bound, with one sentence that says what to do.
#include "tests/importer/import_fixture.hpp"
#include "tests/support/foam_files.hpp"

#include <sys/resource.h>
#include <vtk_cgns.h>
#include <vtk_exodusII.h>
#include <vtk_hdf5.h>
// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <array>

namespace wakesurf::importer::hostile_files_test {
namespace {

class HostileFiles : public Import {
  protected:
    static constexpr const char* bound = "--memory=512MiB";

    // Refused by both commands, with words that hold one of `any_of`: not those of a survey that took
    // too long.
    void expect_refused_soon(const fs::path& source, const std::vector<std::string>& any_of) {
        for (const auto& arguments : {std::vector<std::string>{bound, "--describe", source},
                                      std::vector<std::string>{bound, source, store()}}) {
            const auto outcome = import(arguments);
            EXPECT_EQ(outcome.status, 1) << source.filename() << ": " << outcome.errors;
            EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1)
                << outcome.errors;
            EXPECT_TRUE(std::any_of(any_of.begin(), any_of.end(), [&](const std::string& words) {
                return outcome.errors.find(words) != std::string::npos;
            })) << outcome.errors;
        }
        rusage children{};
        ::getrusage(RUSAGE_CHILDREN, &children);
        EXPECT_LT(children.ru_maxrss, 800 * 1024) << "of the largest process, in kB";
    }
};

const std::vector<std::string> of_memory{"memory: an import may take 512 MiB (import it with "
                                         "--memory SIZE",
                                         "needs too much memory"};

TEST_F(HostileFiles, ThatClaimBillionsOfComponents) {
    auto text = sample_vti().text();
    const std::string three = "NumberOfComponents=\"3\"";
    text.replace(text.find(three), three.size(), "NumberOfComponents=\"2000000000\"");
    expect_refused_soon(put("hugecomp.vti", text), {of_memory[0], of_memory[1], "hugecomp.vti"});
    // Appended data: nothing but the header is looked at before the array is made.
    const auto begin = text.find("<DataArray");
    const auto end = text.find("</DataArray>") + 12;
    text.replace(begin, end - begin,
                 "<DataArray type=\"Float64\" Name=\"U\" NumberOfComponents=\"2000000000\" "
                 "format=\"appended\" offset=\"0\"/>");
    text.replace(text.find("</VTKFile>"), 10,
                 "<AppendedData encoding=\"raw\">_12345678</AppendedData></VTKFile>");
    expect_refused_soon(put("appended.vti", text), {of_memory[0], of_memory[1], "appended.vti"});
}

TEST_F(HostileFiles, ThatClaimBillionsOfCells) {
    const std::string array = "<DataArray type=\"Int64\" Name=\"NAME\" format=\"ascii\">0 1 2 3"
                              "</DataArray>";
    const auto named = [&](const char* name) {
        auto out = array;
        return out.replace(out.find("NAME"), 4, name);
    };
    expect_refused_soon(
        put("hugecells.vtu",
            "<?xml version=\"1.0\"?><VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" header_type=\"UInt64\"><UnstructuredGrid><Piece "
            "NumberOfPoints=\"4\" NumberOfCells=\"4000000000\"><PointData>" +
                vti_array("U", 3, 4, [](std::size_t) { return 1.0; }) + "</PointData><Points>" +
                vti_array("P", 3, 4, [](std::size_t i) { return static_cast<double>(i % 5); }) +
                "</Points><Cells>" + named("connectivity") + named("offsets") + named("types") +
                "</Cells></Piece></UnstructuredGrid></VTKFile>\n"),
        {of_memory[0], of_memory[1], "hugecells.vtu"});
}

TEST_F(HostileFiles, ThatNestBlocksSoDeepThatParsersCrash) {
    std::string deep;
    std::string ends;
    for (int i = 0; i < 200'000; ++i) {
        deep += "<Block index=\"0\">";
        ends += "</Block>";
    }
    const std::string multi_block = "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\">"
                                    "<vtkMultiBlockDataSet>";
    expect_refused_soon(
        put("deep.vtm", multi_block + deep + ends + "</vtkMultiBlockDataSet></VTKFile>\n"),
        {"deep.vtm has elements nested more than 64 deep"});
    expect_refused_soon(
        put("deep.pvd", "<VTKFile type=\"Collection\">" + deep + ends + "</VTKFile>\n"),
        {"deep.pvd has elements nested more than 64 deep"});
    expect_refused_soon(put("cut.vtm", multi_block + deep + "</VTKFile>\n"), {"cut.vtm"});
}

// A number in the table of cells that no mesh of this size has: VTK's reader makes, or looks for, as many cells.
TEST_F(HostileFiles, ThatNameCellsFarBeyondTheMesh) {
    for (const bool binary : {false, true}) {
        const auto mesh = foam_block_mesh({});
        FoamField velocity;
        for (const int cell : mesh.cells)
            velocity.values.push_back({0.5 * cell, 1.0, 2.0});
        const fs::path place = folder_ / (binary ? "binary" : "text");
        write_foam_mesh(place / "constant", mesh, binary);
        write_foam_field(place / "0", mesh, velocity, binary);
        write_file(place / "case.foam", "");
        const fs::path owner = place / "constant" / "polyMesh" / "owner";
        std::string text = read_file(owner);
        const auto list = text.rfind('(');
        if (binary) {
            const std::int32_t large = 1'500'000'000;
            text.replace(list + 1 + 4 * 20, 4, reinterpret_cast<const char*>(&large), 4);
        } else {
            text.insert(text.find_first_of("0123456789", list + 60), "15000000");
        }
        write_file(owner, text);
        expect_refused_soon(place / "case.foam",
                            {"constant/polyMesh/owner is damaged: it names cell "});
    }
}

TEST_F(HostileFiles, ThatNeedMoreThanAnyBoundSayWhichBoundWhereTheyAreGood) {
    auto file = sample_vti();
    file.nodes = {128, 128, 128}; // far more than the bound: a little is over for less than a look
    file.points = vti_array("U", 3, file.point_count(), [](std::size_t) { return 1.0; });
    put("large.vti", file.text());
    const auto outcome = run("large.vti", {"--memory=12MiB"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.errors.find("an import may take 12 MiB (import it with --memory SIZE"),
              std::string::npos)
        << outcome.errors;
    EXPECT_EQ(run("large.vti", {"--memory=2GiB"}).status, 0);
}

/// A file of this length that takes nothing on the disk.
void make_long(const fs::path& file) {
    fs::resize_file(file, std::uintmax_t{64} << 30);
}

TEST_F(HostileFiles, ThatAreLongAndClaimMoreThanTheBoundAreNotRead) {
    const std::string head = "# vtk DataFile Version 3.0\nlong\nBINARY\n";
    const std::string velocity = "POINT_DATA 27000000000\nVECTORS U float\n";
    const std::vector<std::pair<std::string, std::string>> files{
        {"structured.vtk", "DATASET STRUCTURED_POINTS\nDIMENSIONS 3000 3000 3000\nORIGIN 0 0 0\n"
                           "SPACING 1 1 1\n" +
                               velocity},
        {"scalars.vtk",
         "DATASET STRUCTURED_POINTS\nDIMENSIONS 3000 3000 3000\nORIGIN 0 0 0\n"
         "SPACING 1 1 1\nPOINT_DATA 27000000000\nSCALARS p float\nLOOKUP_TABLE default\n"},
        {"rectilinear.vtk", "DATASET RECTILINEAR_GRID\nDIMENSIONS 3000 3000 3000\n"
                            "X_COORDINATES 3000 float\n"},
        {"mesh.vtk", "DATASET UNSTRUCTURED_GRID\nPOINTS 27000000000 float\n"},
        {"small.vtk", "DATASET STRUCTURED_POINTS\nDIMENSIONS 3 3 3\nORIGIN 0 0 0\nSPACING 1 1 1\n"
                      "POINT_DATA 27\nVECTORS U float\n"}};
    for (const auto& [name, text] : files) {
        make_long(put(name, head + text));
        expect_refused_soon(folder_ / name, {"an import may take 512 MiB"});
    }
    auto xml = sample_vti();
    xml.nodes = {3000, 3000, 3000};
    xml.points = "<DataArray type=\"Float32\" Name=\"U\" NumberOfComponents=\"3\" "
                 "format=\"appended\" offset=\"0\"/>";
    auto appended = xml.text();
    appended.replace(appended.find("</VTKFile>"), 10,
                     "<AppendedData encoding=\"raw\">_</AppendedData></VTKFile>");
    put("long.vti", appended);
    expect_refused_soon(folder_ / "long.vti", {"U does not have the size that the file declares"});
}

TEST_F(HostileFiles, OfOpenfoamThatClaimLongListsAreNotRead) {
    for (const bool binary : {false, true})
        for (const std::string file :
             {"constant/polyMesh/points", "constant/polyMesh/faces", "constant/polyMesh/owner",
              "constant/polyMesh/neighbour", "0/U"}) {
            SCOPED_TRACE(file + (binary ? " binary" : " text"));
            const auto mesh = foam_block_mesh({});
            FoamField velocity;
            for (const int cell : mesh.cells)
                velocity.values.push_back({0.5 * cell, 1.0, 2.0});
            const fs::path place = folder_ / "case";
            fs::remove_all(place);
            write_foam_mesh(place / "constant", mesh, binary);
            write_foam_field(place / "0", mesh, velocity, binary);
            write_file(place / "case.foam", "");
            std::string text = read_file(place / file);
            const auto list = text.find("internalField");
            const auto begin = list == std::string::npos ? text.find("}") : text.find('>', list);
            const auto number = text.find_first_of("0123456789", begin);
            text.replace(number, text.find_first_not_of("0123456789", number) - number,
                         "1500000000");
            write_file(place / file, text);
            expect_refused_soon(place / "case.foam", {"an import may take 512 MiB"});
        }
}

TEST_F(HostileFiles, OfEnsightThatAreLongAreNotRead) {
    const std::string head = "a\nb\nnode id off\nelement id off\npart\n         1\nbox\n"
                             "coordinates\n2000000000\n";
    write_file(folder_ / "flow.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: mesh\n"
                                      "VARIABLE\nvector per node: velocity u\n");
    put("u", "u\n");
    make_long(put("mesh", head));
    expect_refused_soon(folder_ / "flow.case", {"an import may take 512 MiB"});
}

TEST_F(HostileFiles, OfExodusThatClaimManyNodesOrElementsAreNotRead) {
    ex_opts(0);
    for (const bool nodes : {true, false}) {
        const fs::path file = folder_ / (nodes ? "nodes.exo" : "elements.exo");
        int word = 8;
        const int out =
            ex_create(file.c_str(), EX_CLOBBER | EX_NETCDF4 | EX_ALL_INT64_DB, &word, &word);
        ASSERT_GE(out, 0);
        ex_init_params sizes{};
        sizes.num_dim = 3;
        sizes.num_nodes = nodes ? 3'000'000'000 : 8;
        sizes.num_elem = nodes ? 1 : 3'000'000'000;
        sizes.num_elem_blk = 1;
        ASSERT_EQ(ex_put_init_ext(out, &sizes), 0);
        ASSERT_EQ(ex_close(out), 0);
        expect_refused_soon(file, {"an import may take 512 MiB"});
    }
}

TEST_F(HostileFiles, OfCgnsThatClaimManyNodesOrElementsAreNotRead) {
    for (const bool structured : {true, false}) {
        const fs::path path = folder_ / (structured ? "structured.cgns" : "mesh.cgns");
        int file = 0;
        int base = 0;
        int zone = 0;
        ASSERT_EQ(cg_open(path.c_str(), CG_MODE_WRITE, &file), CG_OK);
        ASSERT_EQ(cg_base_write(file, "Base", 3, 3, &base), CG_OK);
        const std::array<cgsize_t, 9> size =
            structured ? std::array<cgsize_t, 9>{1200, 1200, 1200, 1199, 1199, 1199}
                       : std::array<cgsize_t, 9>{1'500'000'000, 1'500'000'000};
        ASSERT_EQ(cg_zone_write(file, base, "Zone", size.data(),
                                structured ? CGNS_ENUMV(Structured) : CGNS_ENUMV(Unstructured),
                                &zone),
                  CG_OK);
        ASSERT_EQ(cg_close(file), CG_OK);
        expect_refused_soon(path, {"an import may take 512 MiB"});
    }
}

TEST_F(HostileFiles, OfHdfThatClaimManyNodesAreNotRead) {
    for (const bool image : {true, false}) {
        const fs::path path = folder_ / (image ? "image.vtkhdf" : "mesh.vtkhdf");
        const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
        const hid_t root = H5Gcreate2(file, "VTKHDF", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        const std::array<int, 6> ends{0, 2999, 0, 2999, 0, 2999};
        const long long many = 27'000'000'000;
        const hsize_t count = image ? 6 : 1;
        const hid_t space = H5Screate_simple(1, &count, nullptr);
        if (image) {
            const hid_t extent =
                H5Acreate2(root, "WholeExtent", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT);
            EXPECT_GE(H5Awrite(extent, H5T_NATIVE_INT, ends.data()), 0);
            H5Aclose(extent);
        } else {
            const hid_t data = H5Dcreate2(root, "NumberOfPoints", H5T_NATIVE_LLONG, space,
                                          H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
            EXPECT_GE(H5Dwrite(data, H5T_NATIVE_LLONG, H5S_ALL, H5S_ALL, H5P_DEFAULT, &many), 0);
            H5Dclose(data);
        }
        H5Sclose(space);
        H5Gclose(root);
        H5Fclose(file);
        expect_refused_soon(path, {"an import may take 512 MiB"});
    }
}

} // namespace
} // namespace wakesurf::importer::hostile_files_test
