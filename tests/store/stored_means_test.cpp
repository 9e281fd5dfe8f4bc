#include "store/store_scalars.hpp"
#include "tests/support/small_store.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <numeric>

namespace wakesurf::store::stored_means_test {
namespace {

namespace fs = std::filesystem;

constexpr core::UniformGrid grid{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};

// A store of four time-steps with one scalar.
class Store {
  public:
    Store() {
        layout.folder = folder.path();
        layout.grid.uniform = grid;
        layout.times = {0.0, 0.5, 1.0, 1.5};
        layout.scalars = {{"p", "p"}};
        for (std::size_t step = 0; step < 4; ++step)
            put(step, 100.0f + static_cast<float>(step));
    }

    void put(std::size_t step, float p) const {
        std::string sums = tests::read_file(layout.folder / checksums_file_name);
        sums.resize(8 * step);
        tests::write_file(layout.folder / checksums_file_name, sums);
        tests::append_checksums(
            layout, {tests::put_values(layout, "velocity", step, std::vector<float>(24, 1.0f)),
                     tests::put_values(layout, "p", step, std::vector<float>(8, p))});
    }

    std::shared_ptr<const StoreReader> reader() const { return tests::open_layout(layout).value(); }

    std::shared_ptr<const StoreScalars> scalars() const {
        return StoreScalars::open(reader(), std::make_shared<core::PosixDisk>());
    }

    MeanWriter writer() const { return MeanWriter::begin(layout, reader()->marks()).value(); }

    // Of p over the first steps, with one field of one value a file.
    core::Result<void> add(const std::string& name,
                           const std::vector<float>& values,
                           std::size_t steps = 3,
                           double period = 0.0) const {
        auto to = writer();
        for (const float value : values) {
            EXPECT_TRUE(to.begin_files(1));
            EXPECT_TRUE(to.append(0, std::vector<float>(3, value))); // in pieces
            EXPECT_TRUE(to.append(0, std::vector<float>(5, value)));
            EXPECT_TRUE(to.end_files());
        }
        std::vector<std::size_t> used(steps);
        std::iota(used.begin(), used.end(), 0);
        core::MeanRecord record{"p",
                                "",
                                0.0,
                                layout.times[steps - 1],
                                steps,
                                period,
                                period > 0.0 ? values.size() : 0,
                                "9.9",
                                {{name, {values.front(), values.back()}}}};
        return to.keep(record, source_mark(reader()->marks(), used, 1).value());
    }

    float value(const std::string& name, std::size_t step) const {
        const auto all = scalars();
        const auto slab = all->scalar_values(all->find(name).value(), step, {}).value();
        const auto* begin = reinterpret_cast<const float*>(slab->bytes().data());
        EXPECT_EQ(std::vector<float>(begin, begin + 8), std::vector<float>(8, *begin));
        return *begin;
    }

    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
    }

