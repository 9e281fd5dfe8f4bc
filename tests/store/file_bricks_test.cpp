#include "store/stored_bricks.hpp"
#include "tests/support/brick_store.hpp"
#include "tests/support/read_bricks.hpp"
#include "tests/support/small_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <latch>
#include <mutex>
#include <numeric>

namespace wakesurf::store::file_bricks_test {

namespace {

using namespace core;

using namespace tests;

constexpr std::size_t brick_bytes = 5 * 5 * 5 * 12;

/// 4 x 4 x 1 bricks of 4 cells, two time-steps.
StoreValues plain_values() {
    StoreValues what{UniformGrid{{0, 0, 0}, {1, 1, 1}, {17, 17, 5}}, Precision::Single, {}, {}};
    for (int step = 0; step < 2; ++step) {
        std::vector<float> values(3 * 17 * 17 * 5);
        std::iota(values.begin(), values.end(), 10000.0F * static_cast<float>(step));
        what.values.push_back({values});
    }
    return what;
}

/// Notes what is read of velocities, and waits with it where a test wants that.
class WatchedDisk final : public Disk {
  public:
    struct Read {
        std::string file;
        std::uint64_t offset;
        std::size_t bytes;
        auto operator<=>(const Read&) const = default;
    };

    Result<std::uint64_t> size(const std::filesystem::path& file) const override {
        return disk_.size(file);
    }

    Result<FileIdentity> identity(const std::filesystem::path& file) const override {
        return disk_.identity(file);
    }

    Result<void> read(const std::filesystem::path& file,
                      std::uint64_t offset,
                      std::span<std::byte> out) const override {
        if (file.filename().string().starts_with("velocity") && file.extension() == ".f32") {
            if (gate != nullptr)
                gate->wait();
            const std::scoped_lock lock(mutex_);
            reads_.push_back({file.filename(), offset, out.size()});
        }
        return disk_.read(file, offset, out);
    }

    std::vector<Read> reads() const {
        const std::scoped_lock lock(mutex_);
        auto sorted = reads_;
        std::sort(sorted.begin(), sorted.end());
        return sorted;
    }

    std::latch* gate = nullptr;

  private:
    PosixDisk disk_;
    mutable std::mutex mutex_;
    mutable std::vector<Read> reads_;
};

/// Bricks by their place in a file.
std::vector<std::size_t> order_of(const BrickLayout& layout) {
    std::vector<std::size_t> bricks;
    for (std::size_t place = 0; place < layout.count(); ++place)
        bricks.push_back(layout.brick_on_disk(place));
    return bricks;
}

/// A store and room for its bricks.
class FileBricksTest : public testing::Test {
  protected:
    std::filesystem::path file(const std::string& name) const { return folder_ / "store" / name; }

    BrickRead brick(std::size_t step, std::size_t number) {
        return {step, number, room_.emplace_back(3 * 5 * 5 * 5)};
    }

    std::string message(std::size_t step, std::size_t number) {
        const auto outcome = outcomes_of(*open_bricks(layout_)->bricks(), {brick(step, number)})[0];
        return outcome ? "it was read" : outcome.error().message;
    }

