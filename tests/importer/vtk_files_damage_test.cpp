// VTK's own files that are damaged, hold what cannot be read, or are not what they say.
#include "importer/sources/open_source.hpp"
#include "tests/importer/vtk_files.hpp"
#include "tests/support/vti_text.hpp"

#include <vtkDataSetWriter.h>

namespace wakesurf::importer::vtk_files_damage_test {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

using DamagedVtkFiles = VtkFiles;

// Not silently wrong: what is read of a cut or changed file is an error or what was written.
TEST_F(DamagedVtkFiles, RefusesEveryTruncation) {
    auto image = sample_image(24, 24, 24);
    put_known_flow(*image, 0);
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
        auto writer = vtkSmartPointer<vtkXMLDataSetWriter>::New();
        writer->SetFileName((folder_ / "whole.vti").c_str());
        writer->SetDataMode(mode);
        writer->SetInputData(image);
        ASSERT_EQ(writer->Write(), 1);
        const std::string whole = read_file(folder_ / "whole.vti");
        const std::size_t stride = std::max<std::size_t>(4096, whole.size() / 40 / 4096 * 4096);
        for (std::size_t size = 0; size < whole.size(); size += stride) {
            const auto source = open_source(put("cut.vti", whole.substr(0, size)));
            expect_failure(source, Error::Code::Corrupt, "cut.vti");
            const auto mended =
                open_source(put("cut.vti", whole.substr(0, size) + "</AppendedData></VTKFile>"));
            EXPECT_FALSE(mended.has_value()) << size;
        }
    }
}

TEST_F(DamagedVtkFiles, RefusesEveryTruncationOfLegacyFiles) {
    for (const int type : {VTK_ASCII, VTK_BINARY}) {
        auto mesh = sample_mesh();
        put_known_flow(*mesh, 0);
        auto writer = vtkSmartPointer<vtkDataSetWriter>::New();
        writer->SetFileName((folder_ / "whole.vtk").c_str());
        writer->SetFileType(type);
        writer->SetInputData(mesh);
        ASSERT_EQ(writer->Write(), 1);
        const std::string whole = read_file(folder_ / "whole.vtk");
        for (std::size_t size = 1; size + 1 < whole.size(); size += 13) {
            const auto source = open_source(put("cut.vtk", whole.substr(0, size)));
            const auto read = source ? (*source)->read(0, known_fields())
                                     : core::Result<SourceStep>(tl::unexpected(source.error()));
            if (read) // what follows the arrays that are read is missing
                expect_known_flow(*read->blocks[0], 0);
            else
                EXPECT_FALSE(read.error().message.empty());
            ASSERT_FALSE(HasFailure()) << size;
        }
    }
}

TEST_F(DamagedVtkFiles, SurvivesFlippedBitsInCompressedFiles) {
    for (const std::string extension : {".vti", ".vtr", ".vts", ".vtu"}) {
        vtkSmartPointer<vtkDataSet> data = sample_mesh();
        if (extension == ".vti")
            data = sample_image();
        if (extension == ".vtr")
            data = sample_rectilinear();
        if (extension == ".vts")
            data = sample_structured();
        const std::string whole = read_file(write_step("good" + extension, *data, 0));
        std::array<double, 6> wanted{};
        data->GetBounds(wanted.data());
        std::size_t read_as_written = 0, refused = 0;
        for (std::size_t at = 0; at < whole.size(); at += 11) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
            auto source = open_source(put("flip" + extension, damaged));
            auto read = source ? (*source)->read(0, known_fields())
                               : core::Result<SourceStep>(tl::unexpected(source.error()));
            if (!read) {
                EXPECT_FALSE(read.error().message.empty());
                ++refused;
                continue;
            }
            ASSERT_EQ(read->blocks[0]->GetNumberOfPoints(), data->GetNumberOfPoints()) << at;
            if (!std::equal(wanted.begin(), wanted.end(), read->blocks[0]->GetBounds()))
                continue; // a digit of the origin became another digit: no format can tell
            expect_known_flow(*read->blocks[0], 0);
            if (HasFatalFailure())
                FAIL() << extension << " at " << at;
            ++read_as_written;
        }
        EXPECT_GT(refused, read_as_written) << extension;
    }
}

