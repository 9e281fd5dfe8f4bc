// NetCDF-CF files as sources, written with the netCDF library: packing, fill values, axes in every order, refusals.
#include "importer/assembly/node_values.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/open_source.hpp"
#include "tests/importer/netcdf_files.hpp"
#include "tests/support/temporary_folder.hpp"

#include <algorithm>

namespace wakesurf::importer::netcdf_source_test {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

class NetcdfSource : public testing::Test {
  protected:
    fs::path write(const Flow& flow, const Spoil& spoil = {}) const {
        write_flow(folder_ / "flow.nc", flow, spoil);
        return folder_ / "flow.nc";
    }

    static std::vector<core::FieldInfo> components() {
        using From = core::FieldInfo::Source;
        return {{"u", 1, From::Point, {}, {}},
                {"v", 1, From::Point, {}, {}},
                {"w", 1, From::Point, {}, {}}};
    }

    static void expect_step(Source& source, std::size_t step, double tolerance = known_tolerance) {
        const auto read = source.read(step, components());
        ASSERT_TRUE(read.has_value()) << read.error().message;
        ASSERT_EQ(read->blocks.size(), 1u);
        auto& block = *read->blocks.front();
        for (int c = 0; c < 3; ++c) {
            auto* array = block.GetPointData()->GetArray(c);
            ASSERT_EQ(array->GetNumberOfTuples(), block.GetNumberOfPoints());
            for (vtkIdType i = 0; i < block.GetNumberOfPoints(); ++i)
                ASSERT_NEAR(array->GetTuple1(i),
                            known_velocity(block.GetPoint(i),
                                           static_cast<int>(step))[static_cast<std::size_t>(c)],
                            tolerance)
                    << "component " << c << " at node " << i << " of step " << step;
        }
    }

    static void expect_flow(const fs::path& file,
                            const std::vector<double>& times,
                            double tolerance = known_tolerance * 50) {
        auto source = open_source(file);
        ASSERT_TRUE(source.has_value()) << source.error().message;
        ASSERT_EQ((*source)->description().times, times);
        for (std::size_t i = 0; i < 2 * times.size(); ++i)
            expect_step(**source, i < times.size() ? i : 2 * times.size() - 1 - i, tolerance);
    }

    TemporaryFolder folder_;
};

TEST_F(NetcdfSource, ReadsEveryStepOfEveryFileFormat) {
    for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4})
        for (const nc_type type : {NC_FLOAT, NC_DOUBLE}) {
            Flow flow;
            flow.format = format;
            flow.type = type;
            expect_flow(write(flow), {0.5, 1.5, 4});
        }
}

TEST_F(NetcdfSource, TellsFieldsUnitsAndTimes) {
    const auto source = open_source(write({}));
    const auto& description = (*source)->description();
    EXPECT_EQ(description.name, "flow");
    EXPECT_EQ(description.note, "times are in seconds since 2000-01-01 00:00:00; "
                                "x, y, z have no unit: kept, and taken as m");
    ASSERT_EQ(description.fields.size(), 3u);
    EXPECT_EQ(description.fields[1].name, "v");
    EXPECT_EQ(description.fields[1].components, 1);
    EXPECT_EQ(description.fields[1].unit, "m s-1");
    EXPECT_EQ(description.fields[1].range, (std::array{-2.0, 6.0}));
    EXPECT_EQ((*source)->shared_files()->size(), 1u);
    EXPECT_TRUE((*source)->files(0)->empty());
}

TEST_F(NetcdfSource, TakesDimensionsInAnyOrder) {
    Flow flow;
    std::sort(flow.order.begin(), flow.order.end());
    do {
        flow.format = NC_NETCDF4; // where any dimension may be the unlimited one
        expect_flow(write(flow), flow.times);
    } while (std::next_permutation(flow.order.begin(), flow.order.end()));
}

