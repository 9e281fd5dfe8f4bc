// Every export format, read back by readers of our own: the geometry, the arrays and the words are those of the mesh.
#include "protocol/files/mesh_file.hpp"
#include "protocol/files/mesh_triangles.hpp"
#include "tests/support/mesh_measures.hpp"
#include "tests/support/mesh_readers.hpp"
#include "tests/support/refined_surface.hpp"
#include "tests/support/small_mesh.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace wakesurf::protocol::mesh_file_test {

using nlohmann::json;
using tests::ReadMesh;

namespace {

const MeshMetadata metadata{.rake = {core::Rake::Kind::Line, {{0, 0, 0}, {0.1, 1e-300, -2}}},
                            .parameters = {.kind = core::SurfaceKind::Path, .from = 0.1, .to = 7},
                            .separation = 0.05,
                            .dataset = "a \"b\"\nc",
                            .version = "1.2.3"};

std::string written(MeshFormat format,
                    const core::QuadComplex& mesh,
                    const MeshScalars& scalars = {},
                    GlbCoding glb = GlbCoding::Draco) {
    auto file = mesh_file(format, mesh, metadata, scalars, glb);
    EXPECT_TRUE(file.has_value()) << (file ? "" : file.error().message);
    return file.value_or("");
}

const core::QuadComplex& surface() {
    static const core::QuadComplex mesh = tests::refined_surface();
    return mesh;
}

MeshScalars pressure(const core::QuadComplex& mesh) {
    MeshScalars out;
    for (std::size_t v = 0; v < mesh.vertices(); ++v)
        out["p (mean)"].push_back(static_cast<float>(std::sin(static_cast<double>(v))));
    return out;
}

std::size_t triangles(const core::QuadComplex& mesh) {
    std::size_t count = 0;
    for (const core::Cell& cell : mesh.cells)
        count += core::polygon(cell).count - 2;
    return count;
}

/// Which vertex of the mesh each point of a file is: the only one within `reach`, by its place and its (s, t).
std::vector<core::VertexId> vertices_of(const core::QuadComplex& mesh,
                                        const ReadMesh& read,
                                        const std::string& s,
                                        const std::string& t,
                                        double reach) {
    std::vector<core::VertexId> out;
    for (std::size_t i = 0; i < read.points.size(); ++i) {
        core::VertexId found = core::no_vertex;
        for (core::VertexId v = 0; v < mesh.vertices(); ++v)
            if (glm::length(mesh.position[v] - read.points[i]) < reach &&
                std::abs(mesh.s[v] - read.arrays.at(s)[i]) < 1e-4 &&
                std::abs(mesh.t[v] - read.arrays.at(t)[i]) < 1e-3) {
                EXPECT_EQ(found, core::no_vertex) << "two vertices fit point " << i;
                found = v;
            }
        EXPECT_NE(found, core::no_vertex) << "no vertex fits point " << i;
        out.push_back(found);
    }
    return out;
}

void expect_the_triangles_of(const core::QuadComplex& mesh,
                             const ReadMesh& read,
                             const std::vector<core::VertexId>& at) {
    const auto canonical = [](std::array<std::uint32_t, 3> t) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        return t;
    };
    std::vector<std::array<std::uint32_t, 3>> expected;
    for (const Triangle& each : triangles_of(mesh))
        expected.push_back(canonical(each));
    std::vector<std::array<std::uint32_t, 3>> given;
    for (const auto& face : read.faces)
        given.push_back(canonical({at[face[0]], at[face[1]], at[face[2]]}));
    std::sort(expected.begin(), expected.end());
    std::sort(given.begin(), given.end());
    EXPECT_EQ(given, expected);
}

} // namespace

TEST(MeshFile, PlyHasQuadsTrianglesAndEveryArrayExactly) {
    const auto& mesh = surface();
    const auto scalars = pressure(mesh);
    const auto read = tests::read_ply(written(MeshFormat::Ply, mesh, scalars));
    EXPECT_EQ(read.points, mesh.position);
    EXPECT_EQ(read.arrays.at("s"), mesh.s);
    EXPECT_EQ(read.arrays.at("t"), mesh.t);
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        EXPECT_EQ(read.arrays.at("vy")[v], static_cast<double>(mesh.velocity[v].y));
        EXPECT_EQ(read.arrays.at("deformation")[v], static_cast<double>(mesh.deformation[v]));
        EXPECT_EQ(read.arrays.at("component")[v], mesh.component[v]);
        EXPECT_EQ(read.arrays.at("approximated")[v], mesh.approximated[v]);
        EXPECT_EQ(read.arrays.at("p__mean_")[v], static_cast<double>(scalars.at("p (mean)")[v]));
        EXPECT_FLOAT_EQ(static_cast<float>(read.arrays.at("speed")[v]),
                        static_cast<float>(mesh.speed(static_cast<core::VertexId>(v))));
    }
    EXPECT_EQ(read.about.at("kind"), "path");
    EXPECT_EQ(read.about.at("dataset"), "a \"b\" c") << "a line break would end the comment";
    EXPECT_EQ(read.about.at("rake"), "0,0,0 0.1,1e-300,-2");
}

