#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "protocol/files/surface_lines.hpp"
#include "tests/support/vtp_arrays.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace wakesurf::protocol::surface_lines_test {

namespace {

using core::SurfaceKind;
using tests::array_of;

/// Round a vortex: particles go in circles, each at its own speed.
core::QuadComplex round_a_vortex(SurfaceKind kind) {
    const auto flow = core::make_analytic_flow("lamb-oseen?rc=0.2").value();
    core::SurfaceParameters p;
    p.kind = kind;
    p.to = 3.0;
    p.separation = 0.05;
    const core::Rake rake{core::Rake::Kind::Line, {{0.5, 0, 0}, {1.5, 0, 0}}, 64};
    return core::build_surface(*flow, rake, p).value().mesh;
}

} // namespace

TEST(SurfaceLines, OfOneSeedAreTheCirclesThatParticlesGoOn) {
    for (const auto& [kind, text] : {std::pair{SurfaceKind::Stream, "streamlines:3"},
                                     {SurfaceKind::Path, "pathlines:3"},
                                     {SurfaceKind::Streak, "streaklines:3"}}) {
        const auto wanted = read_lines(text, kind);
        ASSERT_TRUE(wanted) << wanted.error().message;
        const auto lines = surface_lines(round_a_vortex(kind), *wanted);
        ASSERT_TRUE(lines) << lines.error().message;
        ASSERT_EQ(lines->lines.size(), 3u) << text;
        for (std::size_t i = 0; i < 3; ++i) {
            const double radius = 0.5 + 0.25 * static_cast<double>(i + 1);
            ASSERT_GT(lines->lines[i].points.size(), 20u);
            for (const core::Vec3& p : lines->lines[i].points)
                EXPECT_NEAR(std::hypot(p.x, p.y), radius, 2e-3) << text;
        }
    }
}

TEST(SurfaceLines, OfOneAgeRunFromTheInnermostParticleToTheOutermost) {
    const auto lines =
        surface_lines(round_a_vortex(SurfaceKind::Path), {LinesWanted::Along::Release, 2});
    ASSERT_TRUE(lines) << lines.error().message;
    ASSERT_EQ(lines->lines.size(), 2u);
    for (const core::ContourLine& line : lines->lines) {
        const auto radius = [](const core::Vec3& p) { return std::hypot(p.x, p.y); };
        const double first = radius(line.points.front()), last = radius(line.points.back());
        EXPECT_NEAR(std::min(first, last), 0.5, 1e-3);
        EXPECT_NEAR(std::max(first, last), 1.5, 1e-3);
    }
    EXPECT_NEAR(lines->lines[0].value, 1.0, 1e-12);
    EXPECT_NEAR(lines->lines[1].value, 2.0, 1e-12);
}

TEST(SurfaceLines, AreNamedAsTheKindOfSurfaceHasThem) {
    EXPECT_EQ(read_lines("timelines:8", SurfaceKind::Stream).value(),
              (LinesWanted{LinesWanted::Along::Release, 8}));
    const auto wrong = read_lines("streaklines:8", SurfaceKind::Path);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().hint,
              "as in timelines:8, pathlines:every=0.5, pathribbons:every=0.5,width=0.1 or "
              "arrows:every=0.5,width=0.1");
    const auto one_age = read_lines("timelines:8", SurfaceKind::Time);
    ASSERT_FALSE(one_age);
    EXPECT_EQ(one_age.error().hint, "all of it is one age; as in arrows:every=0.5,width=0.1");
}

TEST(SurfaceLines, RefuseANumberThatIsNone) {
    for (const char* text : {"timelines", "timelines:", "timelines:0", "timelines:1001",
                             "timelines:-3", "timelines:3x", "timelines:99999999999", ":", ""})
        EXPECT_FALSE(read_lines(text, SurfaceKind::Streak)) << text;
    EXPECT_TRUE(read_lines("timelines:1000", SurfaceKind::Streak));
    const auto wide = read_lines("timeribbons:every=0.1,width=0.2", SurfaceKind::Streak);
    ASSERT_FALSE(wide);
    EXPECT_EQ(wide.error().message,
              "the width of timeribbons is larger than the distance between them");
    EXPECT_TRUE(read_lines("timeribbons:every=0.2,width=0.2", SurfaceKind::Streak));
}

