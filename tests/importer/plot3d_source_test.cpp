// Plot3D files as sources, written byte by byte in every layout of the format.
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/open_source.hpp"
#include "tests/importer/known_flow.hpp"
#include "tests/support/temporary_folder.hpp"

#include <vtkIdList.h>

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <sstream>

namespace wakesurf::importer::plot3d_source_test {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

constexpr double density = 2.0;

struct Layout {
    bool ascii = false;
    bool big_endian = false;
    bool records = false;
    bool several = true;
    bool doubles = true;
    bool blanking = false;
};

// Collects numbers the way one layout writes them.
class Text {
  public:
    explicit Text(const Layout& layout) : layout_(layout) {}

    void integer(int value) {
        if (layout_.ascii)
            text_ += std::to_string(value) + "\n";
        else
            word(static_cast<std::uint32_t>(value));
    }

    void real(double value) {
        if (layout_.ascii) {
            std::ostringstream out;
            out.precision(17);
            out << value << "\n";
            text_ += out.str();
        } else if (layout_.doubles) {
            word(std::bit_cast<std::uint64_t>(value));
        } else {
            word(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
        }
    }

    void record(const Text& inner) {
        const bool marks = layout_.records && !layout_.ascii;
        if (marks)
            word(static_cast<std::uint32_t>(inner.text_.size()));
        text_ += inner.text_;
        if (marks)
            word(static_cast<std::uint32_t>(inner.text_.size()));
    }

    const std::string& text() const { return text_; }

  private:
    template <class Word>
    void word(Word value) {
        for (std::size_t i = 0; i < sizeof(Word); ++i) {
            const auto shift = 8 * (layout_.big_endian ? sizeof(Word) - 1 - i : i);
            text_.push_back(static_cast<char>(value >> shift & 0xff));
        }
    }

    Layout layout_;
    std::string text_;
};

std::vector<vtkSmartPointer<vtkStructuredGrid>> grids(const Layout& layout) {
    if (!layout.several)
        return {sample_structured()};
    return {sample_structured(), sample_structured(20)};
}

void put_header(Text& out, const Layout& layout) {
    if (layout.several) {
        Text count(layout);
        count.integer(2);
        out.record(count);
    }
    Text sizes(layout);
    for (const auto& grid : grids(layout)) {
        std::array<int, 3> nodes{};
        grid->GetDimensions(nodes.data());
        for (const int along : nodes)
            sizes.integer(along);
    }
    out.record(sizes);
}

// Node 7 of each grid is blanked where the layout has blanking.
std::string grid_text(const Layout& layout) {
    Text out(layout);
    put_header(out, layout);
    for (const auto& grid : grids(layout)) {
        Text body(layout);
        for (int c = 0; c < 3; ++c)
            for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
                body.real(grid->GetPoint(i)[c]);
        for (vtkIdType i = 0; layout.blanking && i < grid->GetNumberOfPoints(); ++i)
            body.integer(i == 7 ? 0 : 1);
        out.record(body);
    }
    return out.text();
}

// Adds the solution of one grid: the four numbers of its header, and the five values of each node.
void put_solution(Text& out,
                  const Layout& layout,
                  const std::array<double, 4>& header,
                  vtkIdType nodes,
                  const std::function<std::array<double, 5>(vtkIdType)>& values) {
    Text parameters(layout);
    for (const double value : header)
        parameters.real(value);
    out.record(parameters);
    Text body(layout);
    for (std::size_t place = 0; place < 5; ++place)
        for (vtkIdType i = 0; i < nodes; ++i)
            body.real(values(i)[place]);
    out.record(body);
}

std::string solution_text(const Layout& layout, int step, double time) {
    Text out(layout);
    put_header(out, layout);
    for (const auto& grid : grids(layout)) {
        put_solution(out, layout, {0.2, 0.0, 100.0, time}, grid->GetNumberOfPoints(),
                     [&](vtkIdType i) -> std::array<double, 5> {
                         const auto u = known_velocity(grid->GetPoint(i), step);
                         return {density, density * u[0], density * u[1], density * u[2], 1.0};
                     });
    }
    return out.text();
}

class Plot3dSource : public testing::Test {
  protected:
    fs::path put(const std::string& name, const std::string& text) const {
        write_file(folder_ / name, text);
        return folder_ / name;
    }

    void put_flow(const std::string& stem,
                  const Layout& layout,
                  const std::vector<double>& times) const {
        put(stem + ".xyz", grid_text(layout));
        for (std::size_t i = 0; i < times.size(); ++i)
            put(stem + "_" + std::to_string(8 + i) + ".q",
                solution_text(layout, static_cast<int>(i), times[i]));
    }

