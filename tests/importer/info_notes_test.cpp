// What `info` and the store's note say of a source beforehand: where an import will end, what is approximate, and which time-steps
// have no velocity. The files are VTK's writers'.
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/known_flow.hpp"

#include <vtkFieldData.h>
#include <vtkXMLDataSetWriter.h>

#include <limits>

namespace wakesurf::importer::info_notes_test {
namespace {

class InfoNotes : public Import {
  protected:
    void write(const std::string& name, vtkDataSet& data) const {
        auto writer = vtkSmartPointer<vtkXMLDataSetWriter>::New();
        writer->SetFileName((folder_ / name).c_str());
        writer->SetInputData(&data);
        ASSERT_EQ(writer->Write(), 1);
    }

    void write_step(int step, double shift = 0.0, double velocity = 0.0) const {
        auto mesh = sample_mesh(shift);
        put_known_flow(*mesh, step);
        vtkDataArray* const u = mesh->GetPointData()->GetArray("U");
        for (vtkIdType i = 0; velocity != 0.0 && i < u->GetNumberOfTuples(); ++i)
            u->SetTuple3(i, velocity, velocity, velocity);
        write("s_" + std::to_string(step) + ".vtu", *mesh);
    }

    core::DatasetInfo info(const std::string& name) const {
        return describe_with_import_process({folder_ / name, {}, {}, {}, importer_program()})
            .value();
    }
};

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

TEST_F(InfoNotes, SayThatAMovingMeshEndsAnImport) {
    for (int step = 0; step < 4; ++step)
        write_step(step, step == 3 ? 0.5 : 0.0);
    EXPECT_NE(info("s_0.vtu").note.find("an import will end before time 3: s_3.vtu (time-step 3) "
                                        "has another mesh than s_0.vtu (time-step 0)"),
              std::string::npos)
        << info("s_0.vtu").note;
    write_step(1, 0.25);
    EXPECT_NE(info("s_0.vtu").note.find("an import will end before time 1"), std::string::npos);
    write_step(1);
    write_step(3);
    EXPECT_EQ(info("s_0.vtu").note.find("an import will end"), std::string::npos);
}

TEST_F(InfoNotes, SayThatATimeStepCannotBeReadAndTimesLeavesItOut) {
    for (int step = 0; step < 5; ++step)
        write_step(step);
    const std::string whole = read_file(folder_ / "s_1.vtu");
    put("s_1.vtu", whole.substr(0, whole.size() / 2));
    EXPECT_NE(info("s_0.vtu").note.find("the data end before time 1: s_1.vtu"), std::string::npos)
        << info("s_0.vtu").note;
    EXPECT_EQ(info("s_0.vtu").times, std::vector<double>{0});
    ASSERT_EQ(run("s_0.vtu", {"--times", "0:0.5,1.5:9"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (std::vector<double>{0, 2, 3, 4}));
    EXPECT_EQ(run("s_0.vtu", {"--times", "0:1,"}).status, 2);
    ASSERT_EQ(run("s_0.vtu", {"--times", "0:0,2:4:2"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (std::vector<double>{0, 2, 4}));
}

TEST_F(InfoNotes, NameTimeStepsWhoseVelocityIsNoNumber) {
    for (const double value : {no_number, 1e300}) {
        write_step(0);
        write_step(1, 0.0, value);
        write_step(2);
        fs::remove(folder_ / "s_3.vtu");
        ASSERT_EQ(run("s_0.vtu").status, 0);
        const std::string words = "no velocity is a number (in single precision) at 1 of 3 "
                                  "time-steps: time 1";
        EXPECT_NE(manifest().info.note.find(words), std::string::npos) << manifest().info.note;
        EXPECT_EQ(manifest().without_velocity, std::vector<std::size_t>{1});
        write_step(3); // the series grows: what was converted before is still so
        ASSERT_EQ(run("s_0.vtu").status, 0);
        EXPECT_NE(manifest().info.note.find("at 1 of 4 time-steps: time 1"), std::string::npos)
            << manifest().info.note;
        fs::remove_all(store());
        write_step(0, 0.0, value);
        EXPECT_NE(info("s_0.vtu").note.find("no velocity of the first time-step is a number"),
                  std::string::npos);
    }
}

TEST_F(InfoNotes, SayThatCellValuesAreAveraged) {
    auto mesh = sample_mesh();
    put_known_flow(*mesh, 0);
    write("points.vtu", *mesh);
    auto velocity = vtkSmartPointer<vtkDoubleArray>::New();
    velocity->SetName("U");
    velocity->SetNumberOfComponents(3);
    velocity->SetNumberOfTuples(mesh->GetNumberOfCells());
    velocity->Fill(1.0);
    mesh->GetPointData()->RemoveArray("U");
    mesh->GetCellData()->AddArray(velocity);
    write("cells.vtu", *mesh);
    EXPECT_NE(info("cells.vtu")
                  .note.find("approximate: the velocity at a node is the mean of the "
                             "cells around it"),
              std::string::npos);
    EXPECT_EQ(info("points.vtu").note.find("approximate"), std::string::npos);
}

} // namespace
} // namespace wakesurf::importer::info_notes_test
