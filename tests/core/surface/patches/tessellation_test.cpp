// Cells cut into smaller ones: what stays as it was, that nothing cracks, and of which order the result is, against the exact surface.
#include "tests/support/drawn_surfaces.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <utility>

namespace wakesurf::core::tessellation_test {

using namespace tests;

namespace {

/// What cracks would show on: sides, tears, mid nodes, a rake that goes round, creases, both directions.
std::vector<DrawnCase> shapes() {
    using Kind = SurfaceKind;
    const Rake across{Rake::Kind::Line, {{-2, -0.6, 0.1}, {-2, 0.6, 0.1}}, 6};
    const Rake circle{Rake::Kind::Circle, {{0, 0, 0}, {1, 0, 0.3}, {0, 1, 0}}, 5};
    const Rake bent{Rake::Kind::Polyline, {{0.4, 0, 0}, {1.0, 0, 0}, {1.0, 0, 0.8}}, 4};
    const Rake line{Rake::Kind::Line, {{0.4, 0.1, 0.3}, {0.5, 0.9, 1.5}}, 4};
    return {
        {"round a sphere", "sphere", across, {.kind = Kind::Stream, .to = 5.0}},
        {"streak round a sphere", "sphere", across, {.kind = Kind::Streak, .to = 4.0}},
        {"from a circle", "abc", circle, {.kind = Kind::Stream, .to = 2.0}},
        {"streak from a circle", "abc", circle, {.kind = Kind::Streak, .to = 1.5}},
        {"from a bent rake", "lamb-oseen", bent, {.kind = Kind::Stream, .to = 1.0}},
        {"streak from a bent rake", "lamb-oseen", bent, {.kind = Kind::Streak, .to = 1.0}},
        {"both ways", "abc", line, {.kind = Kind::Stream, .to = 1.0, .direction = Direction::Both}},
        {"back in time", "abc", line, {.kind = Kind::Time, .to = -1.0, .sweep = Vec3(0, 1, 0)}}};
}

/// Sides between vertices that only one cell has, by the cells' outlines.
std::size_t open_sides(const QuadComplex& mesh) {
    std::map<std::pair<VertexId, VertexId>, int> cells;
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        for (std::uint32_t i = 0; i < outline.count; ++i)
            ++cells[std::minmax(outline.vertex[i], outline.vertex[(i + 1) % outline.count])];
    }
    std::size_t open = 0;
    for (const auto& [side, count] : cells) {
        EXPECT_LE(count, 2);
        open += count == 1;
    }
    return open;
}

DrawnSurface helicoid(double separation) {
    return {{"", "rotation?w=0.3", {Rake::Kind::Line, {{0.5, 0, 0}, {2, 0, 0}}, 4}, {.to = 3.0}},
            separation};
}

} // namespace

TEST(Tessellation, ItsVerticesAreOfFourthOrderWhereFlatCellsAreOfSecond) {
    for (const DrawnCase& c : drawn_cases()) {
        std::vector<DrawnError> curved, flat;
        for (const double separation : {0.1, 0.05}) {
            const DrawnSurface of(c, separation);
            const std::size_t before = of.surface.mesh.vertices();
            const Tessellation fine = of.cut(4);
            EXPECT_EQ(fine.flat_cells, 0) << c.name;
            curved.push_back(drawn_error(of, fine.mesh, before, 300));
            flat.push_back(drawn_error(of, of.cut_flat(4).mesh, before, 300));
        }
        std::printf("%-22s slope %.2f, of the largest %.2f; %.0f and %.0f times nearer at 0.1\n",
                    c.name.c_str(), std::log2(curved[0].rms / curved[1].rms),
                    std::log2(curved[0].most / curved[1].most), flat[0].rms / curved[0].rms,
                    flat[0].most / curved[0].most);
        EXPECT_GE(std::log2(curved[0].rms / curved[1].rms), 3.5) << c.name;
        EXPECT_GE(flat[0].rms, 20.0 * curved[0].rms) << c.name;
        EXPECT_GE(flat[0].most, 20.0 * curved[0].most) << c.name;
    }
}

TEST(Tessellation, WhatIsDrawnOfEightPiecesIsTwentyTimesNearer) {
    const DrawnSurface of = helicoid(0.1);
    const QuadComplex fine = of.cut(8).mesh;
    const QuadComplex& coarse = of.surface.mesh;
    const auto farthest = [](const QuadComplex& mesh) {
        double most = 0.0;
        for (const Cell& cell : mesh.cells)
            for (std::size_t k = 0; k < 2; ++k) { // the middles of both diagonals
                const Vec3 p =
                    0.5 * (mesh.position[cell.corner[k]] + mesh.position[cell.corner[k + 2]]);
                const double angle = std::atan2(p.y, p.x);
                most = std::max(most, std::abs(p.z - 0.3 * angle));
            }
        return most;
    };
    EXPECT_LT(20.0 * farthest(fine), farthest(coarse));
}