    static std::vector<core::FieldInfo> vector(const std::string& name) {
        return {{name, 3, core::FieldInfo::Source::Point, {0, 0}, {}}};
    }

    static void expect_steps(const core::Result<std::unique_ptr<Source>>& source,
                             const std::vector<double>& times,
                             std::size_t blocks = 2) {
        ASSERT_TRUE(source.has_value()) << source.error().message;
        ASSERT_EQ((*source)->description().times, times);
        for (std::size_t i = 0; i < 2 * times.size(); ++i) {
            const std::size_t step = i < times.size() ? i : 2 * times.size() - 1 - i;
            const auto read = (*source)->read(step, vector("Velocity"));
            ASSERT_TRUE(read.has_value()) << read.error().message;
            ASSERT_EQ(read->blocks.size(), blocks);
            for (const auto& block : read->blocks)
                expect_vector(*block, "Velocity", static_cast<int>(step));
        }
    }

    TemporaryFolder folder_;
};

TEST_F(Plot3dSource, ReadsEveryLayout) {
    for (int choice = 0; choice < 64; ++choice) {
        Layout layout;
        layout.ascii = (choice & 1) != 0;
        layout.big_endian = (choice & 2) != 0;
        layout.records = (choice & 4) != 0;
        layout.several = (choice & 8) != 0;
        layout.doubles = (choice & 16) != 0;
        layout.blanking = (choice & 32) != 0;
        if (layout.ascii && (layout.big_endian || layout.records || !layout.doubles))
            continue;
        put_flow("flow", layout, {0.5, 1.5});
        SCOPED_TRACE(choice);
        expect_steps(open_source(folder_ / "flow.xyz"), {0.5, 1.5}, layout.several ? 2 : 1);
    }
}

TEST_F(Plot3dSource, IsNamedByItsGridOrASolutionOrAPattern) {
    put_flow("flow", {}, {0.5, 1.5, 9});
    for (const std::string name : {"flow.xyz", "flow_8.q", "flow_9.q", "flow_*.q"})
        expect_steps(open_source(folder_ / name), {0.5, 1.5, 9});
    const auto source = open_source(folder_ / "flow_9.q");
    EXPECT_EQ((*source)->description().name, "flow");
    EXPECT_EQ((*source)->shared_files()->front().name, "flow.xyz");
    EXPECT_EQ((*source)->files(2)->front().name, "flow_10.q");
    expect_steps(open_source(folder_.path()), {0.5, 1.5, 9});
    fs::rename(folder_ / "flow.xyz", folder_ / "grid.g"); // the only grid
    for (const std::string name : {"grid.g", "flow_8.q"})
        expect_steps(open_source(folder_ / name), {0.5, 1.5, 9});
}

// Paths are confined where nobody has allowed others.
TEST_F(Plot3dSource, TakesNoGridThatIsALinkOutOfAConfinedFolder) {
    put_flow("flow", {}, {0.5, 1.5});
    fs::create_directories(folder_ / "in");
    for (const char* const name : {"flow_8.q", "flow_9.q"})
        fs::rename(folder_ / name, folder_ / "in" / name);
    fs::create_symlink(folder_ / "flow.xyz", folder_ / "in/flow.xyz");
    const auto refused = open_source(folder_ / "in/flow_8.q");
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().message,
              "the folder of flow_8.q names flow.xyz, which lies outside of its folder");
}

TEST_F(Plot3dSource, ReadsOneSolutionAndAListOfFiles) {
    put("one.x", grid_text({}));
    put("one.q", solution_text({}, 0, 2.5));
    expect_steps(open_source(folder_ / "one.x"), {2.5});
    put("late.q", solution_text({}, 1, 2.5));
    put("list.p3d", R"({"auto-detect-format":true,"filenames":[
        {"time":0.25,"xyz":"one.x","q":"one.q"},{"time":4,"xyz":"one.x","q":"late.q"}]})");
    expect_steps(open_source(folder_ / "list.p3d"), {0.25, 4});
    put("list.p3d", R"({"filenames":[{"time":4,"xyz":"one.x","q":"one.q"},
                                     {"time":4,"xyz":"one.x","q":"late.q"}]})");
    const auto again = open_source(folder_ / "list.p3d").value();
    EXPECT_EQ(again->description().times, (std::vector<double>{4}));
    EXPECT_EQ(again->files(0)->front().name, "late.q") << "written last";
    EXPECT_NE(again->description().time_note.find("for the same time: one.q"), std::string::npos);
    for (const char* outside : {"../../etc/passwd", "/etc/passwd"}) {
        put("list.p3d",
            std::string(R"({"filenames":[{"time":4,"xyz":"one.x","q":")") + outside + "\"}]}");
        expect_failure(open_source(folder_ / "list.p3d"), Error::Code::Unsupported,
                       "list.p3d names passwd, which lies outside of its folder");
    }
    put("list.p3d", "{\"filenames\":[]}");
    expect_failure(open_source(folder_ / "list.p3d"), Error::Code::Corrupt, "list of filenames");
}

