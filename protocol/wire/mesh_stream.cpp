#include "protocol/wire/mesh_stream.hpp"

#include "protocol/wire/wire_quantise.hpp"
#include "protocol/wire/wire_residuals.hpp"
#include "protocol/wire/wire_update.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

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

namespace {

/// Up to so many vertices between two that moved cost less when sent along than as a gap between runs.
constexpr std::uint32_t bridge = 12;
/// A delta that leaves less of the mesh than this is hardly smaller than a KEY.
constexpr double least_staying = 0.3;

core::Result<void> check_size(const core::QuadComplex& mesh) {
    if (mesh.vertices() <= max_mesh_vertices && mesh.cells.size() <= max_mesh_cells)
        return {};
    const bool vertices = mesh.vertices() > max_mesh_vertices;
    return core::over_limit(vertices ? max_mesh_vertices : max_mesh_cells,
                            fmt::format("a mesh of {} vertices and {} cells is too large to send",
                                        mesh.vertices(), mesh.cells.size()),
                            "ask for fewer quads or a larger separation");
}

/// Checks the fields. @param before  the number of fields in the last update, if there was one
core::Result<void> check_fields(const MeshFields& fields,
                                const core::QuadComplex& mesh,
                                std::optional<std::size_t> before) {
    if (fields.size() > max_fields)
        return core::over_limit(
            max_fields, fmt::format("a mesh with {} fields is too much to send", fields.size()),
            fmt::format("ask for {} at most", max_fields));
    if (before && *before != fields.size())
        return core::fail(
            core::Error::Code::Corrupt,
            fmt::format("a mesh has {} fields, and had {} before", fields.size(), *before));
    for (const auto& field : fields)
        if (field.size() != mesh.vertices())
            return core::fail(core::Error::Code::Corrupt,
                              fmt::format("a field of a mesh of {} vertices has {} values",
                                          mesh.vertices(), field.size()));
    return {};
}

PointCoding coding_of(PointKind kind, std::size_t attributes, const Tolerance& tolerance) {
    PointCoding coding;
    coding.kind = kind;
    coding.attributes = static_cast<std::uint8_t>(attributes);
    coding.tolerance[0] = tolerance.position;
    for (std::size_t a = 0; a < attributes; ++a)
        coding.tolerance[a + 1] = a == 1 || a == 2 ? tolerance.parameter : tolerance.speed;
    return coding;
}

bool differs(const WireMesh& truth,
             const WireDraft& draft,
             const PointCoding& coding,
             std::uint32_t v) {
    for (std::size_t k = 0; k < 3; ++k)
        if (std::abs(truth.position[v][k] - draft.position_before[v][k]) > coding.tolerance[0])
            return true;
    for (std::size_t a = 0; a < coding.attributes; ++a)
        if (std::abs(truth.codes[a][v] - draft.codes_before[a][v]) > coding.tolerance[a + 1])
            return true;
    return false;
}

Runs moved_of(const WireMesh& truth, const WireDraft& draft, const PointCoding& coding) {
    Runs moved;
    for (std::uint32_t v = 0; v < draft.stay; ++v)
        if (differs(truth, draft, coding, v))
            moved.take({v, v + 1}, bridge);
    return moved;
}

Residuals predicted(WireDraft& draft,
                    const WireMesh& truth,
                    const PointCoding& coding,
                    std::span<const std::uint32_t> coded) {
    return make_residuals(draft, truth, choose_predictors(draft, truth, coding, coded), coded);
}

/// Returns the vertices first to last - 1.
std::vector<std::uint32_t> numbers(std::uint32_t first, std::uint32_t last) {
    std::vector<std::uint32_t> all(last - first);
    std::iota(all.begin(), all.end(), first);
    return all;
}

std::vector<std::uint32_t> numbers(const Runs& runs) {
    std::vector<std::uint32_t> all;
    all.reserve(runs.count());
    for (const Run& run : runs.all())
        for (std::uint32_t v = run.begin; v < run.end; ++v)
            all.push_back(v);
    return all;
}

/// Holds all that is particular to one update; `header` holds the constant part.
struct Step {
    FrameHeader header;
    TopologyEdit edit;
    std::vector<core::Cell> kept;
    WireMesh truth;
    std::shared_ptr<const WireTopology> topology; ///< after the edit
    Tolerance tolerance;
};

/// Appends the bits of doubles, the low half first.
void append_ranges(std::vector<std::uint32_t>& numbers, std::span<const AttributeRange> ranges) {
    for (const AttributeRange& range : ranges)
        for (const double end : {range.lo, range.hi}) {
            const auto bits = std::bit_cast<std::uint64_t>(end);
            numbers.push_back(static_cast<std::uint32_t>(bits));
            numbers.push_back(static_cast<std::uint32_t>(bits >> 32));
        }
}

core::Result<EncodedUpdate> encode(const WireMesh& before, Step step) {
    const std::size_t attributes = step.truth.codes.size();
    WireDraft draft = begin_draft(before, step.edit, step.topology);
    std::vector<Residuals> points;
    const auto code = [&](PointKind kind, const std::vector<std::uint32_t>& coded) {
        if (!coded.empty())
            points.push_back(
                predicted(draft, step.truth, coding_of(kind, attributes, step.tolerance), coded));
    };
    step.edit.moved_vertices =
        moved_of(step.truth, draft, coding_of(PointKind::Moved, attributes, step.tolerance));
    code(PointKind::Moved, numbers(step.edit.moved_vertices));
    code(PointKind::Added, numbers(draft.stay, draft.vertices()));
    FrameHeader& header = step.header;
    draft.after.time = header.time;
    header.flags = static_cast<std::uint8_t>(
        header.flags | (step.tolerance.exact() ? FrameHeader::lossless : std::uint8_t{0}));
    header.lattice_bits = static_cast<std::uint8_t>(draft.after.lattice_bits);
    header.attribute_count = static_cast<std::uint8_t>(attributes);
    for (std::size_t a = 0; a < attributes; ++a)
        header.gaps |= static_cast<std::uint8_t>(draft.after.ranges[a].gaps ? 1U << a : 0U);
    header.vertices = draft.vertices();
    header.cells = static_cast<std::uint32_t>(draft.after.cells().size());
    header.state_sum = state_sum(draft.after);
    std::vector<std::uint32_t> leading;
    if (header.is_key())
        append_ranges(leading, draft.after.ranges);
    append_edit(leading, step.edit, step.kept, draft.stay);
    auto frames = write_update(header, std::move(leading), points);
    if (!frames)
        return tl::unexpected(frames.error());
    EncodedUpdate update;
    update.epoch = header.epoch;
    update.base_seq = header.is_key() ? header.seq : header.seq - 1;
    update.seq = header.seq;
    update.key = header.is_key();
    update.phase = header.phase;
    update.lossless = (header.flags & FrameHeader::lossless) != 0;
    update.frames = std::move(*frames);
    for (const auto& frame : update.frames)
        update.bytes += frame->size();
    update.state_sum = header.state_sum;
    update.state = std::make_shared<const WireMesh>(std::move(draft.after));
    return update;
}

WireMesh nothing(int lattice_bits, std::span<const AttributeRange> ranges) {
    WireMesh mesh;
    mesh.lattice_bits = lattice_bits;
    mesh.ranges.assign(ranges.begin(), ranges.end());
    mesh.codes.resize(ranges.size());
    return mesh;
}

} // namespace

