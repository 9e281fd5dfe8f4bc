// Curves through tetrahedra with linear velocity, beside the exponential of its matrix: Scheuermann et al. 2001.
#include "core/field/cells/linear_cell.hpp"
#include "tests/support/meshed_source.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

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

} // namespace

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
                TraceOptions options;
                options.frozen = true;
                options.longest_step = 0.2;
                options.tolerance = tolerance;
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