    TemporaryFolder folder_;
    std::list<std::vector<float>> room_;
    StoreLayout layout_ = write_store(folder_ / "store", plain_values(), 4);
};

} // namespace

TEST_F(FileBricksTest, ReadsNeighboursInTheFileInOneGo) {
    const auto disk = std::make_shared<WatchedDisk>();
    const auto reader = open_bricks(layout_, disk, 1);
    const auto order = order_of(reader->bricks()->layout());
    for (const auto& outcome : outcomes_of(
             *reader->bricks(), {brick(0, order[5]), brick(0, order[2]), brick(1, order[3]),
                                 brick(0, order[4]), brick(0, order[9]), brick(0, order[4])}))
        EXPECT_TRUE(outcome);
    using Read = WatchedDisk::Read;
    EXPECT_EQ(disk->reads(), (std::vector<Read>{
                                 {"velocity_000000.f32", 2 * brick_bytes, brick_bytes},
                                 {"velocity_000000.f32", 4 * brick_bytes, brick_bytes},
                                 {"velocity_000000.f32", 4 * brick_bytes, 2 * brick_bytes},
                                 {"velocity_000000.f32", 9 * brick_bytes, brick_bytes},
                                 {"velocity_000001.f32", 3 * brick_bytes, brick_bytes},
                             }));
}

TEST_F(FileBricksTest, LeavesEveryThreadSomethingToRead) {
    const auto disk = std::make_shared<WatchedDisk>();
    const auto reader = open_bricks(layout_, disk, 4);
    const auto order = order_of(reader->bricks()->layout());
    std::vector<BrickRead> reads;
    for (const auto number : order)
        reads.push_back(brick(0, number));
    outcomes_of(*reader->bricks(), reads);
    ASSERT_EQ(disk->reads().size(), 4u);
    for (const auto& read : disk->reads())
        EXPECT_EQ(read.bytes, 4 * brick_bytes);
}

TEST_F(FileBricksTest, NamesTheBrickThatIsDamagedAndReadsItsNeighbours) {
    const auto order = order_of(layout_.bricks());
    flip_bit(file("velocity_000001.f32"), 8 * (3 * brick_bytes + 100) + 3);
    const auto outcomes =
        outcomes_of(*open_bricks(layout_, std::make_shared<PosixDisk>(), 1)->bricks(),
                    {brick(1, order[2]), brick(1, order[3]), brick(1, order[4])});
    EXPECT_TRUE(outcomes[0]);
    ASSERT_FALSE(outcomes[1]);
    EXPECT_EQ(outcomes[1].error().code, Error::Code::Corrupt);
    EXPECT_EQ(outcomes[1].error().message,
              "brick " + std::to_string(order[3]) +
                  " of time-step 1 (velocity_000001.f32): it has changed since it was written: its "
                  "checksum differs");
    EXPECT_TRUE(outcomes[2]);
    EXPECT_EQ(open_bricks(layout_)->load(1, {}).error().message, outcomes[1].error().message);
    EXPECT_TRUE(open_bricks(layout_)->load(0, {}));
}

TEST_F(FileBricksTest, ChecksABrickAgainWhenItsFileIsAnotherOneThanItWas) {
    const auto reader = open_bricks(layout_);
    const auto read = [&] { return outcomes_of(*reader->bricks(), {brick(0, 0)})[0]; };
    EXPECT_TRUE(read());
    EXPECT_TRUE(read());
    const std::string values = read_file(file("velocity_000000.f32"));
    flip_bit(file("velocity_000000.f32"), 1000);
    EXPECT_EQ(read().error().code, Error::Code::Corrupt);
    std::filesystem::remove(file("velocity_000000.f32"));
    EXPECT_EQ(read().error().message, "brick 0 of time-step 0 (velocity_000000.f32): cannot read "
                                      "velocity_000000.f32: No such file or directory");
    write_file(file("velocity_000000.f32"), values);
    EXPECT_TRUE(read());
}

TEST_F(FileBricksTest, SaysWhatIsWrongWithTheFiles) {
    const auto values = read_file(file("velocity_000000.f32"));
    const auto sums = read_file(file("velocity_000000.bricks"));
    const std::string begin = "brick 7 of time-step 0 (velocity_000000.f32): ";
    write_file(file("velocity_000000.f32"), values.substr(0, values.size() - 1));
    EXPECT_EQ(message(0, 7), begin + "velocity_000000.f32 has 23999 bytes instead of 24000");
    EXPECT_EQ(open_bricks(layout_)->load(0, {}).error().message,
              "time-step 0 (velocity_000000.f32) has 23999 bytes instead of 24000");
    std::filesystem::remove(file("velocity_000000.f32"));
    EXPECT_EQ(message(0, 7), begin + "cannot read velocity_000000.f32: No such file or directory");
    EXPECT_FALSE(open_bricks(layout_)->whole(0));
    write_file(file("velocity_000000.f32"), values);
    for (const std::string& wrong : {sums.substr(1), sums + "x", std::string()}) {
        write_file(file("velocity_000000.bricks"), wrong);
        EXPECT_EQ(message(0, 7), begin + "velocity_000000.bricks has " +
                                     std::to_string(wrong.size()) + " bytes instead of 80");
        EXPECT_FALSE(open_bricks(layout_)->whole(0));
        EXPECT_FALSE(open_bricks(layout_)->load(0, {}));
    }
    for (std::size_t bit = 0; bit < 8 * sums.size(); bit += 37) {
        write_file(file("velocity_000000.bricks"), sums);
        flip_bit(file("velocity_000000.bricks"), bit);
        EXPECT_EQ(message(0, 7), begin + "velocity_000000.bricks has changed since it was written: "
                                         "its checksum differs");
    }
    // Of another store, or of another time-step of this one.
    write_file(file("velocity_000000.bricks"), read_file(file("velocity_000001.bricks")));
    EXPECT_EQ(message(0, 7), begin + "velocity_000000.bricks has changed since it was written: its "
                                     "checksum differs");
    EXPECT_TRUE(open_bricks(layout_)->bricks()->gaps(0)) << "who cannot tell expects them";
    std::filesystem::remove(file("velocity_000000.bricks"));
    EXPECT_EQ(message(0, 7),
              begin + "cannot read velocity_000000.bricks: No such file or directory");
    write_file(file("velocity_000000.bricks"), sums);
    EXPECT_EQ(message(0, 7), "it was read");
    EXPECT_FALSE(open_bricks(layout_)->bricks()->gaps(0));
}

TEST_F(FileBricksTest, RefusesWhatThereIsNot) {
    const auto reader = open_bricks(layout_);
    const auto outcomes =
        outcomes_of(*reader->bricks(), {brick(2, 0), brick(0, 16), {0, 1, {}}, {0, 1, {}, 1}});
    EXPECT_EQ(outcomes[0].error().message, "there is no brick 0 of time-step 2");
    EXPECT_EQ(outcomes[1].error().message, "there is no brick 16 of time-step 0");
    EXPECT_EQ(outcomes[2].error().code, Error::Code::InvalidArgument);
    EXPECT_EQ(outcomes[3].error().code, Error::Code::NotFound) << "no such field";
}

TEST_F(FileBricksTest, WaitsForATimeStepThatIsBeingWritten) {
    const std::string checksums = read_file(file("checksums.u32"));
    write_file(file("checksums.u32"), checksums.substr(0, 4));
    const auto reader = open_bricks(layout_);
    const auto early = outcomes_of(*reader->bricks(), {brick(1, 0)})[0];
    EXPECT_EQ(early.error().code, Error::Code::NotFound);
    EXPECT_EQ(early.error().message,
              "brick 0 of time-step 1 (velocity_000001.f32): it is not in the store");
    write_file(file("checksums.u32"), checksums);
    EXPECT_TRUE(outcomes_of(*reader->bricks(), {brick(1, 0)})[0]);
}

TEST_F(FileBricksTest, NeverTakesTheBricksOfAStoreThatReplacedThisOneForItsOwn) {
    const auto reader = open_bricks(layout_);
    EXPECT_TRUE(outcomes_of(*reader->bricks(), {brick(0, 3)})[0]);
    auto other = plain_values();
    for (auto& step : other.values)
        step[0][1000] += 1.0F;
    std::filesystem::remove_all(folder_ / "store");
    write_store(folder_ / "store", other, 4);
    std::size_t refused = 0;
    for (std::size_t number = 0; number < 16; ++number)
        for (std::size_t step = 0; step < 2; ++step) {
            const auto outcome = outcomes_of(*reader->bricks(), {brick(step, number)})[0];
            if (outcome)
                continue; // the very same bytes
            EXPECT_NE(outcome.error().message.find("was replaced while in use"), std::string::npos)
                << outcome.error().message;
            ++refused;
        }
    EXPECT_GE(refused, 2u);
}

TEST_F(FileBricksTest, EndsReadsThatHaveNotBegunWhenTheyAreStopped) {
    std::latch open(1);
    const auto disk = std::make_shared<WatchedDisk>();
    disk->gate = &open;
    const auto reader = open_bricks(layout_, disk, 1);
    const auto order = order_of(reader->bricks()->layout());
    std::stop_source stop;
    std::latch done(3);
    std::vector<Result<void>> outcomes(3);
    reader->bricks()->read({brick(0, order[0]), brick(0, order[5]), brick(0, order[10])},
                           stop.get_token(), [&](std::size_t i, Result<void> outcome) {
                               outcomes[i] = std::move(outcome);
                               done.count_down();
                           });
    stop.request_stop();
    open.count_down();
    done.wait();
    EXPECT_EQ(outcomes[2].error().code, Error::Code::Cancelled);
    EXPECT_EQ(outcomes[2].error().message, "reading brick " + std::to_string(order[10]) +
                                               " of time-step 0 (velocity_000000.f32) was "
                                               "cancelled");
    EXPECT_TRUE(outcomes_of(*reader->bricks(), {brick(0, 0)})[0]) << "it goes on for others";
}

TEST_F(FileBricksTest, WaitsForAllReadsWhenItGoes) {
    std::atomic<int> told{0};
    {
        const auto reader = open_bricks(layout_, std::make_shared<PosixDisk>(), 2);
        std::vector<BrickRead> reads;
        for (std::size_t number = 0; number < 16; ++number)
            reads.push_back(brick(number % 2, number));
        reader->bricks()->read(reads, {}, [&](std::size_t, const Result<void>&) { ++told; });
    }
    EXPECT_EQ(told, 16);
}

} // namespace wakesurf::store::file_bricks_test
