// From the true values of vertices to residuals and back: predict, take the difference in steps of the tolerance, go on from
// what the other end will have. The choice of predictors is the sender's. protocol/wire/FORMAT.md, Points.
// Twin of the way back: web-client/src/protocol/wirePredict.ts.
#pragma once

#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_draft.hpp"
#include "protocol/wire/wire_predict.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// How vertices of one kind are predicted and rounded: [0] their position, then each attribute.
struct PointCoding {
    PointKind kind = PointKind::Moved;
    std::uint8_t attributes = 0;
    std::array<std::uint8_t, max_attributes + 1> predictor{};
    std::array<std::uint16_t, max_attributes + 1> tolerance{};

    bool operator==(const PointCoding&) const = default;
};

struct Residuals {
    PointCoding coding;
    std::uint32_t count = 0;
    std::vector<std::int32_t> position; ///< three a vertex
    std::vector<std::vector<std::int32_t>> codes;
    std::vector<std::int32_t> change; ///< of added vertices: three each

    bool operator==(const Residuals&) const = default;
};

/// The predictors that seem best for vertices `coded` of the draft, tried on some of them. Leaves traces in those vertices of
/// the draft. Tolerances are taken from `coding`.
PointCoding choose_predictors(WireDraft& draft,
                              const WireMesh& truth,
                              PointCoding coding,
                              std::span<const std::uint32_t> coded);

/// Fills in vertices `coded` of the draft and returns what the other end needs for the same. Added vertices of a truth without changes
/// get what is predicted.
Residuals make_residuals(WireDraft& draft,
                         const WireMesh& truth,
                         const PointCoding& coding,
                         std::span<const std::uint32_t> coded);

/// Fills in vertices `coded` of the draft from their residuals, as many.
void apply_residuals(WireDraft& draft,
                     const Residuals& residuals,
                     std::span<const std::uint32_t> coded);

} // namespace wakesurf::protocol
