// A Zarr seen as a store: its bricks hold the numbers of its chunks, and what is wrong with a chunk is said by its name.
#include "server/remote/remote_dataset.hpp"
#include "server/remote/zarr/zarr_disk.hpp"
#include "store/open_store.hpp"
#include "tests/support/read_bricks.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>

namespace wakesurf::server::zarr_disk_test {

namespace {

using nlohmann::json;

constexpr std::array<std::size_t, 3> nodes{40, 35, 3}; // x, y, z: bricks of 33 x 33 x 3
constexpr std::array<std::size_t, 4> chunks{2, 2, 10, 16};
constexpr std::size_t steps = 3;

float number(std::size_t component, std::size_t step, std::size_t x, std::size_t y, std::size_t z) {
    return static_cast<float>(component + 10 * step + 100 * x + 10000 * y) +
           0.25F * static_cast<float>(z);
}

/// Three arrays of a closed form, uncompressed, of version 2.
class ZarrDiskTest : public testing::Test {
  protected:
    void SetUp() override {
        put(".zgroup", R"({"zarr_format": 2})");
        for (std::size_t component = 0; component < 3; ++component) {
            const std::string name(1, "uvw"[component]);
            describe(name, 0.0);
            for (std::size_t t = 0; t < steps; t += chunks[0])
                for (std::size_t z = 0; z < nodes[2]; z += chunks[1])
                    for (std::size_t y = 0; y < nodes[1]; y += chunks[2])
                        for (std::size_t x = 0; x < nodes[0]; x += chunks[3])
                            put(name + "/" + std::to_string(t / chunks[0]) + "." +
                                    std::to_string(z / chunks[1]) + "." +
                                    std::to_string(y / chunks[2]) + "." +
                                    std::to_string(x / chunks[3]),
                                chunk(component, {t, z, y, x}));
        }
    }

    void put(const std::string& name, const std::string& text) {
        std::filesystem::create_directories((root() / name).parent_path());
        tests::write_file(root() / name, text);
    }

    void describe(const std::string& name, const json& fill) {
        put(name + "/.zarray", json{{"zarr_format", 2},
                                    {"shape", {steps, nodes[2], nodes[1], nodes[0]}},
                                    {"chunks", chunks},
                                    {"dtype", "<f4"},
                                    {"order", "C"},
                                    {"filters", nullptr},
                                    {"compressor", nullptr},
                                    {"fill_value", fill}}
                                   .dump());
    }

    static std::string chunk(std::size_t component, const std::array<std::size_t, 4>& first) {
        std::vector<float> values;
        for (std::size_t t = 0; t < chunks[0]; ++t)
            for (std::size_t z = 0; z < chunks[1]; ++z)
                for (std::size_t y = 0; y < chunks[2]; ++y)
                    for (std::size_t x = 0; x < chunks[3]; ++x)
                        values.push_back(number(component, first[0] + t, first[3] + x, first[2] + y,
                                                first[1] + z));
        std::string out(values.size() * sizeof(float), '\0');
        std::memcpy(out.data(), values.data(), out.size());
        return out;
    }

    std::shared_ptr<const ZarrDisk> disk() const {
        return ZarrDisk::open(root(), std::make_shared<core::PosixDisk>(), 1 << 20).value();
    }

    std::shared_ptr<const store::StoreReader> reader() const {
        return store::open_store(root(), disk()).value().reader;
    }

    /// Of all bricks of a time-step.
    core::Error read_error(std::size_t step) const { return reader()->load(step, {}).error(); }

    std::filesystem::path root() const { return folder_ / "wake.zarr"; }