TEST(MeshFile, PlyOfPointsHasTheVerticesWithDiscsThatCoverTheCellsAndNoFaces) {
    const auto& mesh = surface();
    const auto whole = tests::read_ply(written(MeshFormat::Ply, mesh, pressure(mesh)));
    const auto read = tests::read_ply(
        mesh_file(MeshFormat::Ply, mesh, metadata, pressure(mesh), {}, PlyElements::Points)
            .value());
    EXPECT_EQ(read.points, whole.points);
    EXPECT_TRUE(read.faces.empty());
    auto arrays = read.arrays;
    arrays.erase("radius");
    EXPECT_EQ(arrays, whole.arrays);
    const auto& radius = read.arrays.at("radius");
    constexpr int steps = 12;
    for (const Triangle& each : triangles_of(mesh))
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j) {
                const double u = double(i) / steps, v = double(j) / steps;
                const core::Vec3 at = (1.0 - u - v) * mesh.position[each[0]] +
                                      u * mesh.position[each[1]] + v * mesh.position[each[2]];
                EXPECT_TRUE(std::any_of(each.begin(), each.end(), [&](std::uint32_t vertex) {
                    return glm::distance(at, mesh.position[vertex]) <= radius[vertex];
                }));
            }
}

TEST(MeshFile, PlyAndObjHaveAQuadWhereNothingHangsAndTheSameFaces) {
    const auto& mesh = surface();
    const auto ply = tests::read_ply(written(MeshFormat::Ply, mesh));
    const auto obj = tests::read_obj(written(MeshFormat::Obj, mesh));
    EXPECT_EQ(ply.faces, obj.faces);
    std::size_t plain = 0;
    for (const core::Cell& cell : mesh.cells)
        plain += core::polygon(cell).count == 4 ? 1 : 0;
    EXPECT_EQ(static_cast<std::size_t>(std::count_if(ply.faces.begin(), ply.faces.end(),
                                                     [](const auto& f) { return f.size() == 4; })),
              plain);
    ASSERT_LT(plain, mesh.cells.size()) << "nothing hangs here";
    EXPECT_EQ(obj.points, mesh.position);
    EXPECT_EQ(obj.arrays.at("s"), mesh.s);
    EXPECT_EQ(obj.arrays.at("t"), mesh.t);
    EXPECT_EQ(obj.about.at("to"), "7");
}

TEST(MeshFile, PlyIsAsWatertightAsTheSurface) {
    const auto& mesh = surface();
    const auto read = tests::read_ply(written(MeshFormat::Ply, mesh));
    const auto uses = tests::edge_uses(read);
    std::size_t border = 0;
    for (const auto& [edge, count] : uses) {
        EXPECT_LE(count, 2);
        border += count == 1 ? 1 : 0;
    }
    std::size_t expected = 0;
    for (const auto& [edge, count] : tests::edge_uses(mesh))
        expected += count == 1 ? 1 : 0;
    EXPECT_EQ(border, expected);
}

TEST(MeshFile, GlbHoldsEveryTriangleAndArrayWithinItsQuantisation) {
    const auto& mesh = surface();
    const auto scalars = pressure(mesh);
    const auto read = tests::read_glb(written(MeshFormat::Glb, mesh, scalars));
    ASSERT_EQ(read.faces.size(), triangles(mesh));
    ASSERT_EQ(read.points.size(), mesh.vertices());
    const auto at = vertices_of(mesh, read, "_S", "_T", 1e-5);
    expect_the_triangles_of(mesh, read, at);
    for (std::size_t i = 0; i < at.size(); ++i) {
        const auto v = at[i];
        EXPECT_NEAR(read.arrays.at("_SPEED")[i], mesh.speed(v), 1e-4);
        EXPECT_NEAR(read.arrays.at("_VELOCITY")[3 * i + 1], mesh.velocity[v].y, 1e-4);
        EXPECT_NEAR(read.arrays.at("_DEFORMATION")[i], mesh.deformation[v], 1e-3);
        EXPECT_EQ(read.arrays.at("_COMPONENT")[i], mesh.component[v]);
        EXPECT_EQ(read.arrays.at("_APPROXIMATED")[i], mesh.approximated[v]);
        EXPECT_NEAR(read.arrays.at("_P__MEAN_")[i], scalars.at("p (mean)")[v], 1e-4);
    }
}

