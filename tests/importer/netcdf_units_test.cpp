// Units of NetCDF-CF files: what they state is converted to metres, seconds and metres a second, and said; what they do not
// state, or in words UDUNITS does not know, is kept and said.
#include "importer/sources/open_source.hpp"
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/netcdf_files.hpp"
#include "tests/support/programs.hpp"

#include <sstream>

namespace wakesurf::importer::netcdf_units_test {
namespace {

using core::Error;
using Strings = std::vector<std::string>;

class NetcdfUnits : public Import {
  protected:
    core::Result<std::unique_ptr<Source>> open(const Flow& flow) const {
        write_flow(folder_ / "flow.nc", flow);
        return open_source(folder_ / "flow.nc");
    }

    // u at the first node of the first step.
    static double first_u(Source& source) {
        const auto read = source.read(0, {source.description().fields.front()});
        EXPECT_EQ(source.description().fields.front().name, "u");
        return read->blocks[0]->GetPointData()->GetArray("u")->GetTuple1(0);
    }

    static std::string note(const core::Result<std::unique_ptr<Source>>& source) {
        return source ? (*source)->description().note : "failed: " + source.error().message;
    }
};

// 0.1 m s-1 for an hour is 360 m; it was 0.1 m.
TEST_F(NetcdfUnits, AnHourOfTheDataIs3600Seconds) {
    Flow flow;
    flow.times = {0, 0.5, 1};
    flow.time_units = "hours since 2000-01-01";
    flow.units = {{"x", "m"}, {"y", "m"}, {"z", "m"}};
    const auto source = open(flow);
    EXPECT_EQ((*source)->description().times, (std::vector<double>{0, 1800, 3600}));
    EXPECT_EQ(note(source), "times were converted from hours to seconds since 2000-01-01");
}

TEST_F(NetcdfUnits, ConvertsTimesOfEveryUsualUnit) {
    const std::map<std::string, double> seconds{
        {"seconds since 1970-01-01 00:00:00", 1}, {"s", 1},        {"minutes since 2000-1-1", 60},
        {"Hours since 2000-01-01", 3600},         {"h", 3600},     {"hr", 3600},
        {"days since 1850-1-1 0:0:0", 86400},     {"day", 86400},  {"d", 86400},
        {"weeks since 2000-01-01", 604800},       {"msec", 0.001}, {"microseconds", 1e-6}};
    for (const auto& [units, factor] : seconds) {
        Flow flow;
        flow.time_units = units;
        const auto source = open(flow);
        ASSERT_TRUE(source.has_value()) << units << ": " << source.error().message;
        ASSERT_EQ((*source)->description().times.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR((*source)->description().times[i], flow.times[i] * factor,
                        1e-12 * flow.times[i] * factor)
                << units;
        EXPECT_NE(note(source).find(factor == 1 ? "times are in " + units : "times were converted"),
                  std::string::npos)
            << note(source);
    }
}

TEST_F(NetcdfUnits, ConvertsLengthsAlongEachAxisByItself) {
    Flow flow;
    flow.units = {{"x", "km"}, {"y", "kilometers"}, {"z", "cm"}};
    const auto source = open(flow);
    double bounds[6];
    (*source)->read(0, {})->blocks[0]->GetBounds(bounds);
    const std::array expected{0.0, 1500.0, -1000.0, 3000.0, 0.02, 0.025};
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(bounds[i], expected[i], 1e-12 * std::abs(expected[i])) << i;
    EXPECT_NE(note(source).find("z was converted from cm to m"), std::string::npos) << note(source);
    EXPECT_NE(note(source).find("y was converted from kilometers to m"), std::string::npos);
}

TEST_F(NetcdfUnits, ConvertsVelocitiesAndSaysTheUnitTheyHaveNow) {
    const std::map<std::string, double> factors{
        {"m s-1", 1},     {"m/s", 1},        {"m s**-1", 1},       {"cm/s", 0.01},
        {"mm s-1", 1e-3}, {"km/h", 1 / 3.6}, {"km hr-1", 1 / 3.6}, {"knot", 1852.0 / 3600.0}};
    for (const auto& [units, factor] : factors)
        for (const nc_type type : {NC_FLOAT, NC_DOUBLE}) {
            Flow flow;
            flow.type = type;
            flow.units = {{"u", units}, {"v", units}, {"w", units}};
            const auto source = open(flow);
            ASSERT_TRUE(source.has_value()) << units << ": " << source.error().message;
            const std::array<double, 3> at{0, -1, 2};
            const double raw = known_velocity(at.data(), 0)[0];
            EXPECT_NEAR(first_u(**source), raw * factor, 1e-6 * std::abs(raw * factor)) << units;
            EXPECT_EQ((*source)->description().fields[0].unit, "m s-1");
            EXPECT_EQ(note(source).find("u, v, w were converted from " + units + " to m s-1") !=
                          std::string::npos,
                      factor != 1)
                << note(source);
        }
}

TEST_F(NetcdfUnits, KeepsWhatItDoesNotKnowAndSaysSo) {
    Flow flow;
    flow.units = {{"x", "cells"}, {"z", "furlongish"}, {"u", ""}, {"v", ""}, {"w", ""}};
    flow.time_units = "iterations";
    EXPECT_EQ(note(open(flow)),
              "times are in 'iterations', which is not known: kept, and taken as s; "
              "x is in 'cells', which is not known: kept, and taken as m; "
              "z is in 'furlongish', which is not known: kept, and taken as m");
    flow.time_units = "hours";
    EXPECT_EQ(note(open(flow)), "times were converted from hours to seconds; "
                                "y has no unit: kept, and taken as m; "
                                "x is in 'cells', which is not known: kept, and taken as m; "
                                "z is in 'furlongish', which is not known: kept, and taken as m; "
                                "u, v, w have no unit: kept, and taken as m s-1");
    flow.units = {{"u", ""}, {"v", ""}, {"w", ""}};
    flow.time_units = "";
    EXPECT_EQ(note(open(flow)), "") << "numbers without any dimension need no words";
    flow.units = {};
    EXPECT_EQ(note(open(flow)), "the times have no unit: kept, and taken as s; "
                                "x, y, z have no unit: kept, and taken as m");
}

TEST_F(NetcdfUnits, RefusesTimesInMonthsAndYearsWhichAreNotAllOfOneLength) {
    for (const std::string units : {"months since 2000-01-01", "years since 1900-1-1", "month"}) {
        Flow flow;
        flow.time_units = units;
        expect_failure(open(flow), Error::Code::Unsupported, "not all of one length");
        flow.times = {3};
        EXPECT_TRUE(open(flow).has_value()) << "a single time-step";
    }
    Flow flow;
    flow.time_units = "common_years since 2000-01-01"; // of 365 days each
    EXPECT_EQ((*open(flow))->description().times[0], 0.5 * 365 * 86400);
}

TEST_F(NetcdfUnits, RefusesAxesThatAreNoLength) {
    for (const std::string units : {"radians", "Pa", "K", "s", "kg m-2"}) {
        Flow flow;
        flow.units = {{"z", units}};
        EXPECT_EQ(open(flow).error().code, Error::Code::Unsupported) << units;
    }
}

TEST_F(NetcdfUnits, RefusesAVelocityOfPartsInDifferentUnits) {
    Flow flow;
    flow.units = {{"w", "Pa s-1"}};
    write_flow(folder_ / "flow.nc", flow);
    expect_refusal("flow.nc", "no vertical velocity: w is a rate of change (Pa s-1)");
    flow.units = {{"v", "m/s"}, {"w", "m s**-1"}}; // other words for one unit
    write_flow(folder_ / "flow.nc", flow);
    EXPECT_EQ(run("flow.nc").status, 0);
}

TEST_F(NetcdfUnits, CountsTheTimesOfAllFilesFromOneReference) {
    Flow flow;
    flow.times = {0, 12};
    for (const std::string day : {"01", "02"}) {
        flow.time_units = "hours since 2000-03-" + day;
        write_flow(folder_ / ("day_" + day + ".nc"), flow);
    }
    const auto source = open_source(folder_ / "day_01.nc");
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->description().times, (std::vector<double>{0, 43200, 86400, 129600}));
    flow.calendar = "360_day";
    write_flow(folder_ / "day_02.nc", flow);
    expect_failure(open_source(folder_ / "day_01.nc"), Error::Code::Unsupported,
                   "counts its times since 2000-03-02, the first file since 2000-03-01");
}

// From the file to the surface: 0.1 m s-1 along each axis for an hour.
TEST_F(NetcdfUnits, MakeAPathOfAnHour360MetresLong) {
    Flow flow;
    flow.times = {0, 0.5, 1};
    flow.time_units = "hours since 2000-01-01";
    flow.axes = {{"x", {0, 0.5, 1}}, {"y", {0, 0.5, 1}}, {"z", {0, 0.5, 1}}};
    flow.units = {{"x", "km"}, {"y", "km"}, {"z", "km"}};
    write_flow(folder_ / "flow.nc", flow, [](std::size_t, double& raw) { raw = 0.1; });
    ASSERT_EQ(run("flow.nc").status, 0);
    const std::string mesh = folder_ / "path.obj";
    const auto built =
        run_child(tests::server_program(),
                  {"surface", store(), "--kind", "path", "--rake", "100,100,100 100,200,100",
                   "--from", "0", "--to", "3600", "-o", mesh},
                  0, [](std::string_view) {}, {});
    ASSERT_EQ(built->exit_status, 0) << built->errors;
    std::istringstream in(read_file(mesh));
    double furthest = 0;
    for (std::string kind; in >> kind; in.ignore(1000, '\n'))
        if (double x = 0; kind == "v" && in >> x)
            furthest = std::max(furthest, x);
    EXPECT_NEAR(furthest, 100 + 360, 1e-3);
}

TEST_F(NetcdfUnits, AreInTheNoteAndTheFieldsOfInfo) {
    Flow flow;
    flow.time_units = "days since 2000-01-01";
    flow.units = {{"x", "km"},   {"y", "km"},   {"z", "km"},
                  {"u", "km/h"}, {"v", "km/h"}, {"w", "km/h"}};
    write_flow(folder_ / "flow.nc", flow);
    const auto info =
        describe_with_import_process({folder_ / "flow.nc", {}, {}, {}, tests::importer_program()});
    ASSERT_TRUE(info.has_value()) << info.error().message;
    EXPECT_EQ(info->note, "times were converted from days to seconds since 2000-01-01; "
                          "x, y, z were converted from km to m; "
                          "u, v, w were converted from km/h to m s-1");
    for (const auto& field : info->fields)
        EXPECT_EQ(field.unit, "m s-1") << field.name;
    EXPECT_EQ(info->times.back(), 4 * 86400.0);
    EXPECT_EQ(info->bounds.hi.x, 1500.0);
}

} // namespace
} // namespace wakesurf::importer::netcdf_units_test
