// Which variables of a NetCDF file are the velocity, which way its components point, and the time of a file without a time axis.
#include "importer/fields/field_choice.hpp"
#include "importer/sources/open_source.hpp"
#include "tests/importer/netcdf_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace wakesurf::importer::netcdf_velocity_test {
namespace {

using namespace tests;
using core::Error;

struct Written {
    std::string name;
    std::string standard{};
    double value = 1.0;
    std::string units = "m s-1";
    std::string long_name{};
    Names dimensions{"z", "y", "x"};
};

struct Contents {
    std::vector<Written> variables;
    std::map<std::string, std::map<std::string, std::string>> axes{}; ///< attributes of x, y, z
    std::string z = "z";
    std::function<void(NetcdfWriter&)> more{};
    std::vector<double> heights{0, 1, 2};
};

class NetcdfVelocity : public testing::Test {
  protected:
    core::Result<std::unique_ptr<Source>> open(const Contents& contents,
                                               const std::string& wish = {}) const {
        {
            NetcdfWriter out(folder_ / "f.nc");
            std::map<std::string, int> axes;
            for (const auto& axis : {std::string("x"), std::string("y"), contents.z}) {
                out.dimension(axis, 3);
                axes[axis] = out.variable(axis, NC_DOUBLE, {axis});
                const auto stated = contents.axes.find(axis);
                if (stated != contents.axes.end())
                    for (const auto& [name, value] : stated->second)
                        out.text(axes[axis], name.c_str(), value);
            }
            out.dimension("component", 3);
            out.dimension("member", 3);
            out.dimension("xu", 4);
            if (contents.more)
                contents.more(out);
            std::vector<int> ids;
            for (const auto& each : contents.variables) {
                Names dimensions = each.dimensions;
                for (auto& dimension : dimensions)
                    dimension = dimension == "z" ? contents.z : dimension;
                ids.push_back(out.variable(each.name, NC_DOUBLE, dimensions));
                for (const auto& [name, value] : {std::pair{"standard_name", each.standard},
                                                  {"units", each.units},
                                                  {"long_name", each.long_name}})
                    if (!value.empty())
                        out.text(ids.back(), name, value);
            }
            out.end();
            for (const auto& [name, id] : axes)
                out.put(id, name == contents.z ? contents.heights : std::vector<double>{0, 1, 2});
            for (std::size_t i = 0; i < ids.size(); ++i) {
                const auto& dimensions = contents.variables[i].dimensions;
                std::vector<std::size_t> count;
                std::size_t total = 1;
                for (const auto& dimension : dimensions) {
                    count.push_back(dimension == "xu" ? 4 : 3);
                    total *= count.back();
                }
                std::vector<double> values(total, contents.variables[i].value);
                if (count.size() == 4) // the components apart
                    for (std::size_t v = 0; v < total; ++v)
                        values[v] += static_cast<double>(dimensions[0] == "z" ? v % 3 : v / 27);
                out.put(ids[i], std::vector<std::size_t>(count.size(), 0), count, values);
            }
        }
        return open_source(folder_ / "f.nc", {.velocity = wish});
    }

    // "a, b, c", or the words of the refusal.
    static std::string chosen(const core::Result<std::unique_ptr<Source>>& source,
                              const std::string& wish = {}) {
        if (!source)
            return source.error().message;
        const auto& description = (*source)->description();
        const auto choice =
            choose_fields(description.fields, {{}, wish, {}, description.velocities});
        return choice ? choice->velocity_name : choice.error().message;
    }

    // The value of a field at the first node.
    static double first_of(Source& source, const std::string& name, int component = 0) {
        const auto read = source.read(0, source.description().fields);
        return read->blocks[0]->GetPointData()->GetArray(name.c_str())->GetComponent(0, component);
    }

