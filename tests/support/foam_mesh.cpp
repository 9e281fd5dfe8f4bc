#include "tests/support/foam_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace wakesurf::tests {

namespace {

using Lattice = std::array<int, 3>; // twice as fine as the boxes

struct Box {
    Lattice low{};
    int size = 2;
};

std::vector<Box> boxes_of(const FoamBlock& block) {
    std::vector<Box> out;
    for (int k = 0; k < block.boxes[2]; ++k)
        for (int j = 0; j < block.boxes[1]; ++j)
            for (int i = 0; i < block.boxes[0]; ++i) {
                const Lattice low{2 * i, 2 * j, 2 * k};
                if (!block.refined || 2 * i < block.boxes[0])
                    out.push_back({low, 2});
                else
                    for (int n = 0; n < 8; ++n)
                        out.push_back({{low[0] + n % 2, low[1] + n / 2 % 2, low[2] + n / 4}, 1});
            }
    return out;
}

// Returns a square, counter-clockwise seen from the side `up` (+1 or -1) of the axis.
std::vector<Lattice> square(Lattice low, int size, std::size_t axis, int up) {
    Lattice u{};
    Lattice v{};
    u[(axis + 1) % 3] = size;
    v[(axis + 2) % 3] = size;
    if (up < 0)
        std::swap(u, v);
    const auto at = [&](int a, int b) {
        return Lattice{low[0] + a * u[0] + b * v[0], low[1] + a * u[1] + b * v[1],
                       low[2] + a * u[2] + b * v[2]};
    };
    return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
}

std::vector<Lattice> with_hanging(const std::vector<Lattice>& corners,
                                  const std::set<Lattice>& nodes) {
    std::vector<Lattice> out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Lattice& here = corners[i];
        const Lattice& next = corners[(i + 1) % corners.size()];
        out.push_back(here);
        const Lattice twice{here[0] + next[0], here[1] + next[1], here[2] + next[2]};
        if (twice[0] % 2 == 0 && twice[1] % 2 == 0 && twice[2] % 2 == 0)
            if (const Lattice middle{twice[0] / 2, twice[1] / 2, twice[2] / 2};
                nodes.contains(middle))
                out.push_back(middle);
    }
    return out;
}

// Sorts inner faces in OpenFOAM's order, then the patches' in theirs.
void put_in_order(FoamMesh& mesh, std::vector<std::pair<int, FoamMesh::Face>> faces) {
    std::stable_sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) {
        if (a.first >= 0 || b.first >= 0)
            return a.first < b.first;
        return std::pair(a.second.owner, a.second.neighbour) <
               std::pair(b.second.owner, b.second.neighbour);
    });
    for (auto& [patch, face] : faces)
        mesh.faces.push_back(std::move(face));
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const auto of_patch = [&](const auto& face) { return face.first == static_cast<int>(p); };
        mesh.patches[p].size =
            static_cast<int>(std::count_if(faces.begin(), faces.end(), of_patch));
        mesh.patches[p].start =
            static_cast<int>(std::count_if(faces.begin(), faces.end(), [&](const auto& face) {
                return face.first < static_cast<int>(p);
            }));
    }
}

} // namespace

