// VTK's own files as sources: every kind of grid, encoding and collection.
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/open_source.hpp"
#include "tests/importer/vtk_files.hpp"
#include "tests/support/vti_text.hpp"

#include <vtkCellData.h>
#include <vtkDataSetWriter.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLDataSetWriter.h>
#include <vtkXMLMultiBlockDataWriter.h>
#include <vtkXMLPDataSetWriter.h>

namespace wakesurf::importer::vtk_files_source_test {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

using VtkFilesSource = VtkFiles;

TEST_F(VtkFilesSource, ReadsEveryKindOfGridAsASeries) {
    const auto check = [&](const std::string& stem, auto make, const std::string& extension) {
        for (int step = 0; step < 3; ++step)
            write_step(stem + "_" + std::to_string(9 + step) + extension, *make(), step);
        for (const std::string name : {"_9", "_10", "_11", "_*", "_%02d", "_%d"}) {
            auto source = open_source(folder_ / (stem + name + extension));
            ASSERT_TRUE(source.has_value()) << source.error().message;
            expect_known_series(**source, {0, 1, 2});
            EXPECT_EQ((*source)->description().name, stem);
            EXPECT_NE((*source)->description().time_note.find("carry no times"), std::string::npos);
            EXPECT_EQ((*source)->files(1)->size(), 1u);
            EXPECT_EQ((*source)->files(1)->front().name, stem + "_10" + extension);
            EXPECT_TRUE((*source)->shared_files()->empty());
        }
    };
    check(
        "image", [] { return sample_image(); }, ".vti");
    check(
        "rectilinear", [] { return sample_rectilinear(); }, ".vtr");
    check(
        "structured", [] { return sample_structured(); }, ".vts");
    check(
        "mesh", [] { return sample_mesh(); }, ".vtu");
}

TEST_F(VtkFilesSource, ListsFieldsWithComponentsPlacesRangesAndUnits) {
    auto mesh = sample_mesh();
    put_known_flow(*mesh, 0);
    mesh->GetPointData()->GetArray("U")->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "m/s");
    const auto source = open_source(write("mesh.vtu", *mesh));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    const auto* u = field_named(**source, "U");
    const auto* t = field_named(**source, "T");
    ASSERT_TRUE(u != nullptr && t != nullptr && field_named(**source, "p") != nullptr);
    EXPECT_EQ((*source)->description().fields.size(), 3u);
    EXPECT_EQ(u->components, 3);
    EXPECT_EQ(u->source, core::FieldInfo::Source::Point);
    EXPECT_EQ(u->unit, "m/s");
    EXPECT_DOUBLE_EQ(u->range[1], std::sqrt(4.0 * 4.0 + 2.0 * 2.0 + 1.0));
    EXPECT_EQ(t->components, 1);
    EXPECT_EQ(t->source, core::FieldInfo::Source::Cell);
    EXPECT_EQ((*source)->description().reader, "vtkXMLUnstructuredGridReader (vtu)");
    EXPECT_TRUE((*source)->description().note.empty());
}

TEST_F(VtkFilesSource, ReadsOnlyTheNamedFields) {
    const auto source = open_source(write_step("a.vtu", *sample_mesh(), 0));
    const auto read = (*source)->read(0, {known_fields()[0]});
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->blocks[0]->GetPointData()->GetNumberOfArrays(), 1);
    EXPECT_EQ(read->blocks[0]->GetCellData()->GetNumberOfArrays(), 0);
}

TEST_F(VtkFilesSource, ReadsEveryEncodingAndCompression) {
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
        for (const int compressor :
             {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA})
            for (const int order : {vtkXMLWriter::BigEndian, vtkXMLWriter::LittleEndian})
                for (const bool base64 : {false, true}) {
                    auto mesh = sample_mesh();
                    put_known_flow(*mesh, 0);
                    auto writer = vtkSmartPointer<vtkXMLDataSetWriter>::New();
                    writer->SetFileName((folder_ / "e.vtu").c_str());
                    writer->SetDataMode(mode);
                    writer->SetCompressorType(compressor);
                    writer->SetByteOrder(order);
                    writer->SetEncodeAppendedData(base64);
                    writer->SetHeaderTypeToUInt64();
                    writer->SetInputData(mesh);
                    ASSERT_EQ(writer->Write(), 1);
                    auto source = open_source(folder_ / "e.vtu");
                    ASSERT_TRUE(source.has_value()) << source.error().message;
                    expect_known_series(**source, {0});
                }
}