    tests::TemporaryFolder folder_;
};

} // namespace

TEST_F(ZarrDiskTest, BricksHoldTheNumbersOfTheChunks) {
    const auto opened = reader();
    const auto& layout = opened->bricks()->layout();
    ASSERT_EQ(layout.count(), 4u);
    for (std::size_t step = 0; step < steps; ++step)
        for (std::size_t brick = 0; brick < layout.count(); ++brick) {
            std::vector<float> values(3 * layout.nodes_per_brick());
            const auto told = tests::outcomes_of(*opened->bricks(), {{step, brick, values}})[0];
            ASSERT_TRUE(told) << told.error().message;
            const auto first = layout.first_node(brick);
            for (std::size_t i = 0; i < layout.nodes_per_brick(); ++i) {
                const auto x = std::min(first[0] + i % 33, nodes[0] - 1);
                const auto y = std::min(first[1] + i / 33 % 33, nodes[1] - 1);
                const auto z = std::min(first[2] + i / 33 / 33, nodes[2] - 1);
                for (std::size_t component = 0; component < 3; ++component)
                    ASSERT_EQ(values[3 * i + component], number(component, step, x, y, z))
                        << step << " " << brick << " " << i;
            }
        }
    EXPECT_FALSE(opened->bricks()->gaps(0));
}

TEST_F(ZarrDiskTest, WholeTimeStepsHoldThem) {
    const auto step = reader()->load(2, {});
    ASSERT_TRUE(step) << step.error().message;
    const auto values = (*step)->velocity();
    const std::size_t node = 39 + nodes[0] * (34 + nodes[1] * 2);
    EXPECT_EQ(values[3 * node + 1], number(1, 2, 39, 34, 2));
}

TEST_F(ZarrDiskTest, AChunkThatIsNotThereIsFilled) {
    std::filesystem::remove(root() / "v/0.0.0.1");
    const auto filled = reader()->load(0, {});
    ASSERT_TRUE(filled) << filled.error().message;
    EXPECT_EQ((*filled)->velocity()[3 * 16 + 1], 0.0F);
    EXPECT_EQ((*filled)->velocity()[3 * 15 + 1], number(1, 0, 15, 0, 0));
    describe("v", nullptr);
    EXPECT_EQ(read_error(0).code, core::Error::Code::NotFound);
    EXPECT_NE(
        read_error(0).message.find("chunk v/0.0.0.1: it is not there, and fill_value is null"),
        std::string::npos)
        << read_error(0).message;
}

TEST_F(ZarrDiskTest, FilledWithNaNItIsAGap) {
    describe("v", "NaN");
    EXPECT_TRUE(reader()->bricks()->gaps(0)) << "there may be one";
    EXPECT_FALSE(reader()->load(0, {}).value()->gaps) << "there is none";
    std::filesystem::remove(root() / "v/0.0.0.1");
    const auto step = reader()->load(0, {}).value();
    EXPECT_TRUE(step->gaps);
    EXPECT_TRUE(std::isnan(step->velocity()[3 * 16 + 1]));
}

TEST_F(ZarrDiskTest, AValueThatIsNotFiniteIsNoticedWhereNoneMayBe) {
    std::string text = tests::read_file(root() / "w/0.1.0.2");
    const float nothing = std::nanf("");
    std::memcpy(text.data(), &nothing, sizeof(nothing));
    put("w/0.1.0.2", text);
    const core::Error error = read_error(0);
    EXPECT_EQ(error.code, core::Error::Code::Corrupt);
    EXPECT_NE(error.message.find("chunk w/0.1.0.2: it has values that are not finite"),
              std::string::npos)
        << error.message;
}

TEST_F(ZarrDiskTest, ADamagedChunkIsNamedWithTheBrickThatWantsIt) {
    std::filesystem::resize_file(root() / "u/1.0.3.2", 100);
    EXPECT_TRUE(reader()->load(0, {}));
    const core::Error error = read_error(2);
    EXPECT_EQ(error.code, core::Error::Code::Corrupt);
    EXPECT_NE(error.message.find("of time-step 2"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("chunk u/1.0.3.2: it has 100 bytes instead of 2560"),
              std::string::npos)
        << error.message;
}

TEST_F(ZarrDiskTest, AChunkThatChangesWhileItIsServedIsNoticed) {
    const auto opened = disk();
    const auto reader = store::open_store(root(), opened).value().reader;
    ASSERT_TRUE(reader->load(0, {}));
    opened->use_memory(opened->least_memory()); // too little to keep it
    for (std::size_t i = 0; i < 2; ++i)
        ASSERT_TRUE(reader->load(2, {}));
    put("u/0.0.0.0", chunk(0, {1, 0, 0, 0}));
    const auto changed = reader->load(0, {});
    ASSERT_FALSE(changed);
    EXPECT_NE(changed.error().message.find("chunk u/0.0.0.0: it has changed"), std::string::npos)
        << changed.error().message;
}

TEST_F(ZarrDiskTest, NothingLeadsOutOfTheFolder) {
    put(".zmetadata",
        json{{"metadata",
              {{"../secret/.zarray", json::parse(tests::read_file(root() / "u/.zarray"))},
               {".zgroup", {{"zarr_format", 2}}}}}}
            .dump());
    const auto none = ZarrDisk::open(root(), std::make_shared<core::PosixDisk>(), 0);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, core::Error::Code::NotFound);
    EXPECT_NE(none.error().message.find("the Zarr has no velocity"), std::string::npos);
}

TEST_F(ZarrDiskTest, NoLinkIsFollowed) {
    std::filesystem::rename(root() / "u/0.0.0.0", folder_ / "elsewhere");
    std::filesystem::create_symlink(folder_ / "elsewhere", root() / "u/0.0.0.0");
    const auto opened = open_disk(root(), 1 << 20);
    ASSERT_TRUE(opened) << opened.error().message;
    const auto refused = store::open_store(root(), opened->disk).value().reader->load(0, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("0.0.0.0: it is a link"), std::string::npos)
        << refused.error().message;
}

TEST_F(ZarrDiskTest, AVelocityThatCannotBeReadIsNamedWithTheReasonAndNoOtherVectorTaken) {
    json array = json::parse(tests::read_file(root() / "v/.zarray"));
    array["filters"] = {{{"id", "fixedscaleoffset"}}};
    put("v/.zarray", array.dump());
    put("B/.zarray", json{{"zarr_format", 2},
                          {"shape", {steps, nodes[2], nodes[1], nodes[0], 3}},
                          {"chunks", {1, nodes[2], nodes[1], nodes[0], 3}},
                          {"dtype", "<f4"},
                          {"order", "C"},
                          {"filters", nullptr},
                          {"compressor", nullptr},
                          {"fill_value", 0.0}}
                         .dump());
    const auto none = ZarrDisk::open(root(), std::make_shared<core::PosixDisk>(), 0);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, core::Error::Code::Unsupported);
    EXPECT_EQ(none.error().message, "v: it has filters, which are not read");
    EXPECT_EQ(none.error().hint, "write it without filters");
}

