// What is made of an importer's output, whatever else is printed between its own words.
#include "server/data/import_process.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace wakesurf::server::import_process_test {
namespace {

using core::Error;
namespace fs = std::filesystem;

class ImportProcess : public testing::Test {
  protected:
    // A program that does as the script says in the importer's place.
    ImportCommand with(const std::string& script) const {
        const fs::path program = folder_ / "importer";
        tests::write_file(program, "#!/bin/sh\n" + script + "\n");
        fs::permissions(program, fs::perms::owner_all);
        ImportCommand command{"source", "store", {}, {}, program};
        return command;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(ImportProcess, TellsTheImportersSentenceAndNothingThatLibrariesPrint) {
    const auto failed = run_import_process(with("echo 'wakesurf-import: u.cgns is damaged' >&2\n"
                                                "echo 'L,G_top,T_top,F,P,P,FD,E,SL,FL' >&2\n"
                                                "exit 1"),
                                           [](const store::ImportProgress&) {});
    EXPECT_EQ(failed.error().message, "u.cgns is damaged");
    EXPECT_EQ(failed.error().code, Error::Code::Corrupt);
    const auto silent = run_import_process(with("echo 'HDF5-DIAG: Error detected' >&2; exit 1"),
                                           [](const store::ImportProgress&) {});
    EXPECT_EQ(silent.error().message, "the importer failed and did not say why");
}

TEST_F(ImportProcess, TellsLibrariesWordsToWhoAsksForThemAlone) {
    auto command = with("echo \"library: a token\" >&2; echo \"wakesurf-import: $*\" >&2; exit 1");
    command.secrets = {"/state", "/token"};
    std::string told;
    command.library_words = [&](std::string_view words) { told = words; };
    const auto error = run_import_process(command, [](const store::ImportProgress&) {}).error();
    EXPECT_EQ(told, "a token");
    EXPECT_EQ(error.message.find("a token"), std::string::npos) << error.message;
    EXPECT_TRUE(
        error.message.starts_with("--told-to-others --secret=/state --secret=/token --parent="))
        << error.message;
}

TEST_F(ImportProcess, SaysWhatIsWrongBeforeItSaysThatTheFileMayStillBeWritten) {
    const fs::path file = folder_ / "run/10.5/U";
    fs::create_directories(file.parent_path());
    tests::write_file(file, "half");
    const auto error = [&](const std::string& words) {
        auto command = with("echo 'wakesurf-import: " + words + "' >&2; exit 1");
        command.source = folder_ / "run";
        return run_import_process(command, [](const store::ImportProgress&) {}).error();
    };
    const std::string words = "time-step 10.5 of run is damaged";
    const std::string may_grow = "10.5/U was changed less than 5 s ago";
    EXPECT_EQ(error(words).message, words) << "the cause comes first";
    EXPECT_TRUE(error(words).hint.starts_with(may_grow)) << error(words).hint;
    EXPECT_TRUE(error("10.5/U of run is not there").hint.starts_with(may_grow));
    EXPECT_EQ(error("0.5/U.gz of run is damaged").hint, "");
    EXPECT_EQ(error("10.5/U has no field p").hint, "");
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::minutes(1));
    EXPECT_EQ(error(words).message, words);
    EXPECT_EQ(error(words).hint, "");
}

TEST_F(ImportProcess, SaysWhatEndedTheImporterAndBlamesNoFile) {
    const auto ended =
        run_import_process(with("kill -SEGV $$"), [](const store::ImportProgress&) {});
    EXPECT_EQ(ended.error().message, "the importer was killed (signal 11)");
    EXPECT_EQ(ended.error().hint.find("damaged"), std::string::npos);
}

TEST_F(ImportProcess, PassesItsShareOfMemoryOn) {
    auto command = with("echo \"wakesurf-import: $*\" >&2; exit 1");
    const std::string parent = "--parent=" + std::to_string(::getpid());
    command.memory = 1'000'000;
    const auto failed = run_import_process(command, [](const store::ImportProgress&) {});
    EXPECT_EQ(failed.error().message, "--memory=1000000 " + parent + " -- source store");
    command.memory = 0;
    EXPECT_EQ(run_import_process(command, [](const store::ImportProgress&) {}).error().message,
              parent + " -- source store");
}

TEST_F(ImportProcess, HearsOnlyProgressOfWhatIsPrinted) {
    std::size_t heard = 0;
    const auto done = run_import_process(
        with("echo 'a warning of a library'\necho '{\"phase\":\"done\",\"done\":2,\"total\":2}'"),
        [&](const store::ImportProgress& progress) { heard += progress.done; });
    EXPECT_TRUE(done.has_value());
    EXPECT_EQ(heard, 2u);
}

TEST_F(ImportProcess, DoesNotKeepADescriptionWithoutEnd) {
    const auto endless =
        describe_with_import_process(with("line=$(head -c 500000 /dev/zero | tr '\\0' x)\n"
                                          "for i in $(seq 200); do echo $line; done"));
    EXPECT_EQ(endless.error().code, Error::Code::OverLimit);
}

} // namespace
} // namespace wakesurf::server::import_process_test
