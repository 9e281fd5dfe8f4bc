#include "importer/assembly/opposite_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace wakesurf::importer {

namespace {

/// A part of the box: coordinates may be in single precision, and OpenFOAM matches faces by 1e-4 of their size.
constexpr double slack = 1e-6;

// Of a grid whose nodes lie in planes, whose sizes are equal.
OppositeNodes of_planes(const std::array<std::size_t, 3>& size, std::size_t axis) {
    OppositeNodes pairs;
    std::array<std::size_t, 3> at{};
    for (at[2] = 0; at[2] < size[2]; ++at[2])
        for (at[1] = 0; at[1] < size[1]; ++at[1])
            for (at[0] = 0; at[0] < size[0]; ++at[0]) {
                if (at[axis] != 0)
                    continue;
                std::array<std::size_t, 3> other = at;
                other[axis] = size[axis] - 1;
                const auto node = [&](const auto& n) {
                    return static_cast<std::uint32_t>(n[0] + size[0] * (n[1] + size[1] * n[2]));
                };
                pairs.push_back({node(at), node(other)});
            }
    return pairs;
}

/// A node of a side by its place there, in units of the slack.
struct SideNode {
    double u, v;
    std::uint32_t node;
};

std::vector<SideNode>
nodes_of_side(const core::CellMesh& mesh, std::size_t count, int axis, double side, double off) {
    std::vector<SideNode> out;
    for (std::size_t i = 0; i < count; ++i) {
        const core::Vec3& p = mesh.points[i];
        if (std::abs(p[axis] - side) <= off)
            out.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], static_cast<std::uint32_t>(i)});
    }
    std::ranges::sort(out, {}, &SideNode::u);
    return out;
}

tl::unexpected<core::Error> no_match(std::size_t axis, std::size_t lacking, std::size_t of) {
    return core::fail(
        core::Error::Code::Unsupported,
        "cannot repeat along " + std::string(1, "xyz"[axis]) + ": " + std::to_string(lacking) +
            " of " + std::to_string(of) + " nodes on one side of its box have none on the other",
        "both sides need the same nodes, with the first plane of them again as the last one");
}

core::Result<OppositeNodes>
of_mesh(const core::CellMesh& mesh, std::size_t count, std::size_t axis) {
    const core::Box box = core::bounds(mesh);
    const int along = static_cast<int>(axis);
    const double off = slack * box.diagonal();
    const auto low = nodes_of_side(mesh, count, along, box.lo[along], off);
    auto high = nodes_of_side(mesh, count, along, box.hi[along], off);
    if (low.empty() || high.empty())
        return core::fail(core::Error::Code::Unsupported,
                          "cannot repeat along " + std::string(1, "xyz"[axis]) +
                              ": it has no nodes on a side of its box",
                          "leave that axis out");
    OppositeNodes pairs;
    std::vector<bool> taken(high.size(), false);
    for (const SideNode& node : low) {
        const auto first = std::ranges::lower_bound(high, node.u - off, {}, &SideNode::u);
        for (auto at = first; at != high.end() && at->u <= node.u + off; ++at) {
            const auto i = static_cast<std::size_t>(at - high.begin());
            if (taken[i] || std::abs(at->v - node.v) > off)
                continue;
            taken[i] = true;
            pairs.push_back({node.node, at->node});
            break;
        }
    }
    if (pairs.size() != low.size())
        return no_match(axis, low.size() - pairs.size(), low.size());
    if (pairs.size() != high.size())
        return no_match(axis, high.size() - pairs.size(), high.size());
    return pairs;
}

} // namespace

core::Result<OppositeNodes>
opposite_nodes(const core::Grid& grid, std::size_t axis, std::size_t nodes) {
    if (const auto* uniform = std::get_if<core::UniformGrid>(&grid))
        return of_planes({uniform->dimensions[0], uniform->dimensions[1], uniform->dimensions[2]},
                         axis);
    if (const auto* rectilinear = std::get_if<core::RectilinearGrid>(&grid)) {
        const auto& [x, y, z] = rectilinear->coordinates;
        return of_planes({x.size(), y.size(), z.size()}, axis);
    }
    return of_mesh(std::get<core::CellMesh>(grid), nodes, axis);
}

} // namespace wakesurf::importer
