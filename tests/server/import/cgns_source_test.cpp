// CGNS files as sources, written with the CGNS library: structured and unstructured zones, time-steps in one file and
// in several, cell and vertex data, refusals.
#include "tests/server/import/known_flow.hpp"
#include "tests/support/temporary_folder.hpp"

#include <vtk_cgns.h>
// clang-format off
#include VTK_CGNS(cgnslib.h)

// clang-format on

namespace wakesurf::server {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

enum class Pointers { Written, Missing };

struct Contents {
    std::vector<double> times{0.25, 0.5, 2};
    std::string vector = "Velocity"; ///< its components get X, Y and Z
    bool structured = true;
    bool adf = false;
    Pointers pointers = Pointers::Written;
    bool at_cells = false;
    int first_step = 0; ///< which known flow the first time-step is
};

void ok(int status) {
    ASSERT_EQ(status, CG_OK) << cg_get_error();
}

// Solution of one zone at one step: the vector at the vertices, T in the cells.
void write_solution(int file, int zone, vtkDataSet& data, const Contents& contents, int step) {
    const std::string n = std::to_string(step);
    int solution = 0;
    int field = 0;
    ok(cg_sol_write(file, 1, zone, ("Flow" + n).c_str(),
                    contents.at_cells ? CGNS_ENUMV(CellCenter) : CGNS_ENUMV(Vertex), &solution));
    const vtkIdType count = contents.at_cells ? data.GetNumberOfCells() : data.GetNumberOfPoints();
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<double> values;
        for (vtkIdType i = 0; i < count; ++i)
            values.push_back(
                contents.at_cells
                    ? known_velocity(cell_centre(data, i).data(), contents.first_step + step)[c]
                    : known_velocity(data.GetPoint(i), contents.first_step + step)[c]);
        ok(cg_field_write(file, 1, zone, solution, CGNS_ENUMV(RealDouble),
                          (contents.vector + "XYZ"[c]).c_str(), values.data(), &field));
    }
    std::vector<double> density(static_cast<std::size_t>(count), 1.25);
    ok(cg_field_write(file, 1, zone, solution, CGNS_ENUMV(RealDouble), "Density", density.data(),
                      &field));
}

int write_zone(int file, const std::string& name, vtkStructuredGrid& grid) {
    const int* n = grid.GetDimensions();
    const std::array<cgsize_t, 9> size{n[0], n[1], n[2], n[0] - 1, n[1] - 1, n[2] - 1, 0, 0, 0};
    int zone = 0;
    ok(cg_zone_write(file, 1, name.c_str(), size.data(), CGNS_ENUMV(Structured), &zone));
    return zone;
}

int write_zone(int file, const std::string& name, vtkUnstructuredGrid& grid) {
    const std::array<cgsize_t, 3> size{grid.GetNumberOfPoints(), grid.GetNumberOfCells(), 0};
    int zone = 0;
    ok(cg_zone_write(file, 1, name.c_str(), size.data(), CGNS_ENUMV(Unstructured), &zone));
    const std::array<std::pair<int, CGNS_ENUMT(ElementType_t)>, 4> types{
        {{VTK_HEXAHEDRON, CGNS_ENUMV(HEXA_8)},
         {VTK_WEDGE, CGNS_ENUMV(PENTA_6)},
         {VTK_PYRAMID, CGNS_ENUMV(PYRA_5)},
         {VTK_TETRA, CGNS_ENUMV(TETRA_4)}}};
    cgsize_t next = 1;
    for (const auto& [vtk, cgns] : types) {
        std::vector<cgsize_t> nodes;
        const cgsize_t first = next;
        for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i) {
            if (grid.GetCellType(i) != vtk)
                continue;
            ++next;
            for (vtkIdType k = 0; k < grid.GetCell(i)->GetNumberOfPoints(); ++k)
                nodes.push_back(grid.GetCell(i)->GetPointId(static_cast<int>(k)) + 1);
        }
        int section = 0;
        ok(cg_section_write(file, 1, zone, (std::string("E") + std::to_string(vtk)).c_str(), cgns,
                            first, next - 1, 0, nodes.data(), &section));
    }
    const std::array<cgsize_t, 4> quad{1, 2, 10, 9}; // of the boundary: no cell
    int section = 0;
    ok(cg_section_write(file, 1, zone, "Floor", CGNS_ENUMV(QUAD_4), next, next, 0, quad.data(),
                        &section));
    return zone;
}