TEST_F(VtkFilesSource, TakesTheTimesTheFilesCarryAndOfTwoTheOneWrittenLast) {
    const auto write_times = [&](std::vector<double> times) {
        for (std::size_t i = 0; i < times.size(); ++i) {
            auto mesh = sample_mesh();
            set_time(*mesh, times[i]);
            write_step(std::string("t") + std::to_string(i) + ".vtu", *mesh, static_cast<int>(i));
        }
        return open_source(folder_ / "t0.vtu");
    };
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
        mode_ = mode;
        expect_known_series(**write_times({0.25, 0.5, 8}), {0.25, 0.5, 8});
    }
    EXPECT_TRUE((*write_times({0.25, 0.5, 8}))->description().note.empty());
    const auto again = write_times({0.25, 0.5, 2, 0.5, 1}).value();
    EXPECT_EQ(again->description().times, (std::vector<double>{0.25, 0.5, 1, 2}));
    for (const auto& [step, number] : {std::pair{0u, 0}, {1u, 3}, {2u, 4}, {3u, 2}}) {
        expect_known_flow(*again->read(step, known_fields())->blocks.front(), number);
        EXPECT_EQ(again->files(step)->front().name, "t" + std::to_string(number) + ".vtu");
    }
    EXPECT_EQ(again->description().time_note,
              "times go back at t3.vtu, as after a restart: they are sorted; left out, as another "
              "was written later for the same time: t1.vtu");
    for (const char* const old : {"t3.vtu", "t4.vtu"})
        std::filesystem::remove(folder_ / old);
    write_step("t1.vtu", *sample_mesh(), 1);
    expect_failure(open_source(folder_ / "t0.vtu"), Error::Code::Corrupt,
                   "t0.vtu has a time, but t1.vtu has none");
}

TEST_F(VtkFilesSource, OrdersFilesByTheNumbersInTheirNamesDecimalsIncluded) {
    int step = 0;
    for (const std::string number : {"0.5", "0.75", "1.0", "10.25"})
        write_step("flow_" + number + ".vtu", *sample_mesh(), step++);
    expect_known_series(**open_source(folder_ / "flow_1.0.vtu"), {0, 1, 2, 3});
    write_step("same_1.vtu", *sample_mesh(), 0);
    write_step("same_01.vtu", *sample_mesh(), 0);
    EXPECT_EQ((*open_source(folder_ / "same_1.vtu"))->description().times.size(), 1u)
        << "padded and not are two series";
    expect_failure(open_source(folder_ / "same_*.vtu"), Error::Code::Corrupt,
                   "have the same number");
    expect_failure(open_source(folder_ / "none_*.vtu"), Error::Code::NotFound,
                   "no file matches none_*.vtu");
    expect_failure(open_source(folder_ / "a*_%d.vtu"), Error::Code::InvalidArgument,
                   "more than one pattern");
}

TEST_F(VtkFilesSource, JoinsThePartsOfACollection) {
    std::string text = "<VTKFile type=\"Collection\"><Collection>";
    for (int step = 0; step < 2; ++step)
        for (int part = 0; part < 2; ++part) {
            const std::string name =
                std::string("s") + std::to_string(step) + std::to_string(part) + ".vtu";
            write_step(name, *sample_mesh(10.0 * part), step);
            text += "<DataSet timestep=\"" + std::to_string(0.5 + step) + "\" group=\"\" part=\"" +
                    std::to_string(part) + "\" file=\"" + name + "\"/>";
        }
    const std::string end = "</Collection></VTKFile>";
    auto source = open_source(put("s.pvd", text + end));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    expect_known_series(**source, {0.5, 1.5});
    const auto read = (*source)->read(1, known_fields());
    ASSERT_TRUE(read.has_value()) << read.error().message;
    ASSERT_EQ(read->blocks.size(), 2u);
    EXPECT_EQ(read->blocks[1]->GetBounds()[1], 13.0);
    EXPECT_EQ((*source)->files(1)->size(), 2u);
    EXPECT_TRUE((*source)->shared_files()->empty()); // a list may grow
    const auto odd = open_source(put("odd.pvd", text +
                                                    "<DataSet timestep=\"3\" part=\"0\" "
                                                    "file=\"s00.vtu\"/>" +
                                                    end))
                         .value();
    EXPECT_EQ(odd->read(2, known_fields())->blocks.size(), 1u)
        << "whether it is one mesh is seen there";
    const auto again = open_source(put("two.pvd", text +
                                                      "<DataSet timestep=\"1.5\" part=\"1\" "
                                                      "group=\"\" file=\"s00.vtu\"/>" +
                                                      end))
                           .value();
    EXPECT_EQ(again->files(1)->back().name, "s00.vtu") << "of one part the last counts";
    EXPECT_EQ(again->description().time_note,
              "left out, as another was written later for the same time: s11.vtu");
}

