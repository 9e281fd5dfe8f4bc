// Exodus II files written by VTK: what the source returns of them, and what it refuses.
#include "importer/sources/files/formats.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkExodusIIWriter.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockDataSetAlgorithm.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>
#include <vtk_exodusII.h>

#include <algorithm>
#include <array>

namespace wakesurf::importer::exodus_source_test {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

constexpr int layers = 40;
const std::vector<double> times{0.0, 0.25, 3.0};

double value_at(double x, double y, double z, int component, std::size_t step) {
    return x + 10 * y + 100 * z + 1000 * component - 0.5 * static_cast<double>(step);
}

std::size_t step_of(double time) {
    return static_cast<std::size_t>(std::find(times.begin(), times.end(), time) - times.begin());
}

// A stack of hexahedra from z = 0 on, as a block, and two wedges beside it as another one.
vtkSmartPointer<vtkUnstructuredGrid> block(bool wedges, std::size_t step) {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    const int height = wedges ? 1 : layers;
    for (int k = 0; k <= height; ++k)
        for (int n = 0; n < 4; ++n)
            points->InsertNextPoint((wedges ? 1 : 0) + (n == 1 || n == 2 ? 1 : 0), n / 2, k);
    grid->SetPoints(points);
    for (vtkIdType k = 0; k < height; ++k) {
        const vtkIdType b = 4 * k;
        const vtkIdType hexahedron[]{b, b + 1, b + 2, b + 3, b + 4, b + 5, b + 6, b + 7};
        const vtkIdType left[]{0, 1, 3, 4, 5, 7};
        const vtkIdType right[]{1, 2, 3, 5, 6, 7};
        if (!wedges) {
            grid->InsertNextCell(VTK_HEXAHEDRON, 8, hexahedron);
        } else {
            grid->InsertNextCell(VTK_WEDGE, 6, left);
            grid->InsertNextCell(VTK_WEDGE, 6, right);
        }
    }
    auto velocity = vtkSmartPointer<vtkDoubleArray>::New();
    velocity->SetName("velocity");
    velocity->SetNumberOfComponents(3);
    auto moved = vtkSmartPointer<vtkDoubleArray>::New();
    moved->SetName("DISPL");
    moved->SetNumberOfComponents(3);
    auto pressure = vtkSmartPointer<vtkDoubleArray>::New();
    pressure->SetName("pressure");
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
        const double* p = points->GetPoint(i);
        velocity->InsertNextTuple3(value_at(p[0], p[1], p[2], 0, step),
                                   value_at(p[0], p[1], p[2], 1, step),
                                   value_at(p[0], p[1], p[2], 2, step));
        moved->InsertNextTuple3(0.25, 0.5, static_cast<double>(step));
        pressure->InsertNextValue(value_at(p[0], p[1], p[2], 5, step));
    }
    grid->GetPointData()->AddArray(velocity);
    grid->GetPointData()->AddArray(moved);
    grid->GetPointData()->AddArray(pressure);
    auto heat = vtkSmartPointer<vtkDoubleArray>::New();
    heat->SetName("heat");
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
        heat->InsertNextValue(static_cast<double>(i) + (wedges ? 500 : 0) -
                              static_cast<double>(step));
    grid->GetCellData()->AddArray(heat);
    return grid;
}

class Flow : public vtkMultiBlockDataSetAlgorithm {
  public:
    static Flow* New() {
        auto* made = new Flow; // VTK counts its references
        made->InitializeObjectBase();
        return made;
    }

    Flow() { SetNumberOfInputPorts(0); }

    int RequestInformation(vtkInformation*,
                           vtkInformationVector**,
                           vtkInformationVector* out) override {
        out->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(),
                                          times.data(), static_cast<int>(times.size()));
        const double range[]{times.front(), times.back()};
        out->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
        return 1;
    }

    int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* out) override {
        vtkInformation* info = out->GetInformationObject(0);
        const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
        auto* blocks = vtkMultiBlockDataSet::GetData(out);
        blocks->SetBlock(0, block(false, step_of(time)));
        blocks->SetBlock(1, block(true, step_of(time)));
        blocks->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
        return 1;
    }
};

class ExodusSource : public testing::Test {
  protected:
    void SetUp() override {
        ex_opts(0); // the writer's library prints by itself
        const auto flow = vtkSmartPointer<Flow>::New();
        auto writer = vtkSmartPointer<vtkExodusIIWriter>::New();
        writer->SetInputConnection(flow->GetOutputPort());
        writer->SetFileName(file().c_str());
        writer->WriteAllTimeStepsOn();
        writer->WriteOutBlockIdArrayOff();
        writer->WriteOutGlobalElementIdArrayOff();
        writer->WriteOutGlobalNodeIdArrayOff();
        writer->Write();
        ASSERT_TRUE(fs::exists(file()));
    }