    tests::TemporaryFolder folder;
    StoreLayout layout;
};

TEST(StoredMeans, AreScalarsOfTheSameValuesAtAllTimes) {
    const Store store;
    ASSERT_TRUE(store.add("p_mean", {4.25f}));
    const auto scalars = store.scalars();
    EXPECT_EQ(scalars->names(), (std::vector<std::string>{"p", "p_mean"}));
    ASSERT_EQ(scalars->means().size(), 1u);
    EXPECT_EQ(scalars->means().front().of, "p");
    EXPECT_EQ(scalars->means().front().to, 1.0);
    EXPECT_TRUE(scalars->times_of(1).empty());
    for (std::size_t step = 0; step < 4; ++step)
        EXPECT_EQ(store.value("p_mean", step), 4.25f);
    EXPECT_EQ(store.value("p", 2), 102.0f);
}

TEST(StoredMeans, OfPhasesHaveTheValuesOfThePhaseOfEachTime) {
    const Store store;
    ASSERT_TRUE(store.add("p_phase", {1.0f, 2.0f}, 4, 1.0));
    EXPECT_EQ(store.value("p_phase", 0), 1.0f);
    EXPECT_EQ(store.value("p_phase", 1), 2.0f);
    EXPECT_EQ(store.value("p_phase", 2), 1.0f);
    EXPECT_EQ(store.value("p_phase", 3), 2.0f);
}

TEST(StoredMeans, AreGoneOnceAValueTheyWereMadeOfIsAnotherAndTheirFilesGoWithTheNext) {
    const Store store;
    ASSERT_TRUE(store.add("p_mean", {1.0f}, 2));
    ASSERT_TRUE(store.add("p_late", {2.0f}, 4));
    const std::size_t before = store.files();
    store.put(3, 7.0f); // a time-step that only the second one has
    EXPECT_EQ(store.scalars()->names(), (std::vector<std::string>{"p", "p_mean"}));
    ASSERT_TRUE(store.add("p_again", {3.0f}, 4));
    EXPECT_EQ(store.files(), before);
    EXPECT_EQ(store.value("p_mean", 0), 1.0f);
}

TEST(StoredMeans, LeaveNothingUnlessTheyAreKeptNorWhenTheyAreRemoved) {
    const Store store;
    const std::size_t before = store.files();
    {
        auto writer = store.writer();
        ASSERT_TRUE(writer.begin_files(2));
        ASSERT_TRUE(writer.append(0, std::vector<float>(8, 1.0f)));
        ASSERT_TRUE(writer.append(1, std::vector<float>(8, 1.0f)));
        ASSERT_TRUE(writer.end_files());
        ASSERT_TRUE(writer.begin_files(2));
        ASSERT_TRUE(writer.append(0, std::vector<float>(4, 1.0f)));
        EXPECT_EQ(store.scalars()->names().size(), 1u) << "nothing is listed before it is whole";
    }
    EXPECT_EQ(store.files(), before);
    ASSERT_TRUE(store.add("p_mean", {1.0f}));
    ASSERT_TRUE(remove_mean(store.folder.path(), "p_mean"));
    EXPECT_EQ(store.files(), before + 1) << "the list stays";
    EXPECT_EQ(store.scalars()->names().size(), 1u);
    EXPECT_EQ(remove_mean(store.folder.path(), "p_mean").error().code, core::Error::Code::NotFound);
}

TEST(StoredMeans, ThatWereCutOffGoWhenTheNextBegins) {
    const Store store;
    ASSERT_TRUE(store.add("p_mean", {1.0f}));
    const std::size_t before = store.files();
    tests::write_file(store.folder / "mean_2_0_000000.f32", "whole, but not listed");
    tests::write_file(store.folder / "mean_2_1_000000.f32.part", "half");
    EXPECT_EQ(store.scalars()->names().size(), 2u);
    const auto writer = store.writer();
    EXPECT_EQ(store.files(), before);
    EXPECT_EQ(store.value("p_mean", 0), 1.0f);
}

TEST(StoredMeans, AreMadeByOneProgramAtATime) {
    const Store store;
    const auto writer = store.writer();
    const auto second = MeanWriter::begin(store.layout, store.reader()->marks());
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("another program"), std::string::npos);
}

TEST(StoredMeans, AreNotShownWhereTheirFileIsDamaged) {
    const Store store;
    ASSERT_TRUE(store.add("p_mean", {1.0f}));
    tests::write_file(store.folder / "mean_1_0_000000.f32", std::string(32, 'x'));
    const auto scalars = store.scalars();
    const auto values = scalars->scalar_values(1, 0, {});
    ASSERT_FALSE(values);
    EXPECT_EQ(values.error().code, core::Error::Code::Corrupt);
    auto list = nlohmann::json::parse(tests::read_file(store.folder / "means.json"));
    auto& means = list["means"];
    while (means.size() < most_means)
        means.push_back(means.front());
    tests::write_file(store.folder / "means.json", list.dump());
    EXPECT_EQ(store.scalars()->names().size(), 1u + most_means);
    means.push_back(means.front());
    tests::write_file(store.folder / "means.json", list.dump());
    EXPECT_EQ(store.scalars()->names().size(), 1u) << "more than any store has";
    tests::write_file(store.folder / "means.json", "{}");
    EXPECT_EQ(store.scalars()->names().size(), 1u) << "the data are there without them";
}

} // namespace
} // namespace wakesurf::store::stored_means_test
