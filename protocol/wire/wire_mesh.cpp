#include "protocol/wire/wire_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace wakesurf::protocol {

namespace {

constexpr std::size_t lanes = 4;

std::uint32_t stir(std::uint32_t sum, std::uint32_t value) {
    return std::rotl(sum ^ value, 13) * 0x9e3779b1u;
}

template <class Word>
std::uint32_t sum_of(std::span<const Word> words) {
    std::array<std::uint32_t, lanes> sum{};
    std::array<std::uint32_t, lanes> of_sums{};
    const std::size_t whole = words.size() / lanes * lanes;
    for (std::size_t at = 0; at < whole; at += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            sum[lane] += words[at + lane];
            of_sums[lane] += sum[lane];
        }
    for (std::size_t at = whole; at < words.size(); ++at) {
        sum[at - whole] += words[at];
        of_sums[at - whole] += sum[at - whole];
    }
    auto result = static_cast<std::uint32_t>(words.size());
    for (std::size_t lane = 0; lane < lanes; ++lane)
        result = stir(stir(result, sum[lane]), of_sums[lane]);
    return result ^ (result >> 15);
}

} // namespace

std::uint32_t word_sum(std::span<const std::uint32_t> words) {
    return sum_of(words);
}

std::uint32_t word_sum(std::span<const std::uint16_t> codes) {
    return sum_of(codes);
}

namespace {

using core::Cell;
using core::no_vertex;

/// Finds the neighbours of vertices, cell after cell. Adding a cell again makes no difference.
class Finder {
  public:
    explicit Finder(std::vector<Neighbours>& of) : of_(of) {}

    void add(const Cell& cell) {
        join_outline(cell);
        complete_highest_corner(cell);
        complete_mids(cell);
    }

  private:
    void join(std::uint32_t u, std::uint32_t w) {
        const std::uint32_t upper = std::max(u, w);
        if (u == w)
            return;
        const std::uint32_t low = std::min(u, w);
        Neighbours& high = of_[upper];
        high.lowest = std::min(high.lowest, low);
        // No vertex is -1, and without a branch this takes half the time.
        high.highest = static_cast<std::uint32_t>(
            std::max(static_cast<std::int32_t>(high.highest), static_cast<std::int32_t>(low)));
    }

    void join_outline(const Cell& cell) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t from = cell.corner[i];
            const std::uint32_t to = cell.corner[(i + 1) % 4];
            const std::uint32_t mid = cell.mid[i];
            if (mid == no_vertex) {
                join(from, to);
            } else {
                join(from, mid);
                join(mid, to);
            }
        }
    }

    /// Only a cell's highest corner can have the other three below it.
    void complete_highest_corner(const Cell& cell) {
        const auto& c = cell.corner;
        const std::size_t one = c[0] >= c[1] ? 0 : 1;
        const std::size_t other = c[2] >= c[3] ? 2 : 3;
        const std::size_t i = c[one] >= c[other] ? one : other;
        const std::uint32_t p = c[(i + 3) % 4];
        const std::uint32_t n = c[(i + 1) % 4];
        const std::uint32_t o = c[(i + 2) % 4];
        Neighbours& highest = of_[c[i]];
        if (highest.beside == no_vertex && p < c[i] && n < c[i] && o < c[i]) {
            highest.beside = p;
            highest.beside2 = n;
            highest.opposite = o;
        }
    }

    void complete_mids(const Cell& cell) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t mid = cell.mid[i];
            const std::uint32_t from = cell.corner[i];
            const std::uint32_t to = cell.corner[(i + 1) % 4];
            if (mid == no_vertex || from >= mid || to >= mid)
                continue;
            Neighbours& hanging = of_[mid];
            if (hanging.beside == no_vertex || hanging.opposite != no_vertex)
                hanging = {hanging.highest, hanging.lowest, from, to, no_vertex};
        }
    }

    std::vector<Neighbours>& of_;
};

} // namespace

WireTopology::WireTopology(std::vector<Cell> all, std::size_t vertices)
    : cells(std::move(all)), neighbours(vertices) {
    Finder find(neighbours);
    for (const Cell& cell : cells)
        find.add(cell);
}

WireTopology::WireTopology(const WireTopology& before, std::vector<Cell> all, std::size_t vertices)
    : cells(std::move(all)) {
    neighbours.reserve(vertices);
    neighbours = before.neighbours;
    neighbours.resize(vertices);
    Finder find(neighbours);
    for (std::size_t i = before.cells.size(); i < cells.size(); ++i)
        find.add(cells[i]);
}

static_assert(sizeof(LatticePoint) == 12 && sizeof(core::Cell) == 32,
              "summed as they lie in memory");

namespace {

/// Returns the sum of the 32 bit words of the values, which lie in memory without gaps.
template <class T>
std::uint32_t sum_of(const std::vector<T>& values) {
    static_assert(sizeof(T) % sizeof(std::uint32_t) == 0);
    return word_sum(std::span(reinterpret_cast<const std::uint32_t*>(values.data()),
                              values.size() * (sizeof(T) / sizeof(std::uint32_t))));
}

} // namespace

double AttributeRange::value(std::uint16_t code) const {
    if (gaps && code >= first_none)
        return std::numeric_limits<double>::quiet_NaN();
    return lo + (hi - lo) * code / last();
}

std::size_t WireMesh::bytes() const {
    std::size_t codes_bytes = 0;
    for (const auto& attribute : codes)
        codes_bytes += attribute.size() * sizeof(std::uint16_t);
    return (position.size() + change.size()) * sizeof(LatticePoint) + codes_bytes +
           topology->cells.size() * sizeof(core::Cell) +
           topology->neighbours.size() * sizeof(Neighbours);
}

std::uint32_t state_sum(const WireMesh& mesh) {
    std::vector<std::uint32_t> parts{
        static_cast<std::uint32_t>(mesh.vertices()), sum_of(mesh.position),
        static_cast<std::uint32_t>(mesh.cells().size()), sum_of(mesh.cells())};
    for (const auto& attribute : mesh.codes)
        parts.push_back(word_sum(std::span(attribute)));
    return sum_of(parts);
}

} // namespace wakesurf::protocol