    fs::path file() const { return folder_ / "flow.exo"; }

    TemporaryFolder folder_;
};

void expect_values(const SourceStep& step, std::size_t index) {
    ASSERT_EQ(step.blocks.size(), 2u);
    EXPECT_EQ(step.blocks[0]->GetNumberOfCells(), layers);
    EXPECT_EQ(step.blocks[1]->GetNumberOfCells(), 2);
    for (std::size_t b = 0; b < 2; ++b) {
        vtkDataSet& grid = *step.blocks[b];
        EXPECT_EQ(grid.GetCellType(0), b == 0 ? VTK_HEXAHEDRON : VTK_WEDGE);
        vtkDataArray* u = grid.GetPointData()->GetArray("velocity");
        vtkDataArray* p = grid.GetPointData()->GetArray("pressure");
        vtkDataArray* heat = grid.GetCellData()->GetArray("heat");
        ASSERT_TRUE(u != nullptr && p != nullptr && heat != nullptr);
        for (vtkIdType i = 0; i < grid.GetNumberOfPoints(); ++i) {
            double at[3];
            grid.GetPoint(i, at);
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(u->GetComponent(i, c), value_at(at[0], at[1], at[2], c, index));
            ASSERT_EQ(p->GetTuple1(i), value_at(at[0], at[1], at[2], 5, index));
            ASSERT_EQ(at[0], std::floor(at[0])); // no displacement
        }
        for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i)
            ASSERT_EQ(heat->GetTuple1(i),
                      static_cast<double>(i) + (b == 0 ? 0 : 500) - static_cast<double>(index));
    }
}

TEST_F(ExodusSource, GivesEveryValueOfEveryTimeStepWithoutDisplacements) {
    const auto opened = open_exodus(file());
    ASSERT_TRUE(opened.has_value()) << opened.error().message;
    const auto& source = *opened;
    EXPECT_EQ(source->description().name, "flow");
    EXPECT_EQ(source->description().times, times);
    EXPECT_NE(source->description().note.find("DISPL"), std::string::npos)
        << source->description().note;
    std::vector<std::string> names;
    for (const auto& field : source->description().fields) {
        names.push_back(field.name);
        EXPECT_EQ(field.components,
                  field.name == "velocity" || field.name.starts_with("DISPL") ? 3 : 1)
            << field.name;
        EXPECT_EQ(field.source == core::FieldInfo::Source::Cell, field.name == "heat")
            << field.name;
    }
    EXPECT_EQ(names.size(), 4u);
    for (const std::size_t step : {2u, 0u, 1u, 0u}) {
        const auto read = source->read(step, source->description().fields);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        expect_values(*read, step);
    }
    const auto only = source->read(1, {source->description().fields.front()});
    ASSERT_TRUE(only.has_value());
    EXPECT_EQ(only->blocks[0]->GetPointData()->GetNumberOfArrays() +
                  only->blocks[0]->GetCellData()->GetNumberOfArrays(),
              1);
    EXPECT_EQ(source->shared_files()->front().name, "flow.exo");
}

void put_time(const fs::path& file, int step, double time) {
    int word = 8;
    int stored = 0;
    float version = 0;
    const int out = ex_open(file.c_str(), EX_WRITE, &word, &stored, &version);
    ASSERT_GE(out, 0);
    ASSERT_EQ(ex_put_time(out, step, &time), 0);
    ASSERT_EQ(ex_close(out), 0);
}

TEST_F(ExodusSource, TakesTheStepThatARestartWroteLast) {
    put_time(file(), 3, times[1]); // 0, 0.25, 0.25
    const auto again = open_exodus(file());
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_EQ((*again)->description().times, (std::vector<double>{times[0], times[1]}));
    EXPECT_NE((*again)->description().time_note.find(
                  "left out, as another was written later for the same time: time-step 1 of "
                  "flow.exo"),
              std::string::npos)
        << (*again)->description().time_note;
    for (const std::size_t step : {1u, 0u, 1u}) {
        const auto read = (*again)->read(step, (*again)->description().fields);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        expect_values(*read, step == 0 ? 0 : 2);
    }
    put_time(file(), 3, 0.125); // 0, 0.25, 0.125
    const auto back = open_exodus(file()).value();
    EXPECT_EQ(back->description().times, (std::vector<double>{0, 0.125, 0.25}));
    for (const std::size_t step : {1u, 2u, 0u}) {
        const auto read = back->read(step, back->description().fields);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        expect_values(*read, std::array<std::size_t, 3>{0, 2, 1}[step]);
    }
}

