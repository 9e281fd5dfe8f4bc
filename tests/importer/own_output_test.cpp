// The importer's own words on descriptors of their own: nothing a library prints gets among them.
#include "importer/base/library_messages.hpp"
#include "tests/importer/cgns_files.hpp"
#include "tests/importer/import_fixture.hpp"
#include "tests/support/programs.hpp"

#include <sys/wait.h>

namespace wakesurf::importer::own_output_test {
namespace {

// What a process writes to standard output and standard error while it has taken them over.
std::array<std::string, 2> printed_with_own_output(bool show_libraries) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const std::string errors = folder / "errors";
    const pid_t process = ::fork();
    if (process == 0) {
        (void)std::freopen(out.c_str(), "w", stdout);
        (void)std::freopen(errors.c_str(), "w", stderr);
        const OwnOutput own = take_outputs(show_libraries);
        std::printf("a library's warning\n");
        std::fprintf(stderr, "a library's error\n");
        std::fputs("{\"phase\":\"done\"}\n", own.results);
        std::fputs("wakesurf-import: a sentence\n", own.errors);
        std::fflush(nullptr);
        ::_exit(0);
    }
    ::waitpid(process, nullptr, 0);
    return {read_file(out), read_file(errors)};
}

TEST(OwnOutput, HoldsOnlyWhatTheImporterSays) {
    const auto [out, errors] = printed_with_own_output(false);
    EXPECT_EQ(out, "{\"phase\":\"done\"}\n");
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_EQ(errors, "wakesurf-import: a sentence\n");
#endif
}

TEST(OwnOutput, ShowsLibrariesOnStandardErrorWhereThatIsWanted) {
    const auto [out, errors] = printed_with_own_output(true);
    EXPECT_EQ(out, "{\"phase\":\"done\"}\n");
    EXPECT_NE(errors.find("a library's warning\n"), std::string::npos);
    EXPECT_NE(errors.find("a library's error\n"), std::string::npos);
    EXPECT_NE(errors.find("wakesurf-import: a sentence\n"), std::string::npos);
}

// The CGNS library prints a warning to standard output about files of newer versions.
TEST_F(Import, DescribesAndConvertsCgnsFilesThatTheLibraryWarnsOf) {
    for (const float version : {4.2f, 4.4f, 4.5f}) {
        Contents contents;
        contents.adf = true; // without the checksums of HDF5, so that a number can be changed
        contents.version = version;
        write_cgns(folder_ / "new.cgns", contents);
        const auto info = describe_with_import_process(
            {folder_ / "new.cgns", {}, {}, {}, tests::importer_program()});
        ASSERT_TRUE(info.has_value()) << version << ": " << info.error().message;
        EXPECT_EQ(info->times.size(), 3u);
        const auto outcome = run("new.cgns");
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        for (const auto& line : outcome.lines)
            EXPECT_TRUE(store::parse_progress_line(line).has_value()) << line;
        fs::remove_all(store());
    }
}

} // namespace
} // namespace wakesurf::importer::own_output_test
