// `wakesurf generate` as its user meets it: a process with an exit status, messages and a store.
#include "core/field/analytic_flow.hpp"
#include "server/data/child_process.hpp"
#include "store/store_manifest.hpp"
#include "store/store_reader.hpp"
#include "tests/support/mask_bytes.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/server/running_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>

#include <algorithm>
#include <filesystem>

namespace wakesurf::server::generate_command_test {

namespace {

namespace fs = std::filesystem;
using tests::read_file;
using tests::RunningProgram;
using tests::write_file;

struct Outcome {
    int status = -1;
    std::string errors;
    std::string output;
};

Outcome wakesurf(const std::vector<std::string>& arguments) {
    Outcome out;
    const auto line = [&](std::string_view text) { out.output.append(text).append("\n"); };
    const auto run = run_child(tests::server_program(), arguments, 0, line, {});
    EXPECT_TRUE(run) << run.error().message;
    out.status = run->exit_status;
    out.errors = run->errors;
    return out;
}

class GenerateCommand : public testing::Test {
  protected:
    fs::path store() const { return folder_ / "store"; }

    Outcome run(const std::string& flow, std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"generate", flow, store()});
        return wakesurf(more);
    }

    store::StoreManifest manifest() const {
        return store::read_store_manifest(store(), core::PosixDisk()).value();
    }

    std::vector<std::string> names() const {
        std::vector<std::string> out;
        for (const auto& entry : fs::directory_iterator(store()))
            out.push_back(entry.path().filename());
        std::sort(out.begin(), out.end());
        return out;
    }

    void refuses(const std::string& flow,
                 const std::vector<std::string>& more,
                 int status,
                 const std::string& part) const {
        const auto outcome = run(flow, more);
        EXPECT_EQ(outcome.status, status) << part;
        EXPECT_TRUE(holds(outcome.errors, part));
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
        EXPECT_FALSE(fs::exists(store())) << part;
    }

    tests::TemporaryFolder folder_;
};

/// Of 48 MB a time-step, so that it is certainly still running when it is stopped.
std::string large(const fs::path& store) {
    return "generate abc " + store.string() + " --grid 200,200,100 --times 0:1:3";
}

} // namespace

TEST_F(GenerateCommand, WritesWhatTheFlowSaysAtEveryNodeAndTime) {
    const auto outcome =
        run("flow:oscillating?a=2", {"--grid", "9,5,7", "--times", "1:3:5", "--parameters", "u=3"});
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto store_manifest = manifest();
    EXPECT_TRUE(store_manifest.complete);
    EXPECT_EQ(store_manifest.layout.times, (std::vector<double>{1, 1.5, 2, 2.5, 3}));
    const auto reader = store::StoreReader::open(store::store_layout(store_manifest, store()),
                                                 std::make_shared<core::PosixDisk>());
    ASSERT_TRUE(reader);
    const auto flow = *core::make_analytic_flow("oscillating?a=2,u=3");
    double fastest = 0.0;
    for (std::size_t step = 0; step < 5; ++step) {
        const auto loaded = (*reader)->load(step, {});
        ASSERT_TRUE(loaded);
        const auto bytes = (*loaded)->slab.bytes();
        ASSERT_EQ(bytes.size(), 9U * 5 * 7 * 12);
        const auto* velocity = reinterpret_cast<const float*>(bytes.data());
        const core::Vec3 middle(0.0);
        core::Vec3 expected;
        ASSERT_TRUE(flow->sample({&middle, 1}, {&store_manifest.layout.times[step], 1},
                                 {&expected, 1}, {}));
        const std::size_t node = 3U * ((3 * 5 + 2) * 9 + 4);
        EXPECT_EQ(velocity[node], static_cast<float>(expected.x));
        EXPECT_EQ(velocity[node + 1], static_cast<float>(expected.y));
        fastest = std::max(fastest, glm::length(expected));
    }
    EXPECT_NEAR(store_manifest.velocity_range[1], fastest, 1e-6);
    EXPECT_EQ(store_manifest.info.fields.front().range, store_manifest.velocity_range);
}