TEST_F(ExodusSource, GoesOnInTheFilesOfItsRestarts) {
    const auto restart = folder_ / "flow.exo-s002";
    fs::copy_file(file(), restart);
    for (const int step : {3, 2, 1})
        put_time(restart, step, 3.0 + step - 0.5); // 3.5, 4.5, 5.5
    for (const auto& named : {file(), restart}) {
        const auto source = open_exodus(named).value();
        EXPECT_EQ(source->description().name, "flow");
        EXPECT_EQ(source->description().times, (std::vector<double>{0, 0.25, 3, 3.5, 4.5, 5.5}));
        EXPECT_TRUE(source->shared_files()->empty());
        EXPECT_EQ(source->files(4)->front().name, "flow.exo-s002");
        for (const std::size_t step : {4u, 2u, 3u, 0u, 5u, 1u}) {
            const auto read = source->read(step, source->description().fields);
            ASSERT_TRUE(read.has_value()) << read.error().message;
            expect_values(*read, step % 3);
        }
        command::SourceOptions alone;
        alone.alone = true;
        EXPECT_EQ(open_exodus(named, alone).value()->description().times.size(), 3u);
    }
    fs::copy_file(restart, folder_ / "flow.exo-s004");
    fs::resize_file(folder_ / "flow.exo-s004", fs::file_size(restart) / 2);
    const auto cut = open_exodus(file()).value();
    EXPECT_EQ(cut->description().times.size(), 7u);
    EXPECT_EQ(cut->description().unreadable.begin()->first, 6u);
    EXPECT_EQ(
        cut->description().note.find("no file of flow.exo between flow.exo-s002 and flow.exo-s004"),
        0u)
        << cut->description().note;
    fs::resize_file(file(), fs::file_size(file()) / 2);
    EXPECT_FALSE(open_exodus(restart).has_value()) << "the first is cut";
}

TEST_F(ExodusSource, JoinsThePiecesOfAParallelRun) {
    for (const char* const piece : {"run.e.3.0", "run.e.3.1", "run.e.3.2"})
        fs::copy_file(file(), folder_ / piece);
    for (const char* const piece : {"run.e.3.0", "run.e.3.2"}) {
        ASSERT_TRUE(is_exodus(folder_ / piece));
        const auto source = open_exodus(folder_ / piece).value();
        EXPECT_EQ(source->description().name, "run");
        EXPECT_EQ(source->description().times, times);
        const auto read = source->read(1, source->description().fields);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        EXPECT_EQ(read->blocks.size(), 3u * 2);
        EXPECT_EQ(source->shared_files()->size(), 3u);
    }
    EXPECT_FALSE(continues_exodus(folder_ / "run.e.3.0"));
    EXPECT_TRUE(continues_exodus(folder_ / "run.e.3.1"));
    put_time(folder_ / "run.e.3.1", 3, 3.5);
    EXPECT_EQ(open_exodus(folder_ / "run.e.3.0").error().message,
              "run.e.3.1 has different times from run.e.3.0");
    fs::remove(folder_ / "run.e.3.1");
    const auto refused = open_exodus(folder_ / "run.e.3.0");
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().message, "run.e.3.0 is one of 3 pieces, and run.e.3.1 is not there");
    EXPECT_EQ(refused.error().hint, "copy all pieces, or join them with epu");
    fs::copy_file(file(), folder_ / "wide.e.12.03");
    EXPECT_EQ(open_exodus(folder_ / "wide.e.12.03").error().message,
              "wide.e.12.03 is one of 12 pieces, and wide.e.12.00 is not there");
    EXPECT_FALSE(is_exodus(folder_ / "run.e.3.1")) << "it is no NetCDF file";
}

// Paths are confined where nobody has allowed others.
TEST_F(ExodusSource, TakesNoPieceThatIsALinkOutOfAConfinedFolder) {
    fs::create_directories(folder_ / "run");
    fs::copy_file(file(), folder_ / "run/run.e.2.0");
    fs::create_symlink(file(), folder_ / "run/run.e.2.1");
    const auto refused = open_exodus(folder_ / "run/run.e.2.0");
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().message,
              "the run of run.e.2.0 names run.e.2.1, which lies outside of its folder");
}

