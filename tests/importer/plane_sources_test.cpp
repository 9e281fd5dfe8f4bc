// Planes of EnSight, CGNS and Exodus: two parts that meet, in a solid-body rotation about the middle of their square.
#include "importer/assembly/grid_assembly.hpp"
#include "importer/assembly/node_values.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/blocks/plane_slab.hpp"
#include "importer/sources/open_source.hpp"
#include "tests/importer/cgns_files.hpp"
#include "tests/support/ensight_text.hpp"

#include <vtk_exodusII.h>

#include <cmath>

namespace wakesurf::importer::plane_sources_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;
using core::Vec3;

constexpr int wide = 3; ///< nodes of a part along x, and 5 along y
constexpr int high = 5;

/// A unit square, of which the parts are the halves.
struct Square {
    Vec3 along_x{1.0, 0.0, 0.0};
    Vec3 along_y{0.0, 1.0, 0.0};
    double floor = 3.0;
    double bent = 0.0;
    double across = 0.0; ///< velocity
    double apart = 0.0;  ///< the second part, out of the plane

    Vec3 normal() const { return glm::cross(along_x, along_y); }

    Vec3 middle() const { return at(0.5, 0.5); }

    Vec3 at(double x, double y) const {
        return Vec3(1.0, 2.0, floor) + x * along_x + y * along_y + bent * x * x * normal();
    }

    std::vector<Vec3> part(int number) const {
        std::vector<Vec3> out;
        for (int i = 0; i < wide * high; ++i)
            out.push_back(at(0.5 * number + 0.25 * (i % wide), 0.25 * (i / wide)) +
                          number * apart * normal());
        return out;
    }

    Vec3 velocity(const Vec3& p) const {
        return glm::cross(normal(), p - middle()) + across * normal();
    }
};

/// Nodes from 1 on, round each cell: of the first row triangles, then quads.
std::vector<std::vector<int>> cells() {
    std::vector<std::vector<int>> out;
    for (int j = 0; j + 1 < high; ++j)
        for (int i = 0; i + 1 < wide; ++i) {
            const int a = j * wide + i + 1;
            if (j == 0) {
                out.push_back({a, a + 1, a + wide + 1});
                out.push_back({a, a + wide + 1, a + wide});
            } else {
                out.push_back({a, a + 1, a + wide + 1, a + wide});
            }
        }
    return out;
}

template <class Number>
std::vector<Number> nodes_of(std::size_t corners) {
    std::vector<Number> out;
    for (const auto& cell : cells())
        if (cell.size() == corners)
            out.insert(out.end(), cell.begin(), cell.end());
    return out;
}

class PlaneSources : public testing::Test {
  protected:
    fs::path put_ensight(const Square& square, bool scalars = false, bool blocks = false) const {
        EnsightText mesh(EnsightEncoding::Text);
        std::array<EnsightText, 3> values{mesh, mesh, mesh};
        for (auto& file : values)
            file.line("values");
        for (const char* const line : {"a", "b", "node id off", "element id off"})
            mesh.line(line);
        for (int number = 0; number < 2; ++number) {
            const auto points = square.part(number);
            const auto put = [&](EnsightText& out, int c, auto&& of) {
                std::vector<float> all;
                for (const auto& p : points)
                    all.push_back(static_cast<float>(of(p)[c]));
                out.numbers(all);
            };
            for (auto* file : {&mesh, &values[0], &values[1], &values[2]}) {
                file->line("part");
                file->integers({number + 1});
                if (file == &mesh)
                    file->line("half");
                file->line(blocks ? "block" : "coordinates");
            }
            if (blocks)
                mesh.integers({wide, high, 1});
            else
                mesh.integers({wide * high});
            for (int c = 0; c < 3; ++c) {
                put(mesh, c, [](const Vec3& p) { return p; });
                put(values[scalars ? static_cast<std::size_t>(c) : 0], c,
                    [&](const Vec3& p) { return square.velocity(p); });
            }
            if (blocks)
                continue;
            const auto triangles = nodes_of<std::int32_t>(3);
            const auto quads = nodes_of<std::int32_t>(4);
            mesh.line("tria3");
            mesh.integers({static_cast<int>(triangles.size() / 3)});
            mesh.integers(triangles, 3);
            mesh.line("nsided");
            mesh.integers({static_cast<int>(quads.size() / 4)});
            mesh.integers(std::vector<std::int32_t>(quads.size() / 4, 4), 1);
            mesh.integers(quads, 4);
            mesh.line("bar2"); // of the edge
            mesh.integers({1});
            mesh.integers({1, 2});
        }
        write_file(folder_ / "g", mesh.text());
        for (std::size_t c = 0; c < 3; ++c)
            write_file(folder_ / ("v" + std::to_string(c)), values[c].text());
        write_file(folder_ / "flow.case",
                   std::string("FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: g\nVARIABLE\n") +
                       (scalars ? "scalar per node: u v0\nscalar per node: v v1\n"
                                : "vector per node: velocity v0\n"));
        return folder_ / "flow.case";
    }

