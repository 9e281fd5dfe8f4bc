#include "protocol/files/slice_files.hpp"
#include "tests/support/vtp_arrays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wakesurf::protocol::slice_files_test {

namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// Two columns and two rows on x from 0 to 4 and y from 0 to 2.
NamedRaster raster(std::string name, std::vector<float> values) {
    return {std::move(name),
            {.window = {{0, 0, 1}, {4, 0, 0}, {0, 2, 0}},
             .columns = 2,
             .rows = 2,
             .values = std::move(values)}};
}

const std::vector<NamedRaster> fields{raster("p", {1, 2, none, 4}),
                                      raster("a \"b\"<c", {5, none, none, 8.5})};

} // namespace

TEST(SliceFiles, VtsHasThePlacesOfTheSamplesAndAllTheirValues) {
    const std::string file = slice_vts(fields, 2.5);
    EXPECT_EQ(tests::array_of<core::Vec3>(file, "Float64", "Points"),
              (std::vector<core::Vec3>{{1, 0.5, 1}, {3, 0.5, 1}, {1, 1.5, 1}, {3, 1.5, 1}}));
    const auto p = tests::array_of<float>(file, "Float32", "p");
    ASSERT_EQ(p.size(), 4U);
    EXPECT_EQ(p[1], 2.0F);
    EXPECT_TRUE(std::isnan(p[2]));
    EXPECT_EQ(tests::array_of<float>(file, "Float32", "a &quot;b&quot;&lt;c")[3], 8.5F);
    EXPECT_NE(file.find("WholeExtent=\"0 1 0 1 0 0\""), std::string::npos);
    EXPECT_NE(file.find(">2.5</DataArray>"), std::string::npos);
}

TEST(SliceFiles, CsvHasARowForEachSampleWithAnyValue) {
    EXPECT_EQ(slice_csv(fields), "x,y,z,\"p\",\"a \"\"b\"\"<c\"\n"
                                 "1,0.5,1,1,5\n"
                                 "3,0.5,1,2,\n"
                                 "3,1.5,1,4,8.5\n");
}

} // namespace wakesurf::protocol::slice_files_test