TEST(MeshFile, PlainGlbHoldsTheMeshAsFloatsWithoutAnyExtension) {
    const auto& mesh = surface();
    const auto scalars = pressure(mesh);
    const auto read = tests::read_glb(written(MeshFormat::Glb, mesh, scalars, GlbCoding::Plain));
    const json gltf = json::parse(read.json);
    EXPECT_FALSE(gltf.contains("extensionsRequired"));
    EXPECT_FALSE(gltf.contains("extensionsUsed"));
    ASSERT_EQ(read.points.size(), mesh.vertices());
    const auto corners = triangles_of(mesh);
    ASSERT_EQ(read.faces.size(), corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        EXPECT_EQ(read.faces[i], (std::vector(corners[i].begin(), corners[i].end())));
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        EXPECT_EQ(core::Vec3f(read.points[v]), core::Vec3f(mesh.position[v]));
        EXPECT_EQ(read.arrays.at("_T")[v], double(static_cast<float>(mesh.t[v])));
        EXPECT_EQ(read.arrays.at("_VELOCITY")[3 * v + 1], double(mesh.velocity[v].y));
        EXPECT_EQ(read.arrays.at("_COMPONENT")[v], mesh.component[v]);
        EXPECT_EQ(read.arrays.at("_P__MEAN_")[v], double(scalars.at("p (mean)")[v]));
        const core::Vec3 normal(read.arrays.at("NORMAL")[3 * v],
                                read.arrays.at("NORMAL")[3 * v + 1],
                                read.arrays.at("NORMAL")[3 * v + 2]);
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-6);
    }
    const auto& positions =
        gltf["accessors"]
            [gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
    EXPECT_EQ(positions["max"].size(), 3u);
}

TEST(MeshFile, PlyHasNormalsTextureCoordinatesAndColoursForThoseWhoShowNothingElse) {
    auto mesh = tests::small_mesh();
    for (std::size_t v = 0; v < mesh.vertices(); ++v)
        mesh.velocity[v] = core::Vec3f(static_cast<float>(v), 0, 0);
    const auto read = tests::read_ply(written(MeshFormat::Ply, mesh));
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        EXPECT_EQ(read.arrays.at("u")[v], double(static_cast<float>(mesh.s[v])));
        EXPECT_EQ(read.arrays.at("v")[v], double(static_cast<float>(mesh.t[v])));
        const core::Vec3 normal(read.arrays.at("nx")[v], read.arrays.at("ny")[v],
                                read.arrays.at("nz")[v]);
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-6);
    }
    const auto colour = [&](std::size_t v) {
        return core::Vec3(read.arrays.at("red")[v], read.arrays.at("green")[v],
                          read.arrays.at("blue")[v]);
    };
    // The ends of the table in web-client/src/scene/surface/colourMap.ts.
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(colour(0)[channel], core::Vec3(0x44, 0x01, 0x54)[channel], 4.0);
        EXPECT_NEAR(colour(7)[channel], core::Vec3(0xfd, 0xe7, 0x25)[channel], 4.0);
    }
    EXPECT_EQ(read.about.at("colours"), "viridis, speed 0 to 7");
}

TEST(MeshFile, SaysAtWhichTimeItIsShownWhereThatIsNotItsEnd) {
    MeshMetadata then = metadata;
    then.time = 2.5;
    const auto file = [&](MeshFormat format) {
        return mesh_file(format, tests::small_mesh(), then, {}).value();
    };
    EXPECT_NE(file(MeshFormat::Vtp).find("Name=\"TimeValue\""), std::string::npos);
    EXPECT_EQ(tests::read_ply(file(MeshFormat::Ply)).about.at("time"), "2.5");
    EXPECT_EQ(
        json::parse(tests::read_glb(file(MeshFormat::Glb)).json)["scenes"][0]["extras"]["time"],
        2.5);
    EXPECT_FALSE(
        tests::read_ply(written(MeshFormat::Ply, tests::small_mesh())).about.contains("time"));
}