    /// @param edges_first  elements of the edge are numbered before the cells
    fs::path put_cgns(const Square& square,
                      int space,
                      bool structured,
                      bool edges_first = false,
                      bool polygons = false) const {
        const auto path = folder_ / "flow.cgns";
        fs::remove(path);
        int file = 0;
        int at = 0;
        ok(cg_set_file_type(CG_FILE_HDF5));
        ok(cg_open(path.c_str(), CG_MODE_WRITE, &file));
        ok(cg_base_write(file, "Base", 2, space, &at));
        for (int number = 0; number < 2; ++number) {
            const auto all = static_cast<cgsize_t>(cells().size());
            const std::vector<cgsize_t> size =
                structured ? std::vector<cgsize_t>{wide, high, wide - 1, high - 1, 0, 0}
                           : std::vector<cgsize_t>{wide * high, all, 0};
            int zone = 0;
            ok(cg_zone_write(file, 1, ("Zone" + std::to_string(number)).c_str(), size.data(),
                             structured ? CGNS_ENUMV(Structured) : CGNS_ENUMV(Unstructured),
                             &zone));
            int solution = 0;
            ok(cg_sol_write(file, 1, zone, "Flow", CGNS_ENUMV(Vertex), &solution));
            for (int c = 0; c < space; ++c) {
                std::vector<double> place;
                std::vector<double> velocity;
                for (const auto& p : square.part(number)) {
                    place.push_back(p[c]);
                    velocity.push_back(square.velocity(p)[c]);
                }
                const std::string axis(1, "XYZ"[c]);
                ok(cg_coord_write(file, 1, zone, CGNS_ENUMV(RealDouble),
                                  ("Coordinate" + axis).c_str(), place.data(), &at));
                ok(cg_field_write(file, 1, zone, solution, CGNS_ENUMV(RealDouble),
                                  ("Velocity" + axis).c_str(), velocity.data(), &at));
            }
            if (structured)
                continue;
            cgsize_t next = 1;
            const auto put = [&](const char* name, auto type, std::size_t corners,
                                 const std::vector<cgsize_t>& nodes) {
                const auto count = static_cast<cgsize_t>(nodes.size() / corners);
                ok(cg_section_write(file, 1, zone, name, type, next, next + count - 1, 0,
                                    nodes.data(), &at));
                next += count;
            };
            if (edges_first)
                put("Edge", CGNS_ENUMV(BAR_2), 2, {1, 2, 2, 3});
            if (polygons) {
                std::vector<cgsize_t> nodes;
                std::vector<cgsize_t> offsets{0};
                for (const auto& cell : cells()) {
                    nodes.insert(nodes.end(), cell.begin(), cell.end());
                    offsets.push_back(static_cast<cgsize_t>(nodes.size()));
                }
                ok(cg_poly_section_write(file, 1, zone, "Polygons", CGNS_ENUMV(NGON_n), 1, all, 0,
                                         nodes.data(), offsets.data(), &at));
                continue;
            }
            put("Triangles", CGNS_ENUMV(TRI_3), 3, nodes_of<cgsize_t>(3));
            put("Quads", CGNS_ENUMV(QUAD_4), 4, nodes_of<cgsize_t>(4));
            if (!edges_first)
                put("Edge", CGNS_ENUMV(BAR_2), 2, {1, 2, 2, 3});
        }
        ok(cg_close(file));
        return path;
    }