TEST(SurfaceLines, OfAVtpEndWhereTheirOffsetsSayAndCloseWhenTheyAreClosed) {
    SurfaceLines lines;
    lines.lines = {{0.25, false, {{0, 0, 0}, {1, 0, 0}}},
                   {0.75, true, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}}};
    const auto file = lines_file(MeshFormat::Vtp, lines, {LinesWanted::Along::Seed, 2},
                                 {.dataset = "d", .version = {}});
    ASSERT_TRUE(file);
    EXPECT_EQ(array_of<std::int64_t>(*file, "Int64", "connectivity"),
              (std::vector<std::int64_t>{0, 1, 2, 3, 4, 2}));
    EXPECT_EQ(array_of<std::int64_t>(*file, "Int64", "offsets"), (std::vector<std::int64_t>{2, 6}));
    EXPECT_EQ(array_of<double>(*file, "Float64", "s"), (std::vector<double>{0.25, 0.75}));
    const auto text = lines_file(MeshFormat::Obj, lines, {LinesWanted::Along::Seed, 2},
                                 {.dataset = "d", .version = {}});
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("l 1 2\no s=0.75\n"), std::string::npos) << *text;
    EXPECT_NE(text->find("l 3 4 5 3\n"), std::string::npos) << *text;
}

TEST(SurfaceLines, TakeMeasuresInLengthsInEitherOrder) {
    using Along = LinesWanted::Along;
    using Form = LinesWanted::Form;
    const auto read = [](const char* text, SurfaceKind kind = SurfaceKind::Stream) {
        return read_lines(text, kind);
    };
    EXPECT_EQ(read("streamlines:every=0.5"), (LinesWanted{Along::Seed, 0, Form::Lines, 0.5, 0.0}));
    EXPECT_EQ(read("timeribbons:8,width=0.1"),
              (LinesWanted{Along::Release, 8, Form::Ribbons, 0.0, 0.1}));
    EXPECT_EQ(read("streamribbons:width=0.1,every=2"),
              (LinesWanted{Along::Seed, 0, Form::Ribbons, 2.0, 0.1}));
    EXPECT_EQ(read("arrows:every=1,width=0.25"),
              (LinesWanted{Along::Seed, 0, Form::Arrows, 1.0, 0.25}));
    EXPECT_TRUE(read("streakribbons:every=1,width=0.1", SurfaceKind::Streak));
    for (const char* text :
         {"streamlines:every=0", "streamlines:every=-1", "streamlines:every=nan",
          "streamlines:every=inf", "streamlines:8,width=0.1", "streamlines:8,every=1",
          "streamlines:every=1,every=2", "timeribbons:8", "timeribbons:width=0.1",
          "arrows:8,width=0.1", "arrows:every=1", "streakribbons:8,width=0.1", "ribbons:8,width=1"})
        EXPECT_FALSE(read(text)) << text;
    EXPECT_EQ(read("arrows:every=1,width=0.1", SurfaceKind::Time),
              (LinesWanted{Along::Seed, 0, Form::Arrows, 1.0, 0.1, false}));
    EXPECT_FALSE(read("ribbons:every=1,width=0.1", SurfaceKind::Time));
}

TEST(SurfaceLines, PointsAreOfAnyKindOfSurfaceAndAsPlyAlone) {
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Time, SurfaceKind::Level})
        EXPECT_EQ(read_lines("points", kind, MeshFormat::Ply).value().form,
                  LinesWanted::Form::Points);
    for (const MeshFormat format :
         {MeshFormat::Vtp, MeshFormat::Glb, MeshFormat::Obj, MeshFormat::Drc})
        EXPECT_EQ(read_lines("points", SurfaceKind::Stream, format).error().message,
                  "points cannot be written as ." + std::string(extension(format)));
    EXPECT_FALSE(read_lines("points:8", SurfaceKind::Stream, MeshFormat::Ply));
    EXPECT_EQ(read_lines("timelines:8", SurfaceKind::Stream, MeshFormat::Drc).error().message,
              "lines cannot be written as .drc");
}