    TemporaryFolder folder_;
};

TEST_F(NetcdfVelocity, IsWhatStandardNamesSayWhateverTheVariablesAreCalled) {
    for (const auto& names : std::vector<std::array<std::string, 3>>{
             {"eastward_sea_water_velocity", "northward_sea_water_velocity",
              "upward_sea_water_velocity"},
             {"eastward_wind", "northward_wind", "upward_air_velocity"},
             {"x_wind", "y_wind", "upward_air_velocity"},
             {"sea_water_x_velocity", "sea_water_y_velocity", "upward_sea_water_velocity"},
             {"grid_eastward_wind", "grid_northward_wind", "upward_air_velocity"},
             {"X_wind", "Y_wind", "Upward_air_velocity"},
             {" x_wind", "y_wind ", "upward_air_velocity "},
             {"eastward_wind", "northward_wind", "downward_air_velocity"}}) {
        const auto source =
            open({{{"var120", names[2]}, {"var131", names[0]}, {"T"}, {"var132", names[1]}}});
        EXPECT_EQ(chosen(source), "var131, var132, var120") << names[0];
    }
    const auto crossed =
        open({{{"u", "northward_wind"}, {"v", "eastward_wind"}, {"w", "upward_air_velocity"}}});
    EXPECT_EQ(chosen(crossed), "v, u, w");
}

TEST_F(NetcdfVelocity, IsAskedForWhereTheFileHasTwo) {
    const Contents two{{{"uo", "sea_water_x_velocity"},
                        {"vo", "sea_water_y_velocity"},
                        {"wo", "upward_sea_water_velocity"},
                        {"ua", "x_wind"},
                        {"va", "y_wind"},
                        {"wa", "upward_air_velocity"}}};
    EXPECT_EQ(chosen(open(two)), "several fields could be the velocity: ua, va, wa or uo, vo, wo");
    EXPECT_EQ(chosen(open(two, "uo,vo,wo"), "uo,vo,wo"), "uo, vo, wo");
    const Contents named{
        {{"u"}, {"v"}, {"w"}, {"ua", "x_wind"}, {"va", "y_wind"}, {"wa", "upward_air_velocity"}}};
    EXPECT_EQ(chosen(open(named)), "several fields could be the velocity: ua, va, wa or u, v, w");
    const Contents twice{{{"u1", "x_wind"},
                          {"u2", "x_wind"},
                          {"v1", "y_wind"},
                          {"v2", "y_wind"},
                          {"w", "upward_air_velocity"}}};
    EXPECT_EQ(chosen(open(twice)), "several fields could be the velocity: u1, v1, w or u2, v2, w");
}

TEST_F(NetcdfVelocity, IsAlongTheAxesWhereTheFileHasTheOneByTheCompassToo) {
    const auto source = open({{{"e", "eastward_wind"},
                               {"n", "northward_wind"},
                               {"i", "x_wind"},
                               {"j", "y_wind"},
                               {"up", "upward_air_velocity"}}});
    EXPECT_EQ(chosen(source), "i, j, up");
}

TEST_F(NetcdfVelocity, IsNoPartOfOneNorOneOfSomethingElse) {
    const auto part = open({{{"a", "eastward_sea_water_velocity_due_to_tides"},
                             {"b", "northward_sea_water_velocity_due_to_tides"},
                             {"c", "upward_sea_water_velocity"}}});
    EXPECT_NE(chosen(part).find("there is no vector field"), std::string::npos) << chosen(part);
    for (const char* const name : {"w", "wap"})
        for (const std::string wish : {std::string(), std::string("u,v,") + name}) {
            const auto omega = open({{{"u", "eastward_wind"},
                                      {"v", "northward_wind"},
                                      {name, "lagrangian_tendency_of_air_pressure"}}},
                                    wish);
            expect_failure(omega, Error::Code::Unsupported,
                           std::string("f.nc has no vertical velocity: ") + name +
                               " is a rate of change (lagrangian_tendency_of_air_pressure)");
        }
    expect_failure(open({{{"u"}, {"v"}, {"w", "", 1.0, "Pa/s"}}}), Error::Code::Unsupported,
                   "f.nc has no vertical velocity: w is a rate of change (Pa/s)");
    const auto beside = open({{{"u", "eastward_wind"},
                               {"v", "northward_wind"},
                               {"w", "upward_air_velocity"},
                               {"wap", "lagrangian_tendency_of_air_pressure", 1.0, "Pa s-1"}}});
    EXPECT_EQ(chosen(beside), "u, v, w");
}

TEST_F(NetcdfVelocity, ThatPointsDownChangesItsSignAndADepthBecomesAHeight) {
    const std::map<std::string, std::map<std::string, std::string>> down{
        {"z", {{"positive", "down"}, {"axis", "Z"}}}};
    const auto expect = [&](const Written& w, double value, bool depth) {
        const auto source = open({{{"u"}, {"v"}, w}, depth ? down : decltype(down)()});
        ASSERT_TRUE(source.has_value()) << source.error().message;
        EXPECT_EQ(first_of(**source, "w"), value) << w.standard << w.long_name << depth;
        const auto& note = (*source)->description().note;
        EXPECT_EQ(note.find("w is stated to point the other way") != std::string::npos,
                  value != 0.5);
        const auto read = (*source)->read(0, {});
        EXPECT_EQ(read->blocks[0]->GetBounds()[5], depth ? 0.0 : 2.0);
    };
    for (const bool depth : {true, false}) {
        expect({"w", "downward_sea_water_velocity", 0.5}, -0.5, depth);
        expect({"w", "downward_air_velocity", 0.5}, -0.5, depth);
        expect({"w", "", 0.5, "m s-1", "Downward velocity"}, -0.5, depth);
        expect({"w", "upward_sea_water_velocity", 0.5}, 0.5, depth);
        expect({"w", "", 0.5}, 0.5, depth);
        expect({"w", "", 0.5, "W m-2", "downward flux"}, 0.5, depth);
        expect({"w", "sea_water_z_velocity", 0.5}, depth ? -0.5 : 0.5, depth);
    }
}

TEST_F(NetcdfVelocity, OfADepthThatDoesNotSayWhichWayIsStillADepth) {
    const auto bounds = [&](const Contents& contents) {
        const auto source = open(contents);
        const auto read = (*source)->read(0, {});
        const bool said =
            (*source)->description().note.find("taken as positive down") != std::string::npos;
        return std::pair(read->blocks[0]->GetBounds()[5], said);
    };
    const std::vector<Written> flow{{"u"}, {"v"}, {"w"}};
    EXPECT_EQ(bounds({flow, {}, "depth"}), (std::pair{0.0, true}));
    EXPECT_EQ(bounds({flow, {{"z", {{"standard_name", "depth"}}}}}), (std::pair{0.0, true}));
    EXPECT_EQ(bounds({flow, {{"depth", {{"positive", "up"}}}}, "depth"}), (std::pair{2.0, false}));
    EXPECT_EQ(bounds({flow, {}, "depth", {}, {-2, -1, 0}}), (std::pair{0.0, false}));
    EXPECT_EQ(bounds({flow, {}, "height"}), (std::pair{2.0, false}));
}

TEST_F(NetcdfVelocity, OfOneArrayHasItsComponentsAlongAnAxis) {
    for (const Names& order :
         {Names{"component", "z", "y", "x"}, Names{"z", "y", "x", "component"}}) {
        const auto source = open({{{"flow_field", "", 1.0, "m s-1", "", order}}});
        ASSERT_TRUE(source.has_value()) << source.error().message;
        EXPECT_EQ(chosen(source), "flow_field");
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(first_of(**source, "flow_field", c), 1.0 + c);
        EXPECT_NE((*source)->description().note.find(
                      "the three values of flow_field along component are taken as x, y and z"),
                  std::string::npos);
    }
    const Names runs{"member", "z", "y", "x"};
    EXPECT_EQ(chosen(open({{{"velocity", "", 1.0, "m s-1", "", runs}}})), "velocity");
    // Three runs of u are no vector.
    const auto three = open({{{"u", "", 1.0, "m s-1", "", runs},
                              {"v", "", 1.0, "m s-1", "", runs},
                              {"w", "", 1.0, "m s-1", "", runs}}});
    expect_failure(three, Error::Code::Unsupported,
                   "has no variable over x, y and z alone: w is over member, z, y and x");
    EXPECT_TRUE(three.error().hint.starts_with("if member has the components"));
}

TEST_F(NetcdfVelocity, OnFacesIsSaidToBeStaggeredWhateverItIsCalled) {
    const auto xu = [](NetcdfWriter& out) {
        out.text(out.variable("xu", NC_DOUBLE, {"xu"}), "axis", "X");
    };
    const Names faces{"z", "y", "xu"};
    for (const auto& [u, v, w] : std::vector<std::array<std::string, 3>>{
             {"u", "v", "w"}, {"uvel", "vvel", "wvel"}, {"U", "V", "W"}})
        expect_failure(open({{{u, "", 1.0, "m s-1", "", faces}, {v}, {w}}, {}, "z", xu}),
                       Error::Code::Unsupported,
                       "f.nc has a staggered grid: " + u + ", " + v + " and " + w +
                           " are on different");
    expect_failure(open({{{"a", "x_wind", 1.0, "m s-1", "", faces},
                          {"b", "y_wind"},
                          {"c", "upward_air_velocity"}},
                         {},
                         "z",
                         xu}),
                   Error::Code::Unsupported, "f.nc has a staggered grid: a, b and c");
}

// Writes u, v, w into groups; the coordinates stay with the file.
void write_groups(const std::filesystem::path& path, const Names& groups) {
    int id = 0;
    NetcdfWriter::ok(nc_create(path.c_str(), NC_CLOBBER | NC_NETCDF4, &id));
    std::array<int, 3> dimensions{};
    for (std::size_t i = 0; i < 3; ++i)
        nc_def_dim(id, std::string(1, "zyx"[i]).c_str(), 3, &dimensions.at(i));
    double value = 0.0;
    for (const auto& name : groups) {
        int group = 0;
        NetcdfWriter::ok(nc_def_grp(id, name.c_str(), &group));
        for (const char* const part : {"u", "v", "w"}) {
            int variable = 0;
            NetcdfWriter::ok(nc_def_var(group, part, NC_DOUBLE, 3, dimensions.data(), &variable));
            const std::vector<double> values(27, ++value);
            NetcdfWriter::ok(nc_put_var_double(group, variable, values.data()));
        }
    }
    NetcdfWriter::ok(nc_close(id));
}

TEST_F(NetcdfVelocity, InAGroupIsReadAndOfSeveralGroupsAskedFor) {
    write_groups(folder_ / "g.nc", {"flow"});
    const auto one = open_source(folder_ / "g.nc");
    EXPECT_EQ(chosen(one), "u, v, w");
    EXPECT_EQ(first_of(**one, "w"), 3.0);
    write_groups(folder_ / "g.nc", {"flow", "mean"});
    const auto two = open_source(folder_ / "g.nc");
    EXPECT_NE(chosen(two).find("flow/u (1 component, point)"), std::string::npos) << chosen(two);
    const std::string wish = "mean/u,mean/v,mean/w";
    const auto mean = open_source(folder_ / "g.nc", {.velocity = wish});
    EXPECT_EQ(chosen(mean, wish), "mean/u, mean/v, mean/w");
    EXPECT_EQ(first_of(**mean, "mean/w"), 6.0);
}

TEST_F(NetcdfVelocity, InAGroupWithinAGroupHasTheAxesAndTimesOfThatGroup) {
    int id = 0;
    int outer = 0;
    int inner = 0;
    NetcdfWriter::ok(nc_create((folder_ / "g.nc").c_str(), NC_CLOBBER | NC_NETCDF4, &id));
    NetcdfWriter::ok(nc_def_grp(id, "results", &outer));
    NetcdfWriter::ok(nc_def_grp(outer, "fine", &inner));
    for (const int group : {outer, inner}) { // the outer one has a coarser grid of the same names
        std::array<int, 4> dimensions{};
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t length = i == 0 ? 2 : group == outer ? 3 : 4;
            const std::string name = i == 0 ? "time" : std::string(1, "tzyx"[i]);
            int axis = 0;
            NetcdfWriter::ok(nc_def_dim(group, name.c_str(), length, &dimensions.at(i)));
            NetcdfWriter::ok(
                nc_def_var(group, name.c_str(), NC_DOUBLE, 1, &dimensions.at(i), &axis));
            std::vector<double> nodes;
            for (std::size_t n = 0; n < length; ++n)
                nodes.push_back(group == outer ? 7.0 + static_cast<double>(n)
                                               : 0.5 * static_cast<double>(n));
            NetcdfWriter::ok(nc_put_var_double(group, axis, nodes.data()));
        }
        int variable = 0;
        for (const char* const name : {"u", "v", "w"})
            NetcdfWriter::ok(
                nc_def_var(group, group == outer ? (std::string("mean_") + name).c_str() : name,
                           NC_DOUBLE, 4, dimensions.data(), &variable));
    }
    NetcdfWriter::ok(nc_close(id));
    const auto source = open_source(folder_ / "g.nc");
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ(chosen(source), "u, v, w");
    EXPECT_EQ((*source)->description().times, (std::vector<double>{0, 0.5}));
    const auto read = (*source)->read(1, {});
    EXPECT_EQ(read->blocks[0]->GetBounds()[5], 1.5);
}