TEST_F(GenerateCommand, MakesAStoreThatInfoAndSurfaceOpenAtOnce) {
    ASSERT_EQ(run("cylinder", {"--grid", "61,41,11"}).status, 0);
    EXPECT_EQ(names(), (std::vector<std::string>{"checksums.u32", "mask.u8", "store.json",
                                                 "store.lock", "velocity_000000.f32"}));
    const auto info = wakesurf({"info", store(), "--json"});
    ASSERT_EQ(info.status, 0) << info.errors;
    const auto description = nlohmann::json::parse(info.output);
    EXPECT_EQ(description["grid"], "uniform");
    EXPECT_EQ(description["obstacle"], true);
    EXPECT_EQ(description["steady"], true);
    EXPECT_EQ(description["points"], 61 * 41 * 11);
    EXPECT_EQ(description["bounds"], nlohmann::json::parse("[-5.0,10.0,-5.0,5.0,-5.0,5.0]"));
    const auto surface = wakesurf({"surface", store(), "--kind", "stream", "--rake",
                                   "-4,0.3,-4 -4,0.3,2", "--to", "5", "-o", folder_ / "out.vtp"});
    EXPECT_EQ(surface.status, 0) << surface.errors;
}

TEST_F(GenerateCommand, LaysTimeStepsInBricksWhereAskedToWithTheSameValues) {
    const std::vector<std::string> grid{"--grid", "61,41,37", "--layout"};
    const auto with = [&](const std::string& layout) {
        auto all = grid;
        all.push_back(layout);
        return all;
    };
    ASSERT_EQ(run("cylinder", with("bricks")).status, 0);
    EXPECT_EQ(names(),
              (std::vector<std::string>{"checksums.u32", "mask.u8", "store.json", "store.lock",
                                        "velocity_000000.bricks", "velocity_000000.f32"}));
    EXPECT_EQ(manifest().layout.brick_cells, 32U);
    const auto info = wakesurf({"info", store()});
    EXPECT_TRUE(holds(info.output, "  stored    bricks of 32 cells\n"));
    EXPECT_TRUE(holds(info.output, "  served    whole time-steps: "))
        << "they fit: " << info.output;
    const auto described = nlohmann::json::parse(wakesurf({"info", store(), "--json"}).output);
    EXPECT_EQ(described["stored"], "bricks of 32 cells");
    EXPECT_EQ(described["served"]["by"], "timeStep");
    const auto open = [&] {
        return store::StoreReader::open(store::store_layout(manifest(), store()),
                                        std::make_shared<core::PosixDisk>())
            .value();
    };
    const auto bricks = open();
    const auto paged = bricks->load(0, {}).value();
    EXPECT_TRUE(holds(run("cylinder", with("bricks")).output, "up to date"));
    EXPECT_TRUE(holds(run("cylinder", with("auto")).output, "up to date"))
        << "what was begun so goes on so";
    EXPECT_EQ(run("cylinder", with("whole")).status, 1) << "that is another store";
    fs::remove(store() / "velocity_000000.bricks");
    ASSERT_EQ(run("cylinder", with("bricks")).status, 0);
    EXPECT_TRUE(open()->whole(0));
    fs::remove_all(store());
    ASSERT_EQ(run("cylinder", with("auto")).status, 0);
    EXPECT_EQ(manifest().layout.brick_cells, 0U) << "less than 1 GiB a time-step";
    EXPECT_TRUE(holds(wakesurf({"info", store()}).output, "  stored    whole time-steps\n"));
    const auto whole = open();
    const std::size_t nodes = core::node_count(whole->grid());
    EXPECT_EQ(tests::mask_bytes(whole->mask(), nodes), tests::mask_bytes(bricks->mask(), nodes));
    const auto flat = whole->load(0, {}).value();
    EXPECT_TRUE(std::ranges::equal(flat->slab.bytes(), paged->slab.bytes()));
}

TEST_F(GenerateCommand, InfoTellsTimesApartHoweverLate) {
    ASSERT_EQ(run("abc", {"--grid", "8,8,8", "--times", "1000000000:1000000000.5:2"}).status, 0);
    const auto info = wakesurf({"info", store()});
    EXPECT_TRUE(holds(info.output, "2 from 1000000000 to 1000000000.5"));
}

TEST_F(GenerateCommand, UsesTheFlowsOwnTimesAndTellsEveryTimeStep) {
    const auto outcome = run("double-gyre", {"--grid", "4,4,4"});
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(manifest().layout.times.size(), 21U);
    EXPECT_EQ(manifest().layout.times.back(), 10.0);
    EXPECT_TRUE(holds(outcome.output, "generate: 7 of 21, velocity_000006.f32\n"));
    EXPECT_TRUE(holds(outcome.output, "21 time-steps of 4 x 4 x 4 nodes"));
}