TEST_F(NetcdfSource, TurnsFallingAxesRound) {
    for (const std::string name : {"x", "y", "z"}) {
        Flow flow;
        std::reverse(flow.axes[name].begin(), flow.axes[name].end());
        expect_flow(write(flow), flow.times);
    }
}

TEST_F(NetcdfSource, MakesAnImageOfEvenNodesAndARectilinearGridOfOthers) {
    const auto block = [&](const Flow& flow) {
        return (*open_source(write(flow)))->read(0, components())->blocks[0];
    };
    Flow flow;
    EXPECT_NE(vtkImageData::SafeDownCast(block(flow)), nullptr);
    flow.axes["y"] = {0, 1, 2 + 3e-6, 3, 4}; // more than a millionth off
    EXPECT_EQ(vtkImageData::SafeDownCast(block(flow)), nullptr);
    flow.axes["y"] = {0, 1, 2, 3, 4.1};
    const auto uneven = block(flow);
    auto* grid = vtkRectilinearGrid::SafeDownCast(uneven);
    ASSERT_NE(grid, nullptr);
    EXPECT_EQ(grid->GetYCoordinates()->GetTuple1(4), 4.1);
    expect_flow(folder_ / "flow.nc", flow.times);
}

TEST_F(NetcdfSource, FindsAxesByTheNamesOfDimensions) {
    Flow flow;
    flow.with_axis_attributes = false;
    expect_flow(write(flow), flow.times);
}

TEST_F(NetcdfSource, UnpacksIntegersAndMakesFillValuesNan) {
    for (const int format : {0, NC_NETCDF4}) {
        Flow flow;
        flow.format = format;
        flow.type = NC_SHORT;
        flow.scale = 0.001;
        expect_flow(write(flow), flow.times, 0.0005 + 1e-9); // half a unit of packing
        auto source = open_source(write(flow, [](std::size_t i, double& raw) {
            if (i % 7 == 3)
                raw = -32768;
        }));
        const auto read = (*source)->read(1, components());
        auto* u = read->blocks[0]->GetPointData()->GetArray("u");
        for (vtkIdType i = 0; i < u->GetNumberOfTuples(); ++i)
            ASSERT_EQ(std::isnan(u->GetTuple1(i)), i % 7 == 3) << i;
        EXPECT_GE(field_named(**source, "w")->range[0], 0.0);
    }
}

TEST_F(NetcdfSource, MakesMissingAndDefaultFillAndInvalidValuesNan) {
    const auto nan_at_3 = [&](const std::function<void(NetcdfWriter&, int)>& define, nc_type type,
                              double raw) {
        {
            NetcdfWriter out(folder_ / "m.nc");
            for (const char* name : {"x", "y", "z"})
                out.dimension(name, 3);
            const int u = out.variable("u", type, {"z", "y", "x"});
            define(out, u);
            out.end();
            std::vector<double> values(27, 5.0);
            values[3] = raw;
            out.put(u, {0, 0, 0}, {3, 3, 3}, values);
        }
        auto source = open_source(folder_ / "m.nc");
        ASSERT_TRUE(source.has_value()) << source.error().message;
        const auto read = (*source)->read(0, {components()[0]});
        auto* found = read->blocks[0]->GetPointData()->GetArray("u");
        for (vtkIdType i = 0; i < 27; ++i)
            EXPECT_EQ(std::isnan(found->GetTuple1(i)), i == 3) << i;
        EXPECT_EQ((*source)->description().fields[0].range, (std::array{5.0, 5.0}));
    };
    const auto nothing = [](NetcdfWriter&, int) {};
    nan_at_3(nothing, NC_FLOAT, static_cast<double>(NC_FILL_FLOAT));
    nan_at_3(nothing, NC_DOUBLE, NC_FILL_DOUBLE);
    nan_at_3(nothing, NC_SHORT, NC_FILL_SHORT);
    nan_at_3(nothing, NC_DOUBLE, std::nan(""));
    nan_at_3([](NetcdfWriter& w, int u) { w.number(u, "missing_value", NC_FLOAT, 1e20); }, NC_FLOAT,
             static_cast<double>(1e20f));
    nan_at_3([](NetcdfWriter& w, int u) { w.number(u, "missing_value", NC_DOUBLE, 1e20); },
             NC_FLOAT, static_cast<double>(1e20f));
    nan_at_3([](NetcdfWriter& w, int u) { w.number(u, "_FillValue", NC_FLOAT, -999); }, NC_FLOAT,
             -999);
    nan_at_3([](NetcdfWriter& w, int u) { w.number(u, "valid_max", NC_FLOAT, 50); }, NC_FLOAT, 51);
    nan_at_3([](NetcdfWriter& w, int u) { w.number(u, "valid_min", NC_FLOAT, -1); }, NC_FLOAT, -2);
}

