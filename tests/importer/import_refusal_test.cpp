// Sources that wakesurf-import cannot read, and what it says of them.
#include "tests/importer/import_fixture.hpp"

#include <cmath>

namespace wakesurf::importer::import_refusal_test {
namespace {

TEST_F(Import, RefusesFilesThatAreNotWhatTheySay) {
    expect_refusal("missing.vti", "missing.vti");
    put("empty.vti", "");
    expect_refusal("empty.vti", "empty");
    put("empty.pvd", "");
    expect_refusal("empty.pvd", "empty");
    put("text.vti", "this is not XML, whatever ends it: </VTKFile>");
    expect_refusal("text.vti", "text.vti");
    put("text.pvd", "neither is this");
    expect_refusal("text.pvd", "text.pvd");
    put("wrong.pvd", sample_vti().text());
    expect_refusal("wrong.pvd", "Collection");
    put("wrong.vti", pvd_text({{"0", "a.vti"}}));
    expect_refusal("wrong.vti", "wrong.vti");
    put("mesh.stuff", "1 2 3");
    expect_refusal("mesh.stuff", "format");
    put("none.pvd", pvd_text({}));
    expect_refusal("none.pvd", "names no files");
}

TEST_F(Import, RefusesATruncatedFileWhereverItIsCut) {
    const std::string whole = read_file(bundled.parent_path() / "sqcyl_000.vti");
    for (std::size_t size = 1; size < whole.size(); size += whole.size() / 12) {
        put("cut.vti", whole.substr(0, size));
        expect_refusal("cut.vti", "cut.vti");
    }
    // Cut in the middle, with an end that looks whole.
    put("cut.vti", whole.substr(0, whole.size() / 2) + "\n</AppendedData>\n</VTKFile>\n");
    expect_refusal("cut.vti", "cut.vti");
    const std::string text = sample_vti().text();
    put("cut.vti", text.substr(0, text.size() / 2) + "</VTKFile>");
    expect_refusal("cut.vti", "cut.vti");
}

TEST_F(Import, RefusesAFileWithTooFewValues) {
    auto file = sample_vti();
    file.points = vti_array("U", 3, file.point_count() - 1, [](std::size_t) { return 1.0; });
    put("few.vti", file.text());
    expect_refusal("few.vti", "few.vti");
}

TEST_F(Import, RefusesAFileWhosePiecesLeaveAHole) {
    auto text = sample_vti().text();
    const std::string piece = "<Piece Extent=\"0 2";
    text.replace(text.find(piece), piece.size(), "<Piece Extent=\"0 1");
    put("hole.vti", text);
    expect_refusal("hole.vti", "hole.vti");
}

TEST_F(Import, RefusesAClaimOfEnormousSize) {
    auto text = sample_vti().text();
    for (auto at = text.find("0 2 0 3 0 4"); at != std::string::npos; at = text.find("0 2 0 3 0 4"))
        text.replace(at, 11, "0 2000000 0 2000000 0 2000000");
    put("huge.vti", text);
    expect_refusal("huge.vti", "huge.vti");
}

TEST_F(Import, ListsWhatThereIsWhenTheVelocityIsNotClear) {
    VtiText file;
    const auto one = [](std::size_t) { return 1.0; };
    file.points = vti_array("p", 1, file.point_count(), one);
    put("none.vti", file.text());
    expect_refusal("none.vti", "no vector field; there is p (1 component, point)");
    file.points = "";
    put("nothing.vti", file.text());
    expect_refusal("nothing.vti", "there is no array that all its parts have");
    file.points =
        vti_array("wind", 3, file.point_count(), one) + vti_array("B", 3, file.point_count(), one);
    put("two.vti", file.text());
    expect_refusal("two.vti", "wind (3 components, point), B (3 components, point)");
    expect_refusal("two.vti", "there is no field V", {"--velocity", "V"});
    ASSERT_EQ(run("two.vti", {"--velocity", "B"}).status, 0);
    EXPECT_EQ(manifest().info.velocity, "B");
    fs::remove_all(store());
    file.points += vti_array("Velocity", 3, file.point_count(), one);
    put("three.vti", file.text());
    ASSERT_EQ(run("three.vti").status, 0);
    EXPECT_EQ(manifest().info.velocity, "Velocity");
}

TEST_F(Import, RefusesMasksThatMove) {
    const auto with_mask = [](const std::function<double(std::size_t)>& value) {
        auto file = sample_vti();
        file.points += vti_array("mask", 1, file.point_count(), value);
        return file.text();
    };
    put("m0.vti", with_mask([](std::size_t i) { return i == 7 ? 0 : 1; }));
    put("m1.vti", with_mask([](std::size_t i) { return i == 8 ? 0 : 1; }));
    expect_refusal("m0.vti", "m1.vti (time-step 1) has another mask than m0.vti");
}

TEST_F(Import, RefusesGridsItCannotHold) {
    auto file = sample_vti();
    file.direction = "0 1 0 1 0 0 0 0 1";
    put("rotated.vti", file.text());
    expect_refusal("rotated.vti", "rotated");
    for (const char* spacing : {"0 1 1", "-1 1 1", "nan 1 1", "1e200 1 1"}) {
        file = sample_vti();
        file.spacing = spacing;
        put("spacing.vti", file.text());
        expect_refusal("spacing.vti", "spacing.vti");
    }
}

TEST_F(Import, RefusesASeriesWhosePartsDisagree) {
    put("a.vti", sample_vti().text());
    auto other = sample_vti();
    other.spacing = "1 1 2";
    put("b.vti", other.text());
    put("grid.pvd", pvd_text({{"0", "a.vti"}, {"1", "b.vti"}}));
    expect_refusal("grid.pvd", "b.vti (time-step 1) has another mesh than a.vti");
    put("gone.pvd", pvd_text({{"0", "a.vti"}, {"1", "gone.vti"}}));
    expect_refusal("gone.pvd", "gone.pvd names gone.vti, which does not exist");
    put("twice.pvd", pvd_text({{"1", "a.vti"}, {"1", "b.vti"}}));
    expect_refusal("twice.pvd", "the same time");
    for (const char* time : {"soon", "nan", "1e999"}) {
        put("time.pvd", pvd_text({{time, "a.vti"}}));
        expect_refusal("time.pvd", "not a finite number");
    }
}

} // namespace
} // namespace wakesurf::importer::import_refusal_test
