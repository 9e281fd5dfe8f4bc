#include "protocol/wire/wire_draft.hpp"

#include <span>
#include <utility>

namespace wakesurf::protocol {

WireDraft begin_draft(const WireMesh& before,
                      const TopologyEdit& edit,
                      std::shared_ptr<const WireTopology> topology) {
    WireDraft draft;
    const Runs& removed = edit.removed_vertices;
    draft.position_before = without(removed, std::span(before.position));
    draft.change_before = without(removed, std::span(before.change));
    for (const auto& codes : before.codes)
        draft.codes_before.push_back(without(removed, std::span(codes)));
    draft.stay = static_cast<std::uint32_t>(draft.position_before.size());
    const std::size_t vertices = std::size_t{draft.stay} + edit.added_vertices;

    WireMesh& after = draft.after;
    after.lattice_bits = before.lattice_bits;
    after.ranges = before.ranges;
    after.topology = std::move(topology);
    after.position.reserve(vertices);
    after.position = draft.position_before;
    after.position.resize(vertices);
    after.change.resize(vertices);
    for (const auto& codes : draft.codes_before) {
        after.codes.emplace_back().reserve(vertices);
        after.codes.back() = codes;
        after.codes.back().resize(vertices);
    }
    return draft;
}

} // namespace wakesurf::protocol