TEST_F(DamagedVtkFiles, RefusesCellsOfNodesThatAreNotThere) {
    auto mesh = sample_mesh();
    put_known_flow(*mesh, 0);
    auto writer = vtkSmartPointer<vtkXMLDataSetWriter>::New();
    writer->SetFileName((folder_ / "m.vtu").c_str());
    writer->SetDataModeToAscii();
    writer->SetInputData(mesh);
    ASSERT_EQ(writer->Write(), 1);
    const std::string good = read_file(folder_ / "m.vtu");
    const auto with = [&](const std::string& from, const std::string& to) {
        auto text = good;
        const auto at = text.find(from, text.find("connectivity"));
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        return open_source(put("bad.vtu", text));
    };
    ASSERT_TRUE(with("0 1 5 4", "0 1 5 4").has_value());
    expect_failure(with("0 1 5 4", "0 1 5 99"), Error::Code::Corrupt, "a node that is not there");
    expect_failure(with("0 1 5 4", "0 1 5 -4"), Error::Code::Corrupt, "a node that is not there");
    expect_failure(with("8 16 22", "8 22 16"), Error::Code::Corrupt, "damaged");
    expect_failure(with("8 16 22", "8 15 22"), Error::Code::Corrupt, "cell 1 has 7 nodes");
    expect_failure(with("12 12 13", "12 12 99"), Error::Code::Corrupt, "unknown type 99");
}

TEST_F(DamagedVtkFiles, RefusesGridsItCannotHold) {
    auto file = sample_vti();
    file.direction = "0 1 0 1 0 0 0 0 1";
    expect_failure(open_source(put("rotated.vti", file.text())), Error::Code::Unsupported,
                   "rotated");
    for (const char* spacing : {"0 1 1", "-1 1 1", "nan 1 1", "1e200 1 1", "a b c"}) {
        file = sample_vti();
        file.spacing = spacing;
        expect_failure(open_source(put("spacing.vti", file.text())), Error::Code::Corrupt,
                       "spacing.vti");
    }
    auto text = sample_vti().text();
    const std::string piece = "<Piece Extent=\"0 2";
    text.replace(text.find(piece), piece.size(), "<Piece Extent=\"0 1");
    expect_failure(open_source(put("hole.vti", text)), Error::Code::Corrupt, "hole.vti has pieces");
    text = sample_vti().text();
    for (auto at = text.find("0 2 0 3 0 4"); at != std::string::npos; at = text.find("0 2 0 3 0 4"))
        text.replace(at, 11, "0 2000000 0 2000000 0 2000000");
    expect_failure(open_source(put("huge.vti", text)), Error::Code::Corrupt, "huge.vti");
    file = sample_vti();
    file.points = vti_array("U", 3, file.point_count() - 1, [](std::size_t) { return 1.0; });
    expect_failure(open_source(put("few.vti", file.text())), Error::Code::Corrupt, "few.vti");
}