TEST_F(Plot3dSource, DeliversMomentumAndDensity) {
    put_flow("flow", {}, {1});
    const auto source = open_source(folder_ / "flow.xyz");
    ASSERT_NE(field_named(**source, "Momentum"), nullptr);
    ASSERT_NE(field_named(**source, "Density"), nullptr);
    EXPECT_EQ(field_named(**source, "Momentum")->components, 3);
    EXPECT_EQ(field_named(**source, "Density")->range, (std::array{density, density}));
    const auto read = (*source)->read(0, vector("Momentum"));
    for (const auto& block : read->blocks) {
        auto* momentum = block->GetPointData()->GetArray("Momentum");
        for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
            ASSERT_NEAR(momentum->GetComponent(i, 1),
                        density * known_velocity(block->GetPoint(i), 0)[1], 1e-5);
    }
}

TEST_F(Plot3dSource, AsksWhatTheFiveValuesAreWhereTheyAreNoFlows) {
    const Layout layout{.several = false};
    const auto open = [&](const std::array<double, 4>& header, const std::array<double, 5>& values,
                          const std::string& wish) {
        put("f.xyz", grid_text(layout));
        Text out(layout);
        put_header(out, layout);
        put_solution(out, layout, header, grids(layout)[0]->GetNumberOfPoints(),
                     [&](vtkIdType) { return values; });
        put("f.q", out.text());
        return open_source(folder_ / "f.xyz", {.velocity = wish});
    };
    const std::array<double, 4> nothing{};
    const std::array<double, 5> fire{20, 1, 0.5, 0.25, 0};
    for (const auto& values : {fire, {1.2, 1, 1, 1, 0}, {-3, 1, 0, 0, 900}}) {
        const auto refused = open(nothing, values, "");
        expect_failure(refused, Error::Code::InvalidArgument,
                       "f.q may not hold density, momentum and energy");
        EXPECT_NE(refused.error().hint.find("--velocity 2,3,4"), std::string::npos);
    }
    const auto by_place = open(nothing, fire, "2,3,4");
    ASSERT_TRUE(by_place.has_value()) << by_place.error().message;
    EXPECT_NE((*by_place)->description().note.find("by their places"), std::string::npos);
    const auto& fields = (*by_place)->description().fields;
    ASSERT_EQ(fields.size(), 5u);
    EXPECT_EQ(choose_velocity(fields, "2,3,4")->name, "2, 3, 4");
    const auto read = (*by_place)->read(0, fields);
    for (int place = 1; place <= 5; ++place)
        EXPECT_EQ(
            read->blocks[0]->GetPointData()->GetArray(std::to_string(place).c_str())->GetTuple1(4),
            fire.at(static_cast<std::size_t>(place) - 1));
    EXPECT_TRUE(open(nothing, fire, "Momentum,Density").has_value());
    for (const auto& [header, values] :
         std::vector<std::pair<std::array<double, 4>, std::array<double, 5>>>{
             {{0.8, 0, 1e6, 3}, fire},
             {nothing, {1.2, 1, 1, 1, 2.5}},
             {nothing, {1, 1, 1, 1, 0}},
             {nothing, {0, 0, 0, 0, 0}}}) {
        const auto taken = open(header, values, "");
        ASSERT_TRUE(taken.has_value()) << taken.error().message;
        EXPECT_NE((*taken)->description().note.find("taken as density, momentum and energy"),
                  std::string::npos);
    }
}

TEST_F(Plot3dSource, TakesTheTimesThatFdsWritesIntoNames) {
    for (const char* const end : {"_0000_00", "_0002_50", "_0010_00"})
        put(std::string("fire_1") + end + ".q", solution_text({}, 0, 0));
    put("fire.xyz", grid_text({}));
    for (const char* const name : {"fire.xyz", "fire_1_0002_50.q"}) {
        const auto source = open_source(folder_ / name);
        ASSERT_TRUE(source.has_value()) << source.error().message;
        EXPECT_EQ((*source)->description().times, (std::vector<double>{0, 2.5, 10})) << name;
        EXPECT_EQ((*source)->description().time_note,
                  "the times are those in the names of the files");
        EXPECT_EQ((*source)->files(1)->front().name, "fire_1_0002_50.q");
    }
    const auto alone = open_source(folder_ / "fire_1_0002_50.q", {.alone = true});
    EXPECT_EQ((*alone)->description().times.size(), 1u);
    put("fire_2_0000_00.q", solution_text({}, 0, 0));
    expect_failure(open_source(folder_ / "fire.xyz"), Error::Code::InvalidArgument,
                   "several series of solutions are beside fire.xyz");
}

