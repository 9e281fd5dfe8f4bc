// `wakesurf verify` as its user meets it: what it says of files, and its exit status.
#include "server/data/child_process.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/value_of.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server::verify_command_test {

namespace {

struct Told {
    int status = -1;
    std::string words; ///< of both streams
};

class VerifyCommand : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    static Told run(const std::vector<std::string>& arguments) {
        Told told;
        const auto outcome =
            run_child(tests::server_program(), arguments, 0,
                      [&](std::string_view line) { (told.words += line) += '\n'; }, {});
        if (outcome) {
            told.status = outcome->exit_status;
            told.words += outcome->errors;
        }
        return told;
    }

    /// Writes a small stream surface.
    std::string surface(const std::string& data, const std::string& name) const {
        const auto told =
            run({"surface", data, "--kind", "stream", "--rake", "0.4,0.4,0.3 0.6,0.6,0.3", "--to",
                 "2", "--separation", "0.1", "-o", path(name)});
        EXPECT_EQ(told.status, 0) << told.words;
        return path(name);
    }

    static bool viewer_is_built() {
        return std::filesystem::exists(
            std::filesystem::path(tests::server_program()).parent_path() /
            "../../../web-client/dist/animation.html");
    }

    /// Writes an animation of it.
    std::string animation(const std::string& data, const std::string& name) const {
        const auto told =
            run({"surface", data, "--kind", "stream", "--rake", "0.4,0.4,0.3 0.6,0.6,0.3", "--to",
                 "2", "--separation", "0.1", "--times", "0:2:0.5", "-o", path(name)});
        EXPECT_EQ(told.status, 0) << told.words;
        return path(name);
    }

    static std::string text_of(const std::string& file) {
        std::ifstream stream(file, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    }

    /// Samples the tornado at so many times.
    std::string store(const std::string& name, int times) const {
        const std::string list = fmt::format("0:{}:{}", times - 1, times);
        const auto told =
            run({"generate", "tornado", path(name), "--grid", "12,12,12", "--times", list});
        EXPECT_EQ(told.status, 0) << told.words;
        return path(name);
    }

    void change(const std::string& file, std::size_t at) const {
        std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
        stream.seekg(static_cast<std::streamoff>(at));
        const auto byte = static_cast<char>(stream.get() ^ 1);
        stream.seekp(static_cast<std::streamoff>(at));
        stream.put(byte);
    }

    static void tells(const Told& told, int status, const std::string& words) {
        EXPECT_EQ(told.status, status) << told.words;
        EXPECT_TRUE(holds(told.words, words));
    }

  private:
    tests::TemporaryFolder folder_;
};

} // namespace

TEST_F(VerifyCommand, MakesTheSurfaceOfABuiltInFlowAgainAndFindsTheSameBytes) {
    for (const char* name : {"a.vtp", "a.glb", "a.ply", "a.obj", "a.drc"})
        tells(run({"verify", surface("flow:tornado", name)}), 0, "verified: the same");
}

TEST_F(VerifyCommand, NamesTheVertexOfWhichOneByteIsAnother) {
    const std::string file = surface("flow:tornado", "a.ply");
    change(file, std::filesystem::file_size(file) / 2);
    const auto told = run({"verify", file});
    tells(told, 1, " instead of ");
    tells(told, 1, " of vertex ");
    tells(told, 1, "the file has been changed since");
}

TEST_F(VerifyCommand, MakesAnAnimationAgainAndNamesWhatDiffersInIt) {
    if (!viewer_is_built())
        GTEST_SKIP() << "without the built web client";
    const std::string file = animation("flow:tornado", "a.html");
    tells(run({"verify", file}), 0, "verified: the same");
    const std::string text = text_of(file);
    change(file, text.find("id=\"frames\">") + 2000);
    tells(run({"verify", file}), 1, "differs: the surface differs, in frame ");
    tells(run({"verify", file}), 1, "the file has been changed since");
    std::ofstream(file, std::ios::binary) << text;
    change(file, text.find("\"title\":\"") + 9);
    tells(run({"verify", file}), 1, "differs: its description differs in `title`");
    std::ofstream(file, std::ios::binary) << text;
    change(file, text.size() - 40);
    tells(run({"verify", file}), 1, "differs: its viewer differs, at byte ");
}

TEST_F(VerifyCommand, KnowsTheDataOfAnAnimation) {
    if (!viewer_is_built())
        GTEST_SKIP() << "without the built web client";
    const std::string data = store("data", 4);
    const std::string file = animation(data, "a.html");
    tells(run({"verify", file}), 2, "name the data: wakesurf verify " + file + " DATA");
    tells(run({"verify", file, data}), 0, "verified");
    run({"generate", "tornado", path("later"), "--grid", "12,12,12", "--times", "0.5:3.5:4"});
    tells(run({"verify", file, path("later")}), 1, "from the first time-step on");
}

TEST_F(VerifyCommand, NeedsTheDataOfAFileToBeNamedUnlessTheyAreABuiltInFlow) {
    const std::string data = store("data", 4);
    const std::string file = surface(data, "a.vtp");
    tells(run({"verify", file}), 2, "name the data: wakesurf verify " + file + " DATA");
    tells(run({"verify", file, data}), 0, "verified");
    std::filesystem::rename(data, path("elsewhere"));
    tells(run({"verify", file, path("elsewhere")}), 0, "verified");
}

TEST_F(VerifyCommand, TellsOtherDataFromThoseOfTheFile) {
    const std::string file = surface(store("data", 4), "a.vtp");
    tells(run({"verify", file, "flow:tornado"}), 1,
          "the data differ: the file was made from stored data");
    run({"generate", "tornado", path("finer"), "--grid", "13,12,12", "--times", "0:3:4"});
    tells(run({"verify", file, path("finer")}), 1, "the data differ: they have another grid");
    run({"generate", "tornado", path("later"), "--grid", "12,12,12", "--times", "0.5:3.5:4"});
    tells(run({"verify", file, path("later")}), 1, "from the first time-step on");
    tells(run({"verify", surface("flow:abc", "b.vtp"), "flow:tornado"}), 1,
          "the file was made from flow:abc, not from flow:tornado");
}

TEST_F(VerifyCommand, TakesASeriesThatHasGrownForTheSameData) {
    const std::string file = surface(store("data", 4), "a.vtp");
    tells(run({"verify", file, store("grown", 7)}), 0, "verified");
}

TEST_F(VerifyCommand, RefusesAFileWithoutARecipe) {
    std::ofstream(path("old.obj")) << "v 0 0 0\n";
    tells(run({"verify", path("old.obj")}), 2, "has no recipe");
    tells(run({"verify", path("none.vtp")}), 1, "cannot read");
    tells(run({"verify", path("")}), 1, "cannot read");
}

TEST_F(VerifyCommand, SaysThatARecipeIsDamaged) {
    const std::string file = surface("flow:tornado", "a.obj");
    change(file, 200);
    tells(run({"verify", file}), 1, "its recipe is damaged");
}

} // namespace wakesurf::server::verify_command_test
