#include "core/base/machine_memory.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::machine_memory_test {

namespace {

using tests::TemporaryFolder;

/// A machine with control groups of one version at /sys/fs/cgroup.
class Groups {
  public:
    /// @param group  of this process, as /proc/self/cgroup names it
    /// @param top    what of the hierarchy is mounted
    Groups(int version, const std::string& group, const std::string& top = "/")
        : version_(version) {
        std::filesystem::create_directories(folder_ / "proc/self");
        const bool first = version == 1;
        tests::write_file(folder_ / "proc/self/cgroup",
                          "12:cpu,cpuacct:/elsewhere\n" +
                              (first ? "4:memory:" + group + "\n0::/\n" : "0::" + group + "\n"));
        tests::write_file(
            folder_ / "proc/self/mountinfo",
            "31 23 0:28 / /sys/fs/cgroup rw - tmpfs tmpfs rw,mode=755\n35 31 0:32 " + top +
                (first ? " /sys/fs/cgroup/memory rw,relatime shared:1 - cgroup cgroup rw,memory\n"
                       : " /sys/fs/cgroup rw,nosuid - cgroup2 cgroup2 rw,nsdelegate\n"));
        std::filesystem::create_directories(at(""));
    }

    Groups&
    limit(const std::string& group, const std::string& value, const std::string& file = "") {
        std::filesystem::create_directories(at(group));
        tests::write_file(at(group) / (!file.empty()   ? file
                                       : version_ == 1 ? "memory.limit_in_bytes"
                                                       : "memory.max"),
                          value + "\n");
        return *this;
    }

    std::uint64_t granted() const { return granted_memory(folder_.path()); }

  private:
    std::filesystem::path at(const std::string& group) const {
        return folder_ / (version_ == 1 ? "sys/fs/cgroup/memory/" : "sys/fs/cgroup/") / group;
    }

    int version_;
    TemporaryFolder folder_;
};

constexpr std::uint64_t mebi = 1 << 20;

std::string bytes(std::uint64_t mebibytes) {
    return std::to_string(mebibytes * mebi);
}

} // namespace

TEST(GrantedMemory, IsTheMachinesWhereNoControlGroupLimitsIt) {
    EXPECT_EQ(Groups(1, "/user").limit("user", "9223372036854771712").granted(), machine_memory());
    EXPECT_EQ(Groups(2, "/user").limit("user", "max").granted(), machine_memory());
    EXPECT_EQ(Groups(2, "/user").granted(), machine_memory()) << "without the controller";
    EXPECT_EQ(granted_memory(TemporaryFolder().path()), machine_memory()) << "without /proc";
}

TEST(GrantedMemory, IsTheControlGroupsOfVersion1) {
    EXPECT_EQ(Groups(1, "/job").limit("job", bytes(5)).granted(), 5 * mebi);
}

TEST(GrantedMemory, IsTheControlGroupsOfVersion2) {
    EXPECT_EQ(Groups(2, "/job").limit("job", bytes(5)).granted(), 5 * mebi);
    EXPECT_EQ(Groups(2, "/job").limit("job", "max").limit("job", bytes(6), "memory.high").granted(),
              6 * mebi)
        << "above which everything is slow";
}

TEST(GrantedMemory, IsTheLeastOfNestedGroups) {
    EXPECT_EQ(Groups(1, "/a/b/c")
                  .limit("a", bytes(4))
                  .limit("a/b", bytes(9))
                  .limit("a/b/c", "-1")
                  .granted(),
              4 * mebi);
    EXPECT_EQ(Groups(2, "/a/b/c")
                  .limit("a", bytes(9))
                  .limit("a/b", bytes(3))
                  .limit("a/b/c", "max")
                  .granted(),
              3 * mebi);
}

TEST(GrantedMemory, IsFoundWhereAContainerSeesOnlyItsOwnGroup) {
    EXPECT_EQ(Groups(1, "/docker/4f2a", "/docker/4f2a").limit("", bytes(5)).granted(), 5 * mebi);
    EXPECT_EQ(Groups(1, "/docker/4f2a/sub", "/docker/4f2a").limit("sub", bytes(4)).granted(),
              4 * mebi);
    EXPECT_EQ(Groups(2, "/").limit("", bytes(5)).granted(), 5 * mebi);
    EXPECT_EQ(Groups(2, "/../../other").limit("", bytes(5)).granted(), 5 * mebi);
}

TEST(GrantedMemory, AGroupOfMoreThanTheMachineHasGrantsTheMachines) {
    EXPECT_EQ(Groups(2, "/job").limit("job", std::to_string(machine_memory() * 1000)).granted(),
              machine_memory());
}

TEST(GrantedMemory, OfThisVeryProcessIsSomethingAndNoMoreThanTheMachines) {
    EXPECT_GT(granted_memory(), 0U);
    EXPECT_LE(granted_memory(), machine_memory());
}

TEST(ResidentMemory, GrowsByWhatIsTouched) {
    const auto before = resident_memory();
    const std::string much(64 * mebi, 'x');
    EXPECT_GE(resident_memory(), before + 60 * mebi) << much.size();
}

} // namespace wakesurf::core::machine_memory_test
