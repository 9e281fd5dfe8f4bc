#include "core/base/crc32c.hpp"
#include "core/field/sample_scalar.hpp"
#include "core/field/stored_flow.hpp"
#include "store/store_reader.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace wakesurf::store::sample_scalar_test {
namespace {

using namespace core;

using tests::TemporaryFolder;
using tests::write_file;

constexpr UniformGrid grid{{-1, 0, 2}, {0.5, 0.25, 1.0}, {5, 6, 4}};

double pressure(const Vec3& x, double t) {
    return 3.0 * x.x - x.y + 0.5 * x.z + 2.0 * t - t * x.x * x.y;
}

// A store of a uniform flow and two scalar fields, trilinear in space and linear in time.
class Store {
  public:
    explicit Store(float at_first_node = 0.0f) {
        layout.folder = folder.path();
        layout.grid.uniform = grid;
        layout.times = {0.0, 0.5, 2.0};
        layout.scalars = {{"p", "p"}, {"T (K)", "t-k"}};
        std::string sums;
        for (std::size_t step = 0; step < layout.times.size(); ++step) {
            std::vector<float> velocity;
            std::vector<float> p;
            std::vector<float> t;
            for (std::size_t node = 0; node < grid.nodes(); ++node) {
                velocity.insert(velocity.end(), {1.0f, 0.0f, 0.0f});
                p.push_back(static_cast<float>(pressure(position(node), layout.times[step])));
                t.push_back(300.0f);
            }
            t[0] = at_first_node;
            for (const auto& [stem, values] :
                 {std::pair<std::string, std::vector<float>&>{"velocity", velocity},
                  {"p", p},
                  {"t-k", t}}) {
                const auto bytes = std::as_bytes(std::span<const float>(values));
                write_file(folder / step_file_name(stem, step, Precision::Single),
                           {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
                const std::uint32_t sum = crc32c(bytes);
                sums.append(reinterpret_cast<const char*>(&sum), sizeof(sum));
            }
        }
        write_file(folder / checksums_file_name, sums);
        reader = StoreReader::open(layout, std::make_shared<PosixDisk>()).value();
        flow = make_stored_flow(std::make_shared<TimeStepCache>(reader, TimeStepCache::Options{}));
    }

    static Vec3 position(std::size_t node) {
        return grid.origin + grid.spacing * Vec3(node % 5, node / 5 % 6, node / 30);
    }

    std::vector<float> sample(const std::string& name,
                              const std::vector<Vec3>& points,
                              const std::vector<double>& times) const {
        const auto scalar = find_scalar(reader->layout(), name).value();
        return sample_scalar(*flow, *reader, scalar, points, times, {}).value();
    }

    TemporaryFolder folder;
    StoreLayout layout;
    std::shared_ptr<const StoreReader> reader;
    std::unique_ptr<Flow> flow;
};

TEST(SampleScalar, InterpolatesInSpaceAndTimeWhateverTheOrderOfThePoints) {
    const Store store;
    std::vector<Vec3> points;
    std::vector<double> times;
    for (int i = 0; i < 200; ++i) {
        const double a = std::fmod(0.618 * i, 1.0);
        const double b = std::fmod(0.414 * i, 1.0);
        points.push_back(grid.origin + grid.bounds().extent() * Vec3(a, b, 1.0 - a * b));
        times.push_back(2.0 * std::fmod(0.732 * i, 1.0));
    }
    const auto values = store.sample("p", points, times);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(values[i], pressure(points[i], times[i]), 2e-6 * 20.0) << i;
    EXPECT_EQ(store.sample("T (K)", {points[7]}, {1.0})[0], 300.0f);
}

TEST(SampleScalar, TimesBeyondTheSeriesAreItsEnds) {
    const Store store;
    const Vec3 x(0.1, 0.6, 3.3);
    const auto values = store.sample("p", {x, x}, {-5.0, 9.0});
    EXPECT_NEAR(values[0], pressure(x, 0.0), 1e-5);
    EXPECT_NEAR(values[1], pressure(x, 2.0), 1e-5);
}

TEST(SampleScalar, IsNoNumberOutsideAndWhereTheFieldHasNone) {
    const Store store(std::numeric_limits<float>::infinity());
    const auto outside = store.sample("p", {Vec3(-1.01, 0, 2), Vec3(0, 0, 9)}, {0.0, 1.0});
    EXPECT_TRUE(std::isnan(outside[0]) && std::isnan(outside[1]));
    const Vec3 beside_the_bad_node = grid.origin + 0.1 * grid.spacing;
    EXPECT_TRUE(std::isnan(store.sample("T (K)", {beside_the_bad_node}, {0.0})[0]));
}

TEST(SampleScalar, AnUnknownFieldIsAnErrorThatListsTheKnownOnes) {
    const Store store;
    const auto error = find_scalar(store.layout, "nut").error();
    EXPECT_EQ(error.code, Error::Code::NotFound);
    EXPECT_NE(error.hint.find("p, T (K)"), std::string::npos) << error.hint;
}

TEST(SampleScalar, ClosedFormsHaveNoNodes) {
    const Store store;
    EXPECT_EQ(store.flow->shares(grid.origin).count, 8u);
    EXPECT_EQ(store.flow->shares(Vec3(100.0)).count, 0u);
}

} // namespace
} // namespace wakesurf::store::sample_scalar_test
