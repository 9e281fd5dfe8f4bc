// Surfaces at random that benchmarks measure: the same in every run.
#pragma once

#include "server/data/open_dataset.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <memory>
#include <random>
#include <vector>

namespace wakesurf::bench {

struct RandomRequest {
    std::shared_ptr<const core::Flow> flow;
    core::Rake rake;
    core::SurfaceParameters parameters;
};

constexpr std::size_t random_surfaces = 5;

inline std::vector<RandomRequest> random_requests(const core::AnalyticEntry& entry,
                                                  core::SurfaceKind kind) {
    std::mt19937 random(16);
    std::vector<RandomRequest> all;
    while (all.size() < random_surfaces) {
        tests::AskedSurface each = tests::surface_anywhere(entry, kind, 0.05, random);
        all.push_back({std::move(each.flow), each.rake, each.parameters});
    }
    return all;
}

/// Returns surfaces from lines in the fluid, a fifth of the domain long, through half of the data.
inline std::vector<RandomRequest>
random_requests(const std::shared_ptr<const server::LoadedDataset>& dataset,
                core::SurfaceKind kind) {
    const core::Flow& flow = *dataset->flow;
    const core::Box box = flow.domain();
    std::mt19937 random(16);
    const auto part = [&] {
        return 0.1 + 0.8 * static_cast<double>(random()) / std::mt19937::max();
    };
    const auto point = [&] {
        const double x = 0.5 * part(), y = part();
        return core::Vec3(x, y, part());
    };
    std::vector<RandomRequest> all;
    while (all.size() < random_surfaces) {
        const core::Vec3 from = point(), to = glm::mix(from, point(), 0.4);
        const core::Vec3 a = box.lo + box.extent() * from, b = box.lo + box.extent() * to;
        if (flow.status(a) != core::PointStatus::Inside ||
            flow.status(b) != core::PointStatus::Inside)
            continue;
        RandomRequest request{dataset->flow, {core::Rake::Kind::Line, {a, b}, 12}, {}};
        const std::vector<double>& times = dataset->info.times;
        request.parameters.kind = kind;
        request.parameters.from = times.front();
        request.parameters.to = 0.5 * (times.front() + times.back());
        request.parameters.separation = 0.04 * glm::length(b - a);
        if (kind == core::SurfaceKind::Time)
            request.parameters.sweep = 0.05 * box.extent();
        all.push_back(std::move(request));
    }
    return all;
}

} // namespace wakesurf::bench