struct MeshStream::Held {
    std::uint32_t surface;
    std::uint32_t epoch;
    Lattice lattice;
    bool attributes;
    std::uint32_t next_seq;
    bool started = false;
    MeshPlaces places;
    std::shared_ptr<const WireMesh> state;

    std::optional<std::size_t> fields() const {
        if (!started || !attributes)
            return std::nullopt;
        return state->ranges.size() - surface_attributes.size();
    }

    FrameHeader header(const core::KeyedMesh& mesh, Phase phase, bool key) const {
        FrameHeader header;
        header.flags = key ? FrameHeader::key : std::uint8_t{0};
        header.surface = surface;
        header.epoch = epoch;
        header.seq = next_seq;
        header.phase = phase;
        header.time = mesh.time;
        return header;
    }
};

MeshStream::MeshStream(std::uint32_t surface,
                       std::uint32_t epoch,
                       Lattice lattice,
                       bool attributes,
                       std::uint32_t first_seq)
    : held_(std::make_unique<Held>(Held{surface,
                                        epoch,
                                        lattice,
                                        attributes,
                                        first_seq,
                                        false,
                                        {},
                                        std::make_shared<const WireMesh>()})) {}

MeshStream::~MeshStream() = default;
MeshStream::MeshStream(MeshStream&&) noexcept = default;
MeshStream& MeshStream::operator=(MeshStream&&) noexcept = default;

