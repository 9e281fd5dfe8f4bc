// Curves through tetrahedra with linear velocity, beside the exponential of its matrix: Scheuermann et al. 2001.
#include "core/field/cells/cell_sampler.hpp"
#include "tests/support/meshed_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace wakesurf::core::linear_tets_test {

using namespace tests;

namespace {

/// Velocity `slope` x + `constant`.
struct LinearField {
    glm::dmat3 slope{0.0};
    Vec3 constant{0.0};

    Vec3 operator()(const Vec3& p) const { return slope * p + constant; }

    /// Where a particle is after a time, by scaling and squaring of the exponential of the 4 x 4 matrix, in long double.
    Vec3 after(const Vec3& seed, double time) const {
        using Matrix = std::array<std::array<long double, 4>, 4>;
        const auto product = [](const Matrix& a, const Matrix& b) {
            Matrix out{};
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    for (std::size_t k = 0; k < 4; ++k)
                        out[i][j] += a[i][k] * b[k][j];
            return out;
        };
        constexpr int halvings = 12;
        Matrix m{}, sum{}, power{};
        for (std::size_t i = 0; i < 4; ++i) {
            sum[i][i] = power[i][i] = 1.0L;
            for (std::size_t j = 0; j < 4 && i < 3; ++j)
                m[i][j] =
                    static_cast<long double>(j < 3 ? slope[static_cast<int>(j)][static_cast<int>(i)]
                                                   : constant[static_cast<int>(i)]) *
                    static_cast<long double>(time) / (1 << halvings);
        }
        for (int k = 1; k < 20; ++k) {
            power = product(power, m);
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j) {
                    power[i][j] /= k;
                    sum[i][j] += power[i][j];
                }
        }
        for (int k = 0; k < halvings; ++k)
            sum = product(sum, sum);
        Vec3 out;
        for (int i = 0; i < 3; ++i) {
            const auto& row = sum[static_cast<std::size_t>(i)];
            out[i] = static_cast<double>(row[0] * static_cast<long double>(seed.x) +
                                         row[1] * static_cast<long double>(seed.y) +
                                         row[2] * static_cast<long double>(seed.z) + row[3]);
        }
        return out;
    }
};

/// Entries are multiples of 1/32 and nodes of 1/256, so that a node's velocity is no longer than a float: the stored data are the field.
LinearField random_field(std::mt19937& random) {
    std::uniform_int_distribution<int> entry(-40, 40);
    LinearField field;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            field.slope[i][j] = entry(random) / 32.0;
        field.constant[i] = entry(random) / 64.0;
    }
    return field;
}

/// 8^3 cubes from 0 to 1 of six tetrahedra each, inner nodes moved at random.
CellMesh random_tetrahedra(std::mt19937& random) {
    constexpr std::uint32_t n = 8;
    std::uniform_int_distribution<int> by(-6, 6);
    CellMesh mesh;
    for (std::uint32_t z = 0; z <= n; ++z)
        for (std::uint32_t y = 0; y <= n; ++y)
            for (std::uint32_t x = 0; x <= n; ++x) {
                Vec3 p = Vec3(x, y, z) * 32.0;
                for (int axis = 0; axis < 3; ++axis)
                    if (p[axis] > 0.0 && p[axis] < 256.0)
                        p[axis] += by(random);
                mesh.points.push_back(p / 256.0);
            }
    const auto node = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return (z * (n + 1) + y) * (n + 1) + x;
    };
    constexpr std::array<std::array<std::uint32_t, 3>, 6> orders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n; ++x)
                for (std::size_t which = 0; which < orders.size(); ++which) {
                    std::array<std::uint32_t, 3> at{x, y, z};
                    std::vector<std::uint32_t> corners{node(x, y, z)};
                    for (const std::uint32_t axis : orders[which]) {
                        ++at[axis];
                        corners.push_back(node(at[0], at[1], at[2]));
                    }
                    if (which >= 3) // odd orders turn the other way round
                        std::swap(corners[1], corners[2]);
                    add_cell(mesh, CellShape::Tetrahedron, corners);
                }
    connect_cells(mesh);
    return mesh;
}

/// A velocity that is not linear: between the nodes it has another slope in each tetrahedron.
Vec3 swirling(const Vec3& p) {
    const Vec3 v(1.0 + 0.6 * std::sin(7.0 * p.y), std::cos(5.0 * p.x + 3.0 * p.z) - 0.3,
                 0.8 * std::sin(6.0 * p.x * p.y) + 0.2);
    return Vec3(Vec3f(v)); // as it is stored
}

/// One tetrahedron and what is linear in it.
struct Tetrahedron {
    glm::dmat3 to_share; ///< of nodes 1 to 3, from the place beside node 0
    Vec3 origin;
    LinearField field;

    double least_share(const Vec3& p) const {
        const Vec3 share = to_share * (p - origin);
        return std::min({share.x, share.y, share.z, 1.0 - share.x - share.y - share.z});
    }
};