TEST_F(Plot3dSource, MarksTheCellsOfBlankedNodes) {
    Layout layout;
    layout.blanking = true;
    put_flow("flow", layout, {1});
    const auto read = (*open_source(folder_ / "flow.xyz"))->read(0, vector("Velocity"));
    auto& block = *read->blocks[1];
    auto* ghost = block.GetCellData()->GetArray("vtkGhostType");
    ASSERT_NE(ghost, nullptr);
    int marked = 0;
    auto nodes = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType i = 0; i < block.GetNumberOfCells(); ++i) {
        block.GetCellPoints(i, nodes);
        const bool blanked = nodes->IsId(7) >= 0;
        EXPECT_EQ(ghost->GetTuple1(i) != 0, blanked) << i;
        marked += blanked ? 1 : 0;
    }
    EXPECT_EQ(marked, 2);
}

TEST_F(Plot3dSource, CountsTheStepsWhereTheirTimesDoNotRise) {
    put_flow("flow", {}, {0, 0, 0});
    const auto source = open_source(folder_ / "flow.xyz");
    expect_steps(source, {0, 1, 2});
    EXPECT_NE((*source)->description().time_note.find("do not increase"), std::string::npos);
}

TEST_F(Plot3dSource, RefusesEveryTruncation) {
    for (const bool ascii : {false, true})
        for (const bool records : {false, true}) {
            Layout layout;
            layout.ascii = ascii;
            layout.records = records;
            const auto grid = grid_text(layout);
            const auto solution = solution_text(layout, 0, 1);
            put("flow.q", solution);
            for (std::size_t size = 0; size < grid.size(); size += grid.size() / 50) {
                put("flow.xyz", grid.substr(0, size));
                EXPECT_FALSE(open_source(folder_ / "flow.xyz").has_value()) << size;
            }
            put("flow.xyz", grid);
            for (std::size_t size = 0; size < solution.size(); size += solution.size() / 50) {
                put("flow.q", solution.substr(0, size));
                expect_failure(open_source(folder_ / "flow.xyz"), Error::Code::Corrupt, "flow.q");
            }
            put("flow.q", solution.substr(0, solution.size() - 1));
            expect_failure(open_source(folder_ / "flow.xyz"), Error::Code::Corrupt, "flow.q");
        }
}

TEST_F(Plot3dSource, RefusesFilesThatDoNotBelongTogether) {
    put("flow.xyz", grid_text({}));
    expect_failure(open_source(folder_ / "flow.xyz"), Error::Code::NotFound, "no solutions beside");
    Layout single;
    single.several = false;
    put("flow.q", solution_text(single, 0, 1));
    expect_failure(open_source(folder_ / "flow.xyz"), Error::Code::Corrupt,
                   "flow.q is truncated or not a solution on the grid");
    fs::remove(folder_ / "flow.xyz");
    expect_failure(open_source(folder_ / "flow.q"), Error::Code::NotFound, "no grid beside flow.q");
    put("a.g", grid_text({}));
    put("b.g", grid_text({}));
    expect_failure(open_source(folder_ / "flow.q"), Error::Code::InvalidArgument, "several grids");
}

TEST_F(Plot3dSource, RefusesGridsInThePlane) {
    std::string text = "3 2\n";
    for (int i = 0; i < 12; ++i)
        text += std::to_string(i) + "\n";
    put("flat.xyz", text);
    put("flat.q", "1 ");
    expect_failure(open_source(folder_ / "flat.xyz"), Error::Code::Unsupported,
                   "flat.xyz is not three-dimensional");
}

TEST_F(Plot3dSource, DoesNotGiveAnEarlierStepForADamagedOne) {
    put_flow("flow", {}, {0, 1, 2});
    const auto source = open_source(folder_ / "flow.xyz");
    const auto good = read_file(folder_ / "flow_9.q");
    put("flow_9.q", good.substr(0, good.size() / 2));
    ASSERT_TRUE((*source)->read(0, vector("Velocity")).has_value());
    expect_failure((*source)->read(1, vector("Velocity")), Error::Code::Corrupt, "flow_9.q");
    EXPECT_TRUE((*source)->read(2, vector("Velocity")).has_value());
}

} // namespace
} // namespace wakesurf::importer::plot3d_source_test