    /// @param space  coordinates of a node; with three the cells are shells
    fs::path put_exodus(const Square& square, int space) const {
        const auto path = folder_ / "flow.exo";
        int word = 8;
        int stored = 8;
        const int file = ex_create(path.c_str(), EX_CLOBBER, &word, &stored);
        const auto triangles = nodes_of<int>(3);
        const auto quads = nodes_of<int>(4);
        auto points = square.part(0);
        const auto second = square.part(1);
        points.insert(points.end(), second.begin(), second.end());
        const auto count = static_cast<std::int64_t>(points.size());
        const auto cell_count = static_cast<std::int64_t>(2 * cells().size());
        ex_put_init(file, "plane", space, count, cell_count, 4, 0, 0);
        std::array<std::vector<double>, 3> place;
        std::array<std::vector<double>, 3> velocity;
        for (const auto& p : points)
            for (int c = 0; c < 3; ++c) {
                place.at(static_cast<std::size_t>(c)).push_back(p[c]);
                velocity.at(static_cast<std::size_t>(c)).push_back(square.velocity(p)[c]);
            }
        ex_put_coord(file, place[0].data(), place[1].data(),
                     space == 3 ? place[2].data() : nullptr);
        for (int block = 0; block < 4; ++block) {
            const bool of_triangles = block % 2 == 0;
            auto nodes = of_triangles ? triangles : quads;
            for (int& node : nodes)
                node += block / 2 * wide * high;
            const int corners = of_triangles ? 3 : 4;
            const auto size = static_cast<std::int64_t>(nodes.size()) / corners;
            ex_put_block(file, EX_ELEM_BLOCK, block + 1,
                         space == 3     ? of_triangles ? "TRISHELL3" : "SHELL4"
                         : of_triangles ? "TRI3"
                                        : "QUAD4",
                         size, corners, 0, 0, 0);
            ex_put_conn(file, EX_ELEM_BLOCK, block + 1, nodes.data(), nullptr, nullptr);
        }
        ex_put_variable_param(file, EX_NODAL, space);
        for (int c = 0; c < space; ++c)
            ex_put_variable_name(file, EX_NODAL, c + 1,
                                 (std::string("velocity_") + "xyz"[c]).c_str());
        const double time = 0.0;
        ex_put_time(file, 1, &time);
        for (int c = 0; c < space; ++c)
            ex_put_var(file, 1, EX_NODAL, c + 1, 1, count,
                       velocity.at(static_cast<std::size_t>(c)).data());
        ex_close(file);
        return path;
    }

    TemporaryFolder folder_;
};

