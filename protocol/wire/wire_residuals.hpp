// From the true values of vertices to residuals and back: predict, take the difference in steps of the
// tolerance, continue from the decoder's value. The sender chooses the predictors. protocol/wire/FORMAT.md,
// Points. Twin of the way back: web-client/src/protocol/wirePoints.ts.
#pragma once

#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_draft.hpp"
#include "protocol/wire/wire_predict.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Describes how vertices of one kind are predicted and rounded: [0] their position, then each attribute.
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
    /// The changes of added vertices, three numbers each.
    std::vector<std::int32_t> change;

    bool operator==(const Residuals&) const = default;
};

/// Returns the predictors that seem best for vertices `coded` of the draft, tried on some of them, whose
/// values in the draft it overwrites. Tolerances are taken from `coding`.
PointCoding choose_predictors(WireDraft& draft,
                              const WireMesh& truth,
                              PointCoding coding,
                              std::span<const std::uint32_t> coded);

/// Fills in vertices `coded` of the draft and returns the residuals from which the decoder does the same. If
/// the truth has no changes, added vertices get the predicted ones.
Residuals make_residuals(WireDraft& draft,
                         const WireMesh& truth,
                         const PointCoding& coding,
                         std::span<const std::uint32_t> coded);

/// Fills in vertices `coded` of the draft from their residuals, as many.
void apply_residuals(WireDraft& draft,
                     const Residuals& residuals,
                     std::span<const std::uint32_t> coded);

} // namespace wakesurf::protocol
