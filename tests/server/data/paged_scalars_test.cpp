// Scalars in time-steps larger than memory, as a server opens them: surfaces are coloured, and level sets lie, as if all were there.
#include "core/dataset/brick_cache.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/level/level_triangles.hpp"
#include "server/data/open_dataset.hpp"
#include "server/data/surface_scalars.hpp"
#include "tests/support/brick_store.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <future>

namespace wakesurf::server::paged_scalars_test {
namespace {

using core::Vec3;

constexpr std::size_t mebi = std::size_t{1} << 20;
constexpr std::size_t scalars = 12;
const core::UniformGrid grid{{0, 0, 0}, Vec3(1.0 / 64), {65, 65, 65}};

/// A flow that turns, and scalars that are smooth, with nodes that have no value.
tests::StoreValues values() {
    tests::StoreValues what;
    what.grid = grid;
    for (const double time : {0.0, 1.0, 2.0, 3.0}) {
        auto& step = what.values.emplace_back(1 + scalars);
        for (std::size_t k = 0; k < 65; ++k)
            for (std::size_t j = 0; j < 65; ++j)
                for (std::size_t i = 0; i < 65; ++i) {
                    const Vec3 at = Vec3(i, j, k) / 64.0 - 0.5;
                    for (const double u : {0.1 - 0.5 * at.y, 0.5 * at.x, 0.05 + 0.02 * time})
                        step[0].push_back(static_cast<float>(u));
                    for (std::size_t s = 1; s <= scalars; ++s)
                        step[s].push_back(
                            i * j * k % 911 == 910
                                ? NAN
                                : static_cast<float>(glm::length(at) + 0.1 * time +
                                                     0.01 * std::sin(40.0 * at.x * double(s))));
                }
    }
    return what;
}

struct Coloured {
    core::QuadComplex mesh;
    std::vector<std::vector<float>> values;
};

/// A streak surface, and the values of all scalars on it, one after the other.
Coloured coloured(const LoadedDataset& dataset) {
    core::SurfaceParameters parameters;
    parameters.kind = core::SurfaceKind::Streak;
    parameters.to = 2.5;
    parameters.separation = 0.03;
    const core::Rake rake{core::Rake::Kind::Line, {{0.3, 0.4, 0.2}, {0.7, 0.6, 0.5}}, 16};
    Coloured out{core::build_surface(*dataset.flow, rake, parameters).value().mesh, {}};
    const std::vector<double> times(out.mesh.vertices(), 2.5);
    for (std::size_t s = 1; s <= scalars; ++s) {
        const std::string name = "s" + std::to_string(s);
        out.values.push_back(
            surface_scalars(dataset, out.mesh, times, {name}, {}).value().at(name));
    }
    return out;
}

bool same(const std::vector<float>& a, const std::vector<float>& b) {
    return std::ranges::equal(a, b, [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    });
}

class PagedScalars : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = new tests::TemporaryFolder;
        tests::write_whole_store(*folder_ / "flat", values(), 0);
        tests::write_whole_store(*folder_ / "bricks", values(), 8);
    }

    static void TearDownTestSuite() { delete folder_; }

    static LoadedDataset open(const char* name, std::size_t bytes) {
        return open_store(*folder_ / name, {{bytes, 1}}).value();
    }

    inline static tests::TemporaryFolder* folder_ = nullptr;
};

TEST_F(PagedScalars, ColourASurfaceInATimeStepLargerThanMemoryWithTheSameBits) {
    const auto flat = open("flat", 512 * mebi);
    ASSERT_FALSE(flat.cache->bricks());
    const auto expected = coloured(flat);
    ASSERT_GT(expected.mesh.vertices(), 300u);

    const auto paged = open("bricks", 2 * mebi);
    ASSERT_TRUE(paged.cache->bricks());
    EXPECT_GT(paged.info.bytes_per_step, 2 * mebi) << "one time-step, of the velocity alone";
    const auto got = coloured(paged);
    EXPECT_EQ(got.mesh.position, expected.mesh.position);
    for (std::size_t s = 0; s < scalars; ++s)
        EXPECT_TRUE(same(got.values[s], expected.values[s])) << "s" << s + 1;
    const auto status = paged.cache->bricks()->status();
    EXPECT_LE(status.most_bytes, status.budget);
    EXPECT_LE(status.budget, 2 * mebi);
}

TEST_F(PagedScalars, AreSampledByManyAtOnceInTheSameMemory) {
    const auto expected = coloured(open("flat", 512 * mebi));
    const auto paged = open("bricks", 2 * mebi);
    std::vector<std::future<Coloured>> all;
    for (int i = 0; i < 4; ++i)
        all.push_back(std::async(std::launch::async, [&] { return coloured(paged); }));
    for (auto& each : all) {
        const auto got = each.get();
        for (std::size_t s = 0; s < scalars; ++s)
            EXPECT_TRUE(same(got.values[s], expected.values[s])) << "s" << s + 1;
    }
    const auto status = paged.cache->bricks()->status();
    EXPECT_LE(status.most_bytes, status.budget);
}

TEST_F(PagedScalars, HaveTheSameLevelSetsAtStoredTimesAndBetweenThem) {
    const auto flat = open("flat", 512 * mebi);
    const auto paged = open("bricks", 2 * mebi);
    for (const double time : {1.0, 1.25, 3.0}) {
        const auto expected = flat.levels->values("s3", time, {}).value();
        const auto got = paged.levels->values("s3", time, {}).value();
        EXPECT_TRUE(same(got->values, expected->values));
        EXPECT_EQ(got->range, expected->range);
        const auto triangles =
            core::level_triangles(flat.store->grid(), expected->values, 0.55, 1'000'000, {}, {});
        EXPECT_GT(triangles->triangles.size(), 1000u);
    }
    const auto status = paged.cache->bricks()->status();
    EXPECT_GT(status.reads, 2 * 512u) << "all bricks of a scalar came through the cache";
    EXPECT_LE(status.most_bytes, status.budget);
}

TEST_F(PagedScalars, DecideWithTheGridWhetherTimeStepsFit) {
    const auto decided = [&](const char* name, std::size_t bytes) {
        const auto opened = open(name, bytes);
        core::TimeStepCache::Options options;
        options.budget_bytes = bytes;
        const auto how = how_served(*opened.store, options);
        EXPECT_EQ(how.by_brick, opened.cache->bricks() != nullptr) << name << ' ' << bytes;
        return how.by_brick;
    };
    const auto reader = open("bricks", 2 * mebi).store;
    const std::size_t window = core::TimeStepCache::smallest_window(*reader);
    EXPECT_TRUE(decided("bricks", window + reader->scalar_memory() / 2))
        << "four time-steps fit, and not what sampling whole scalars takes";
    EXPECT_FALSE(decided("bricks", window + reader->scalar_memory() + mebi));
    EXPECT_FALSE(decided("flat", window + reader->scalar_memory() + mebi));
}

} // namespace
} // namespace wakesurf::server::paged_scalars_test