TEST_F(GenerateCommand, DoesNothingWhereTheSameStoreIsThereAlready) {
    ASSERT_EQ(run("abc", {"--grid", "8,8,8"}).status, 0);
    const auto before = fs::last_write_time(store() / "velocity_000000.f32");
    const auto again = run("abc", {"--grid", "8,8,8"});
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_TRUE(holds(again.output, "up to date"));
    EXPECT_EQ(fs::last_write_time(store() / "velocity_000000.f32"), before);
}

TEST_F(GenerateCommand, TouchesNoFolderOfSomethingElse) {
    ASSERT_EQ(run("abc", {"--grid", "8,8,8"}).status, 0);
    const auto other = run("abc", {"--grid", "8,8,9"});
    EXPECT_EQ(other.status, 1);
    EXPECT_TRUE(holds(other.errors, "a different store"));
    EXPECT_EQ(manifest().layout.grid.uniform.dimensions[2], 8U);
    fs::remove_all(store());
    fs::create_directory(store());
    write_file(store() / "thesis.tex", "text");
    const auto thesis = run("abc", {"--grid", "8,8,8"});
    EXPECT_EQ(thesis.status, 1);
    EXPECT_TRUE(holds(thesis.errors, "thesis.tex"));
    EXPECT_EQ(names(), std::vector<std::string>{"thesis.tex"});
}

TEST_F(GenerateCommand, RefusesBeforeItWritesAnything) {
    refuses("abc", {"--grid", "1,8,8"}, 2, "--grid");
    refuses("abc", {"--grid", "8,8"}, 2, "--grid");
    refuses("abc", {"--grid", "8,8,-8"}, 2, "--grid");
    refuses("abc", {"--grid", "4000000000,4000000000,4000000000"}, 2, "--grid");
    refuses("abc", {"--times", "0:1"}, 2, "--times");
    refuses("abc", {"--layout", "columns"}, 2, "--layout");
    refuses("abc", {"--times", "1:0:3"}, 2, "--times");
    refuses("abc", {"--times", "0:nan:3"}, 2, "--times");
    refuses("abc", {"--times", "0:1:1000000000"}, 2, "--times");
    refuses("abc", {"--parameters", "Q=1"}, 2, "Q=1");
    refuses("nothing", {}, 1, "lamb-oseen");
    refuses("abc", {"--grid", "100000,100000,1000"}, 1, "GB");
}

TEST_F(GenerateCommand, StopsAtASignalAndGoesOnLaterToTheSameBytes) {
    RunningProgram generate(large(store()));
    EXPECT_TRUE(holds(generate.line(), "generate: 1 of 3"));
    const auto [status, words] = generate.stop(SIGINT);
    EXPECT_EQ(status, 1);
    EXPECT_TRUE(holds(words, "run the same command again"));
    for (const auto& name : names())
        EXPECT_FALSE(name.ends_with(".part")) << name;
    EXPECT_FALSE(manifest().complete);
    EXPECT_EQ(wakesurf({"info", store()}).status, 0) << "from its first time-step on it is a store";

    const auto first = fs::last_write_time(store() / "velocity_000000.f32");
    const std::vector<std::string> same{"--grid", "200,200,100", "--times", "0:1:3"};
    ASSERT_EQ(run("abc", same).status, 0);
    EXPECT_TRUE(manifest().complete);
    EXPECT_EQ(fs::last_write_time(store() / "velocity_000000.f32"), first);
    EXPECT_EQ(read_file(store() / "velocity_000002.f32"),
              read_file(store() / "velocity_000000.f32"))
        << "the flow is steady";
}

TEST_F(GenerateCommand, RefusesAFolderThatAnotherOneIsWriting) {
    RunningProgram generate(large(store()));
    EXPECT_TRUE(holds(generate.line(), "generate: 1 of 3"));
    const auto second = run("abc", {"--grid", "200,200,100", "--times", "0:1:3"});
    EXPECT_EQ(second.status, 1);
    EXPECT_TRUE(holds(second.errors, "another program"));
    EXPECT_EQ(generate.stop(SIGTERM).status, 1);
}

} // namespace wakesurf::server::generate_command_test
