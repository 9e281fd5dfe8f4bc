// Planes and boxes on the command line.
#include "server/data/region_text.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::region_text_test {

namespace {

std::string refusal(const std::string& text) {
    const auto region = parse_region(text, "--through");
    return region ? "" : region.error().message;
}

} // namespace

TEST(RegionText, ReadsAPlaneWhoseNormalHasAnyLength) {
    for (const char* normal : {"0,0,1", "0,0,1e-300", "0,0,1e300"}) {
        const auto plane = std::get<core::Plane>(
            value_of(parse_region(std::string("plane:1,2,3:") + normal, "--through")));
        EXPECT_EQ(plane.point, core::Vec3(1, 2, 3));
        EXPECT_EQ(plane.height({7, 7, 5}), 2.0) << normal;
    }
}

TEST(RegionText, ReadsABoxFromAnyTwoCorners) {
    const auto box = std::get<core::Box>(value_of(parse_region("box:1,-2,3:0,5,-1", "--through")));
    EXPECT_EQ(box.lo, core::Vec3(0, -2, -1));
    EXPECT_EQ(box.hi, core::Vec3(1, 5, 3));
}

TEST(RegionText, RefusesWhatIsNeither) {
    for (const char* text :
         {"", "plane", "plane:", "plane:0,0,0", "ball:0,0,0:1,1,1", "box:0,0:1,1,1",
          "box:0,0,0:1,1,1:2,2,2", "plane:0,0,nan:1,0,0", "plane:0,0,0:0,0,0", "box:0,0,0:1,1,0"})
        EXPECT_TRUE(refusal(text).starts_with("--through: ")) << text;
}

} // namespace wakesurf::server::region_text_test