TEST_F(NetcdfSource, NotesMissingCoordinatesAndTimes) {
    {
        NetcdfWriter out(folder_ / "n.nc");
        out.dimension("time", 2);
        for (const char* name : {"x", "y", "z"})
            out.dimension(name, 3);
        const int u = out.variable("u", NC_FLOAT, {"time", "z", "y", "x"});
        out.end();
        out.put(u, {0, 0, 0, 0}, {2, 3, 3, 3}, std::vector<double>(54, 1.0));
    }
    const auto source = open_source(folder_ / "n.nc");
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->description().times, (std::vector<double>{0, 1}));
    EXPECT_NE((*source)->description().time_note.find("carry no times"), std::string::npos);
    EXPECT_NE((*source)->description().note.find("no coordinates along z"), std::string::npos);
}

TEST_F(NetcdfSource, JoinsNumberedFiles) {
    for (int i = 0; i < 2; ++i) {
        Flow flow;
        flow.times = {2.0 * i, 2.0 * i + 1};
        write_flow(folder_ / ("part_" + std::to_string(i) + ".nc"), flow);
    }
    auto source = open_source(folder_ / "part_1.nc");
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->description().times, (std::vector<double>{0, 1, 2, 3}));
    const auto last = (*source)->read(3, components());
    EXPECT_EQ(last->blocks[0]->GetPointData()->GetArray("u")->GetTuple1(0), 11.0); // step 1 there
    EXPECT_EQ((*source)->files(3)->front().name, "part_1.nc");
}

TEST_F(NetcdfSource, KnowsWhichOfItsFilesIsCutOff) {
    for (int i = 0; i < 3; ++i) {
        Flow flow;
        flow.times = {2.0 * i, 2.0 * i + 1};
        write_flow(folder_ / ("part_" + std::to_string(i) + ".nc"), flow);
    }
    const auto last = folder_ / "part_2.nc";
    std::filesystem::resize_file(last, std::filesystem::file_size(last) / 2);
    const auto source = open_source(last).value();
    EXPECT_EQ(source->description().times, (std::vector<double>{0, 1, 2, 3, 4}));
    ASSERT_EQ(source->description().unreadable.size(), 1u);
    EXPECT_EQ(source->description().unreadable.at(4).message.find("part_2.nc"), 0u);
    EXPECT_TRUE(source->read(3, components()).has_value());
    const auto first = folder_ / "part_0.nc";
    std::filesystem::resize_file(first, std::filesystem::file_size(first) / 2);
    EXPECT_FALSE(open_source(last).has_value());
}