TEST_F(ExodusSource, AFileCutOffFailsAtOnceOrWhenItIsRead) {
    const std::string whole = read_file(file());
    const auto source = open_exodus(file()).value();
    std::vector<std::size_t> cuts{whole.size() - 1, whole.size() - 9, whole.size() - 100};
    for (std::size_t cut = 0; cut < whole.size(); cut += 512)
        cuts.push_back(cut);
    for (const auto cut : cuts) {
        write_file(file(), whole.substr(0, cut));
        const auto opened = open_exodus(file());
        EXPECT_FALSE(opened.has_value()) << cut << " of " << whole.size();
        if (!opened) {
            EXPECT_EQ(opened.error().message.find(folder_.path().string()), std::string::npos)
                << opened.error().message;
        }
        const auto read = source->read(1, source->description().fields);
        EXPECT_FALSE(read.has_value()) << cut << " of " << whole.size();
    }
    fs::remove(file());
    EXPECT_EQ(source->read(1, source->description().fields).error().code, Error::Code::NotFound);
    write_file(file(), whole);
    expect_values(source->read(1, source->description().fields).value(), 1);
}

void put_nodes_of_two_cubes(int out) {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    for (int n = 0; n < 12; ++n) {
        x.push_back(n % 3);
        y.push_back(n / 3 % 2);
        z.push_back(n / 6);
    }
    ASSERT_EQ(ex_put_coord(out, x.data(), y.data(), z.data()), 0);
}

// Two cubes with a side set each, below; only one is called wall. The velocity is written as three scalars.
void write_side_sets(const fs::path& file, bool moving_floor, int format = 0) {
    int word = 8;
    const int out = ex_create(file.c_str(), EX_CLOBBER | format, &word, &word);
    ASSERT_GE(out, 0);
    ASSERT_EQ(ex_put_init(out, "two cubes", 3, 12, 2, 1, 0, 2), 0);
    put_nodes_of_two_cubes(out);
    ASSERT_EQ(ex_put_block(out, EX_ELEM_BLOCK, 1, "HEX8", 2, 8, 0, 0, 0), 0);
    const int nodes[]{1, 2, 5, 4, 7, 8, 11, 10, 2, 3, 6, 5, 8, 9, 12, 11};
    ASSERT_EQ(ex_put_conn(out, EX_ELEM_BLOCK, 1, nodes, nullptr, nullptr), 0);
    for (const int set : {1, 2}) {
        constexpr int below = 5;
        ASSERT_EQ(ex_put_set_param(out, EX_SIDE_SET, set, 1, 0), 0);
        ASSERT_EQ(ex_put_set(out, EX_SIDE_SET, set, &set, &below), 0);
        ASSERT_EQ(ex_put_name(out, EX_SIDE_SET, set, set == 1 ? "Lower_Wall" : "inlet"), 0);
    }
    ASSERT_EQ(ex_put_variable_param(out, EX_NODAL, 3), 0);
    for (int c = 0; c < 3; ++c)
        ASSERT_EQ(ex_put_variable_name(out, EX_NODAL, c + 1,
                                       std::string("velocity_").append(1, "xyz"[c]).c_str()),
                  0);
    const double time = 0.5;
    ASSERT_EQ(ex_put_time(out, 1, &time), 0);
    for (int c = 0; c < 3; ++c) {
        std::vector<double> values;
        for (std::size_t n = 0; n < 12; ++n)
            values.push_back(static_cast<double>(n / 6) + (moving_floor ? 1 : 0)); // z, and more
        ASSERT_EQ(ex_put_var(out, 1, EX_NODAL, c + 1, 1, 12, values.data()), 0);
    }
    ASSERT_EQ(ex_close(out), 0);
}