void write_coordinates(int file, int zone, vtkDataSet& data) {
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<double> values;
        for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
            values.push_back(data.GetPoint(i)[c]);
        int coordinate = 0;
        ok(cg_coord_write(file, 1, zone, CGNS_ENUMV(RealDouble),
                          (std::string("Coordinate") + "XYZ"[c]).c_str(), values.data(),
                          &coordinate));
    }
}

void write_pointers(int file, int zone, std::size_t steps) {
    ok(cg_ziter_write(file, 1, zone, "ZoneIterativeData"));
    ok(cg_goto(file, 1, "Zone_t", zone, "ZoneIterativeData_t", 1, "end"));
    std::string names(32 * steps, ' ');
    for (std::size_t i = 0; i < steps; ++i)
        names.replace(32 * i, 5, "Flow" + std::to_string(i));
    const std::array<cgsize_t, 2> size{32, static_cast<cgsize_t>(steps)};
    ok(cg_array_write("FlowSolutionPointers", CGNS_ENUMV(Character), 2, size.data(), names.data()));
}

void write_cgns(const fs::path& path, const Contents& contents) {
    fs::remove(path);
    ok(cg_set_file_type(contents.adf ? CG_FILE_ADF : CG_FILE_HDF5));
    int file = 0;
    int base = 0;
    ok(cg_open(path.c_str(), CG_MODE_WRITE, &file));
    ok(cg_base_write(file, "Base", 3, 3, &base));
    if (!contents.times.empty()) {
        ok(cg_biter_write(file, base, "TimeIterValues", static_cast<int>(contents.times.size())));
        ok(cg_goto(file, base, "BaseIterativeData_t", 1, "end"));
        const auto steps = static_cast<cgsize_t>(contents.times.size());
        ok(cg_array_write("TimeValues", CGNS_ENUMV(RealDouble), 1, &steps, contents.times.data()));
    }
    for (int block = 0; block < 2; ++block) {
        const std::string name = "Zone" + std::to_string(block);
        vtkSmartPointer<vtkDataSet> data;
        int zone = 0;
        if (contents.structured) {
            auto grid = sample_structured(20.0 * block);
            zone = write_zone(file, name, *grid);
            data = grid;
        } else {
            auto grid = sample_mesh(20.0 * block);
            zone = write_zone(file, name, *grid);
            data = grid;
        }
        write_coordinates(file, zone, *data);
        const auto steps = std::max<std::size_t>(contents.times.size(), 1);
        for (std::size_t step = 0; step < steps; ++step)
            write_solution(file, zone, *data, contents, static_cast<int>(step));
        if (contents.pointers == Pointers::Written && !contents.times.empty())
            write_pointers(file, zone, steps);
    }
    ok(cg_close(file));
}

class CgnsSource : public testing::Test {
  protected:
    static void expect_step(Source& source, std::size_t step, const std::string& vector) {
        const auto read =
            source.read(step, {{vector, 3, core::FieldInfo::Source::Point, {0, 0}, {}}});
        ASSERT_TRUE(read.has_value()) << read.error().message;
        ASSERT_EQ(read->blocks.size(), 2u);
        EXPECT_EQ(read->blocks[0]->GetPointData()->GetNumberOfArrays(), 1);
        EXPECT_NEAR(read->blocks[1]->GetBounds()[0] - read->blocks[0]->GetBounds()[0], 20.0, 1e-12);
        for (const auto& block : read->blocks)
            expect_vector(*block, vector.c_str(), static_cast<int>(step));
    }

    static void expect_steps(const core::Result<std::unique_ptr<Source>>& source,
                             const std::vector<double>& times,
                             const std::string& vector = "Velocity") {
        ASSERT_TRUE(source.has_value()) << source.error().message;
        ASSERT_EQ((*source)->description().times, times);
        for (std::size_t i = 0; i < 2 * times.size(); ++i)
            expect_step(**source, i < times.size() ? i : 2 * times.size() - 1 - i, vector);
    }

    core::Result<std::unique_ptr<Source>> open(const Contents& contents) const {
        write_cgns(folder_ / "flow.cgns", contents);
        return open_source(folder_ / "flow.cgns");
    }

    TemporaryFolder folder_;
};

TEST_F(CgnsSource, ReadsEveryStepOfStructuredAndUnstructuredZones) {
    for (const bool structured : {true, false})
        for (const bool adf : {false, true}) {
            Contents contents;
            contents.structured = structured;
            contents.adf = adf;
            expect_steps(open(contents), contents.times);
        }
}