TEST_F(VtkFilesSource, SortsACollectionByTimeAndRefusesTimesThatAreNone) {
    for (int step = 0; step < 2; ++step)
        write_step(std::string(1, static_cast<char>('a' + step)) + ".vtu", *sample_mesh(), step);
    expect_known_series(**open_source(put("s.pvd", pvd_text({{"2", "b.vtu"}, {"-1.5", "a.vtu"}}))),
                        {-1.5, 2});
    expect_failure(open_source(put("t.pvd", pvd_text({{"1", "a.vtu"}, {"1", "b.vtu"}}))),
                   Error::Code::Corrupt, "t.pvd gives a.vtu and b.vtu the same time, 1");
    for (const std::string time : {"soon", "nan", "1e999"})
        expect_failure(open_source(put("t.pvd", pvd_text({{time, "a.vtu"}}))), Error::Code::Corrupt,
                       "not a finite number");
    expect_failure(open_source(put("t.pvd", pvd_text({{"1", "gone.vtu"}}))), Error::Code::NotFound,
                   "t.pvd names gone.vtu, which does not exist");
    expect_failure(open_source(put("t.pvd", pvd_text({}))), Error::Code::Corrupt, "names no files");
    expect_failure(open_source(put("t.pvd", "no XML")), Error::Code::Corrupt, "t.pvd");
    expect_failure(open_source(put("t.pvd", sample_vti().text())), Error::Code::Corrupt,
                   "Collection");
}

// Two fluid blocks (one nested), a wall by name, one by its velocity, an inlet, a patch that starts at rest.
std::string multi_block_text(int step) {
    const std::string n = std::to_string(step);
    return "<?xml version='1.0'?>\n<VTKFile type='vtkMultiBlockDataSet' version='1.0'>\n"
           "<vtkMultiBlockDataSet>\n<DataSet name='internal' file='f" +
           n +
           "/internal.vtu'/>\n"
           "<Block name='more'><Block name='deep'><DataSet name='b' file='f" +
           n +
           "/b.vts'/>"
           "</Block></Block>\n<Block name='boundary'>"
           "<DataSet name='lowerWall' file='f" +
           n +
           "/wall.vtp'/>"
           "<DataSet name='cylinder' file='f" +
           n +
           "/cylinder.vtp'/>"
           "<DataSet name='inlet' file='f" +
           n +
           "/inlet.vtp'/>"
           "<DataSet name='starting' file='f" +
           n +
           "/starting.vtp'/>"
           "<DataSet name='empty'/></Block></vtkMultiBlockDataSet>\n"
           "<FieldData><DataArray type='Float32' Name='TimeValue' NumberOfTuples='1' "
           "format='ascii'> " +
           std::to_string(step) + ".5 </DataArray></FieldData></VTKFile>\n";
}

vtkSmartPointer<vtkPolyData> patch(double velocity) {
    auto out = vtkSmartPointer<vtkPolyData>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (const auto& p :
         {std::array{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 0.0, 1.0}, {0.0, 0.0, 1.0}})
        points->InsertNextPoint(p.data());
    out->SetPoints(points);
    auto polygons = vtkSmartPointer<vtkCellArray>::New();
    const std::array<vtkIdType, 4> nodes{0, 1, 2, 3};
    polygons->InsertNextCell(4, nodes.data());
    out->SetPolys(polygons);
    auto u = vtkSmartPointer<vtkDoubleArray>::New();
    u->SetName("U");
    u->SetNumberOfComponents(3);
    for (int i = 0; i < 4; ++i)
        u->InsertNextTuple3(velocity, 0, 0);
    out->GetPointData()->AddArray(u);
    return out;
}