TEST_F(ExodusSource, TakesSideSetsCalledWallForWalls) {
    for (const bool moving : {false, true}) {
        write_side_sets(file(), moving);
        const auto opened = open_exodus(file());
        ASSERT_TRUE(opened.has_value()) << opened.error().message;
        const auto& fields = (*opened)->description().fields;
        ASSERT_EQ(fields.size(), 1u);
        EXPECT_EQ(fields[0].components, 3); // joined
        EXPECT_EQ((*opened)->description().times, std::vector<double>{0.5});
        const auto step = (*opened)->read(0, fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        ASSERT_EQ(step->walls.size(), 1u);
        vtkPolyData& faces = *step->walls[0].faces;
        ASSERT_EQ(faces.GetNumberOfCells(), 1);
        ASSERT_EQ(faces.GetNumberOfPoints(), 4);
        for (vtkIdType i = 0; i < 4; ++i) {
            EXPECT_LE(faces.GetPoint(i)[0], 1.0);
            EXPECT_EQ(faces.GetPoint(i)[2], 0.0);
        }
        EXPECT_EQ(step->walls[0].no_slip, !moving);
    }
}

// Two cubes, a block each; of the elements' variables the second block has only the heat, the first also the velocity.
void write_fluid_and_solid(const fs::path& file) {
    int word = 8;
    const int out = ex_create(file.c_str(), EX_CLOBBER, &word, &word);
    ASSERT_GE(out, 0);
    ASSERT_EQ(ex_put_init(out, "two blocks", 3, 12, 2, 2, 0, 0), 0);
    put_nodes_of_two_cubes(out);
    const int nodes[2][8]{{1, 2, 5, 4, 7, 8, 11, 10}, {2, 3, 6, 5, 8, 9, 12, 11}};
    for (const int block : {1, 2}) {
        ASSERT_EQ(ex_put_block(out, EX_ELEM_BLOCK, block, "HEX8", 1, 8, 0, 0, 0), 0);
        ASSERT_EQ(ex_put_conn(out, EX_ELEM_BLOCK, block, nodes[block - 1], nullptr, nullptr), 0);
    }
    const char* const names[]{"velocity_x", "velocity_y", "velocity_z", "heat"};
    ASSERT_EQ(ex_put_variable_param(out, EX_ELEM_BLOCK, 4), 0);
    for (int c = 0; c < 4; ++c)
        ASSERT_EQ(ex_put_variable_name(out, EX_ELEM_BLOCK, c + 1, names[c]), 0);
    int table[]{1, 1, 1, 1, 0, 0, 0, 1};
    ASSERT_EQ(ex_put_truth_table(out, EX_ELEM_BLOCK, 2, 4, table), 0);
    for (int step = 1; step <= 2; ++step) {
        const double time = step;
        ASSERT_EQ(ex_put_time(out, step, &time), 0);
        for (int variable = 1; variable <= 4; ++variable)
            for (const int block : {1, 2}) {
                const double value = 10.0 * variable + step;
                if (block == 1 || variable == 4) {
                    ASSERT_EQ(ex_put_var(out, step, EX_ELEM_BLOCK, variable, block, 1, &value), 0);
                }
            }
    }
    ASSERT_EQ(ex_close(out), 0);
}

TEST_F(ExodusSource, TakesBlocksWithoutAVelocityForSolids) {
    write_fluid_and_solid(file());
    const auto opened = open_exodus(file());
    ASSERT_TRUE(opened.has_value()) << opened.error().message;
    const auto& fields = (*opened)->description().fields;
    EXPECT_EQ(fields.size(), 2u);
    for (const std::size_t step : {1u, 0u}) {
        const auto read = (*opened)->read(step, fields);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        ASSERT_EQ(read->blocks.size(), 1u);
        EXPECT_EQ(read->blocks[0]->GetBounds()[1], 1.0);
        vtkDataArray* const velocity = read->blocks[0]->GetCellData()->GetArray("velocity_");
        ASSERT_NE(velocity, nullptr);
        EXPECT_EQ(velocity->GetComponent(0, 1), 21.0 + static_cast<double>(step));
        ASSERT_EQ(read->solids.size(), 1u);
        EXPECT_EQ(read->solids[0]->GetNumberOfPolys(), 6);
        EXPECT_EQ(read->solids[0]->GetBounds()[0], 1.0);
    }
}

TEST_F(ExodusSource, RefusesFilesOfEveryNetcdfFormatThatAreCutOff) {
    for (const int format : {0, EX_64BIT_OFFSET, EX_64BIT_DATA, EX_NETCDF4}) {
        write_side_sets(file(), false, format);
        ASSERT_TRUE(open_exodus(file()).has_value()) << format;
        const std::string whole = read_file(file());
        for (const std::size_t from_end : {1u, 8u, 97u, 1000u, 3000u}) {
            write_file(file(), whole.substr(0, whole.size() - from_end));
            EXPECT_FALSE(open_exodus(file()).has_value())
                << format << ", " << from_end << " of " << whole.size() << " bytes less";
        }
    }
}

TEST_F(ExodusSource, RefusesOtherFiles) {
    write_file(file(), "no Exodus file at all");
    const auto refused = open_exodus(file());
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, Error::Code::Corrupt);
    EXPECT_EQ(open_exodus(folder_ / "none.exo").error().code, Error::Code::NotFound);
}

} // namespace
} // namespace wakesurf::importer::exodus_source_test
