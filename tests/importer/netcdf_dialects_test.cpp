// NetCDF files as models write them that do not name a coordinate as its dimension: which variable has the coordinates, and of several
// velocities the one whose parts are at the same nodes.
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/open_source.hpp"
#include "tests/importer/netcdf_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace wakesurf::importer::netcdf_dialects_test {
namespace {

using namespace tests;
using core::Error;

constexpr std::size_t nx = 4, ny = 5, nz = 3;

struct Dialect {
    Names dimensions{"ni", "nj", "nk"}; ///< x, y, z
    Names coordinates{"xh", "yh", "zh"};
    std::string units = "km";
    bool axis = true;       ///< attributes
    bool staggered = false; ///< u, v, w on faces besides
    bool others = false;    ///< profiles along the same dimensions
};

class NetcdfDialects : public testing::Test {
  protected:
    std::filesystem::path write(const Dialect& dialect) const {
        const auto path = folder_ / "cm1out_000001.nc";
        NetcdfWriter out(path, NC_64BIT_OFFSET);
        const std::array<std::size_t, 3> count{nx, ny, nz};
        out.dimension("nt", NC_UNLIMITED);
        std::array<int, 3> axis{};
        for (std::size_t i = 0; i < 3; ++i) {
            out.dimension(dialect.dimensions[i], count[i]);
            out.dimension(dialect.dimensions[i] + "p1", count[i] + 1);
        }
        const int time = out.variable("time", NC_FLOAT, {"nt"});
        out.text(time, "units", "seconds since 2000-01-01 00:00:00");
        for (std::size_t i = 0; i < 3; ++i) {
            axis[i] = out.variable(dialect.coordinates[i], NC_FLOAT, {dialect.dimensions[i]});
            out.text(axis[i], "units", dialect.units);
            if (dialect.axis)
                out.text(axis[i], "axis", std::string(1, "XYZ"[i]));
            if (dialect.others)
                out.variable("profile" + std::to_string(i), NC_FLOAT, {dialect.dimensions[i]});
            if (dialect.staggered)
                out.text(
                    out.variable("f" + std::to_string(i), NC_FLOAT, {dialect.dimensions[i] + "p1"}),
                    "axis", std::string(1, "XYZ"[i]));
        }
        const auto& [x, y, z] =
            std::tie(dialect.dimensions[0], dialect.dimensions[1], dialect.dimensions[2]);
        std::array<int, 3> parts{};
        for (std::size_t c = 0; c < 3; ++c) {
            parts[c] = out.variable(std::string(1, "uvw"[c]) + "interp", NC_FLOAT, {"nt", z, y, x});
            out.text(parts[c], "units", "m/s");
            if (dialect.staggered)
                out.variable(
                    std::string(1, "uvw"[c]), NC_FLOAT,
                    {"nt", c == 2 ? z + "p1" : z, c == 1 ? y + "p1" : y, c == 0 ? x + "p1" : x});
        }
        out.end();
        for (std::size_t i = 0; i < 3; ++i) {
            std::vector<double> nodes(count[i]);
            for (std::size_t k = 0; k < nodes.size(); ++k)
                nodes[k] = 0.5 * static_cast<double>(k);
            out.put(axis[i], nodes);
        }
        out.put(time, {0, 60});
        for (std::size_t t = 0; t < 2; ++t)
            for (std::size_t c = 0; c < 3; ++c) {
                std::vector<double> values;
                for (std::size_t i = 0; i < nx * ny * nz; ++i)
                    values.push_back(value(i, c, t));
                out.put(parts[c], {t, 0, 0, 0}, {1, nz, ny, nx}, values);
            }
        return path;
    }

    static double value(std::size_t node, std::size_t c, std::size_t t) {
        return 0.25 * static_cast<double>(node) + 16.0 * static_cast<double>(c) -
               static_cast<double>(t);
    }

    void expect_flow(const Dialect& dialect, double longest) const {
        auto source = open_source(write(dialect));
        ASSERT_TRUE(source.has_value()) << source.error().message;
        EXPECT_EQ((*source)->description().times, (std::vector<double>{0, 60}));
        const auto read = (*source)->read(1, (*source)->description().fields);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        auto& block = *read->blocks.front();
        double bounds[6];
        block.GetBounds(bounds);
        EXPECT_DOUBLE_EQ(bounds[1], longest * 1.5);
        EXPECT_DOUBLE_EQ(bounds[3], longest * 2.0);
        EXPECT_DOUBLE_EQ(bounds[5], longest * 1.0);
        for (std::size_t c = 0; c < 3; ++c) {
            auto* part =
                block.GetPointData()->GetArray((std::string(1, "uvw"[c]) + "interp").c_str());
            ASSERT_NE(part, nullptr);
            for (vtkIdType i = 0; i < part->GetNumberOfTuples(); ++i)
                ASSERT_EQ(part->GetTuple1(i), value(static_cast<std::size_t>(i), c, 1));
        }
        EXPECT_EQ(choose_velocity((*source)->description().fields, {})->name,
                  "uinterp, vinterp, winterp");
    }

    TemporaryFolder folder_;
};

TEST_F(NetcdfDialects, HaveCoordinatesInVariablesOfOtherNamesThanTheDimensions) {
    expect_flow({}, 1000.0);
    expect_flow({.units = "m"}, 1.0);
    expect_flow({.axis = false}, 1000.0); // by their names
    expect_flow({.others = true}, 1000.0);
    expect_flow({.axis = false, .others = true}, 1000.0);
    expect_flow({.dimensions = {"nx", "ny", "nz"}, .coordinates = {"x", "y", "z"}}, 1000.0);
    expect_flow({.dimensions = {"x_dim", "y_dim", "z_dim"},
                 .coordinates = {"x_c", "y_c", "zu_3d"},
                 .axis = false},
                1000.0);
}

TEST_F(NetcdfDialects, WithVelocitiesOnFacesOpenByTheOneAtCommonNodes) {
    expect_flow({.staggered = true}, 1000.0);
}

TEST_F(NetcdfDialects, ThatDoNotTellWhichVariableHasTheCoordinatesAreRefused) {
    Dialect two{.coordinates = {"easting", "northing", "up"}, .axis = false};
    expect_failure(open_source(write(two)), Error::Code::Unsupported,
                   "has no variable over x, y and z");
}

} // namespace
} // namespace wakesurf::importer::netcdf_dialects_test