FoamMesh foam_block_mesh(const FoamBlock& block) {
    FoamMesh mesh;
    mesh.patches = {{"inlet", "patch"},
                    {"outlet", "patch"},
                    {"floor", "wall"},
                    {"lid", "wall"},
                    {"sides", "patch"}};
    const auto boxes = boxes_of(block);
    std::map<Lattice, int> owner_of; // of every voxel of the lattice
    std::set<Lattice> nodes;
    const auto position = [](const Lattice& at) {
        return std::array<double, 3>{std::pow(at[0] / 2.0, 1.2), std::pow(at[1] / 2.0, 0.9),
                                     at[2] / 2.0};
    };
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        const auto [low, size] = boxes[b];
        for (int n = 0; n < 8; ++n) {
            const Lattice corner{low[0] + n % 2 * size, low[1] + n / 2 % 2 * size,
                                 low[2] + n / 4 * size};
            nodes.insert(corner);
            if (size == 1 && n > 0)
                continue;
            owner_of[{low[0] + n % 2, low[1] + n / 2 % 2, low[2] + n / 4}] = static_cast<int>(b);
        }
        const auto a = position(low);
        const auto c = position({low[0] + size, low[1] + size, low[2] + size});
        mesh.centres.push_back({(a[0] + c[0]) / 2, (a[1] + c[1]) / 2, (a[2] + c[2]) / 2});
        mesh.cells.push_back(static_cast<int>(b));
    }
    std::map<Lattice, int> number;
    for (const auto& node : nodes) {
        number[node] = static_cast<int>(mesh.points.size());
        mesh.points.push_back(position(node));
    }
    std::vector<std::pair<int, FoamMesh::Face>> faces; // patch or -1
    for (std::size_t b = 0; b < boxes.size(); ++b)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int up : {-1, 1}) {
                const auto [low, size] = boxes[b];
                std::set<int> done;
                for (int n = 0; n < size * size; ++n) {
                    Lattice voxel = low;
                    voxel[axis] += up > 0 ? size : -1;
                    voxel[(axis + 1) % 3] += n % size;
                    voxel[(axis + 2) % 3] += n / size;
                    const auto other = owner_of.find(voxel);
                    const int neighbour = other == owner_of.end() ? -1 : other->second;
                    if (!done.insert(neighbour).second ||
                        (neighbour >= 0 && neighbour < static_cast<int>(b)))
                        continue;
                    const bool finer =
                        neighbour >= 0 && boxes[static_cast<std::size_t>(neighbour)].size < size;
                    Box smaller = finer ? boxes[static_cast<std::size_t>(neighbour)] : boxes[b];
                    smaller.low[axis] = low[axis] + (up > 0 ? size : 0);
                    FoamMesh::Face face;
                    for (const auto& node :
                         with_hanging(square(smaller.low, smaller.size, axis, up), nodes))
                        face.nodes.push_back(number.at(node));
                    face.owner = static_cast<int>(b);
                    face.neighbour = neighbour;
                    const int side = axis == 2 ? 4 : static_cast<int>(2 * axis) + (up > 0 ? 1 : 0);
                    faces.emplace_back(neighbour < 0 ? side : -1, std::move(face));
                }
            }
    put_in_order(mesh, std::move(faces));
    return mesh;
}

std::array<FoamMesh, 2> decompose(const FoamMesh& whole, double fraction) {
    std::vector<std::size_t> by_x(whole.centres.size());
    for (std::size_t i = 0; i < by_x.size(); ++i)
        by_x[i] = i;
    std::stable_sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) {
        return whole.centres[a][0] < whole.centres[b][0];
    });
    std::vector<int> part_of(by_x.size(), 0);
    for (std::size_t i = static_cast<std::size_t>(fraction * static_cast<double>(by_x.size()));
         i < by_x.size(); ++i)
        part_of[by_x[i]] = 1;
    std::vector<int> patch_of(whole.faces.size(), -1);
    for (std::size_t p = 0; p < whole.patches.size(); ++p)
        for (int f = 0; f < whole.patches[p].size; ++f)
            patch_of[static_cast<std::size_t>(whole.patches[p].start + f)] = static_cast<int>(p);
    std::array<FoamMesh, 2> parts;
    for (int part = 0; part < 2; ++part) {
        FoamMesh& mesh = parts[static_cast<std::size_t>(part)];
        mesh.part = part;
        mesh.patches = whole.patches;
        const std::string other = std::to_string(1 - part);
        mesh.patches.push_back(
            {"procBoundary" + std::to_string(part) + "to" + other, "processor", 0, 0, 1 - part});
        std::vector<int> local(part_of.size(), -1);
        for (std::size_t c = 0; c < part_of.size(); ++c)
            if (part_of[c] == part) {
                local[c] = static_cast<int>(mesh.cells.size());
                mesh.cells.push_back(static_cast<int>(c));
                mesh.centres.push_back(whole.centres[c]);
            }
        std::map<int, int> point;
        std::vector<std::pair<int, FoamMesh::Face>> faces;
        for (std::size_t f = 0; f < whole.faces.size(); ++f) {
            FoamMesh::Face face = whole.faces[f];
            const int own = local[static_cast<std::size_t>(face.owner)];
            const int next =
                face.neighbour < 0 ? -1 : local[static_cast<std::size_t>(face.neighbour)];
            if (own < 0 && next < 0)
                continue;
            const bool cut = face.neighbour >= 0 && (own < 0 || next < 0);
            if (own < 0)
                std::reverse(face.nodes.begin(), face.nodes.end());
            face.owner = own < 0 ? next : own;
            face.neighbour = cut ? -1 : next;
            for (int& node : face.nodes) {
                const auto [at, added] =
                    point.try_emplace(node, static_cast<int>(mesh.points.size()));
                if (added)
                    mesh.points.push_back(whole.points[static_cast<std::size_t>(node)]);
                node = at->second;
            }
            faces.emplace_back(cut ? static_cast<int>(whole.patches.size()) : patch_of[f],
                               std::move(face));
        }
        put_in_order(mesh, std::move(faces));
    }
    return parts;
}

} // namespace wakesurf::tests