TEST(MeshFile, OfGlbIsColouredByAgeFromDarkToBright) {
    const core::QuadComplex mesh = surface();
    const auto read = tests::read_glb(written(MeshFormat::Glb, mesh, {}, GlbCoding::Plain));
    const auto& colours = read.arrays.at("COLOR_0");
    ASSERT_EQ(colours.size(), 3 * mesh.vertices());
    const auto brightness = [&](std::size_t v) {
        return 0.2126 * colours[3 * v] + 0.7152 * colours[3 * v + 1] + 0.0722 * colours[3 * v + 2];
    };
    for (std::size_t a = 0; a < mesh.vertices(); ++a)
        for (std::size_t b = 0; b < mesh.vertices(); ++b)
            if (std::abs(mesh.t[a]) < std::abs(mesh.t[b])) {
                EXPECT_LE(brightness(a), brightness(b) + 1e-6);
            }
}

TEST(MeshFile, OfGlbStandsUprightWhereYIsUp) {
    const auto node =
        json::parse(tests::read_glb(written(MeshFormat::Glb, surface())).json)["nodes"][0];
    const auto q = node["rotation"].get<std::vector<double>>();
    const core::Vec3 axis(q[0], q[1], q[2]);
    const auto turned = [&](const core::Vec3& v) {
        return v + 2.0 * glm::cross(axis, glm::cross(axis, v) + q[3] * v);
    };
    EXPECT_LT(glm::length(turned({0, 0, 1}) - core::Vec3(0, 1, 0)), 1e-12);
    EXPECT_LT(glm::length(turned({1, 0, 0}) - core::Vec3(1, 0, 0)), 1e-12);
}

