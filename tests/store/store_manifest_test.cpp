#include "tests/support/sample_manifest.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::store::store_manifest_test {
namespace {

using nlohmann::json;
using tests::sample_manifest;

core::Error::Code error_of(const json& value) {
    const auto parsed = parse_store_manifest(value.dump());
    EXPECT_FALSE(parsed.has_value()) << value.dump();
    return parsed ? core::Error::Code::Cancelled : parsed.error().code;
}

/// Why a text is refused; empty of one that is read.
std::string refusal(const std::string& text) {
    const auto parsed = parse_store_manifest(text);
    return parsed ? std::string() : parsed.error().message;
}

TEST(StoreManifest, ReadsBackWhatItWrites) {
    const auto before = sample_manifest();
    const auto after = parse_store_manifest(store_manifest_text(before));
    ASSERT_TRUE(after.has_value()) << after.error().message;
    EXPECT_EQ(after->source, before.source);
    EXPECT_EQ(after->layout.times, before.layout.times);
    EXPECT_EQ(after->layout.precision, before.layout.precision);
    EXPECT_EQ(after->layout.scalars, before.layout.scalars);
    EXPECT_EQ(after->layout.mask, before.layout.mask);
    EXPECT_EQ(after->layout.walls, before.layout.walls);
    EXPECT_EQ(after->layout.checksums, before.layout.checksums);
    EXPECT_EQ(after->velocity_range, before.velocity_range);
    EXPECT_EQ(after->layout.grid.uniform.origin, before.layout.grid.uniform.origin);
    EXPECT_EQ(after->layout.grid.dimensions, before.layout.grid.dimensions);
    EXPECT_EQ(after->layout.grid.uniform.spacing, before.layout.grid.uniform.spacing);
    EXPECT_EQ(store_manifest_text(*after), store_manifest_text(before));
}

TEST(StoreManifest, ShortensWordsOfItsSourceAndLeavesOutFieldsWithNamesBeyondAnyUse) {
    auto before = sample_manifest();
    const std::string megabyte(1 << 20, 'u');
    before.info.length_unit = before.info.time_unit = before.info.note = before.info.why =
        before.info.reader = megabyte;
    before.info.fields.push_back({std::string(256, 'n'), 1, {}, {0, 1}, megabyte});
    before.info.fields.push_back({megabyte, 1, {}, {0, 1}, "m"});
    const auto after = parse_store_manifest(store_manifest_text(before));
    ASSERT_TRUE(after.has_value()) << after.error().message;
    EXPECT_EQ(after->info.length_unit, std::string(32, 'u'));
    EXPECT_EQ(after->info.time_unit, std::string(32, 'u'));
    EXPECT_EQ(after->info.note.size(), 4096u);
    EXPECT_EQ(after->info.why.size(), 4096u);
    EXPECT_EQ(after->info.reader.size(), 256u);
    ASSERT_EQ(after->info.fields.size(), before.info.fields.size() - 1);
    EXPECT_EQ(after->info.fields.back().name, std::string(256, 'n'));
    EXPECT_EQ(after->info.fields.back().unit, std::string(32, 'u'));
}

TEST(StoreManifest, WritesOutWhatActsOrCannotBeSeenInNames) {
    auto before = sample_manifest();
    const std::string turned = "p\xe2\x80\xae\x1b[2J";
    before.info.name = before.info.note = turned;
    before.info.velocity = "U" + turned;
    ASSERT_FALSE(before.layout.scalars.empty());
    before.layout.scalars.front().name = turned;
    before.info.fields = {{"U" + turned, 3, {}, {0, 1}, turned}, {turned, 1, {}, {0, 1}, "m"}};
    const auto after = parse_store_manifest(store_manifest_text(before));
    ASSERT_TRUE(after.has_value()) << after.error().message;
    EXPECT_EQ(after->info.name, "p[2J");
    EXPECT_EQ(after->info.note, "p[2J");
    EXPECT_EQ(after->info.velocity, "Up\\u202e\\u001b[2J");
    EXPECT_EQ(after->info.fields.front().name, after->info.velocity);
    EXPECT_EQ(after->info.fields.front().unit, "p[2J");
    EXPECT_EQ(after->layout.scalars.front().name, "p\\u202e\\u001b[2J");
    EXPECT_TRUE(after->info.fields.back().stored) << "it is found by that name";
}

TEST(StoreManifest, ReadsBackEveryKindOfGrid) {
    auto before = sample_manifest();
    before.info.grid = core::GridKind::Rectilinear;
    before.layout.grid = {core::GridKind::Rectilinear, {}, {3, 4, 5}};
    auto after = parse_store_manifest(store_manifest_text(before));
    ASSERT_TRUE(after.has_value()) << after.error().message;
    EXPECT_EQ(after->layout.grid.kind, core::GridKind::Rectilinear);
    EXPECT_EQ(after->layout.grid.dimensions, before.layout.grid.dimensions);
    for (const auto kind : {core::GridKind::Curvilinear, core::GridKind::Unstructured}) {
        before.info.grid = kind;
        before.layout.grid = {kind, {}, {}, 60, 24};
        after = parse_store_manifest(store_manifest_text(before));
        ASSERT_TRUE(after.has_value()) << after.error().message;
        EXPECT_EQ(after->layout.grid.kind, kind);
        EXPECT_EQ(after->layout.grid.points, 60u);
        EXPECT_EQ(after->layout.grid.cells, 24u);
    }
}

TEST(StoreManifest, KeepsTheAxesAlongWhichTheFlowRepeats) {
    auto manifest = sample_manifest();
    EXPECT_EQ(store_manifest_text(manifest).find("periodic"), std::string::npos);
    manifest.info.periodic = manifest.layout.grid.periodic = {true, false, true};
    const auto back = parse_store_manifest(store_manifest_text(manifest));
    ASSERT_TRUE(back.has_value()) << back.error().message;
    EXPECT_EQ(back->info.periodic, manifest.info.periodic);
    EXPECT_EQ(back->layout.grid.periodic, manifest.info.periodic);
    manifest.info.periodic[0] = false;
    EXPECT_FALSE(parse_store_manifest(store_manifest_text(manifest)).has_value());
}

TEST(StoreManifest, IsOfVersion3WhereTimeStepsLieInBricksAndOnlyThere) {
    auto before = sample_manifest();
    EXPECT_EQ(json::parse(store_manifest_text(before))["version"], 2);
    before.layout.brick_cells = 32;
    const std::string text = store_manifest_text(before);
    EXPECT_EQ(json::parse(text)["version"], 3);
    const auto after = parse_store_manifest(text);
    ASSERT_TRUE(after.has_value()) << after.error().message;
    EXPECT_EQ(after->layout.brick_cells, 32u);
    EXPECT_EQ(store_manifest_text(*after), text);
    json older = json::parse(text);
    older["version"] = 2;
    EXPECT_EQ(error_of(older), core::Error::Code::Corrupt);
    json largest = json::parse(text);
    largest["bricks"] = json{{"cells", 128}};
    EXPECT_TRUE(parse_store_manifest(largest.dump()));
    for (const json& bricks : {json(32), json::object(), json{{"cells", 0}}, json{{"cells", 33}},
                               json{{"cells", 256}}, json{{"cells", -32}}, json{{"cells", "32"}}}) {
        json wrong = json::parse(text);
        wrong["bricks"] = bricks;
        EXPECT_EQ(error_of(wrong), core::Error::Code::Corrupt) << bricks;
    }
    before.info.grid = core::GridKind::Unstructured;
    before.layout.grid = {core::GridKind::Unstructured, {}, {}, 60, 24};
    EXPECT_EQ(parse_store_manifest(store_manifest_text(before)).error().message,
              "store.json: a mesh of cells does not lie in bricks");
}

TEST(StoreManifest, RefusesTextCutAnywhere) {
    const std::string whole = store_manifest_text(sample_manifest());
    for (std::size_t size = 0; size < whole.size(); size += 3)
        EXPECT_TRUE(refusal(whole.substr(0, size))
                        .starts_with("store.json: the text is not valid JSON from byte "))
            << size << ": " << refusal(whole.substr(0, size));
}

TEST(StoreManifest, WithAByteChangedIsRefusedOrAgreesWithItself) {
    const std::string whole = store_manifest_text(sample_manifest());
    std::size_t refused = 0, read = 0;
    for (std::size_t at = 0; at < whole.size(); at += 5)
        for (const char c : {'0', '9', '"', '[', '\xff'}) {
            std::string changed = whole;
            changed[at] = c;
            const auto parsed = parse_store_manifest(changed);
            if (!parsed) {
                ++refused;
                EXPECT_EQ(parsed.error().hint, "import the dataset again") << changed;
                continue;
            }
            ++read;
            const auto& [info, layout] = std::tie(parsed->info, parsed->layout);
            EXPECT_EQ(info.points, layout.grid.nodes());
            EXPECT_EQ(info.bytes_per_step, layout.grid.nodes() * 12);
            EXPECT_EQ(info.times, layout.times);
            EXPECT_EQ(info.bounds.lo, layout.grid.uniform.bounds().lo);
            EXPECT_EQ(info.bounds.hi, layout.grid.uniform.bounds().hi);
        }
    EXPECT_GT(refused, read);
    EXPECT_GT(read, 100u); // names, checksums, spaces between members
}

TEST(StoreManifest, RefusesPartsThatDisagree) {
    using Code = core::Error::Code;
    const json good = json::parse(store_manifest_text(sample_manifest()));
    const auto with = [&](const char* pointer, const json& value) {
        json changed = good;
        changed[json::json_pointer(pointer)] = value;
        return error_of(changed);
    };
    EXPECT_EQ(with("/times", {0.5}), Code::Corrupt);
    EXPECT_EQ(with("/info/points", 61), Code::Corrupt);
    EXPECT_EQ(with("/info/bytesPerStep", 719), Code::Corrupt);
    EXPECT_EQ(with("/grid/dimensions", {3, 4, 6}), Code::Corrupt);
    EXPECT_EQ(with("/grid/dimensions", {1, 4, 6}), Code::Corrupt);
    EXPECT_EQ(with("/grid/dimensions", {4294967295, 4294967295, 4294967295}), Code::Corrupt);
    EXPECT_EQ(with("/grid/spacing", {0, 1, 1}), Code::Corrupt);
    EXPECT_EQ(with("/grid/origin", {1e300, 0, 0}), Code::Corrupt);
    EXPECT_EQ(with("/info/bounds", {0, 1, 0, 1, 0, 1}), Code::Corrupt);
    EXPECT_EQ(with("/mask", "mask.u8"), Code::Corrupt);
    EXPECT_EQ(with("/precision", "double"), Code::Corrupt);
    EXPECT_EQ(with("/checksums/mask.u8", 4294967296), Code::Corrupt);
    EXPECT_EQ(with("/source/steps", json::array({json::array()})), Code::Corrupt);
    EXPECT_EQ(with("/grid/kind", "rectilinear"), Code::Corrupt);
    EXPECT_EQ(with("/grid/kind", "analytic"), Code::Corrupt);
    EXPECT_EQ(with("/grid/kind", "hexagonal"), Code::Corrupt);
    for (const char* stem : {"../../etc/passwd", "", "velocity", "a/b", "a_000000", "P"})
        EXPECT_EQ(with("/scalars/0/stem", stem), Code::Corrupt) << stem;
    EXPECT_EQ(with("/format", "something"), Code::Corrupt);
    EXPECT_EQ(with("/version", 1), Code::Unsupported);
    EXPECT_EQ(with("/version", 3), Code::Corrupt) << "time-steps are whole";
    EXPECT_EQ(with("/version", 4), Code::Unsupported);
    EXPECT_EQ(with("/source/files/0/size", -1), Code::Corrupt);
    EXPECT_EQ(error_of(json::array()), Code::Corrupt);
    EXPECT_EQ(parse_store_manifest(std::string(100'000, '[')).error().code, Code::OverLimit);
}

TEST(StoreManifest, IsReadFromItsFolder) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(read_store_manifest(folder.path(), core::PosixDisk()).error().code,
              core::Error::Code::NotFound);
    tests::write_file(folder / manifest_file_name, store_manifest_text(sample_manifest()));
    const auto manifest = read_store_manifest(folder.path(), core::PosixDisk());
    ASSERT_TRUE(manifest.has_value()) << manifest.error().message;
    const auto layout = store_layout(*manifest, folder.path());
    EXPECT_EQ(layout.folder, folder.path());
    EXPECT_EQ(layout.times, manifest->layout.times);
    EXPECT_TRUE(layout.mask);
}

} // namespace
} // namespace wakesurf::store::store_manifest_test