/// The halves hang together, each node has the velocity of the rotation, and the thickness is the cells' width.
void expect_rotation(const fs::path& path, const Square& square) {
    const auto source = open_source(path);
    ASSERT_TRUE(source.has_value()) << source.error().message;
    const auto& fields = (*source)->description().fields;
    const auto choice = choose_velocity(fields, "");
    ASSERT_TRUE(choice.has_value()) << choice.error().message;
    const auto step = (*source)->read(0, choice->parts.arrays);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    const auto even = even_slabs(step->blocks);
    ASSERT_TRUE(even.has_value()) << even.error().message;
    const auto slab = assemble_grid(step->blocks);
    ASSERT_TRUE(slab.has_value()) << slab.error().message;
    ASSERT_TRUE(slab->across.has_value());
    EXPECT_NEAR(std::abs(glm::dot(*slab->across, square.normal())), 1.0, 1e-4);
    const auto& points = std::get<core::CellMesh>(slab->grid).points;
    EXPECT_EQ(points.size(), 2u * (2 * wide - 1) * high);
    const auto velocity = node_values(*slab, step->blocks, choice->parts, {});
    ASSERT_TRUE(velocity.has_value()) << velocity.error().message;
    const double thickness = std::sqrt(1.0 / static_cast<double>(slab->source_cells));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 p = points[i];
        const double height = glm::dot(p - square.middle(), square.normal());
        EXPECT_NEAR(std::abs(height), 0.5 * thickness, 1e-4);
        const Vec3 expected = square.velocity(p - height * square.normal());
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR((*velocity)[3 * i + static_cast<std::size_t>(c)], expected[c], 1e-4);
    }
}

Square slanting() {
    const double r = std::sqrt(0.5);
    return {{r, r, 0.0}, {-0.5, 0.5, r}};
}

TEST_F(PlaneSources, OfEnsightAreOneSlabAlongAxesAndSlantingWithVectorsOrTwoScalars) {
    expect_rotation(put_ensight({}), {});
    expect_rotation(put_ensight(slanting()), slanting());
    expect_rotation(put_ensight({}, true), {});
    expect_rotation(put_ensight({}, false, true), {});
    expect_rotation(put_ensight(slanting(), false, true), slanting());
}

TEST_F(PlaneSources, OfCgnsAreOneSlabWithTwoCoordinatesOrThreeWhateverTheirElementsNumbers) {
    for (const bool structured : {true, false})
        for (const int space : {2, 3}) {
            Square flat;
            flat.floor = space == 2 ? 0.0 : 3.0;
            expect_rotation(put_cgns(flat, space, structured), flat);
        }
    expect_rotation(put_cgns(slanting(), 3, true), slanting());
    expect_rotation(put_cgns(slanting(), 3, false), slanting());
    Square flat;
    flat.floor = 0.0;
    expect_rotation(put_cgns(flat, 2, false, true), flat);
    expect_rotation(put_cgns(slanting(), 3, false, false, true), slanting());
    expect_rotation(put_cgns(slanting(), 3, false, true), slanting());
}

TEST_F(PlaneSources, OfExodusAreOneSlabOfShellsOrOfAFileWithTwoDimensions) {
    Square flat;
    flat.floor = 0.0;
    expect_rotation(put_exodus(flat, 2), flat);
    expect_rotation(put_exodus({}, 3), {});
    expect_rotation(put_exodus(slanting(), 3), slanting());
}

TEST_F(PlaneSources, ThatAreNotOneAreRefused) {
    Square bent;
    bent.bent = 0.1;
    for (const auto& path : {put_ensight(bent), put_cgns(bent, 3, false), put_exodus(bent, 3)}) {
        const auto source = open_source(path);
        ASSERT_FALSE(source.has_value()) << path;
        EXPECT_NE(source.error().message.find("do not lie in one plane"), std::string::npos)
            << source.error().message;
    }
    Square apart;
    apart.apart = 0.3;
    for (const auto& path : {put_ensight(apart), put_cgns(apart, 3, true), put_exodus(apart, 3)}) {
        const auto source = open_source(path);
        ASSERT_TRUE(source.has_value()) << source.error().message;
        const auto step = (*source)->read(0, (*source)->description().fields);
        ASSERT_TRUE(step.has_value());
        const auto slab = even_slabs(step->blocks);
        ASSERT_FALSE(slab.has_value()) << path;
        EXPECT_NE(slab.error().message.find("parts that do not lie in one plane"),
                  std::string::npos)
            << slab.error().message;
    }
}

} // namespace
} // namespace wakesurf::importer::plane_sources_test
