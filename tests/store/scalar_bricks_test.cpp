// Scalars that come brick by brick beside the velocity: the same bits as from whole time-steps, within the bricks' memory.
#include "core/dataset/brick_cache.hpp"
#include "core/field/sample_scalar.hpp"
#include "core/field/stored_flow.hpp"
#include "tests/support/brick_store.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

namespace wakesurf::store::scalar_bricks_test {

namespace {

using namespace core;

constexpr std::array<std::uint32_t, 3> nodes{70, 41, 37};

/// A velocity and two scalars of noise, with values that are no numbers, on a grid with a solid ball.
tests::StoreValues noise(Grid grid, Precision precision) {
    tests::StoreValues what;
    what.grid = std::move(grid);
    what.precision = precision;
    const std::size_t count = std::size_t{nodes[0]} * nodes[1] * nodes[2];
    std::mt19937 random(7);
    std::uniform_real_distribution<float> number(-1.0F, 1.0F);
    what.values.resize(3);
    for (auto& step : what.values)
        for (const std::size_t components : {3u, 1u, 1u}) {
            std::vector<float> values(count * components);
            for (float& value : values)
                value = number(random);
            if (components == 1)
                for (std::size_t i = 0; i < count; i += 997)
                    values[i] = std::numeric_limits<float>::quiet_NaN();
            step.push_back(std::move(values));
        }
    for (std::size_t node = 0; node < count; ++node) {
        const Vec3 at(node % nodes[0], node / nodes[0] % nodes[1], node / nodes[0] / nodes[1]);
        what.fluid.push_back(glm::length(at - Vec3(31, 20, 18)) < 6.0 ? 0 : 1);
    }
    return what;
}

Grid uniform() {
    return UniformGrid{{0, 0, 0}, {1, 1, 1}, nodes};
}

Grid rectilinear() {
    RectilinearGrid grid;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = 0; i < nodes[axis]; ++i)
            grid.coordinates[axis].push_back(i + 0.3 * std::sin(0.7 * i));
    return grid;
}

struct Places {
    std::vector<Vec3> at;
    std::vector<double> times;
};

/// In the domain and a little outside, some on nodes and on stored times.
Places places(std::size_t count) {
    Places places;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> part(-0.02, 1.02);
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 at(69.0 * part(random), 40.0 * part(random), 36.0 * part(random));
        places.at.push_back(i % 5 == 0 ? glm::round(at) : at);
        places.times.push_back(i % 7 == 0 ? std::round(2.0 * part(random)) : 2.0 * part(random));
    }
    return places;
}

/// Bricks of a reader, read one by one in an order that a seed decides.
class Shuffled final : public TimeStepSource, public BrickSource {
  public:
    Shuffled(std::shared_ptr<const StoreReader> reader, unsigned seed)
        : reader_(std::move(reader)), random_(seed) {}

    const Grid& grid() const override { return reader_->grid(); }

    const SolidMask& mask() const override { return reader_->mask(); }

    const std::vector<double>& times() const override { return reader_->times(); }

    bool ready(std::size_t step) const override { return reader_->ready(step); }

    std::size_t bytes_per_step() const override { return reader_->bytes_per_step(); }

    Result<std::shared_ptr<const TimeStep>> load(std::size_t index,
                                                 std::stop_token stop) const override {
        return reader_->load(index, stop);
    }

    const BrickSource* bricks() const override { return this; }

    const BrickLayout& layout() const override { return reader_->bricks()->layout(); }

    bool gaps(std::size_t step) const override { return reader_->bricks()->gaps(step); }

    void read(std::vector<BrickRead> reads, std::stop_token stop, Done done) const override {
        std::vector<std::size_t> order(reads.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        {
            const std::scoped_lock lock(mutex_);
            std::shuffle(order.begin(), order.end(), random_);
        }
        for (const std::size_t i : order)
            reader_->bricks()->read({reads[i]}, stop, [i, done](std::size_t, Result<void> outcome) {
                done(i, std::move(outcome));
            });
    }

  private:
    std::shared_ptr<const StoreReader> reader_;
    mutable std::mutex mutex_;
    mutable std::mt19937 random_;
};

/// A store whose time-steps come brick by brick, in the least memory there is.
struct Paged {
    explicit Paged(std::shared_ptr<const StoreReader> its_reader, unsigned seed = 0)
        : reader(std::move(its_reader)),
          cache(std::make_shared<TimeStepCache>(std::make_shared<Shuffled>(reader, seed),
                                                TimeStepCache::Options{0, 1, {}, true})),
          flow(make_stored_flow(cache)) {}

