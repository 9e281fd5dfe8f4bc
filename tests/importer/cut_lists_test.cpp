// Lists of files that end too early, as a solver leaves them that was killed while it wrote one, or still writes.
#include "importer/sources/open_source.hpp"
#include "tests/importer/vtk_files.hpp"
#include "tests/support/vti_text.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::importer::cut_lists_test {
namespace {

using namespace tests;
using core::Error;

class CutLists : public VtkFiles {
  protected:
    void SetUp() override {
        for (const int step : {0, 1, 2})
            write_step("s" + std::to_string(step) + ".vtu", *sample_mesh(), step);
    }

    // Expects those time-steps whose `sign` is within a part of the list, or a refusal where there is none.
    void
    expect_whole_steps(const std::string& name, const std::string& list, const std::string& sign) {
        for (std::size_t size = 0; size <= list.size(); ++size) {
            const std::string part = list.substr(0, size);
            std::size_t steps = 0;
            for (auto at = part.find(sign); at != std::string::npos; at = part.find(sign, at + 1))
                ++steps;
            const auto source = open_source(put(name, part));
            steps = std::min<std::size_t>(steps, 3); // the list ends in one more of JSON
            ASSERT_EQ(source.has_value(), steps > 0) << size;
            if (!source)
                continue;
            const auto& described = (*source)->description();
            ASSERT_EQ(described.times.size(), steps) << size;
            const bool whole = described.time_note.empty();
            EXPECT_TRUE(whole ? steps == 3 : described.time_note.find(name + " is not whole") == 0)
                << size << described.time_note;
            if (size % 16 == 0) {
                const auto last = (*source)->read(steps - 1, known_fields());
                ASSERT_TRUE(last.has_value()) << last.error().message;
                expect_known_flow(*last->blocks[0], static_cast<int>(steps) - 1);
            }
        }
    }
};

TEST_F(CutLists, OfXmlGiveTheTimeStepsThatTheyWhollyName) {
    const std::string list = pvd_text({{"0", "s0.vtu"}, {"0.5", "s1.vtu"}, {"2", "s2.vtu"}});
    expect_whole_steps("s.pvd", list, "\"/>");
    EXPECT_TRUE(open_source(put("s.pvd", list)).value()->description().time_note.empty());
    for (const char* const comment : {"<!-- > 2", "<!-- > 2 -->"}) {
        const auto cut = list.substr(0, list.find("<DataSet timestep=\"2\"")) + comment;
        const auto source = open_source(put("s.pvd", cut));
        ASSERT_TRUE(source.has_value()) << source.error().message;
        EXPECT_EQ((*source)->description().times, (std::vector<double>{0, 0.5}));
    }
}

TEST_F(CutLists, MayNameFilesBehindTheFirstThatAreNotThere) {
    const std::string list = pvd_text({{"0", "s0.vtu"}, {"0.5", "gone.vtu"}});
    const auto cut = open_source(put("s.pvd", list.substr(0, list.find("</Collection>"))));
    ASSERT_TRUE(cut.has_value()) << cut.error().message;
    EXPECT_FALSE((*cut)->fields_at(1).has_value());
    EXPECT_TRUE((*cut)->description().unreadable.contains(1));
    EXPECT_FALSE(open_source(put("s.pvd", list)).has_value());
}

TEST_F(CutLists, OfJsonGiveTheTimeStepsThatTheyWhollyName) {
    expect_whole_steps("s.vtu.series",
                       R"({"file-series-version": "1.0", "files": [{"name": "s0.vtu", "time": 0},
                         {"name": "s1.vtu", "time": 0.5}, {"name": "s2.vtu", "time": 2}]})",
                       "}");
}

TEST_F(CutLists, LeaveOutATimeStepOfWhichTheyNameSomePartsOnly) {
    std::string list = "<VTKFile type=\"Collection\"><Collection>";
    for (const int step : {0, 1})
        for (const int part : {0, 1}) {
            const std::string name = "p" + std::to_string(step) + std::to_string(part) + ".vtu";
            write_step(name, *sample_mesh(10.0 * part), step);
            list += "<DataSet timestep=\"" + std::to_string(step) + "\" part=\"" +
                    std::to_string(part) + "\" file=\"" + name + "\"/>";
        }
    const auto last = list.rfind("<DataSet");
    EXPECT_EQ(open_source(put("p.pvd", list)).value()->description().times.size(), 2u);
    EXPECT_EQ(open_source(put("p.pvd", list.substr(0, last))).value()->description().times.size(),
              1u);
}

TEST_F(CutLists, OfBlocksAreReadBehindATagAndEndTheSeriesWhereTheyNameFewer) {
    const std::string head =
        "<VTKFile type=\"vtkMultiBlockDataSet\"><vtkMultiBlockDataSet><Block index=\"0\">";
    const std::string one = "<DataSet index=\"0\" file=\"s0.vtu\"/>";
    write_step("other.vtu", *sample_mesh(10.0), 0);
    const std::string two = one + "<DataSet index=\"1\" file=\"other.vtu\"/>";
    const std::string tail = "</Block></vtkMultiBlockDataSet></VTKFile>";
    const auto open = open_source(put("b.vtm", head + two + "</Block>\n"));
    ASSERT_TRUE(open.has_value()) << open.error().message;
    EXPECT_EQ((*open)->description().note.find("b.vtm ends too early: the files that it lists, 2,"),
              0u)
        << (*open)->description().note;
    expect_failure(open_source(put("b.vtm", head + one + "<DataSet ind")), Error::Code::Corrupt,
                   "b.vtm is truncated");
    put("m_0.vtm", head + two + tail);
    put("m_1.vtm", head + two);
    put("m_2.vtm", head + one);
    const auto series = open_source(folder_ / "m_0.vtm").value();
    EXPECT_TRUE(series->read(1, known_fields()).has_value());
    expect_failure(series->read(2, known_fields()), Error::Code::Corrupt,
                   "m_2.vtm ends too early: it lists 1 of 2 files");
}

} // namespace
} // namespace wakesurf::importer::cut_lists_test
