// Files in which every cell, or every patch of cells, has nodes of its own, as finite element programs write them: the nodes are joined, however
// 32-bit coordinates were rounded, and no particle is lost between cells.
#include "core/dataset/time_step_cache.hpp"
#include "core/field/stored_flow.hpp"
#include "importer/assembly/grid_assembly.hpp"
#include "importer/assembly/node_values.hpp"
#include "tests/importer/known_flow.hpp"
#include "tests/support/sampled_source.hpp"

#include <vtkFloatArray.h>
#include <vtkPoints.h>

#include <map>
#include <random>

namespace wakesurf::importer::soup_test {
namespace {

using core::Vec3;

class Soup {
  public:
    explicit Soup(double noise, int type = VTK_DOUBLE) : noise_(-noise, noise) {
        points_->SetDataType(type);
    }

    /// n^3 hexahedra; nodes are shared inside of a box, but with none of another.
    void add_box(const Vec3& lo, const Vec3& hi, int n = 1) {
        const vtkIdType first = points_->GetNumberOfPoints();
        for (int k = 0; k <= n; ++k)
            for (int j = 0; j <= n; ++j)
                for (int i = 0; i <= n; ++i) {
                    const Vec3 p = lo + (hi - lo) * Vec3(i, j, k) / double(n);
                    points_->InsertNextPoint(p.x + noise_(random_), p.y + noise_(random_),
                                             p.z + noise_(random_));
                }
        const vtkIdType row = n + 1, slice = row * row;
        for (int k = 0; k < n; ++k)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const vtkIdType a = first + i + row * j + slice * k;
                    const std::array<vtkIdType, 8> nodes{
                        a,         a + 1,         a + row + 1,         a + row,
                        a + slice, a + slice + 1, a + slice + row + 1, a + slice + row};
                    grid_->InsertNextCell(VTK_HEXAHEDRON, 8, nodes.data());
                }
    }

    /// m^3 boxes of n^3 cells.
    void add_boxes(const Vec3& lo, const Vec3& hi, int m, int n = 1) {
        const Vec3 size = (hi - lo) / double(m);
        for (int k = 0; k < m; ++k)
            for (int j = 0; j < m; ++j)
                for (int i = 0; i < m; ++i)
                    add_box(lo + size * Vec3(i, j, k), lo + size * Vec3(i + 1, j + 1, k + 1), n);
    }

    vtkSmartPointer<vtkDataSet> take() {
        grid_->SetPoints(points_);
        return grid_;
    }

  private:
    std::mt19937 random_{3};
    std::uniform_real_distribution<double> noise_;
    vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
    vtkSmartPointer<vtkUnstructuredGrid> grid_ = vtkSmartPointer<vtkUnstructuredGrid>::New();
};

GridAssembly assembled(const std::vector<vtkSmartPointer<vtkDataSet>>& blocks) {
    auto out = assemble_grid(blocks);
    EXPECT_TRUE(out.has_value());
    return out ? std::move(*out) : GridAssembly();
}

/// (1, 0.3 z, 0.2): a particle goes to (x + t, y + 0.3 (z t + 0.1 t^2), z + 0.2 t).
Vec3 wind(const Vec3& p, double) {
    return {1.0, 0.3 * p.z, 0.2};
}

void expect_particles_pass(const GridAssembly& assembly) {
    const auto flow = core::make_stored_flow(std::make_shared<core::TimeStepCache>(
        std::make_shared<tests::SampledSource>(assembly.grid, std::vector{0.0}, wind),
        core::TimeStepCache::Options{}));
    std::vector<core::Curve> curves(400);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        curves[i].seed = Vec3(0.05, 0.1 + 1.1 * double(i % 20) / 20.0, 0.1 + double(i / 20) / 20.0);
        curves[i].duration = 1.9;
    }
    ASSERT_TRUE(flow->trace(curves, {.frozen = true, .tolerance = 1e-8, .longest_step = 0.1}, {}));
    int lost = 0;
    double worst = 0.0;
    for (const auto& curve : curves) {
        lost += curve.end != core::CurveEnd::Time;
        const Vec3& p = curve.seed;
        const double t = curve.last.time;
        worst = std::max(
            worst, glm::length(curve.last.position -
                               Vec3(p.x + t, p.y + 0.3 * (p.z * t + 0.1 * t * t), p.z + 0.2 * t)));
    }
    EXPECT_EQ(lost, 0);
    EXPECT_LT(worst, 1e-5);
}

TEST(Soup, OfRoundedNodesIsOneMesh) {
    for (const int type : {VTK_FLOAT, VTK_DOUBLE})
        for (const int inside : {1, 2}) {
            Soup soup(1e-7, type);
            soup.add_boxes(Vec3(0), Vec3(2), 6 / inside, inside);
            const auto mesh = assembled({soup.take()});
            EXPECT_EQ(core::node_count(mesh.grid), 7u * 7u * 7u);
            EXPECT_EQ(core::cell_count(mesh.grid), 216u);
            EXPECT_NE(mesh.note.find("points were joined"), std::string::npos) << mesh.note;
            EXPECT_NE(mesh.note.find("9.5e-07"), std::string::npos) << mesh.note;
            expect_particles_pass(mesh);
        }
}