TEST_F(NetcdfVelocity, OfFilesOfOneTimeEachHasTheTimesThatTheyState) {
    for (const auto& [name, dimensions, attribute, value] :
         std::vector<std::tuple<std::string, Names, std::string, std::string>>{
             {"time", {}, "units", "seconds"},
             {"time", {"one"}, "units", "seconds"},
             {"t", {}, "long_name", "time"},
             {"valid", {}, "standard_name", "time"},
             {"now", {"one"}, "units", "seconds since 2020-01-01"},
             {"clock", {}, "axis", "T"},
             {"since_start", {}, "units", "s"}}) {
        const auto write = [&](const std::string& file, double time, bool with_time) {
            NetcdfWriter out(folder_ / file);
            for (const char* axis : {"z", "y", "x"})
                out.dimension(axis, 3);
            out.dimension("one", 1);
            const int stated = with_time ? out.variable(name, NC_DOUBLE, dimensions) : 0;
            if (with_time)
                out.text(stated, attribute.c_str(), value);
            const int start = out.variable("forecast", NC_DOUBLE, {"one"});
            out.text(start, "standard_name", "forecast_reference_time");
            out.text(start, "units", "hours since 2020-01-01");
            for (const char* part : {"u", "v", "w"})
                out.text(out.variable(part, NC_DOUBLE, {"z", "y", "x"}), "coordinates",
                         "forecast since_start");
            out.end();
            if (with_time)
                out.put(stated, std::vector<std::size_t>(dimensions.size(), 0),
                        std::vector<std::size_t>(dimensions.size(), 1), {time});
        };
        write("o_0.nc", 7.5, true);
        write("o_1.nc", 8.0, true);
        write("o_3.nc", 9.0, true);
        const auto source = open_source(folder_ / "o_0.nc");
        ASSERT_TRUE(source.has_value()) << name << ": " << source.error().message;
        EXPECT_EQ((*source)->description().times, (std::vector<double>{7.5, 8, 9})) << name;
        EXPECT_EQ((*source)->description().time_note, "");
        for (const char* file : {"o_0.nc", "o_1.nc", "o_3.nc"})
            write(file, 0.0, false);
        const auto none = open_source(folder_ / "o_0.nc");
        EXPECT_EQ((*none)->description().places, (std::vector<double>{0, 1, 3}));
        EXPECT_NE((*none)->description().time_note.find("carry no times"), std::string::npos);
    }
}

