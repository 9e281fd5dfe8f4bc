// The errors that surfaces of random rakes state, checked from both sides, for every kind and accuracy.
#pragma once

#include "tests/support/measured_error.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <random>

namespace wakesurf::tests {

/// Returns random lines through the domain, and one to its middle, where bodies and axes are.
inline std::vector<core::Rake> rakes(const core::Flow& flow, std::uint32_t seed) {
    const core::Box box = flow.domain();
    std::mt19937 random(seed);
    const auto part = [&] {
        return 0.1 + 0.8 * static_cast<double>(random()) / std::mt19937::max();
    };
    const auto point = [&] {
        const double x = part(), y = part();
        return box.lo + box.extent() * core::Vec3(x, y, part());
    };
    const core::Vec3 middle = box.lo + 0.5 * box.extent();
    const core::Vec3 reach = 0.08 * box.extent();
    std::vector<core::Rake> all{
        {core::Rake::Kind::Line,
         {middle - reach * core::Vec3(3.0, 1.0, 0.3), middle - reach * core::Vec3(3.0, -1.0, 0.3)},
         12}};
    for (int i = 0; i < 2; ++i) {
        const core::Vec3 from = point();
        all.push_back({core::Rake::Kind::Line, {from, point()}, 12});
    }
    std::erase_if(all, [&](const core::Rake& rake) {
        return flow.status(rake.points[0]) != core::PointStatus::Inside;
    });
    return all;
}

inline core::SurfaceParameters
asked(const core::Flow& flow, core::SurfaceKind kind, core::Accuracy accuracy, double time) {
    const core::Vec3 extent = flow.domain().extent();
    core::SurfaceParameters p{.kind = kind,
                              .from = flow.time_range().value_or(std::array{0.0, 0.0})[0],
                              .accuracy = accuracy};
    p.to = p.from + (kind == core::SurfaceKind::Time ? 0.3 * time : time);
    p.max_quads = 20'000;
    p.separation = (accuracy == core::Accuracy::Exact ? 0.05 : 0.03) * glm::length(extent);
    if (kind == core::SurfaceKind::Time)
        p.sweep = 0.08 * extent * core::Vec3(1.0, -0.5, 0.7);
    return p;
}

/// Checks surfaces of every kind and accuracy, from random rakes.
/// @param time   time that passes
/// @param most   vertices of a surface that are tested
/// @param seeds  of so many sets of rakes together: of one the 99th percentile is that of one or two vertices
inline void expect_true_errors(const core::Flow& flow,
                               double time,
                               std::uint32_t seed,
                               std::size_t most,
                               double most_uncertain = 0.02,
                               std::uint32_t seeds = 1) {
    for (const auto& [kind, name] : every_kind)
        for (const core::Accuracy accuracy :
             {core::Accuracy::Fast, core::Accuracy::Balanced, core::Accuracy::Exact}) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(static_cast<int>(accuracy)));
            const core::SurfaceParameters p = asked(flow, kind, accuracy, time);
            MeasuredErrors sum;
            for (std::uint32_t each = seed; each < seed + seeds; ++each)
                for (const core::Rake& rake : rakes(flow, each))
                    measure(sum, flow, rake, p, most);
            EXPECT_GT(sum.truth.size(), 20u);
            sum.check(accuracy, p.separation, 3.0 * glm::length(flow.domain().extent()));
            EXPECT_LE(static_cast<double>(sum.uncertain),
                      most_uncertain * static_cast<double>(sum.vertices));
        }
}

} // namespace wakesurf::tests