std::shared_ptr<const WireMesh> MeshStream::state() const {
    return held_->state;
}

std::size_t MeshStream::bytes() const {
    return held_->state->bytes() + held_->places.bytes();
}

core::Result<EncodedUpdate> MeshStream::next(const core::KeyedMesh& given,
                                             const UpdateOptions& options,
                                             const MeshFields& fields) {
    Held& held = *held_;
    if (auto fine =
            check_size(given.mesh)
                .and_then([&] { return check_ids(given); })
                .and_then([&] { return guard_mesh(given.mesh, held.lattice, held.attributes); })
                .and_then([&] { return check_fields(fields, given.mesh, held.fields()); });
        !fine)
        return tl::unexpected(fine.error());
    core::KeyedMesh without_cells;
    without_cells.time = given.time;
    const bool empty = given.mesh.cells.empty();
    const core::KeyedMesh& mesh = empty ? without_cells : given;

    const MeshFields without_values(fields.size());
    const AttributeValues values = held.attributes
                                       ? AttributeValues(mesh.mesh, empty ? without_values : fields)
                                       : AttributeValues();
    // An update unrelated to the mesh before is coded as if there had been none: the same surface leads to
    // the same state.
    const bool anew = !held.started || options.unrelated;
    std::vector<AttributeRange> ranges;
    if (held.attributes)
        ranges = ranges_for(values, anew ? std::span<const AttributeRange>()
                                         : std::span(held.state->ranges));
    bool key = anew || ranges != held.state->ranges;
    MeshMatch matched = key ? match({}, {}, mesh, held.attributes)
                            : match(held.places, held.state->cells(), mesh, false);
    const auto vertices = static_cast<double>(mesh.mesh.vertices());
    if (!key && matched.vertices_stay < least_staying * vertices) {
        key = true;
        matched = match({}, {}, mesh, held.attributes);
    }

    Step step;
    step.header = held.header(mesh, options.phase, key);
    step.truth =
        quantise_mesh(mesh.mesh, held.lattice, values, ranges, matched.places.vertices.place);
    static const WireTopology none;
    step.topology = !key && matched.edit.keeps_topology()
                        ? held.state->topology
                        : std::make_shared<const WireTopology>(
                              !key && matched.edit.only_adds() ? *held.state->topology : none,
                              std::move(matched.cells), mesh.mesh.vertices());
    step.edit = std::move(matched.edit);
    step.kept = std::move(matched.kept);
    step.tolerance = options.tolerance;
    auto update = encode(key ? nothing(held.lattice.bits, ranges) : *held.state, std::move(step));
    if (!update)
        return update;
    held.started = true;
    held.state = update->state;
    held.places = std::move(matched.places);
    ++held.next_seq;
    return update;
}

core::Result<EncodedUpdate> encode_key(std::uint32_t surface, const EncodedUpdate& update) {
    const WireMesh& state = *update.state;
    Step step;
    step.header.flags = FrameHeader::key;
    step.header.surface = surface;
    step.header.epoch = update.epoch;
    step.header.seq = update.seq;
    step.header.phase = update.phase;
    step.header.time = state.time;
    step.edit.added_vertices = static_cast<std::uint32_t>(state.vertices());
    step.edit.added_cells = static_cast<std::uint32_t>(state.cells().size());
    step.edit.cells = state.cells();
    step.truth = state;
    step.topology = state.topology;
    auto key = encode(nothing(state.lattice_bits, state.ranges), std::move(step));
    if (key)
        key->state = update.state;
    return key;
}

core::KeyedMesh with_ids(core::QuadComplex mesh, double time) {
    core::KeyedMesh keyed;
    keyed.vertex_id = numbers(0, static_cast<std::uint32_t>(mesh.vertices()));
    keyed.cell_id = numbers(0, static_cast<std::uint32_t>(mesh.cells.size()));
    keyed.mesh = std::move(mesh);
    keyed.time = time;
    return keyed;
}

} // namespace wakesurf::protocol