TEST_F(VtkFilesSource, ReadsMultiBlockSeriesWithTheirWalls) {
    for (int step = 0; step < 2; ++step) {
        const std::string n = std::to_string(step);
        fs::create_directory(folder_ / ("f" + n));
        put("flow_" + n + ".vtm", multi_block_text(step));
        write_step("f" + n + "/internal.vtu", *sample_mesh(), step);
        write_step("f" + n + "/b.vts", *sample_structured(20), step);
        write("f" + n + "/wall.vtp", *patch(1.0));
        write("f" + n + "/cylinder.vtp", *patch(0.0));
        write("f" + n + "/inlet.vtp", *patch(1.0));
        write("f" + n + "/starting.vtp", *patch(step));
    }
    put("flow.vtm.series", R"({"file-series-version":"1.0","files":[
        {"name":"flow_0.vtm","time":0.125},{"name":"flow_1.vtm","time":3}]})");
    const auto check = [&](const std::string& name, const std::vector<double>& times) {
        auto source = open_source(folder_ / name);
        ASSERT_TRUE(source.has_value()) << source.error().message;
        EXPECT_EQ((*source)->description().name, "flow");
        expect_known_series(**source, times);
        const auto read = (*source)->read(1, known_fields());
        ASSERT_EQ(read->blocks.size(), 2u);
        ASSERT_EQ(read->walls.size(), 2u);
        EXPECT_FALSE(read->walls[0].no_slip); // named a wall, but it moves
        EXPECT_TRUE(read->walls[1].no_slip);
        EXPECT_EQ(read->walls[1].faces->GetNumberOfPolys(), 1);
        EXPECT_EQ((*source)->files(1)->size(), 7u);
    };
    check("flow.vtm.series", {0.125, 3});
    check("flow_0.vtm", {0.5, 1.5});
    EXPECT_EQ((*open_source(folder_.path()))->description().reader,
              "vtkXMLUnstructuredGridReader (vtm.series)");
    fs::remove(folder_ / "f1" / "b.vts");
    expect_failure((*open_source(folder_ / "flow.vtm.series"))->read(1, known_fields()),
                   Error::Code::NotFound, "flow_1.vtm names f1/b.vts, which does not exist");
}

TEST_F(VtkFilesSource, ReadsSurfacesWithValuesOfTheirFaces) {
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
        mode_ = mode;
        auto wall = patch(0.0);
        auto shear = vtkSmartPointer<vtkDoubleArray>::New();
        shear->SetName("shear");
        shear->InsertNextValue(0.25);
        wall->GetCellData()->AddArray(shear);
        write("wall.vtp", *wall);
        write_step("flow.vtu", *sample_mesh(), 0);
        const auto source =
            open_source(put("s.pvd", "<VTKFile type=\"Collection\"><Collection>"
                                     "<DataSet timestep=\"0\" part=\"0\" file=\"flow.vtu\"/>"
                                     "<DataSet timestep=\"0\" part=\"1\" file=\"wall.vtp\"/>"
                                     "</Collection></VTKFile>"));
        ASSERT_TRUE(source.has_value()) << source.error().message;
        EXPECT_EQ((*source)->read(0, known_fields())->walls.size(), 1u);
    }
}

