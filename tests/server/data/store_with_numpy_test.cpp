// What store/README.md promises to people with numpy: its very lines are run on stores made here.
#include "core/base/crc32c.hpp"
#include "core/base/disk.hpp"
#include "server/data/child_process.hpp"
#include "store/store_generation.hpp"
#include "store/store_grid.hpp"
#include "store/store_manifest.hpp"
#include "store/store_reader.hpp"
#include "store/store_writer.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace wakesurf::server::store_with_numpy_test {
namespace {

namespace fs = std::filesystem;
using tests::read_file;
using tests::write_file;

constexpr const char* debian_python = "/usr/bin/python3"; // where python3-numpy puts its module

/// The code blocks of the Format section, in their order.
std::vector<std::string> snippets() {
    const std::string text = read_file(tests::source_folder() / "store" / "README.md");
    const auto begin = text.find("## Format");
    const auto end = text.find("\n## ", begin + 1);
    std::vector<std::string> blocks;
    constexpr std::string_view fence = "```python\n";
    for (auto at = text.find(fence, begin); at < end; at = text.find(fence, at)) {
        at += fence.size();
        blocks.push_back(text.substr(at, text.find("```", at) - at));
    }
    return blocks;
}

class StoreWithNumpy : public testing::Test {
  protected:
    void SetUp() override {
        const auto found = python("import numpy");
        ASSERT_EQ(found.first, 0) << debian_python << " has no numpy: install python3-numpy\n"
                                  << found.second;
        ASSERT_EQ(snippets().size(), 3u);
    }

    fs::path store() const { return folder_ / "store"; }

    /// Exit status and output of lines run in the store's folder.
    std::pair<int, std::string> python(const std::string& lines) const {
        fs::create_directories(store());
        write_file(folder_ / "lines.py",
                   "import os\nos.chdir(\"" + store().string() + "\")\n" + lines);
        std::string output;
        const auto run =
            run_child(debian_python, {folder_ / "lines.py"}, 0,
                      [&](std::string_view line) { output.append(line).append("\n"); }, {});
        if (!run)
            return {-1, run.error().message};
        return {run->exit_status, output + run->errors};
    }

    std::shared_ptr<const store::StoreReader> reader() const {
        const auto disk = std::make_shared<core::PosixDisk>();
        const auto manifest = store::read_store_manifest(store(), *disk).value();
        return store::StoreReader::open(store::store_layout(manifest, store()), disk).value();
    }

    tests::TemporaryFolder folder_;
};

/// What numpy prints of float32, told apart from its neighbours.
std::vector<float> numbers_in(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '[' || c == ']'; }, ' ');
    std::istringstream in(text);
    return {std::istream_iterator<float>(in), {}};
}

TEST_F(StoreWithNumpy, TheLinesForUniformGridsPrintAVelocity) {
    store::GenerateRequest request;
    request.flow = "abc";
    request.grid = {{0, 0, 0}, {0.1, 0.2, 0.3}, {9, 7, 5}};
    request.times = {0.25};
    ASSERT_TRUE(store::generate_store(request, store(), [](const store::ImportProgress&) {}, {}));
    const auto [status, output] = python(snippets()[0]);
    ASSERT_EQ(status, 0) << output;
    const auto step = reader()->load(0, {}).value();
    const float* middle = step->velocity().data() + 3 * ((2 * 7 + 3) * 9 + 4);
    const auto numbers = numbers_in(output);
    ASSERT_EQ(numbers.size(), 4u) << output;
    EXPECT_EQ(numbers[0], 0.25f);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(numbers[1 + i], middle[i], 1e-6f) << output;
}

TEST_F(StoreWithNumpy, TheLinesForCellMeshesPrintPositionsAndVelocitiesOfACell) {
    core::CellMesh mesh;
    mesh.points = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.cells = {{{1, 2, 3, 4}, {}, core::CellShape::Tetrahedron}};
    mesh.cells[0].beyond.fill(core::beyond_domain);
    auto writer = store::StoreWriter::open(store(), [] { return core::Result<void>(); }).value();
    store::StoreManifest manifest;
    for (const auto& file : store::grid_files(mesh))
        manifest.layout.checksums[file.name] = writer.write(file.name, file.bytes).value();
    const std::vector<float> velocity{0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    const auto sum = writer
                         .write(store::step_file_name("velocity", 0, core::Precision::Single),
                                std::as_bytes(std::span(velocity)))
                         .value();
    ASSERT_TRUE(writer.finish_step(0, {&sum, 1}));
    manifest.layout.grid = store::stored_grid(mesh);
    manifest.layout.times = manifest.info.times = {0.5};
    manifest.info.grid = core::GridKind::Unstructured;
    manifest.info.points = 5;
    manifest.info.cells = 1;
    manifest.info.bytes_per_step = 60;
    const std::string text = store::store_manifest_text(manifest);
    ASSERT_TRUE(writer.write("store.json", std::as_bytes(std::span(text))));
    EXPECT_EQ(reader()->load(0, {}).value()->velocity()[14], 12.0f) << "it is a store";

    const auto [status, output] = python(snippets()[1]);
    ASSERT_EQ(status, 0) << output;
    EXPECT_EQ(numbers_in(output), (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0,  0,  1, //
                                                      1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}))
        << output;
}

TEST_F(StoreWithNumpy, TheLinesForBricksPrintTheFirstNodeAndItsBricksChecksum) {
    store::GenerateRequest request;
    request.flow = "abc";
    request.grid = {{0, 0, 0}, {0.1, 0.2, 0.3}, {34, 33, 40}};
    request.times = {0.25};
    request.placement = store::StepPlacement::Bricks;
    ASSERT_TRUE(store::generate_store(request, store(), [](const store::ImportProgress&) {}, {}));
    const auto [status, output] = python(snippets()[2]);
    ASSERT_EQ(status, 0) << output;
    const auto step = reader()->load(0, {}).value();
    const auto numbers = numbers_in(output);
    ASSERT_EQ(numbers.size(), 4u) << output;
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(numbers[i], step->velocity()[i], 1e-6f) << output;
    std::vector<std::byte> brick(std::size_t{33} * 33 * 33 * 12);
    ASSERT_TRUE(core::PosixDisk().read(store() / "velocity_000000.f32", 0, brick));
    EXPECT_EQ(numbers[3], static_cast<float>(core::crc32c(brick, 0)));
}

} // namespace
} // namespace wakesurf::server::store_with_numpy_test