TEST(SurfaceLines, RibbonsAndArrowsArePolygonsOfTheFile) {
    const core::QuadComplex mesh = round_a_vortex(SurfaceKind::Stream);
    for (const char* text : {"streamribbons:every=0.4,width=0.05", "timeribbons:3,width=0.05",
                             "arrows:every=0.4,width=0.05"}) {
        const auto wanted = read_lines(text, SurfaceKind::Stream).value();
        const auto cut = surface_lines(mesh, wanted);
        ASSERT_TRUE(cut) << cut.error().message;
        const std::size_t polygons = cut->cutouts.ends.size();
        EXPECT_GT(polygons, 20u) << text;
        const auto file =
            lines_file(MeshFormat::Vtp, *cut, wanted, {.dataset = "d", .version = {}});
        ASSERT_TRUE(file);
        EXPECT_NE(file->find("NumberOfPolys=\"" + std::to_string(polygons) + "\""),
                  std::string::npos);
        EXPECT_EQ(array_of<std::int64_t>(*file, "Int64", "offsets").size(), polygons);
        const auto obj =
            lines_file(MeshFormat::Obj, *cut, wanted, {.dataset = "d", .version = {}}).value();
        std::size_t faces = 0;
        for (auto at = obj.find("\nf "); at != std::string::npos; at = obj.find("\nf ", at + 1))
            ++faces;
        EXPECT_EQ(faces, polygons);
    }
    const auto none =
        surface_lines(mesh, read_lines("arrows:every=9,width=3", SurfaceKind::Stream).value());
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "there is no room for them on this surface");
}

TEST(SurfaceLines, RibbonsThatAreWiderThanTheSurfaceAreRefused) {
    const core::QuadComplex mesh = round_a_vortex(SurfaceKind::Stream);
    const auto ribbons = [&](const char* text) {
        return surface_lines(mesh, read_lines(text, SurfaceKind::Stream).value());
    };
    EXPECT_TRUE(ribbons("streamribbons:1,width=0.9"));
    const auto wide = ribbons("streamribbons:1,width=6"); // the vortex shears it
    ASSERT_FALSE(wide);
    EXPECT_EQ(wide.error().message.substr(0, 57),
              "the ribbons would be wider than the surface, which is 5.7");
}

TEST(SurfaceLines, AreEdgesOrFacesOfAPly) {
    const core::QuadComplex mesh = round_a_vortex(SurfaceKind::Stream);
    const auto wanted = read_lines("streamlines:3", SurfaceKind::Stream).value();
    const auto lines = surface_lines(mesh, wanted).value();
    std::size_t edges = 0, points = 0;
    for (const core::ContourLine& line : lines.lines) {
        edges += line.points.size() - (line.closed ? 0 : 1);
        points += line.points.size();
    }
    const auto file = lines_file(MeshFormat::Ply, lines, wanted, {.dataset = "d", .version = {}});
    ASSERT_TRUE(file);
    EXPECT_NE(file->find("element vertex " + std::to_string(points) + "\n"), std::string::npos);
    EXPECT_NE(file->find("element edge " + std::to_string(edges) + "\n"), std::string::npos);
    const std::size_t body = file->find("end_header\n") + 11;
    EXPECT_EQ(file->size() - body, points * 24 + edges * 16);
}

TEST(SurfaceLines, AreLinesOrTrianglesOfAGlb) {
    const core::QuadComplex mesh = round_a_vortex(SurfaceKind::Stream);
    for (const char* text : {"streamlines:3", "arrows:every=0.4,width=0.05"}) {
        const auto wanted = read_lines(text, SurfaceKind::Stream).value();
        const auto found = surface_lines(mesh, wanted).value();
        const auto file =
            lines_file(MeshFormat::Glb, found, wanted, {.dataset = "d", .version = {}});
        ASSERT_TRUE(file);
        // A header of 12 bytes, then the first chunk: its length, its kind, its text.
        std::uint32_t length = 0;
        std::memcpy(&length, file->data() + 12, sizeof(length));
        const auto gltf = nlohmann::json::parse(file->substr(20, length));
        const auto& primitive = gltf["meshes"][0]["primitives"][0];
        std::size_t wanted_indices = 0;
        for (const core::ContourLine& line : found.lines)
            wanted_indices += 2 * (line.points.size() - (line.closed ? 0 : 1));
        if (wanted.form == LinesWanted::Form::Arrows) {
            EXPECT_EQ(primitive["mode"], 4);
            wanted_indices =
                3 * (found.cutouts.connectivity.size() - 2 * found.cutouts.ends.size());
        } else {
            EXPECT_EQ(primitive["mode"], 1);
        }
        EXPECT_EQ(gltf["accessors"][primitive["indices"].get<std::size_t>()]["count"],
                  wanted_indices);
        EXPECT_TRUE(primitive["attributes"].contains("_S"));
    }
}

TEST(SurfaceLines, HaveNoPlaceInADrc) {
    const auto file = lines_file(MeshFormat::Drc, {}, {}, {});
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, core::Error::Code::Unsupported);
}

} // namespace wakesurf::protocol::surface_lines_test
