// The stated errors of a surface beside the true ones: the distance of its vertices from the exact surface,
// across it.
#pragma once

#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/exact_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wakesurf::tests {

inline double at99(std::vector<double> all) {
    if (all.empty())
        return 0.0;
    const auto place = all.begin() + static_cast<std::ptrdiff_t>(
                                         std::ceil(0.99 * static_cast<double>(all.size() - 1)));
    std::nth_element(all.begin(), place, all.end());
    return *place;
}

/// Collects the errors of surfaces with the same accuracy and separation.
struct MeasuredErrors {
    std::vector<double> stated, truth; ///< of vertices that are not uncertain
    std::size_t uncertain = 0, vertices = 0;

    /// Returns the number of vertices whose own error is no less than the true one, but for `unseen`.
    std::size_t covered(double unseen) const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < truth.size(); ++i)
            count += truth[i] <= stated[i] + unseen;
        return count;
    }

    /// Checks the 99th percentile from both sides: not less than the truth, but for the integrator's
    /// tolerance on `way`, and at most ten times as much, but for invisible errors.
    /// @param times  the weight of invisible errors
    void check(core::Accuracy accuracy, double separation, double way, double times = 1.0) const {
        const double unseen = separation / (accuracy == core::Accuracy::Exact      ? 50'000.0
                                            : accuracy == core::Accuracy::Balanced ? 50.0
                                                                                   : 4.0);
        EXPECT_LE(at99(truth), at99(stated) + core::trace_tolerance(accuracy) * way);
        EXPECT_LE(at99(stated), 10.0 * at99(truth) + times * unseen);
    }
};

/// Adds every n-th of a surface's vertices, so that there are at most `most`.
inline void measure(MeasuredErrors& sum,
                    const core::Flow& flow,
                    const core::Rake& rake,
                    const core::SurfaceParameters& p,
                    std::size_t most) {
    const auto surface = core::build_surface(flow, rake, p);
    if (!surface && surface.error().code == core::Error::Code::OverLimit)
        return;
    ASSERT_TRUE(surface) << surface.error().message;
    const core::QuadComplex& mesh = surface->mesh;
    ASSERT_EQ(mesh.error.size(), mesh.vertices());
    if (mesh.vertices() == 0)
        return;
    ASSERT_TRUE(surface->statistics.error);
    sum.uncertain += surface->statistics.error->uncertain;
    sum.vertices += mesh.vertices();
    std::vector<double> certain;
    std::vector<core::VertexId> of;
    for (core::VertexId v = 0; v < mesh.vertices(); ++v) {
        EXPECT_TRUE(std::isfinite(mesh.error[v]));
        if (double(mesh.error[v]) <= surface->statistics.separation) {
            certain.push_back(mesh.error[v]);
            of.push_back(v);
        }
    }
    EXPECT_EQ(certain.size(), mesh.vertices() - surface->statistics.error->uncertain);
    EXPECT_EQ(at99(certain), surface->statistics.error->error99);
    std::vector<core::VertexId> some;
    for (std::size_t i = 0; i < of.size(); i += 1 + of.size() / most)
        some.push_back(of[i]);
    const auto distances = ExactSheet(flow, rake, p).distances(mesh, some);
    for (std::size_t i = 0; i < some.size(); ++i)
        if (distances[i]) {
            sum.stated.push_back(mesh.error[some[i]]);
            sum.truth.push_back(distances[i]->across);
        }
}

} // namespace wakesurf::tests