TEST_F(DamagedVtkFiles, RefusesFilesThatAreNotWhatTheySay) {
    expect_failure(open_source(folder_ / "missing.vti"), Error::Code::NotFound, "missing.vti");
    for (const std::string name : {"e.vti", "e.vtu", "e.vtm", "e.pvd", "e.vtm.series", "e.vtk"}) {
        expect_failure(open_source(put(name, "")), Error::Code::Corrupt, name + " is empty");
        expect_failure(open_source(put(name, "not XML, whatever ends it: </VTKFile>\n")),
                       Error::Code::Corrupt, name);
    }
    expect_failure(open_source(put("w.vti", pvd_text({{"0", "a.vti"}}))), Error::Code::Unsupported,
                   "w.vti holds Collection");
    expect_failure(open_source(put("mesh.stl", "solid")), Error::Code::Unsupported,
                   "mesh.stl is of a format that cannot be read");
    expect_failure(open_source(put("j.vtm.series", R"({"files":[{"name":"a.vtm","time":"x"}]})")),
                   Error::Code::Corrupt, "not a finite number");
    expect_failure(open_source(put("j.vtm.series", R"({"files":[]})")), Error::Code::Corrupt,
                   "names no files");
    put("self.vtm", "<VTKFile type='vtkMultiBlockDataSet'><vtkMultiBlockDataSet>"
                    "<DataSet file='self.vtm'/></vtkMultiBlockDataSet></VTKFile>");
    expect_failure(open_source(folder_ / "self.vtm"), Error::Code::Unsupported,
                   "nested too deeply");
}

TEST_F(DamagedVtkFiles, TakesAFolderForTheOneDatasetInIt) {
    expect_failure(open_source(folder_.path()), Error::Code::NotFound, "nothing that can be read");
    put("notes.txt", "");
    for (int step = 0; step < 2; ++step)
        write_step("flow_" + std::to_string(step) + ".vtu", *sample_mesh(), step);
    expect_known_series(**open_source(folder_.path()), {0, 1});
    write_step("other.vtu", *sample_mesh(), 0);
    expect_failure(open_source(folder_.path()), Error::Code::InvalidArgument,
                   "several datasets: flow_0.vtu, other.vtu");
    put("s.pvd", pvd_text({{"4", "flow_0.vtu"}, {"5", "flow_1.vtu"}}));
    expect_known_series(**open_source(folder_.path()), {4, 5});
}

TEST_F(DamagedVtkFiles, OpensASeriesWhoseLaterFilesCannotBeRead) {
    for (const bool timed : {false, true})
        for (const std::string& torn : {std::string(), sample_vti().text().substr(0, 200)}) {
            for (int step = 0; step < 4; ++step) {
                auto image = sample_image();
                if (timed)
                    set_time(*image, 0.5 * step);
                write_step("a" + std::to_string(step) + ".vti", *image, step);
            }
            // The last one: a simulation is writing it.
            put("a3.vti", torn);
            auto source = open_source(folder_ / "a0.vti");
            ASSERT_TRUE(source.has_value()) << source.error().message;
            const auto& description = (*source)->description();
            const double step = timed ? 0.5 : 1.0;
            EXPECT_EQ(description.times, (std::vector{0.0, step, 2 * step, 3 * step}));
            EXPECT_TRUE((*source)->read(2, known_fields()).has_value());
            expect_failure((*source)->read(3, known_fields()), Error::Code::Corrupt, "a3.vti");
            // One in the middle as well.
            put("a1.vti", torn);
            source = open_source(folder_ / "a0.vti");
            ASSERT_TRUE(source.has_value()) << source.error().message;
            EXPECT_EQ((*source)->description().times[2], 2 * step);
            expect_failure((*source)->read(1, known_fields()), Error::Code::Corrupt, "a1.vti");
            EXPECT_TRUE((*source)->read(2, known_fields()).has_value());
        }
}

TEST_F(DamagedVtkFiles, DoesNotGiveAnEarlierStepForADamagedOne) {
    for (int step = 0; step < 3; ++step)
        write_step(std::string("d") + std::to_string(step) + ".vtu", *sample_mesh(), step);
    auto source = open_source(folder_ / "d0.vtu");
    const std::string good = read_file(folder_ / "d1.vtu");
    put("d1.vtu", good.substr(0, good.size() / 2));
    ASSERT_TRUE((*source)->read(0, known_fields()).has_value());
    expect_failure((*source)->read(1, known_fields()), Error::Code::Corrupt, "d1.vtu");
    put("d1.vtu", good);
    expect_known_series(**source, {0, 1, 2});
}

} // namespace
} // namespace wakesurf::importer::vtk_files_damage_test
