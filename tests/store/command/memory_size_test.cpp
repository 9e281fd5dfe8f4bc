#include "store/command/memory_size.hpp"

#include <gtest/gtest.h>

namespace wakesurf::command::memory_size_test {
namespace {

TEST(MemorySize, IsReadTheWayPeopleWriteIt) {
    EXPECT_EQ(command::parse_memory_size("1073741824"), 1073741824u);
    EXPECT_EQ(command::parse_memory_size("12b"), 12u);
    EXPECT_EQ(command::parse_memory_size("1.5GiB"), 1610612736u);
    EXPECT_EQ(command::parse_memory_size("1.5 gib"), 1610612736u);
    EXPECT_EQ(command::parse_memory_size("4Gi"), std::uint64_t{4} << 30);
    EXPECT_EQ(command::parse_memory_size("800MB"), 800'000'000u);
    EXPECT_EQ(command::parse_memory_size("2k"), 2000u);
    EXPECT_EQ(command::parse_memory_size("0.25TiB"), std::uint64_t{1} << 38);
}

TEST(MemorySize, IsRefusedWhenItIsNone) {
    for (const char* text : {"", "GiB", "4XB", "4Gib2", "-1GiB", "nan", "inf", "0", "0.1b",
                             "1e30GiB", "1,5GiB", "4 G B"})
        EXPECT_EQ(command::parse_memory_size(text).error().code, core::Error::Code::InvalidArgument)
            << text;
}

} // namespace
} // namespace wakesurf::command::memory_size_test