TEST_F(VtkFilesSource, TakesPartsOfACollectionForWallsAndSolids) {
    std::string text = "<VTKFile type=\"Collection\"><Collection>";
    for (int step = 0; step < 2; ++step) {
        const std::string n = std::to_string(step);
        auto heater = sample_mesh(40);
        put_known_flow(*heater, step);
        heater->GetPointData()->RemoveArray("U");
        write("heater" + n + ".vtu", *heater);
        write_step("flow" + n + ".vtu", *sample_mesh(), step);
        write("cylinder" + n + ".vtp", *patch(0.0));
        write("starting" + n + ".vtp", *patch(step));
        int part = 0;
        for (const std::string& name : {"flow" + n + ".vtu", "cylinder" + n + ".vtp",
                                        "starting" + n + ".vtp", "heater" + n + ".vtu"}) {
            text += "<DataSet timestep=\"" + n + "\" part=\"" + std::to_string(part) +
                    "\" file=\"" + name + "\"/>";
            ++part;
        }
    }
    const auto source = open_source(put("s.pvd", text + "</Collection></VTKFile>"));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    expect_known_series(**source, {0, 1});
    for (const std::size_t step : {0u, 1u}) {
        const auto read = (*source)->read(step, known_fields());
        EXPECT_EQ(read->blocks.size(), 1u);
        ASSERT_EQ(read->walls.size(), 1u);
        EXPECT_TRUE(read->walls[0].no_slip);
        ASSERT_EQ(read->solids.size(), 1u);
        EXPECT_EQ(read->solids[0]->GetBounds()[1], 43.0);
    }
}

TEST_F(VtkFilesSource, ReadsWhatVtksMultiBlockWriterWrites) {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    auto image = sample_image();
    auto mesh = sample_mesh(30);
    put_known_flow(*image, 0);
    put_known_flow(*mesh, 0);
    auto inner = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    inner->SetBlock(0, mesh);
    blocks->SetBlock(0, image);
    blocks->SetBlock(1, inner);
    auto writer = vtkSmartPointer<vtkXMLMultiBlockDataWriter>::New();
    writer->SetFileName((folder_ / "m.vtm").c_str());
    writer->SetInputData(blocks);
    ASSERT_EQ(writer->Write(), 1);
    auto source = open_source(folder_ / "m.vtm");
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->read(0, known_fields())->blocks.size(), 2u);
    expect_known_series(**source, {0});
}

TEST_F(VtkFilesSource, ReadsParallelFilesAndMissesNoPiece) {
    const auto check = [&](const std::string& name, vtkDataSet& data, std::size_t blocks) {
        put_known_flow(data, 0);
        auto writer = vtkSmartPointer<vtkXMLPDataSetWriter>::New();
        writer->SetFileName((folder_ / name).c_str());
        writer->SetInputData(&data);
        writer->SetNumberOfPieces(2);
        writer->SetStartPiece(0);
        writer->SetEndPiece(1);
        ASSERT_EQ(writer->Write(), 1);
        auto source = open_source(folder_ / name);
        ASSERT_TRUE(source.has_value()) << source.error().message;
        expect_known_series(**source, {0});
        EXPECT_EQ((*source)->read(0, known_fields())->blocks.size(), blocks) << name;
        const auto files = (*source)->files(0);
        ASSERT_EQ(files->size(), 3u);
        const std::string piece = files->back().name;
        const std::string whole = read_file(folder_ / piece);
        put(piece, whole.substr(0, whole.size() / 2));
        EXPECT_FALSE((*source)->read(0, known_fields()).has_value()) << name;
        fs::remove(folder_ / piece);
        expect_failure((*source)->read(0, known_fields()), Error::Code::NotFound,
                       name + " names " + piece + ", which does not exist");
    };
    check("i.pvti", *sample_image(), 1);
    check("r.pvtr", *sample_rectilinear(), 1);
    check("s.pvts", *sample_structured(), 1);
}

TEST_F(VtkFilesSource, ReadsThePiecesOfAParallelMeshAsBlocks) {
    write_step("m_0.vtu", *sample_mesh(), 0);
    write_step("m_1.vtu", *sample_mesh(10), 0);
    auto source = open_source(put(
        "m.pvtu", "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid><Piece "
                  "Source=\"m_0.vtu\"/><Piece Source=\"m_1.vtu\"/></PUnstructuredGrid></VTKFile>"));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    expect_known_series(**source, {0});
    EXPECT_EQ((*source)->read(0, known_fields())->blocks.size(), 2u);
}

TEST_F(VtkFilesSource, ReadsLegacyFiles) {
    for (const int type : {VTK_ASCII, VTK_BINARY}) {
        for (int step = 0; step < 2; ++step) {
            auto mesh = sample_mesh();
            put_known_flow(*mesh, step);
            auto writer = vtkSmartPointer<vtkDataSetWriter>::New();
            writer->SetFileName(
                (folder_ / (std::string("l") + std::to_string(step) + ".vtk")).c_str());
            writer->SetFileType(type);
            writer->SetInputData(mesh);
            ASSERT_EQ(writer->Write(), 1);
        }
        auto source = open_source(folder_ / "l1.vtk");
        ASSERT_TRUE(source.has_value()) << source.error().message;
        expect_known_series(**source, {0, 1});
    }
}