TEST_F(NetcdfSource, TakesWhatARestartWroteLast) {
    for (const double first : {0.0, 1.0}) { // 0, 1 and 1, 2
        Flow flow;
        flow.times = {first, first + 1};
        write_flow(folder_ / ("part_" + std::to_string(static_cast<int>(first)) + ".nc"), flow);
    }
    const auto parts = open_source(folder_ / "part_0.nc").value();
    EXPECT_EQ(parts->description().times, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(parts->files(1)->front().name, "part_1.nc");
    EXPECT_EQ(parts->description().time_note,
              "left out, as another was written later for the same time: time-step 1 of part_0.nc");
    Flow flow;
    flow.times = {1, 2, 3, 2, 4};
    const auto source = open_source(write(flow)).value();
    EXPECT_EQ(source->description().times, (std::vector<double>{1, 2, 3, 4}));
    for (const auto& [step, in_file] : {std::pair{1u, 3}, {2u, 2}, {3u, 4}})
        EXPECT_EQ(source->read(step, components())
                      ->blocks[0]
                      ->GetPointData()
                      ->GetArray("u")
                      ->GetTuple1(0),
                  1.0 + 10.0 * in_file);
    EXPECT_EQ(source->description().time_note,
              "times go back at time-step 3 of flow.nc, as after a restart: they are sorted; "
              "left out, as another was written later for the same time: time-step 1 of flow.nc");
}

TEST_F(NetcdfSource, RefusesTimesThatAreNone) {
    Flow flow;
    flow.times = {1, std::nan(""), 2};
    expect_failure(open_source(write(flow)), Error::Code::Corrupt, "time-step 1 of flow.nc has no");
}

TEST_F(NetcdfSource, RefusesWhatIsNotAGridInSpace) {
    Flow flow;
    flow.units["x"] = "degrees_east";
    expect_failure(open_source(write(flow)), Error::Code::Unsupported, "x is an angle");
    flow = {};
    flow.units["z"] = "hPa";
    expect_failure(open_source(write(flow)), Error::Code::Unsupported, "z is a pressure");
    flow = {};
    flow.axes["y"] = {0, 1, 3, 2, 4};
    expect_failure(open_source(write(flow)), Error::Code::Corrupt, "neither increase nor decrease");
}

TEST_F(NetcdfSource, GivesAPlaneAThicknessWithOrWithoutItsThirdDimension) {
    for (const bool uneven : {false, true})
        for (const Names& order :
             {Names{"time", "y", "x"}, Names{"x", "time", "y"}, Names{"time", "z", "y", "x"}}) {
            {
                NetcdfWriter out(folder_ / "plane.nc");
                out.dimension("time", 2);
                out.dimension("x", 4);
                out.dimension("y", 3);
                out.dimension("z", 1);
                const int x = out.variable("x", NC_DOUBLE, {"x"});
                const int u = out.variable("u", NC_DOUBLE, order);
                const int v = out.variable("v", NC_DOUBLE, order);
                out.end();
                out.put(x,
                        uneven ? std::vector<double>{0, 1, 3, 6} : std::vector<double>{0, 1, 2, 3});
                std::map<std::string, std::size_t> length{
                    {"time", 2}, {"x", 4}, {"y", 3}, {"z", 1}};
                std::vector<std::size_t> count;
                std::vector<std::size_t> start;
                for (const auto& name : order) {
                    count.push_back(length[name]);
                    start.push_back(0);
                }
                for (const int variable : {u, v}) {
                    std::vector<double> values;
                    for (std::size_t n = 0; n < 24; ++n) {
                        std::map<std::string, std::size_t> at;
                        std::size_t rest = n;
                        for (std::size_t d = order.size(); d-- > 0; rest /= count[d])
                            at[order[d]] = rest % count[d];
                        values.push_back(
                            static_cast<double>(100 * at["time"] + 10 * at["y"] + at["x"]) +
                            (variable == v ? 0.5 : 0.0));
                    }
                    out.put(variable, start, count, values);
                }
            }
            const auto source = open_source(folder_ / "plane.nc");
            ASSERT_TRUE(source.has_value()) << source.error().message;
            const auto step = (*source)->read(1, (*source)->description().fields);
            ASSERT_TRUE(step.has_value()) << step.error().message;
            vtkDataSet& slab = *step->blocks.front();
            ASSERT_EQ(slab.GetNumberOfPoints(), 24);
            for (vtkIdType i = 0; i < 24; ++i) {
                const auto value = [&](const char* name) {
                    return slab.GetPointData()->GetArray(name)->GetTuple1(i);
                };
                EXPECT_EQ(value("u"), static_cast<double>(100 + 10 * (i / 4 % 3) + i % 4));
                EXPECT_EQ(value("v"), value("u") + 0.5);
                EXPECT_EQ(value("w"), 0.0);
            }
            EXPECT_LT(slab.GetBounds()[4], 0.0);
            EXPECT_GT(slab.GetBounds()[5], 0.0);
        }
}

TEST_F(NetcdfSource, TakesThePartsOfAPlanesVelocityByTheirStandardNames) {
    {
        NetcdfWriter out(folder_ / "sea.nc");
        out.dimension("time", 2);
        out.dimension("x", 4);
        out.dimension("y", 3);
        const int east = out.variable("current_e", NC_DOUBLE, {"time", "y", "x"});
        const int north = out.variable("current_n", NC_DOUBLE, {"time", "y", "x"});
        out.text(east, "standard_name", "eastward_sea_water_velocity");
        out.text(north, "standard_name", "northward_sea_water_velocity");
        out.end();
        for (const int variable : {east, north})
            out.put(variable, {0, 0, 0}, {2, 3, 4},
                    std::vector<double>(24, variable == east ? 1.5 : 0.5));
    }
    const auto source = open_source(folder_ / "sea.nc");
    ASSERT_TRUE(source.has_value()) << source.error().message;
    const auto& description = (*source)->description();
    const auto velocity = choose_velocity(description.fields, "", description.velocities);
    ASSERT_TRUE(velocity.has_value()) << velocity.error().message;
    const auto step = (*source)->read(1, velocity->parts.arrays);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    const auto values = point_values(step->blocks, velocity->parts);
    ASSERT_TRUE(values.has_value());
    for (std::size_t i = 0; i < values->size(); ++i)
        EXPECT_EQ((*values)[i], i % 3 == 0 ? 1.5f : i % 3 == 1 ? 0.5f : 0.0f);
}

TEST_F(NetcdfSource, RefusesStaggeredAndCurvilinearGrids) {
    {
        NetcdfWriter out(folder_ / "s.nc");
        for (const char* name : {"x", "y", "z", "xu"})
            out.dimension(name, 4);
        out.text(out.variable("xu", NC_DOUBLE, {"xu"}), "axis", "X");
        out.variable("u", NC_FLOAT, {"z", "y", "xu"});
        out.variable("v", NC_FLOAT, {"z", "y", "x"});
    }
    expect_failure(open_source(folder_ / "s.nc"), Error::Code::Unsupported,
                   "s.nc has a staggered grid");
    {
        NetcdfWriter out(folder_ / "c.nc");
        for (const char* name : {"i", "j", "z"})
            out.dimension(name, 4);
        out.variable("xc", NC_DOUBLE, {"j", "i"});
        out.variable("yc", NC_DOUBLE, {"j", "i"});
        out.text(out.variable("u", NC_FLOAT, {"z", "j", "i"}), "coordinates", "xc yc");
    }
    expect_failure(open_source(folder_ / "c.nc"), Error::Code::Unsupported,
                   "c.nc has curvilinear coordinates: xc yc");
}

TEST_F(NetcdfSource, RefusesTwoTimes) {
    {
        NetcdfWriter out(folder_ / "t.nc");
        for (const char* name : {"x", "y", "z", "time", "t"})
            out.dimension(name, 4);
        for (const char* name : {"u", "v", "w"})
            out.variable(name, NC_FLOAT, {"time", "z", "y", "x"});
        out.variable("p", NC_FLOAT, {"t", "z", "y", "x"});
    }
    expect_failure(open_source(folder_ / "t.nc"), Error::Code::Unsupported,
                   "t.nc has two times: that of p is not that of u");
}

TEST_F(NetcdfSource, RefusesTwoVariablesOrDimensionsOfOneName) {
    Flow flow;
    flow.format = NC_64BIT_OFFSET;
    const std::string whole = read_file(write(flow));
    const auto renamed = [&](char from, std::size_t nth) {
        std::string text = whole;
        const std::string name{0, 0, 0, 1, from, 0, 0, 0};
        std::size_t at = text.find(name);
        for (std::size_t i = 1; i < nth; ++i)
            at = text.find(name, at + 1);
        text.at(at + 4) = 'x'; // the library writes none such, and reads them
        write_file(folder_ / "twice.nc", text);
        return open_source(folder_ / "twice.nc");
    };
    expect_failure(renamed('u', 1), Error::Code::Corrupt, "it has two variables called x");
    expect_failure(renamed('y', 2), Error::Code::Corrupt, "it has two variables called x");
    expect_failure(renamed('y', 1), Error::Code::Corrupt, "it has two dimensions called x");
}

TEST_F(NetcdfSource, NamesTheFieldThatIsNotThere) {
    const auto source = open_source(write({}));
    expect_failure((*source)->read(0, {{"q", 1, core::FieldInfo::Source::Point, {}, {}}}),
                   Error::Code::NotFound, "flow.nc has no field q");
}

TEST_F(NetcdfSource, RefusesEveryTruncation) {
    for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4}) {
        Flow flow;
        flow.format = format;
        flow.axes["x"].clear();
        for (int i = 0; i < 40; ++i)
            flow.axes["x"].push_back(0.1 * i);
        const std::string whole = read_file(write(flow));
        for (std::size_t size = 1; size < whole.size(); size += 511) {
            write_file(folder_ / "cut.nc", whole.substr(0, size));
            expect_failure(open_source(folder_ / "cut.nc"), Error::Code::Corrupt, "cut.nc");
        }
        write_file(folder_ / "cut.nc", whole.substr(0, whole.size() - 8));
        expect_failure(open_source(folder_ / "cut.nc"), Error::Code::Corrupt, "cut.nc");
    }
    write_file(folder_ / "text.nc", "no NetCDF");
    expect_failure(open_source(folder_ / "text.nc"), Error::Code::Corrupt,
                   "text.nc is not a NetCDF file");
}

