// Times that VTK's files state in any of the places where programs write them.
#include "importer/sources/open_source.hpp"
#include "tests/importer/vtk_files.hpp"

#include <vtkDataSetWriter.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkXMLMultiBlockDataWriter.h>

namespace wakesurf::importer::stated_times_test {
namespace {

using namespace tests;
using Times = std::vector<double>;

class StatedTimes : public VtkFiles {
  protected:
    Times times(const std::string& name) const {
        const auto source = open_source(folder_ / name);
        EXPECT_TRUE(source.has_value()) << name << ": " << source.error().message;
        if (!source)
            return {};
        note_ = (*source)->description().time_note;
        places_ = (*source)->description().places;
        return (*source)->description().times;
    }

    // Without a time of its own.
    std::string piece(const std::string& name, vtkDataSet& data) const {
        put_known_flow(data, 0);
        write(name, data);
        return name;
    }

    void put_parallel(const std::string& name,
                      const std::string& kind,
                      const std::string& rest,
                      const std::string& field_data) const {
        put(name, "<VTKFile type=\"" + kind + "\" version=\"1.0\" byte_order=\"LittleEndian\"><" +
                      kind + " GhostLevel=\"0\"" + rest + "</" + kind + "></VTKFile>");
        std::string text = read_file(folder_ / name);
        const auto at = text.find('>', text.find("GhostLevel"));
        put(name, text.insert(at + 1, field_data));
    }

    static std::string
    field_data(const std::string& name, const std::string& type, const std::string& value) {
        return "<FieldData><DataArray type=\"" + type + "\" Name=\"" + name +
               "\" NumberOfTuples=\"1\" format=\"ascii\">" + value + "</DataArray></FieldData>";
    }

    mutable std::string note_;
    mutable Times places_;
};

const std::string arrays =
    "<PPointData><PDataArray type=\"Float64\" Name=\"U\" NumberOfComponents=\"3\"/>"
    "</PPointData><PPoints><PDataArray type=\"Float64\" Name=\"Points\" "
    "NumberOfComponents=\"3\"/></PPoints>";

TEST_F(StatedTimes, AreThoseOfAParallelFileOrElseOfItsFirstPiece) {
    for (const auto& [type, value, time] : {std::tuple{"Float64", "3.5", 3.5},
                                            {"Float32", "0.25", 0.25},
                                            {"Int32", "7", 7.0},
                                            {"UInt8", "200", 200.0},
                                            {"Int64", "-4", -4.0}}) {
        put_parallel("p_0.pvtu", "PUnstructuredGrid",
                     ">" + arrays + "<Piece Source=\"" + piece("a.vtu", *sample_mesh()) + "\"/>",
                     field_data("TimeValue", type, value));
        EXPECT_EQ(times("p_0.pvtu"), Times{time}) << type;
    }
    auto mesh = sample_mesh();
    set_time(*mesh, 8.5);
    put_parallel("q.pvtu", "PUnstructuredGrid",
                 ">" + arrays + "<Piece Source=\"" + piece("b.vtu", *mesh) + "\"/>", "");
    EXPECT_EQ(times("q.pvtu"), Times{8.5});
    auto image = sample_image();
    const std::string shape =
        " WholeExtent=\"0 3 0 4 0 5\" Origin=\"-1 0.5 2\" Spacing=\"0.5 0.25 1\">"
        "<PPointData><PDataArray type=\"Float64\" Name=\"U\" "
        "NumberOfComponents=\"3\"/></PPointData>"
        "<Piece Extent=\"0 3 0 4 0 5\" Source=\"";
    put_parallel("i.pvti", "PImageData", shape + piece("c.vti", *image) + "\"/>",
                 field_data("TIME", "Float64", "2.5"));
    EXPECT_EQ(times("i.pvti"), Times{2.5});
    set_time(*image, 4.5);
    put_parallel("j.pvti", "PImageData", shape + piece("d.vti", *image) + "\"/>", "");
    EXPECT_EQ(times("j.pvti"), Times{4.5});
}

TEST_F(StatedTimes, AreThoseOfACollectionOfBlocksInAnyEncoding) {
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
        auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
        auto mesh = sample_mesh();
        put_known_flow(*mesh, 0);
        blocks->SetBlock(0, mesh);
        set_time(*blocks, 0.75);
        auto writer = vtkSmartPointer<vtkXMLMultiBlockDataWriter>::New();
        writer->SetFileName((folder_ / "m.vtm").c_str());
        writer->SetDataMode(mode);
        writer->SetInputData(blocks);
        ASSERT_EQ(writer->Write(), 1);
        EXPECT_EQ(times("m.vtm"), Times{0.75}) << mode << read_file(folder_ / "m.vtm");
    }
}

TEST_F(StatedTimes, AreReadAsVisItWritesThemInLegacyFiles) {
    const auto write_legacy = [&](int step, const char* time_name, bool cycle,
                                  const std::string& title) {
        auto image = sample_image();
        put_known_flow(*image, step);
        if (time_name != nullptr) {
            set_time(*image, 0.5 + step);
            image->GetFieldData()->GetArray("TimeValue")->SetName(time_name);
        }
        if (cycle) {
            auto value = vtkSmartPointer<vtkIntArray>::New();
            value->SetName("CYCLE");
            value->InsertNextValue(100 * step * step);
            image->GetFieldData()->AddArray(value);
        }
        auto writer = vtkSmartPointer<vtkDataSetWriter>::New();
        writer->SetFileName((folder_ / ("l_" + std::to_string(step) + ".vtk")).c_str());
        writer->SetHeader(title.c_str());
        writer->SetInputData(image);
        ASSERT_EQ(writer->Write(), 1);
    };
    for (const char* const name : {"TIME", "TimeValue", "Time"}) {
        for (int step = 0; step < 3; ++step)
            write_legacy(step, name, true, "vtk output");
        EXPECT_EQ(times("l_1.vtk"), (Times{0.5, 1.5, 2.5})) << name;
        EXPECT_EQ(note_, "");
    }
    for (int step = 0; step < 3; ++step)
        write_legacy(step, nullptr, true, "vtk output");
    EXPECT_EQ(times("l_1.vtk"), (Times{0, 1, 2}));
    EXPECT_EQ(note_, "the files carry cycles, but no times: 0, 1, 2, ... are used");
    EXPECT_EQ(places_, (Times{0, 1, 4})) << "the cycles are 0, 100 and 400";
    for (int step = 0; step < 3; ++step)
        write_legacy(step, nullptr, false,
                     "Athena++ data at time= " + std::to_string(0.25 * step) + "  cycle= 1");
    EXPECT_EQ(times("l_1.vtk"), (Times{0, 0.25, 0.5}));
    EXPECT_EQ(note_, "the times are those in the titles of the files");
    EXPECT_EQ(places_, (Times{0, 1, 2})) << "--dt may replace them";
    for (const char* const title : {"runtime=4", "time is short", "time=", "time= soon"}) {
        for (int step = 0; step < 3; ++step)
            write_legacy(step, nullptr, false, title);
        EXPECT_EQ(times("l_1.vtk"), (Times{0, 1, 2}));
        EXPECT_EQ(note_, "the files carry no times: 0, 1, 2, ... are used");
    }
}

} // namespace
} // namespace wakesurf::importer::stated_times_test
