// Headers of NetCDF files that the netCDF library takes as they are: what it would write beyond its callers' memory, or count for years.
#include "importer/sources/open_source.hpp"
#include "tests/importer/netcdf_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace wakesurf::importer::netcdf_header_test {
namespace {

using namespace tests;
using core::Error;

class NetcdfHeader : public testing::Test {
  protected:
    std::filesystem::path put(const std::string& bytes) const {
        write_file(folder_ / "flow.nc", bytes);
        return folder_ / "flow.nc";
    }

    std::filesystem::path write(const Flow& flow) const {
        write_flow(folder_ / "flow.nc", flow);
        return folder_ / "flow.nc";
    }

    TemporaryFolder folder_;
};

TEST_F(NetcdfHeader, WithALongerNameThanTheFormatHasIsRefused) {
    expect_failure(open_source(put(file_with_name(NC_MAX_NAME))), Error::Code::Unsupported,
                   "has no variable over x, y and z");
    for (const std::size_t bytes : {NC_MAX_NAME + 1, 400, 100'000})
        expect_failure(open_source(put(file_with_name(bytes))), Error::Code::Corrupt,
                       "its header is damaged");
}

TEST_F(NetcdfHeader, ThatLeavesTheNumberOfTimeStepsOpenIsRefused) {
    for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA}) {
        Flow flow;
        flow.format = format;
        std::string bytes = read_file(write(flow));
        const std::size_t width = format == NC_64BIT_DATA ? 8 : 4;
        bytes.replace(4, width, std::string(width, '\xff'));
        expect_failure(open_source(put(bytes)), Error::Code::Unsupported,
                       "flow.nc does not say how many time-steps it has");
    }
}

TEST_F(NetcdfHeader, WhoseUnitMakesCoordinatesInfiniteOrEqualIsRefused) {
    for (const char* const unit : {"1e308 m", "1e-300 m"}) {
        Flow flow;
        flow.axes["x"] = {0, 1e-30, 10};
        flow.units["x"] = unit;
        expect_failure(open_source(write(flow)), Error::Code::Corrupt,
                       std::string("when they are converted from ") + unit);
    }
}

} // namespace
} // namespace wakesurf::importer::netcdf_header_test
