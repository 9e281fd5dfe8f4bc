// A store in bricks, its surfaces and its bytes, for tests of other sources of bricks.
#pragma once

#include "core/dataset/brick_cache.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "server/data/bricks/rank_bricks.hpp"
#include "store/open_store.hpp"
#include "store/store_generation.hpp"
#include "tests/support/read_bricks.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::tests {

/// Writes 12 bricks a time-step of a tornado. `spread` makes other values of the same shape.
inline void write_bricks(const std::filesystem::path& folder, double spread = 1.0) {
    store::GenerateRequest request;
    request.flow = "tornado";
    request.grid = {
        core::Vec3(0.0), spread * core::Vec3(1.0 / 96, 1.0 / 64, 1.0 / 64), {97, 65, 65}};
    request.times = {0.0, 0.5, 1.0, 1.5};
    request.placement = store::StepPlacement::Bricks;
    store::generate_store(request, folder, [](const auto&) {}, {})
        .map_error([](const core::Error& error) { throw std::runtime_error(error.message); });
}

constexpr std::size_t bricks_a_step = 12;
constexpr std::size_t bricks_in_all = 4 * bricks_a_step;

inline std::shared_ptr<const store::StoreReader> reader_of(const std::filesystem::path& folder) {
    return store::open_store(folder).value().reader;
}

/// Returns all bricks of velocity, one after the other; empty if one could not be read.
inline std::vector<float> all_bricks(const core::BrickSource& source) {
    const std::size_t values = 3 * source.layout().nodes_per_brick();
    std::vector<float> out(bricks_in_all * values);
    std::vector<core::BrickRead> reads;
    for (std::size_t i = 0; i < bricks_in_all; ++i)
        reads.push_back(
            {i / bricks_a_step, i % bricks_a_step, std::span(out).subspan(i * values, values)});
    for (const auto& outcome : outcomes_of(source, reads))
        if (!outcome) {
            ADD_FAILURE() << outcome.error().message;
            return {};
        }
    return out;
}

/// Returns the mesh of a streak surface. @param by_brick  with memory for some bricks only
inline core::QuadComplex streak_through(std::shared_ptr<const core::TimeStepSource> source,
                                        bool by_brick) {
    core::TimeStepCache::Options options;
    options.by_brick = by_brick;
    if (by_brick)
        options.budget_bytes = 1;
    const auto flow =
        core::make_stored_flow(std::make_shared<core::TimeStepCache>(std::move(source), options));
    core::SurfaceParameters parameters;
    parameters.kind = core::SurfaceKind::Streak;
    parameters.to = 1.5;
    parameters.separation = 0.03;
    const core::Rake rake{core::Rake::Kind::Line, {{0.35, 0.5, 0.1}, {0.65, 0.5, 0.8}}, 16};
    return core::build_surface(*flow, rake, parameters).value().mesh;
}

/// Returns what differs; empty if all bytes are the same.
inline std::string difference(const core::QuadComplex& a, const core::QuadComplex& b) {
    const auto same = [](const auto& one, const auto& other) {
        return one.size() == other.size() &&
               std::memcmp(one.data(), other.data(), one.size() * sizeof(one[0])) == 0;
    };
    return !same(a.position, b.position)      ? "positions"
           : !same(a.velocity, b.velocity)    ? "velocities"
           : !same(a.t, b.t)                  ? "release times"
           : a.cells.size() != b.cells.size() ? "cells"
                                              : "";
}

} // namespace wakesurf::tests
