// Messages of libraries as people see them: without folders, addresses and places in source files.
#include "importer/base/library_messages.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <vector>

namespace wakesurf::importer::library_messages_test {
namespace {

TEST(LibraryMessages, NameFilesWithoutTheirFolders) {
    const auto cleaned = [](const std::string& text) {
        return without_folders(text, {"/srv/runs of may/case", "runs/relative"});
    };
    EXPECT_EQ(cleaned("cannot open /home/ada/data/u_1.vti"), "cannot open u_1.vti");
    EXPECT_EQ(cleaned("for file: /home/ada/noise.vtk"), "for file: noise.vtk");
    EXPECT_EQ(cleaned("in the CGNS file '/srv/x/generated.cgns'."),
              "in the CGNS file 'generated.cgns'.");
    EXPECT_EQ(cleaned("(/a/b.nc), [/c/d.nc] and \"/e/f.nc\""), "(b.nc), [d.nc] and \"f.nc\"");
    EXPECT_EQ(cleaned("path=/a/b/c.nc;/d/e"), "path=c.nc;e");
    EXPECT_EQ(cleaned("open of /srv/runs of may/case/0.5/U failed"), "open of 0.5/U failed");
    EXPECT_EQ(cleaned("runs/relative/u.vti is empty"), "u.vti is empty");
    EXPECT_EQ(cleaned("/home/ada/folder/ is empty"), "folder/ is empty");
}

TEST(LibraryMessages, LeaveWhatIsNoPathAlone) {
    for (const char* text : {"u is in m/s and k in m2/s2", "the sizes 3/4 and u/v",
                             "Momentum / Density", "time folder 0.5/U", "either/or", "a / b"})
        EXPECT_EQ(without_folders(text, {}), text);
}

TEST(LibraryMessages, MakeOneSentenceOfALibrarysMessage) {
    EXPECT_EQ(
        sentence_of_library("ERROR: In ./IO/XML/vtkXMLReader.cxx, line 501\n"
                            "vtkXMLImageDataReader (0x55fb3a): Error opening file /a/b.vti\n\n"),
        "Error opening file b.vti");
    EXPECT_EQ(sentence_of_library("Generic Warning: In ./IO/CGNS/vtkCGNSReader.cxx, line 819\n"
                                  "Solution \"F\" is missing.\n\n"),
              "Solution \"F\" is missing");
    EXPECT_EQ(sentence_of_library("ERROR: In ./Common/ExecutionModel/vtkExecutive.cxx, line 753\n"
                                  "vtkCompositeDataPipeline (0x55fb): Algorithm "
                                  "vtkXMLImageDataReader(0x55fc) returned failure for request: "
                                  "vtkInformation (0x55fd)\n  Debug: Off\n"),
              "");
    EXPECT_EQ(sentence_of_library(std::string(1000, 'x')).size(), 200u);
}

TEST(FailureWords, AreSentencesAboutTheFile) {
    std::string unexpected;
    try {
        std::vector<int> values;
        values.resize(values.max_size() + 1);
    } catch (const std::exception& error) {
        unexpected = error_of(error, "a.vtu").message;
    }
    EXPECT_EQ(unexpected, "a.vtu contains an impossible size or number");
    EXPECT_EQ(error_of(std::bad_alloc(), "a.vtu").code, core::Error::Code::OverLimit);
    EXPECT_EQ(error_of(std::bad_alloc(), "a.vtu").message,
              "there is not enough memory to read a.vtu");
    const std::filesystem::filesystem_error denied(
        "open", "/home/ada/a.vtu", std::make_error_code(std::errc::permission_denied));
    EXPECT_EQ(error_of(denied, "a.vtu").message, "cannot read a.vtu: Permission denied");
    EXPECT_EQ(error_of(std::runtime_error("no block 7 in /home/ada/a.vtu"), "a.vtu").message,
              "cannot read a.vtu (no block 7 in a.vtu)");
}

} // namespace
} // namespace wakesurf::importer::library_messages_test