std::vector<Tetrahedron> tetrahedra_of(const CellMesh& mesh) {
    std::vector<Tetrahedron> out;
    for (const MeshCell& cell : mesh.cells) {
        const auto at = [&](int i) { return mesh.points[cell.node[static_cast<std::size_t>(i)]]; };
        const Vec3 v = swirling(at(0));
        Tetrahedron one;
        one.origin = at(0);
        one.to_share = glm::inverse(glm::dmat3(at(1) - at(0), at(2) - at(0), at(3) - at(0)));
        one.field.slope =
            glm::dmat3(swirling(at(1)) - v, swirling(at(2)) - v, swirling(at(3)) - v) *
            one.to_share;
        one.field.constant = v - one.field.slope * at(0);
        out.push_back(one);
    }
    return out;
}

/// From tetrahedron to tetrahedron by the matrix exponential, each left where it ends to the last bit; nothing where the mesh ends.
std::optional<Vec3> by_exponentials(const std::vector<Tetrahedron>& mesh, Vec3 p, double time) {
    constexpr double beside = 1e-9; // times the velocity: which tetrahedron comes next
    while (time > 0.0) {
        const Tetrahedron* inside = nullptr;
        for (const Tetrahedron& each : mesh)
            if (const Vec3 ahead = p + beside * each.field(p);
                inside == nullptr && each.least_share(ahead) >= 0.0)
                inside = &each;
        if (inside == nullptr)
            return std::nullopt;
        const auto is_inside = [&](double after) {
            return inside->least_share(inside->field.after(p, after)) >= 0.0;
        };
        // A piece is too short for the curve to leave and come back within it.
        constexpr double piece = 1.0 / 1024.0;
        double good = std::min(beside, time), bad = good;
        while (bad < time && is_inside(bad)) {
            good = bad;
            bad = std::min(bad + piece, time);
        }
        if (is_inside(bad))
            good = bad;
        else
            for (int k = 0; k < 60; ++k)
                (is_inside(0.5 * (good + bad)) ? good : bad) = 0.5 * (good + bad);
        p = inside->field.after(p, good);
        time -= good;
        if (good == 0.0)
            return std::nullopt;
    }
    return p;
}

} // namespace

TEST(LinearTets, CurvesGoFromOneTetrahedronToTheNextByTheExponentialOfEach) {
    std::mt19937 random(29);
    std::uniform_real_distribution<double> place(0.15, 0.7);
    const CellMesh mesh = random_tetrahedra(random);
    const auto tetrahedra = tetrahedra_of(mesh);
    const auto flow = meshed_flow(mesh, {0.0}, [](const Vec3& p, double) { return swirling(p); });
    std::vector<Curve> curves(40);
    for (Curve& curve : curves) {
        const double x = place(random), y = place(random), z = place(random);
        curve.seed = {x, y, z};
        curve.duration = 0.4;
    }
    for (const double tolerance : {1e-4, 1e-9}) {
        std::vector<Curve> traced = curves;
        TraceOptions options{.frozen = true, .tolerance = tolerance, .longest_step = 0.2};
        ASSERT_TRUE(flow->trace(traced, options, {}));
        double worst = 0.0;
        int compared = 0;
        for (const Curve& curve : traced)
            if (const auto end = by_exponentials(tetrahedra, curve.seed, curve.duration);
                end && curve.end == CurveEnd::Time) {
                ++compared;
                worst = std::max(worst, glm::length(curve.last.position - *end));
            }
        EXPECT_GT(compared, 20);
        EXPECT_LE(worst, 1e-9) << tolerance;
    }
}

TEST(LinearTets, TheClosedFormIsThatOfTheMatrixExponential) {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const LinearField field = random_field(random);
        const Vec3 seed(0.1, -0.4, 0.7);
        for (const double time : {1e-6, 0.01, 1.0, 4.0}) {
            const Vec3 end = field.after(seed, time);
            const Vec3 way = linear_way(field.slope, field(seed), time);
            EXPECT_LT(glm::length(seed + way - end), 1e-12 * std::max(1.0, glm::length(way)));
        }
    }
}

TEST(LinearTets, CurvesEndWhereTheMatrixExponentialSaysWhateverTheTolerance) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> place(0.2, 0.8);
    double worst = 0.0;
    int compared = 0;
    for (int round = 0; round < 12; ++round) {
        const LinearField field = random_field(random);
        const auto flow = meshed_flow(random_tetrahedra(random), {0.0},
                                      [&](const Vec3& p, double) { return field(p); });
        for (const double duration : {0.75, -0.75})
            for (const double tolerance : {1e-4, 1e-9}) {
                std::vector<Curve> curves(40);
                for (Curve& curve : curves) {
                    const double x = place(random), y = place(random), z = place(random);
                    curve.seed = {x, y, z};
                    curve.duration = duration;
                }
                TraceOptions options{.frozen = true, .tolerance = tolerance, .longest_step = 0.2};
                ASSERT_TRUE(flow->trace(curves, options, {}));
                for (const Curve& curve : curves) {
                    if (curve.end != CurveEnd::Time)
                        continue; // it left the mesh
                    ++compared;
                    EXPECT_GT(curve.steps.size(), 1u);
                    worst = std::max(worst, glm::length(curve.last.position -
                                                        field.after(curve.seed, duration)));
                }
            }
    }
    EXPECT_GT(compared, 400);
    EXPECT_LE(worst, 1e-12);
    RecordProperty("worst", std::to_string(worst));
}

} // namespace wakesurf::core::linear_tets_test