TEST(Tessellation, NormalsAndCoordinatesFollowTheSurface) {
    const DrawnSurface of = helicoid(0.1);
    const QuadComplex fine = of.cut(5).mesh;
    for (std::size_t v = 0; v < fine.vertices(); ++v) {
        const Vec3& p = fine.position[v];
        EXPECT_NEAR(fine.s[v], (std::hypot(p.x, p.y) - 0.5) / 1.5, 1e-4);
        EXPECT_NEAR(fine.t[v], std::atan2(p.y, p.x), 2e-4);
        const Vec3 normal = glm::normalize(
            glm::cross(Vec3(p.x, p.y, 0.0) / std::hypot(p.x, p.y), Vec3(-p.y, p.x, 0.3)));
        EXPECT_GT(std::abs(glm::dot(normal, Vec3(fine.normal[v]))), 1.0 - 1e-6);
        EXPECT_LT(glm::length(Vec3(fine.velocity[v]) - Vec3(-p.y, p.x, 0.3)), 1e-6);
    }
}

TEST(Tessellation, KeepsItsVerticesAndHasNoCracks) {
    for (const DrawnCase& c : shapes())
        for (const std::uint32_t pieces : {2u, 3u, 4u}) {
            const DrawnSurface of(c, 0.2);
            const QuadComplex& coarse = of.surface.mesh;
            const QuadComplex fine = of.cut(pieces).mesh;
            EXPECT_EQ(fine.validate(), "") << c.name;
            EXPECT_EQ(fine.cells.size(), coarse.cells.size() * pieces * pieces) << c.name;
            EXPECT_TRUE(
                std::equal(coarse.position.begin(), coarse.position.end(), fine.position.begin()));
            EXPECT_TRUE(std::equal(coarse.s.begin(), coarse.s.end(), fine.s.begin()));
            EXPECT_TRUE(
                std::equal(coarse.velocity.begin(), coarse.velocity.end(), fine.velocity.begin()));
            EXPECT_EQ(open_sides(fine), pieces * open_sides(coarse)) << c.name;
        }
}

TEST(Tessellation, IsTheSameOnAnyNumberOfThreads) {
    const DrawnSurface of(shapes()[3], 0.2);
    const auto cut = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return of.cut(3).mesh; });
    };
    const QuadComplex one = cut(1), four = cut(4);
    EXPECT_EQ(one.position, four.position);
    EXPECT_EQ(one.normal, four.normal);
    EXPECT_EQ(one.cells, four.cells);
}

TEST(Tessellation, IsFlatWithoutTangentsOnEitherSideAlike) {
    DrawnSurface of(shapes()[2], 0.2);
    QuadComplex& mesh = of.surface.mesh;
    for (std::size_t v = 0; v < mesh.vertices(); v += 3)
        mesh.tangents[v] = {Vec3(NAN), Vec3(1e9)};
    const Tessellation cut = of.cut(3);
    EXPECT_EQ(cut.mesh.validate(), "");
    EXPECT_EQ(open_sides(cut.mesh), 3 * open_sides(mesh));
    for (const Vec3& each : cut.mesh.position)
        EXPECT_TRUE(finite(each));
    EXPECT_EQ(of.cut_flat(3).flat_cells, mesh.cells.size());
}

TEST(Tessellation, OfOnePieceIsTheMeshItself) {
    const DrawnSurface of = helicoid(0.2);
    const QuadComplex same = of.cut(1).mesh;
    EXPECT_EQ(same.position, of.surface.mesh.position);
    EXPECT_EQ(same.cells, of.surface.mesh.cells);
    EXPECT_TRUE(same.normal.empty());
}

TEST(Tessellation, RefusesWhatIsEmptyTooLargeOrHasNoMemory) {
    EXPECT_EQ(tessellate(QuadComplex{}, 4, {}, false).error().code, Error::Code::InvalidArgument);
    QuadComplex large = helicoid(0.2).surface.mesh;
    large.cells.resize(100'000);
    const auto refused = tessellate(large, 64, {}, false);
    EXPECT_EQ(refused.error().code, Error::Code::OverLimit);
    EXPECT_NE(refused.error().message.find("409600000 quads"), std::string::npos);
    const MemoryAccount account(1 << 20);
    WorkMemory memory(account, {}, std::chrono::milliseconds(0));
    const auto short_of_memory =
        tessellate(helicoid(0.2).surface.mesh, 32, {}, false, {nullptr, &memory});
    EXPECT_EQ(short_of_memory.error().code, Error::Code::OverLimit);
}

} // namespace wakesurf::core::tessellation_test