TEST_F(NetcdfSource, DoesNotGiveAnEarlierStepForADamagedOne) {
    for (int i = 0; i < 3; ++i) {
        Flow flow;
        flow.times = {1.0 * i};
        write_flow(folder_ / (std::string("d") + std::to_string(i) + ".nc"), flow);
    }
    auto source = open_source(folder_ / "d0.nc");
    const std::string good = read_file(folder_ / "d1.nc");
    write_file(folder_ / "d1.nc", good.substr(0, good.size() / 2));
    ASSERT_TRUE((*source)->read(0, components()).has_value());
    expect_failure((*source)->read(1, components()), Error::Code::Corrupt, "d1.nc");
    EXPECT_TRUE((*source)->read(2, components()).has_value());
}

TEST_F(NetcdfSource, OfAnAxisWithoutNodesIsRefused) {
    for (const bool with_coordinates : {false, true}) {
        const auto file = folder_ / (with_coordinates ? "with.nc" : "without.nc");
        {
            NetcdfWriter out(file);
            out.dimension("z", 2);
            out.dimension("y", 2);
            out.dimension("x", NC_UNLIMITED);
            if (with_coordinates)
                out.variable("x", NC_DOUBLE, {"x"});
            for (const char* name : {"u", "v", "w"})
                out.variable(name, NC_FLOAT, {"z", "y", "x"});
            out.end();
        }
        const auto source = open_source(file);
        ASSERT_FALSE(source.has_value());
        EXPECT_NE(source.error().message.find("no nodes along x"), std::string::npos)
            << source.error().message;
    }
}

} // namespace
} // namespace wakesurf::importer::netcdf_source_test
