#include "protocol/wire/mesh_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace wakesurf::protocol {

namespace {

using core::Error;

/// Counts the indices below `size` that `bad` finds; the error states the count and the first. It visits all
/// of them: a loop without an early exit is vectorized.
template <class Bad>
core::Result<void> refuse(std::size_t size, Error::Code code, std::string_view what, Bad bad) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < size; ++i)
        count += bad(i) ? 1u : 0u;
    if (count == 0)
        return {};
    std::size_t first = 0;
    while (!bad(first))
        ++first;
    return core::fail(code,
                      fmt::format("{} of {} {}, the first is number {}", count, size, what, first),
                      "this is a fault of the surface engine; please report it with the rake");
}

/// Returns false for NaN as well.
bool narrow_finite(double value) {
    return std::abs(static_cast<float>(value)) <= std::numeric_limits<float>::max();
}

/// Compares squares: the root would cost more than all the rest.
bool speed_finite(const core::Vec3f& velocity) {
    constexpr double most = std::numeric_limits<float>::max();
    const core::Vec3 v(velocity);
    return glm::dot(v, v) <= most * most;
}

/// No vertex is one below 0, so that mids need no check of their own whether they exist.
bool refers_beyond(const core::Cell& cell, core::VertexId vertices) {
    core::VertexId corner = 0;
    core::VertexId mid = 0;
    for (std::size_t side = 0; side < 4; ++side) {
        corner = std::max(corner, cell.corner[side]);
        mid = std::max(mid, cell.mid[side] + 1);
    }
    return corner >= vertices || mid > vertices;
}

core::Result<void> guard_attributes(const core::QuadComplex& mesh) {
    const std::size_t n = mesh.vertices();
    if (mesh.s.size() != n || mesh.t.size() != n || mesh.velocity.size() != n)
        return core::fail(Error::Code::Corrupt,
                          fmt::format("a mesh of {} vertices has {} s, {} t and {} velocities", n,
                                      mesh.s.size(), mesh.t.size(), mesh.velocity.size()));
    return refuse(n, Error::Code::Corrupt, "vertices have an attribute that is not finite",
                  [&](std::size_t i) {
                      return !(narrow_finite(mesh.s[i]) & narrow_finite(mesh.t[i]) &
                               speed_finite(mesh.velocity[i]));
                  });
}

} // namespace

core::Result<void>
guard_mesh(const core::QuadComplex& mesh, const Lattice& lattice, bool attributes) {
    if (!valid(lattice))
        return core::fail(Error::Code::InvalidArgument, "the lattice of the dataset is not usable",
                          "check the dataset's bounds");
    const std::size_t n = mesh.vertices();
    const LatticeRounding rounding(lattice);
    return refuse(n, Error::Code::OutOfDomain, "vertices are not finite or lie outside the dataset",
                  [&](std::size_t i) { return !rounding.holds(mesh.position[i]); })
        .and_then([&] {
            return refuse(mesh.cells.size(), Error::Code::Corrupt,
                          "cells use a vertex that does not exist", [&](std::size_t i) {
                              return refers_beyond(mesh.cells[i], static_cast<core::VertexId>(n));
                          });
        })
        .and_then([&] { return attributes ? guard_attributes(mesh) : core::Result<void>{}; });
}

} // namespace wakesurf::protocol