TEST(Soup, InSeveralFilesIsOneMesh) {
    std::vector<vtkSmartPointer<vtkDataSet>> files;
    for (int part = 0; part < 2; ++part) {
        Soup soup(1e-7, VTK_FLOAT);
        for (int i = 0; i < 2; ++i)
            soup.add_box(Vec3(0.5 * (2 * part + i), 0, 0), Vec3(0.5 * (2 * part + i + 1), 2, 2), 4);
        files.push_back(soup.take());
    }
    const auto mesh = assembled(files);
    EXPECT_EQ(core::node_count(mesh.grid), 17u * 5u * 5u);
    expect_particles_pass(mesh);
}

TEST(Soup, OfCellsOfSeveralSizesLosesNoParticleAtTheirFaces) {
    Soup soup(1e-7, VTK_FLOAT);
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const Vec3 lo = Vec3(i, j, k);
                if ((i + j + k) % 2 == 0)
                    soup.add_box(lo, lo + 1.0);
                else
                    soup.add_boxes(lo, lo + 1.0, i == 1 ? 4 : 3);
            }
    expect_particles_pass(assembled({soup.take()}));
}

TEST(Soup, KeepsCellsThinnerThanTheRoundingOfTheirPlace) {
    // 1e-6 thick, a thousand away from the origin: 32 bits there are 6e-5.
    for (const double noise : {0.0, 2e-9}) {
        Soup soup(noise);
        for (int k = 0; k < 8; ++k)
            for (int i = 0; i < 3; ++i)
                soup.add_box(Vec3(1000.0 + 0.01 * i, 0.0, 1e-6 * k),
                             Vec3(1000.0 + 0.01 * (i + 1), 0.01, 1e-6 * (k + 1)));
        const auto mesh = assembled({soup.take()});
        EXPECT_EQ(core::node_count(mesh.grid), 4u * 2u * 9u) << noise;
        EXPECT_EQ(core::cell_count(mesh.grid), 24u) << noise;
        EXPECT_EQ(mesh.note.find("without volume"), std::string::npos) << mesh.note;
    }
}

TEST(Soup, AveragesValuesOfCellsOverTheNodesThatWereJoined) {
    Soup soup(1e-7, VTK_FLOAT);
    soup.add_boxes(Vec3(0), Vec3(2), 4);
    const std::vector<vtkSmartPointer<vtkDataSet>> blocks{soup.take()};
    auto values = vtkSmartPointer<vtkFloatArray>::New();
    values->SetName("T");
    for (vtkIdType i = 0; i < blocks[0]->GetNumberOfCells(); ++i) {
        const auto c = tests::cell_centre(*blocks[0], i);
        values->InsertNextValue(static_cast<float>(1.0 + c[0] - 2.0 * c[2]));
    }
    blocks[0]->GetCellData()->AddArray(values);
    const auto mesh = assembled(blocks);
    const FieldParts field{{{"T", 1, core::FieldInfo::Source::Cell, {0, 0}, {}}}, {}, 1};
    const auto nodes = node_values(mesh, blocks, field, {}).value();
    const auto& points = std::get<core::CellMesh>(mesh.grid).points;
    int inside = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points[i];
        if (std::min({p.x, p.y, p.z}) < 0.1 || std::max({p.x, p.y, p.z}) > 1.9)
            continue;
        ++inside;
        EXPECT_NEAR(nodes[i], 1.0 + p.x - 2.0 * p.z, 1e-5);
    }
    EXPECT_EQ(inside, 27);
}

TEST(Soup, LeavesTheSidesOfABaffleApart) {
    // Two rows of cells that share the nodes of the first column; the others lie at one place twice.
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    std::map<std::array<int, 4>, vtkIdType> made;
    const auto node = [&](int i, int j, int k, int side) {
        const auto [at, added] =
            made.try_emplace({i, j, k, j == 1 && i > 1 ? side : 0}, points->GetNumberOfPoints());
        if (added)
            points->InsertNextPoint(i, j, k);
        return at->second;
    };
    for (int side = 0; side < 2; ++side)
        for (int i = 0; i < 4; ++i) {
            std::array<vtkIdType, 8> nodes{};
            for (int c = 0; c < 8; ++c)
                nodes[static_cast<std::size_t>(c)] =
                    node(i + ((c + 1) / 2 % 2), side + (c / 2 % 2), c / 4, side);
            grid->InsertNextCell(VTK_HEXAHEDRON, 8, nodes.data());
        }
    grid->SetPoints(points);
    const auto mesh = assembled({grid});
    EXPECT_EQ(core::node_count(mesh.grid), std::size_t(points->GetNumberOfPoints()));
    EXPECT_EQ(mesh.note, "");
}

} // namespace
} // namespace wakesurf::importer::soup_test
