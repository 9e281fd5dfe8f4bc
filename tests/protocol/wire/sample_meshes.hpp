// Meshes for the wire's tests: made with +, -, * and / alone, so that every machine makes the same bits.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/wire/lattice.hpp"
#include "protocol/wire/mesh_encoder.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <span>
#include <utility>

namespace wakesurf::protocol::samples {

inline const core::Box domain{{-1.0, -2.0, -2.0}, {6.0, 2.0, 2.0}};

inline void add_vertex(core::QuadComplex& mesh, double s, double t) {
    const double bend = t * (1.0 - t) * (s - 0.3);
    mesh.position.push_back(
        {5.0 * t - 0.5, 2.0 * s - 1.0 + bend, 1.5 * bend + s * s - 0.5 * t * t});
    mesh.s.push_back(s);
    mesh.t.push_back(4.0 * t);
    mesh.velocity.push_back({static_cast<float>(1.0 + bend), static_cast<float>(s * t), 0.25f});
}

/// Returns a smooth sheet, its vertices column by column, its cells strip by strip, like the engine's in a
/// calm flow.
inline core::QuadComplex sheet(std::uint32_t columns, std::uint32_t rows) {
    core::QuadComplex mesh;
    for (std::uint32_t c = 0; c < columns; ++c)
        for (std::uint32_t r = 0; r < rows; ++r)
            add_vertex(mesh, c / (columns - 1.0), r / (rows - 1.0));
    for (std::uint32_t c = 0; c + 1 < columns; ++c)
        for (std::uint32_t r = 0; r + 1 < rows; ++r) {
            const std::uint32_t v = c * rows + r;
            core::Cell cell;
            cell.corner = {v, v + rows, v + rows + 1, v + 1};
            mesh.cells.push_back(cell);
        }
    return mesh;
}

/// Returns a sheet whose quads take one or two segments of either column and sometimes a node on the cross
/// sides, too.
inline core::QuadComplex
hanging_sheet(std::uint32_t columns, std::uint32_t rows, std::uint32_t seed) {
    std::minstd_rand random(seed);
    core::QuadComplex mesh = sheet(columns, rows);
    mesh.cells.clear();
    const auto step = [&](std::uint32_t& at, std::uint32_t end, core::VertexId& mid) {
        ++at;
        if (at < end && random() % 4 == 0)
            mid = at++;
        return at;
    };
    for (std::uint32_t c = 0; c + 1 < columns; ++c) {
        std::uint32_t left = c * rows;
        std::uint32_t right = left + rows;
        const std::uint32_t left_end = left + rows - 1;
        const std::uint32_t right_end = right + rows - 1;
        while (left < left_end && right < right_end) {
            core::Cell cell;
            cell.corner[0] = left;
            cell.corner[1] = right;
            cell.corner[3] = step(left, left_end, cell.mid[3]);
            cell.corner[2] = step(right, right_end, cell.mid[1]);
            for (const std::size_t side : {0u, 2u})
                if (random() % 16 == 0)
                    cell.mid[side] = static_cast<std::uint32_t>(random() % mesh.vertices());
            mesh.cells.push_back(cell);
        }
    }
    return mesh;
}

/// Returns cells of any ids and positions anywhere in the domain, without geometry or order.
inline core::QuadComplex chaos(std::uint32_t vertices, std::uint32_t cells, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto any = [&] { return static_cast<std::uint32_t>(random()) % vertices; };
    const auto unit = [&] { return static_cast<double>(random()) / 4294967295.0; };
    core::QuadComplex mesh;
    for (std::uint32_t i = 0; i < vertices; ++i) {
        mesh.position.push_back(domain.lo + domain.extent() * core::Vec3(unit(), unit(), unit()));
        mesh.s.push_back(unit());
        mesh.t.push_back(unit() * 1e6);
        mesh.velocity.push_back({static_cast<float>(unit()), static_cast<float>(unit()), 0.f});
    }
    for (std::uint32_t i = 0; i < cells; ++i) {
        core::Cell cell;
        for (auto& corner : cell.corner)
            corner = any();
        for (auto& mid : cell.mid)
            if (random() % 3 == 0)
                mid = any();
        mesh.cells.push_back(cell);
    }
    return mesh;
}

inline EncodedState encode(const core::QuadComplex& mesh, const EncodeOptions& options = {}) {
    auto state = encode_state(mesh, lattice_over(domain), options);
    EXPECT_TRUE(state.has_value()) << (state ? "" : state.error().message);
    return state ? std::move(*state) : EncodedState{};
}

} // namespace wakesurf::protocol::samples