TEST(MeshFile, GlbNamesItsExtensionAndItsBounds) {
    const auto read = tests::read_glb(written(MeshFormat::Glb, surface()));
    const json gltf = json::parse(read.json);
    EXPECT_EQ(gltf["extensionsRequired"], json({"KHR_draco_mesh_compression"}));
    EXPECT_EQ(gltf["extensionsUsed"], gltf["extensionsRequired"]);
    EXPECT_EQ(gltf["asset"]["version"], "2.0");
    EXPECT_EQ(gltf["materials"][0]["doubleSided"], true);
    EXPECT_EQ(gltf["scenes"][0]["extras"]["dataset"], metadata.dataset);
    EXPECT_EQ(gltf["scenes"][0]["extras"]["rake"], json({{0, 0, 0}, {0.1, 1e-300, -2}}));
    const json& positions =
        gltf["accessors"]
            [gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
    for (int axis = 0; axis < 3; ++axis) {
        const auto [lo, hi] =
            std::minmax_element(read.points.begin(), read.points.end(),
                                [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
        EXPECT_EQ(positions["min"][axis].get<float>(), static_cast<float>((*lo)[axis]));
        EXPECT_EQ(positions["max"][axis].get<float>(), static_cast<float>((*hi)[axis]));
    }
}

TEST(MeshFile, GlbKeepsSurfacesOfAnySizeToAMillionthOfIt) {
    for (const double size : {1e-9, 1e-3, 1.0, 1e6, 1e30}) {
        auto mesh = surface();
        for (auto& p : mesh.position)
            p *= size;
        double longest = 0.0;
        for (const auto& p : mesh.position)
            longest = std::max(longest, glm::length(p - mesh.position[0]));
        const auto read = tests::read_glb(written(MeshFormat::Glb, mesh));
        const auto at = vertices_of(mesh, read, "_S", "_T", 2e-5 * size);
        for (std::size_t i = 0; i < at.size(); ++i)
            EXPECT_LT(glm::length(read.points[i] - mesh.position[at[i]]), 1e-6 * longest);
        const auto last = std::max_element(read.points.begin(), read.points.end(),
                                           [](const auto& a, const auto& b) { return a.x < b.x; });
        const json gltf = json::parse(read.json);
        EXPECT_EQ(gltf["accessors"][1]["max"][0].get<float>(), static_cast<float>(last->x)) << size;
    }
}

TEST(MeshFile, DrcHoldsTheSameUnderTheNamesOfTheOtherFormats) {
    const auto& mesh = surface();
    const auto read = tests::read_drc(written(MeshFormat::Drc, mesh, pressure(mesh)));
    const auto at = vertices_of(mesh, read, "s", "t", 1e-5);
    expect_the_triangles_of(mesh, read, at);
    for (const char* name :
         {"speed", "velocity", "deformation", "component", "approximated", "p (mean)"})
        EXPECT_TRUE(read.arrays.contains(name)) << name;
    EXPECT_EQ(read.about.at("kind"), "path");
    EXPECT_EQ(read.about.at("wakesurf"), "1.2.3");
}

TEST(MeshFile, FieldsOfOneSpellingStayApart) {
    const auto mesh = tests::small_mesh();
    const std::vector<float> values(8, 1.0F);
    const MeshScalars scalars{{"s", values}, {"P", values}, {"p", values}, {"p ", values}};
    const auto ply = tests::read_ply(written(MeshFormat::Ply, mesh, scalars));
    for (const char* name : {"s", "s_2", "P", "p", "p_"})
        EXPECT_EQ(ply.arrays.at(name).size(), 8u) << name;
    const auto glb = tests::read_glb(written(MeshFormat::Glb, mesh, scalars));
    for (const char* name : {"_S", "_S_2", "_P", "_P_2", "_P_"})
        EXPECT_EQ(glb.arrays.at(name).size(), 8u) << name;
}

TEST(MeshFile, ValuesThatAreMissingNeverReachDraco) {
    auto mesh = tests::small_mesh();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    mesh.deformation[3] = -infinite;
    const MeshScalars scalars{{"p", {nan, 5, 4, 3, 2, infinite, 6, 7}},
                              {"q", std::vector<float>(8, nan)}};
    const auto read = tests::read_glb(written(MeshFormat::Glb, mesh, scalars));
    EXPECT_EQ(json::parse(read.json)["scenes"][0]["extras"]["missing"],
              (json{{"p", 2}, {"q", 8}, {"deformation", 1}}));
    for (const double value : read.arrays.at("_P"))
        EXPECT_TRUE(value > 1.999 && value < 7.001) << value;
    EXPECT_EQ(read.arrays.at("_Q"), std::vector<double>(8, 0.0));
}

TEST(MeshFile, PositionsThatAreNotFiniteAreRefusedByDracosFormatsOnly) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e300}) {
        auto mesh = tests::small_mesh();
        mesh.position[2].y = bad;
        for (const MeshFormat format : {MeshFormat::Glb, MeshFormat::Drc}) {
            const auto file = mesh_file(format, mesh, metadata, {});
            ASSERT_FALSE(file.has_value());
            EXPECT_NE(file.error().message.find("vertex 2"), std::string::npos)
                << file.error().message;
        }
        EXPECT_TRUE(mesh_file(MeshFormat::Ply, mesh, metadata, {}).has_value());
    }
}

TEST(MeshFile, AllAttributesEqualAndCellsWithoutAreaAreWritten) {
    auto mesh = tests::small_mesh();
    mesh.position.assign(8, {1, 2, 3});
    mesh.s.assign(8, 0.5);
    mesh.t.assign(8, 0.5);
    const auto read = tests::read_glb(written(MeshFormat::Glb, mesh));
    for (const auto& point : read.points)
        EXPECT_EQ(point, core::Vec3(1, 2, 3));
}

TEST(MeshFile, SurfacesWithoutCellsAreEmptyFilesWhereTheFormatHasSuch) {
    EXPECT_EQ(tests::read_ply(written(MeshFormat::Ply, {})).points.size(), 0u);
    EXPECT_EQ(tests::read_obj(written(MeshFormat::Obj, {})).faces.size(), 0u);
    EXPECT_FALSE(
        json::parse(tests::read_glb(written(MeshFormat::Glb, {})).json).contains("meshes"));
    EXPECT_EQ(mesh_file(MeshFormat::Drc, {}, metadata, {}).error().code,
              core::Error::Code::InvalidArgument);
}

TEST(MeshFile, GivesTheSameBytesForTheSameMeshInEveryFormat) {
    for (const MeshFormat format : mesh_formats) {
        const auto first = written(format, surface());
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_TRUE(written(format, surface()) == first) << extension(format);
        EXPECT_EQ(mesh_format(extension(format)), format);
    }
    EXPECT_FALSE(mesh_format("stl").has_value());
    EXPECT_EQ(mesh_extensions(), ".vtp, .glb, .ply, .obj or .drc");
}

} // namespace wakesurf::protocol::mesh_file_test
