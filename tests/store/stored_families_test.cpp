#include "store/store_scalars.hpp"
#include "store/store_writer.hpp"
#include "tests/support/small_store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace wakesurf::store::stored_families_test {
namespace {

namespace fs = std::filesystem;

constexpr core::UniformGrid grid{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};

// A store of three time-steps without scalars, or with one.
class Store {
  public:
    Store() {
        layout.folder = folder.path();
        layout.grid.uniform = grid;
        layout.times = {0.0, 0.5, 2.0};
        layout.scalars = {{"p", "p"}};
        for (std::size_t step = 0; step < 3; ++step)
            put(step, static_cast<float>(step));
    }

    void put(std::size_t step, float speed) const {
        const std::vector<float> velocity(24, speed);
        const std::vector<float> p(8, 100.0f + static_cast<float>(step));
        std::string sums = tests::read_file(layout.folder / checksums_file_name);
        sums.resize(8 * step);
        tests::write_file(layout.folder / checksums_file_name, sums);
        tests::append_checksums(layout, {tests::put_values(layout, "velocity", step, velocity),
                                         tests::put_values(layout, "p", step, p)});
    }

    std::shared_ptr<const StoreReader> reader() const { return tests::open_layout(layout).value(); }

    std::shared_ptr<const StoreScalars> scalars() const {
        return StoreScalars::open(reader(), std::make_shared<core::PosixDisk>());
    }

    core::Result<void> add(const std::string& name, float value, std::size_t step = 1) const {
        core::FamilyRecord record{name, {core::FamilyPlane{{1, 2, 3}, {0, 0, 2}}, "p"}, "9.9", {}};
        record.request.length = 12.5;
        record.steps = {{step, layout.times[step], {8, 8, 0, 0, 0, 0, {value, value}}}};
        const std::vector<std::vector<float>> values{std::vector<float>(8, value)};
        return add_family(layout.folder, reader()->marks(), record, values,
                          [](const auto&) { return core::Result<void>(); });
    }

    std::vector<float> values(const std::string& name, std::size_t step) const {
        const auto all = scalars();
        const auto slab = all->scalar_values(all->find(name).value(), step, {}).value();
        const auto* begin = reinterpret_cast<const float*>(slab->bytes().data());
        return {begin, begin + 8};
    }

    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
    }

    tests::TemporaryFolder folder;
    StoreLayout layout;
};

TEST(StoredFamilies, AreScalarsWithTheirRecipeAndAreThereWhenTheStoreIsOpenedAgain) {
    const Store store;
    ASSERT_TRUE(store.add("psi", 4.25f));
    const auto scalars = store.scalars();
    EXPECT_EQ(scalars->names(), (std::vector<std::string>{"p", "psi"}));
    EXPECT_EQ(scalars->times_of(0), std::vector<double>{}) << "it has values at all";
    EXPECT_EQ(scalars->times_of(1).size(), scalars->families().front().steps.size());
    ASSERT_EQ(scalars->families().size(), 1u);
    const core::FamilyRecord& record = scalars->families().front();
    EXPECT_EQ(record.request.scalar, "p");
    EXPECT_EQ(std::get<core::FamilyPlane>(record.request.source).normal, core::Vec3(0, 0, 2));
    EXPECT_EQ(record.request.length, 12.5);
    EXPECT_EQ(record.version, "9.9");
    EXPECT_EQ(store.values("psi", 1), std::vector<float>(8, 4.25f));
    EXPECT_EQ(store.values("p", 2), std::vector<float>(8, 102.0f));
}

TEST(StoredFamilies, HaveNoValueAtTimeStepsThatTheyWereNotMadeFor) {
    const Store store;
    ASSERT_TRUE(store.add("psi", 4.25f));
    for (const std::size_t step : {0, 2})
        for (const float value : store.values("psi", step))
            EXPECT_TRUE(std::isnan(value));
}

TEST(StoredFamilies, AreGoneOnceTheVelocityIsAnotherAndTheirNameIsFree) {
    const Store store;
    ASSERT_TRUE(store.add("psi", 1.0f, 1));
    ASSERT_TRUE(store.add("phi", 2.0f, 0));
    store.put(1, 7.0f);
    store.put(2, 2.0f);
    EXPECT_EQ(store.scalars()->names(), (std::vector<std::string>{"p", "phi"}));
    const std::size_t before = store.files();
    ASSERT_TRUE(store.add("psi", 3.0f));
    EXPECT_EQ(store.files(), before) << "the file of the old one went";
    EXPECT_EQ(store.values("psi", 1), std::vector<float>(8, 3.0f));
    EXPECT_EQ(store.values("phi", 0), std::vector<float>(8, 2.0f));
}