    std::shared_ptr<const StoreReader> reader;
    std::shared_ptr<TimeStepCache> cache;
    std::unique_ptr<Flow> flow;
};

void expect_same(const std::vector<float>& a, const std::vector<float>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(a[i]), std::bit_cast<std::uint32_t>(b[i])) << i;
}

} // namespace

TEST(ScalarBricks, HaveTheSameBitsAsWholeTimeStepsInAnyBricksAndAnyOrder) {
    const Places some = places(3000);
    for (const Grid& grid : {uniform(), rectilinear()})
        for (const Precision precision : {Precision::Single, Precision::Half}) {
            const auto what = noise(grid, precision);
            const tests::TemporaryFolder flat;
            const auto whole = tests::open_bricks(tests::write_store(flat.path(), what, 0));
            const auto flow =
                make_stored_flow(std::make_shared<TimeStepCache>(whole, TimeStepCache::Options{}));
            const auto expected = sample_scalar(*flow, *whole, 1, some.at, some.times, {}).value();
            EXPECT_GT(std::count_if(expected.begin(), expected.end(),
                                    [](float value) { return std::isfinite(value); }),
                      1500);
            for (const std::uint32_t cells : {8u, 32u}) {
                const tests::TemporaryFolder folder;
                const auto layout = tests::write_store(folder.path(), what, cells);
                for (unsigned seed = 0; seed < 4; ++seed) {
                    const Paged paged(tests::open_bricks(layout), seed);
                    expect_same(
                        sample_scalar(*paged.flow, *paged.reader, 1, some.at, some.times, {})
                            .value(),
                        expected);
                    const auto status = paged.cache->bricks()->status();
                    EXPECT_GT(status.reads, 0u) << "they came through the cache of bricks";
                    EXPECT_LE(status.most_bytes, status.budget);
                }
            }
        }
}

TEST(ScalarBricks, AreReadWherePointsAreAndNowhereElse) {
    const tests::TemporaryFolder folder;
    const Paged paged(tests::open_bricks(
        tests::write_store(folder.path(), noise(uniform(), Precision::Single), 8)));
    const std::vector<Vec3> points{{1, 1, 1}, {2.5, 3.5, 7.9}, {30.2, 33.1, 9.4}};
    const auto reads = [&](double time) {
        const auto before = paged.cache->bricks()->status().reads;
        const std::vector<double> times(points.size(), time);
        EXPECT_TRUE(sample_scalar(*paged.flow, *paged.reader, 0, points, times, {}));
        return paged.cache->bricks()->status().reads - before;
    };
    EXPECT_EQ(reads(1.0), 2u) << "of one time-step where the time is a stored one";
    EXPECT_EQ(reads(1.5), 2u) << "and of the next";
    EXPECT_EQ(reads(1.25), 0u);
    EXPECT_TRUE(paged.cache->bricks()->held().empty()) << "which counts velocity";
}

TEST(ScalarBricks, ThatAreDamagedAreNamed) {
    const tests::TemporaryFolder folder;
    const auto layout = tests::write_store(folder.path(), noise(uniform(), Precision::Single), 16);
    std::fstream file(folder / step_file_name("s2", 1, Precision::Single),
                      std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(40); // of the first brick
    file.put('\x55');
    file.close();
    const Paged paged(tests::open_bricks(layout));
    const std::vector<Vec3> points{{1, 1, 1}}, elsewhere{{40, 30, 30}};
    const std::vector<double> times{0.5};
    const auto refused = sample_scalar(*paged.flow, *paged.reader, 1, points, times, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Error::Code::Corrupt);
    EXPECT_NE(refused.error().message.find("brick 0 of time-step 1 (s2_000001.f32)"),
              std::string::npos)
        << refused.error().message;
    EXPECT_TRUE(sample_scalar(*paged.flow, *paged.reader, 1, elsewhere, times, {}));
    EXPECT_TRUE(sample_scalar(*paged.flow, *paged.reader, 0, points, times, {}));
}

TEST(ScalarBricks, AreWaitedForUntilTheWorkIsCancelled) {
    const tests::TemporaryFolder folder;
    const Paged paged(tests::open_bricks(
        tests::write_store(folder.path(), noise(uniform(), Precision::Single), 8)));
    std::stop_source stop;
    stop.request_stop();
    const std::vector<Vec3> points{{1, 1, 1}};
    const std::vector<double> times{0.5};
    const auto refused =
        sample_scalar(*paged.flow, *paged.reader, 0, points, times, stop.get_token());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Error::Code::Cancelled);
}

} // namespace wakesurf::store::scalar_bricks_test