TEST_F(VtkFilesSource, KeepsTheSolidCellsOfAMixedMeshAndThickensPlanes) {
    auto mesh = sample_mesh();
    const std::array<vtkIdType, 4> quad{0, 1, 5, 4};
    mesh->InsertNextCell(VTK_QUAD, 4, quad.data());
    auto source = open_source(write_step("mixed.vtu", *mesh, 0));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    expect_known_series(**source, {0});
    EXPECT_EQ((*source)->read(0, known_fields())->blocks[0]->GetNumberOfCells(), 5);
    auto flat = vtkSmartPointer<vtkUnstructuredGrid>::New();
    flat->SetPoints(sample_mesh()->GetPoints());
    flat->InsertNextCell(VTK_QUAD, 4, quad.data());
    flat->InsertNextCell(VTK_LINE, 2, quad.data()); // as mesh generators write of the edge
    for (const auto& plane :
         {write_step("flat.vtu", *flat, 0), write_step("sheet.vti", *sample_image(4, 1, 6), 0)}) {
        const auto thick = open_source(plane);
        ASSERT_TRUE(thick.has_value()) << thick.error().message;
        const auto step = (*thick)->read(0, (*thick)->description().fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        EXPECT_TRUE(has_solid_cells(*step->blocks[0]));
    }
    const auto bent = flat;
    bent->InsertNextCell(VTK_QUAD, 4, std::array<vtkIdType, 4>{1, 2, 6, 9}.data());
    expect_failure(open_source(write_step("bent.vtu", *bent, 0)), Error::Code::Unsupported,
                   "bent.vtu has no cells in space");
    expect_failure(open_source(write_step("line.vti", *sample_image(4, 1, 1), 0)),
                   Error::Code::Unsupported, "line.vti has 1 nodes along y, and is not a plane");
    expect_failure(open_source(write("patch.vtp", *patch(1.0))), Error::Code::Unsupported,
                   "patch.vtp is a surface");
}

TEST_F(VtkFilesSource, KeepsTheMarksOfHiddenCellsWhateverFieldsAreAskedFor) {
    for (int step = 0; step < 2; ++step) {
        const auto mesh = sample_mesh();
        auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
        marks->SetName(vtkDataSetAttributes::GhostArrayName());
        marks->SetNumberOfValues(mesh->GetNumberOfCells());
        marks->Fill(0);
        marks->SetValue(1, vtkDataSetAttributes::HIDDENCELL);
        mesh->GetCellData()->AddArray(marks);
        write_step("g_" + std::to_string(step) + ".vtu", *mesh, step);
    }
    auto source = open_source(folder_ / "g_0.vtu");
    ASSERT_TRUE(source.has_value()) << source.error().message;
    for (const std::size_t step : {1u, 0u}) {
        const auto read = (*source)->read(step, known_fields());
        ASSERT_TRUE(read.has_value()) << read.error().message;
        vtkDataArray* marks =
            read->blocks[0]->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
        ASSERT_NE(marks, nullptr) << "time-step " << step;
        EXPECT_EQ(marks->GetTuple1(0), 0.0);
        EXPECT_EQ(marks->GetTuple1(1), vtkDataSetAttributes::HIDDENCELL);
    }
}

TEST_F(VtkFilesSource, NamesTheFieldAStepLacks) {
    write_step("a0.vtu", *sample_mesh(), 0);
    auto other = sample_mesh();
    put_known_flow(*other, 1);
    other->GetPointData()->RemoveArray("U");
    write("a1.vtu", *other);
    auto source = open_source(folder_ / "a0.vtu");
    expect_failure((*source)->read(1, known_fields()), Error::Code::NotFound,
                   "a1.vtu has no field U");
    EXPECT_TRUE((*source)->read(0, known_fields()).has_value());
}

} // namespace
} // namespace wakesurf::importer::vtk_files_source_test