TEST_F(NetcdfVelocity, OfFilesWithoutATimeCoordinateHasTheirDatesOrAttributes) {
    enum class Kind { Number, Date, Text };
    for (const Kind kind : {Kind::Number, Kind::Date, Kind::Text}) {
        for (const int number : {3, 4}) {
            NetcdfWriter out(folder_ / ("o_" + std::to_string(number) + ".nc"));
            for (const char* axis : {"z", "y", "x"})
                out.dimension(axis, 3);
            out.dimension("one", 1);
            out.dimension("length", 19);
            const std::string date = "2020-01-01_00:00:0" + std::to_string(number);
            for (const char* part : {"u", "v", "w"})
                out.variable(part, NC_DOUBLE, {"z", "y", "x"});
            const int times = out.variable("Times", NC_CHAR, {"one", "length"});
            if (kind == Kind::Number)
                out.number(NC_GLOBAL, "time", NC_DOUBLE, 0.25 * number);
            if (kind == Kind::Date)
                out.text(NC_GLOBAL, "time_coverage_start",
                         "2020-01-01T00:00:0" + std::to_string(number) + "Z");
            out.end();
            if (kind == Kind::Text)
                out.text_values(times, date);
        }
        const auto source = open_source(folder_ / "o_3.nc");
        ASSERT_TRUE(source.has_value()) << source.error().message;
        const auto& [times, note] =
            std::tie((*source)->description().times, (*source)->description().note);
        EXPECT_EQ(times, kind == Kind::Number ? (std::vector<double>{0.75, 1})
                                              : (std::vector<double>{0, 1}));
        EXPECT_NE(note.find(kind == Kind::Number ? "times are the attribute time"
                            : kind == Kind::Date ? "times are seconds since 2020-01-01 00:00:03, "
                                                   "from the dates in time_coverage_start"
                                                 : "from the dates in Times"),
                  std::string::npos)
            << note;
    }
}