TEST(StoredFamilies, LeaveNothingWhenTheyAreRemoved) {
    const Store store;
    const std::size_t before = store.files();
    ASSERT_TRUE(store.add("psi", 1.0f));
    const auto in_use = store.scalars();
    ASSERT_TRUE(remove_family(store.folder.path(), "psi"));
    EXPECT_EQ(store.files(), before + 1) << "families.json";
    EXPECT_FALSE(store.scalars()->find("psi"));
    const auto slab = in_use->scalar_values(1, 1, {}).value();
    EXPECT_TRUE(std::isnan(reinterpret_cast<const float*>(slab->bytes().data())[0]));
    const auto again = remove_family(store.folder.path(), "psi");
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().code, core::Error::Code::NotFound);
}

TEST(StoredFamilies, LeaveEverythingAsItWasWhenTheyCannotBeWritten) {
    const Store store;
    ASSERT_TRUE(store.add("psi", 1.0f));
    const std::string before = tests::read_file(store.folder / "families.json");
    const std::size_t files = store.files();
    fs::create_directory(store.folder /
                         "families.json.part"); // stands in the way, as a full disk does
    const auto refused = store.add("phi", 2.0f);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, core::Error::Code::Io);
    fs::remove(store.folder / "families.json.part");
    EXPECT_EQ(tests::read_file(store.folder / "families.json"), before);
    EXPECT_EQ(store.files(), files);
    EXPECT_EQ(store.values("psi", 1), std::vector<float>(8, 1.0f));
}

TEST(StoredFamilies, LeaveAReserveOnTheDisk) {
    const tests::TemporaryFolder folder;
    constexpr std::uint64_t mebi = std::uint64_t{1} << 20;
    const std::uint64_t free = std::filesystem::space(folder.path()).available;
    ASSERT_GT(free, 200 * mebi);
    EXPECT_TRUE(check_room_for(folder.path(), free - 160 * mebi, "families"));
    const auto refused = check_room_for(folder.path(), free - mebi, "families");
    ASSERT_FALSE(refused) << "it would fit, but leave less than 64 MiB";
    EXPECT_NE(refused.error().message.find("MiB"), std::string::npos);
}

TEST(StoredFamilies, AreAtMostSixteen) {
    const Store store;
    for (std::size_t i = 0; i < most_families; ++i)
        ASSERT_TRUE(store.add("f" + std::to_string(i), 1.0f));
    const auto refused = store.add("more", 1.0f);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, core::Error::Code::OverLimit);
}

TEST(StoredFamilies, DoNotHideTheDataWhereTheyAreDamaged) {
    const Store store;
    ASSERT_TRUE(store.add("psi", 1.0f));
    tests::flip_bit(store.folder / "family_1_000001.f32", 9);
    const auto scalars = store.scalars();
    const auto damaged = scalars->scalar_values(1, 1, {});
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().code, core::Error::Code::Corrupt);
    tests::write_file(store.folder / "families.json", "{\"format\": 3");
    EXPECT_EQ(store.scalars()->names(), std::vector<std::string>{"p"});
    const auto refused = store.add("phi", 2.0f);
    ASSERT_FALSE(refused) << "what is there might still be mended";
    EXPECT_EQ(refused.error().code, core::Error::Code::Corrupt);
}

TEST(StoredFamilies, BelongToAStoreForTheImporterAndGoWithItsData) {
    const Store store;
    ASSERT_TRUE(store.add("psi", 1.0f));
    auto writer = StoreWriter::open(store.folder.path(), [] { return core::Result<void>(); });
    ASSERT_TRUE(writer) << writer.error().message;
    ASSERT_TRUE(writer->clear());
    EXPECT_FALSE(fs::exists(store.folder / "families.json"));
    EXPECT_FALSE(fs::exists(store.folder / "family_1_000001.f32"));
}

} // namespace
} // namespace wakesurf::store::stored_families_test