TEST_F(CgnsSource, LeavesCellDataInTheCells) {
    for (const bool structured : {true, false}) {
        Contents contents;
        contents.structured = structured;
        contents.at_cells = true;
        const auto source = open(contents);
        ASSERT_TRUE(source.has_value()) << source.error().message;
        const auto* velocity = field_named(**source, "Velocity");
        ASSERT_NE(velocity, nullptr);
        EXPECT_EQ(velocity->source, core::FieldInfo::Source::Cell);
        for (int step = 0; step < 3; ++step) {
            const auto read = (*source)->read(static_cast<std::size_t>(step), {*velocity});
            ASSERT_TRUE(read.has_value()) << read.error().message;
            for (const auto& block : read->blocks) {
                auto* array = block->GetCellData()->GetArray("Velocity");
                ASSERT_EQ(array->GetNumberOfTuples(), block->GetNumberOfCells());
                for (vtkIdType i = 0; i < block->GetNumberOfCells(); ++i)
                    for (int c = 0; c < 3; ++c)
                        ASSERT_NEAR(array->GetComponent(i, c),
                                    known_velocity(cell_centre(*block, i).data(),
                                                   step)[static_cast<std::size_t>(c)],
                                    1e-9);
            }
        }
    }
}

TEST_F(CgnsSource, TellsItsFields) {
    const auto source = open({});
    const auto* velocity = field_named(**source, "Velocity");
    ASSERT_NE(velocity, nullptr);
    EXPECT_EQ(velocity->components, 3);
    EXPECT_EQ(velocity->source, core::FieldInfo::Source::Point);
    EXPECT_EQ((*source)->description().reader, "vtkCGNSReader (cgns)");
    EXPECT_EQ((*source)->shared_files()->front().name, "flow.cgns");
}

TEST_F(CgnsSource, DeliversMomentumAndDensity) {
    Contents contents;
    contents.vector = "Momentum";
    const auto source = open(contents);
    expect_steps(source, contents.times, "Momentum");
    ASSERT_NE(field_named(**source, "Density"), nullptr);
    EXPECT_EQ(field_named(**source, "Density")->range, (std::array{1.25, 1.25}));
}

TEST_F(CgnsSource, ReadsOneFileAStep) {
    for (int i = 0; i < 3; ++i) {
        Contents contents;
        contents.times = {};
        contents.first_step = i;
        write_cgns(folder_ / ("n_" + std::to_string(i) + ".cgns"), contents);
        contents.times = {1.5 + i};
        write_cgns(folder_ / ("t_" + std::to_string(i) + ".cgns"), contents);
    }
    expect_steps(open_source(folder_ / "n_2.cgns"), {0, 1, 2});
    const auto timed = open_source(folder_ / "t_*.cgns");
    expect_steps(timed, {1.5, 2.5, 3.5});
    EXPECT_EQ((*timed)->files(1)->front().name, "t_1.cgns");
}

TEST_F(CgnsSource, RefusesSeveralSolutionsWithoutTimes) {
    Contents contents;
    contents.pointers = Pointers::Missing;
    expect_failure(open(contents), Error::Code::Unsupported,
                   "flow.cgns has several solutions at one place, Flow0 and Flow1");
}

TEST_F(CgnsSource, RefusesTimesThatDoNotRise) {
    Contents contents;
    contents.times = {1, 3, 2};
    expect_failure(open(contents), Error::Code::Corrupt,
                   "time-step 2 of flow.cgns comes after time-step 1 of flow.cgns");
}

TEST_F(CgnsSource, RefusesEveryTruncation) {
    for (const bool adf : {false, true}) {
        Contents contents;
        contents.adf = adf;
        write_cgns(folder_ / "flow.cgns", contents);
        const std::string whole = read_file(folder_ / "flow.cgns");
        for (std::size_t size = 1; size < whole.size(); size += 4096) {
            write_file(folder_ / "cut.cgns", whole.substr(0, size));
            expect_failure(open_source(folder_ / "cut.cgns"), Error::Code::Corrupt, "cut.cgns");
        }
    }
    write_file(folder_ / "text.cgns", "no CGNS");
    expect_failure(open_source(folder_ / "text.cgns"), Error::Code::Corrupt, "text.cgns");
}

TEST_F(CgnsSource, DoesNotGiveAnotherStepForOneThatIsGone) {
    auto source = open({});
    Contents shorter;
    shorter.times = {0.25, 0.5};
    write_cgns(folder_ / "flow.cgns", shorter);
    expect_failure((*source)->read(2, {}), Error::Code::Corrupt,
                   "flow.cgns at time 2 is not in the file any more");
}

} // namespace
} // namespace wakesurf::server
