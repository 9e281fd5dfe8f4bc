// CGNS files as sources, written with the CGNS library: structured and unstructured zones, time-steps in one file and
// in several, cell and vertex data, refusals.
#include "importer/sources/open_source.hpp"
#include "tests/importer/cgns_files.hpp"

namespace wakesurf::importer::cgns_source_test {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

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

    static void expect_vector_in_cells(vtkDataSet& block, int step) {
        auto* array = block.GetCellData()->GetArray("Velocity");
        ASSERT_NE(array, nullptr);
        ASSERT_EQ(array->GetNumberOfTuples(), block.GetNumberOfCells());
        for (vtkIdType i = 0; i < block.GetNumberOfCells(); ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(
                    array->GetComponent(i, c),
                    known_velocity(cell_centre(block, i).data(), step)[static_cast<std::size_t>(c)],
                    1e-9);
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
            for (const auto& block : read->blocks)
                expect_vector_in_cells(*block, step);
        }
    }
}

TEST_F(CgnsSource, ConvertsCoordinatesToTheUnitOfLengthOfTheVelocity) {
    Contents contents;
    const auto length_and_note = [&] {
        const auto source = open(contents);
        if (!source)
            return std::pair(0.0, source.error().message);
        const auto bounds = (*source)->read(1, {})->blocks[1]->GetBounds();
        return std::pair(bounds[0], (*source)->description().note);
    };
    for (const bool structured : {true, false}) {
        contents.structured = structured;
        contents.length = contents.of_coordinates = CGNS_ENUMV(LengthUnitsNull);
        const auto [as_written, no_note] = length_and_note();
        EXPECT_EQ(no_note, "");
        contents.length = CGNS_ENUMV(Meter);
        EXPECT_EQ(length_and_note(), (std::pair(as_written, std::string())));
        contents.of_coordinates = CGNS_ENUMV(Millimeter);
        const auto [millimetres, note] = length_and_note();
        EXPECT_NEAR(millimetres, 1e-3 * as_written, 1e-15);
        EXPECT_EQ(note, "x, y, z were converted from millimeter to meter, the velocity's unit");
        contents.length = CGNS_ENUMV(Millimeter); // one system, whichever it is
        EXPECT_EQ(length_and_note(), (std::pair(as_written, std::string())));
        contents.length = CGNS_ENUMV(LengthUnitsNull);
        EXPECT_EQ(length_and_note(),
                  std::pair(as_written, std::string("the velocities have no unit of length: kept, "
                                                    "and taken as millimeter per second")));
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

TEST_F(CgnsSource, TakesZonesWithoutAVelocityForSolids) {
    for (const bool structured : {true, false})
        for (const bool at_cells : {false, true}) {
            Contents contents;
            contents.structured = structured;
            contents.at_cells = at_cells;
            contents.solid = true;
            const auto source = open(contents);
            ASSERT_TRUE(source.has_value()) << source.error().message;
            const auto& fields = (*source)->description().fields;
            EXPECT_NE(field_named(**source, "Velocity"), nullptr);
            EXPECT_NE(field_named(**source, "Pressure"), nullptr);
            EXPECT_EQ(field_named(**source, "Temperature"), nullptr);
            for (const std::size_t step : {2u, 0u}) {
                const auto read = (*source)->read(step, fields);
                ASSERT_TRUE(read.has_value()) << read.error().message;
                ASSERT_EQ(read->blocks.size(), 1u);
                ASSERT_EQ(read->solids.size(), 1u);
                EXPECT_NEAR(read->solids[0]->GetBounds()[0] - read->blocks[0]->GetBounds()[0], 20.0,
                            1e-12);
            }
        }
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
    expect_failure(open(contents), Error::Code::Unsupported,
                   "time-step 2 of flow.cgns is at time 2, after time 3");
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

// VTK's reader takes for cells what is numbered up to their count.
TEST_F(CgnsSource, ReadsTheCellsWhereverTheElementsOfBoundariesAreNumbered) {
    const auto cells = sample_mesh()->GetNumberOfCells();
    for (const auto& boundary : std::vector<Boundary>{{false, false, false, 1},
                                                      {false, false, false, 3 * cells},
                                                      {true, true, false, 1},
                                                      {false, true, true, 2},
                                                      {true, false, true, 4}})
        for (const bool at_cells : {false, true}) {
            SCOPED_TRACE(testing::Message()
                         << (boundary.last ? "last" : "first") << boundary.between << boundary.mixed
                         << boundary.count << (at_cells ? " at cells" : " at nodes"));
            Contents contents;
            contents.structured = false;
            contents.boundary = boundary;
            contents.at_cells = at_cells;
            const auto source = open(contents);
            ASSERT_TRUE(source.has_value()) << source.error().message;
            EXPECT_EQ((*source)->description().times, contents.times);
            const auto* velocity = field_named(**source, "Velocity");
            const auto* density = field_named(**source, "Density");
            ASSERT_NE(velocity, nullptr);
            ASSERT_NE(density, nullptr);
            for (const std::size_t step : {2u, 0u, 1u}) {
                const auto read = (*source)->read(step, {*velocity, *density});
                ASSERT_TRUE(read.has_value()) << read.error().message;
                ASSERT_EQ(read->blocks.size(), 2u);
                for (const auto& block : read->blocks) {
                    EXPECT_EQ(block->GetNumberOfCells(), cells);
                    at_cells ? expect_vector_in_cells(*block, static_cast<int>(step))
                             : expect_vector(*block, "Velocity", static_cast<int>(step));
                }
            }
        }
}

TEST_F(CgnsSource, WithOtherNumbersTellsZonesWithoutAVelocityFromTheFluid) {
    Contents contents;
    contents.structured = false;
    contents.boundary.last = false;
    contents.at_cells = true;
    contents.solid = true;
    contents.times.clear();
    const auto source = open(contents);
    ASSERT_TRUE(source.has_value()) << source.error().message;
    const auto read = (*source)->read(0, (*source)->description().fields);
    ASSERT_TRUE(read.has_value()) << read.error().message;
    ASSERT_EQ(read->blocks.size(), 1u);
    EXPECT_EQ(read->solids.size(), 1u);
    expect_vector_in_cells(*read->blocks[0], 0);
    EXPECT_NE(field_named(**source, "Pressure"), nullptr);
    EXPECT_EQ(field_named(**source, "Temperature"), nullptr);
}

} // namespace
} // namespace wakesurf::importer::cgns_source_test