TEST_F(NetcdfVelocity, OfAnotherMeshThanAGridIsRefusedWithTheReason) {
    const auto expect = [&](const std::function<void(NetcdfWriter&)>& more, const char* words) {
        const auto source = open({{}, {}, "z", more});
        expect_failure(source, Error::Code::Unsupported, words);
    };
    expect(
        [](NetcdfWriter& out) {
            out.dimension("faces", 4);
            out.dimension("layers", 5);
            out.text(out.variable("mesh2d", NC_INT, {}), "cf_role", "mesh_topology");
            out.variable("ucx", NC_DOUBLE, {"z", "faces", "layers"});
        },
        "f.nc has an unstructured mesh (UGRID: mesh2d)");
    expect(
        [](NetcdfWriter& out) {
            for (const char* name : {"west_east", "west_east_stag", "south_north", "bottom_top"})
                out.dimension(name, 4);
            for (const char* name : {"PH", "PHB", "V"})
                out.variable(name, NC_FLOAT, {"bottom_top", "south_north", "west_east"});
            out.text(out.variable("U", NC_FLOAT, {"bottom_top", "south_north", "west_east_stag"}),
                     "coordinates", "XLONG_U XLAT_U XTIME");
        },
        "f.nc is a WRF file: U, V and W are on the faces of its cells, and the heights");
}

} // namespace
} // namespace wakesurf::importer::netcdf_velocity_test