TEST_F(ZarrDiskTest, CoordinatesInMoreChunksThanTheyMayLieInAreRefusedBeforeOneIsLookedFor) {
    std::filesystem::remove_all(root());
    put(".zgroup", R"({"zarr_format": 2})");
    const auto array = [&](const std::string& name, const json& shape, const json& in) {
        put(name + "/.zarray", json{{"zarr_format", 2},
                                    {"shape", shape},
                                    {"chunks", in},
                                    {"dtype", "<f8"},
                                    {"order", "C"},
                                    {"filters", nullptr},
                                    {"compressor", nullptr},
                                    {"fill_value", 0}}
                                   .dump());
    };
    for (const char* name : {"u", "v", "w"})
        array(name, {2, 2, 4097}, {2, 2, 64});
    array("x", {4097}, {1});
    const auto opened = ZarrDisk::open(root(), std::make_shared<core::PosixDisk>(), 1 << 20);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().message, "x lies in 4097 chunks, and coordinates may lie in 4096");
}

TEST_F(ZarrDiskTest, OneComponentAloneIsNoVelocity) {
    put("u/.zattrs", R"({"_ARRAY_DIMENSIONS": ["time", "z", "y", "x"]})");
    const auto none = ZarrDisk::open(root() / "u", std::make_shared<core::PosixDisk>(), 0);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, core::Error::Code::NotFound);
    EXPECT_EQ(none.error().hint, "there is one array with 4 axes, which is the root");
}

TEST_F(ZarrDiskTest, WhatIsNoZarrIsSaidToBeNone) {
    const auto none = ZarrDisk::open(folder_.path(), std::make_shared<core::PosixDisk>(), 0);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("holds no Zarr"), std::string::npos)
        << none.error().message;
    put(".zgroup", "[]");
    EXPECT_FALSE(ZarrDisk::open(root(), std::make_shared<core::PosixDisk>(), 0));
}

} // namespace wakesurf::server::zarr_disk_test
