#include "server/data/dataset_argument.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace wakesurf::server::dataset_argument_test {
namespace {

using Kind = DatasetArgument::Kind;
using tests::TemporaryFolder;
using tests::write_file;

TEST(DatasetArgument, TellsFlowsStoresAndSourcesApart) {
    const TemporaryFolder folder;
    write_file(folder / "a.vti", "x");
    std::filesystem::create_directory(folder / "s");
    write_file(folder / "s/store.json", "{}");
    const auto flow = resolve_dataset("flow:abc?A=2").value();
    EXPECT_EQ(flow.kind, Kind::Flow);
    EXPECT_EQ(flow.flow, "abc?A=2");
    EXPECT_EQ(resolve_dataset(folder / "s").value().kind, Kind::Store);
    EXPECT_EQ(resolve_dataset(folder / "s/store.json").value().path,
              resolve_dataset(folder / "s").value().path);
    const auto source = resolve_dataset(folder / "s/../a.vti").value();
    EXPECT_EQ(source.kind, Kind::Source);
    EXPECT_EQ(source.name, "a");
    EXPECT_EQ(source.path, std::filesystem::canonical(folder / "a.vti"));
}

TEST(DatasetArgument, ALinkToAFileKeepsItsName) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "links");
    write_file(folder / "a_7.vti", "");
    std::filesystem::create_symlink(folder / "a_7.vti", folder / "links/b_0.vti");
    const auto linked = resolve_dataset(folder / "links/b_0.vti").value();
    EXPECT_EQ(linked.path, std::filesystem::canonical(folder / "links") / "b_0.vti");
    EXPECT_EQ(linked.name, "b_0");
    std::filesystem::remove(folder / "a_7.vti");
    EXPECT_EQ(resolve_dataset(folder / "links/b_0.vti").error().code, core::Error::Code::NotFound);
}

TEST(DatasetArgument, FoldersAndPatternsAreLeftToTheImporter) {
    const TemporaryFolder folder;
    const auto whole = resolve_dataset(folder.path()).value();
    EXPECT_EQ(whole.kind, Kind::Source);
    EXPECT_EQ(whole.path, std::filesystem::canonical(folder.path()));
    EXPECT_EQ(whole.name, folder.path().filename());
    for (const char* pattern : {"u_*.vtu", "u_%04d.vtu"}) {
        const auto series = resolve_dataset(folder / pattern).value();
        EXPECT_EQ(series.kind, Kind::Source);
        EXPECT_EQ(series.path, std::filesystem::canonical(folder.path()) / pattern);
    }
    EXPECT_EQ(resolve_dataset(folder / "none/u_*.vtu").error().code, core::Error::Code::NotFound);
}

TEST(DatasetArgument, NamesNoFolderWhenNothingIsThere) {
    EXPECT_EQ(resolve_dataset("").error().message, "the name of the dataset is empty");
    const auto error = resolve_dataset("/no/such/place.pvd").error();
    EXPECT_EQ(error.code, core::Error::Code::NotFound);
    EXPECT_EQ(error.message.find("/no"), std::string::npos) << error.message;
}

TEST(DatasetArgument, EqualNamesInDifferentPlacesHaveDifferentStores) {
    DatasetArgument a{Kind::Source, "run", "", "/a/run.pvd"};
    DatasetArgument b{Kind::Source, "run", "", "/b/run.pvd"};
    EXPECT_NE(store_folder("/s", a), store_folder("/s", b));
    EXPECT_EQ(store_folder("/s", a), store_folder("/s", a));
    command::SourceOptions water, alone;
    water.velocity = "U.water";
    alone.alone = true;
    EXPECT_NE(store_folder("/s", a), store_folder("/s", a, water));
    EXPECT_NE(store_folder("/s", a), store_folder("/s", a, alone));
    const std::string name = store_folder("/s", a).filename();
    EXPECT_EQ(name.size(), std::string("run-").size() + 16);
    EXPECT_TRUE(name.starts_with("run-"));
}

TEST(DatasetArgument, StoresAreKeptWhereTheEnvironmentSaysElseInTheCache) {
    ::setenv("WAKESURF_STORE", "/kept/here", 1);
    EXPECT_EQ(default_store_root(), "/kept/here");
    ::unsetenv("WAKESURF_STORE");
    EXPECT_TRUE(default_store_root().string().find("wakesurf") != std::string::npos);
}

TEST(DatasetArgument, SlugsAreSafeInUrlsAndFolders) {
    EXPECT_EQ(slug("Flow past a cylinder (2)"), "Flow-past-a-cylinder-2");
    EXPECT_EQ(slug("../../etc"), "etc");
    EXPECT_EQ(slug("\xff\xfe"), "dataset");
    EXPECT_EQ(slug("lamb-oseen?gamma=1"), "lamb-oseen-gamma-1");
    EXPECT_LE(slug(std::string(1000, 'x')).size(), 64u);
}

} // namespace
} // namespace wakesurf::server::dataset_argument_test
