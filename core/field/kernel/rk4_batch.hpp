// The data of a batch kernel: time-steps and up to 32 particles, for one RK4 step each or several. It is
// plain data, because some kernels are compiled for newer processors: an inline function of a shared header
// that such a kernel emitted could replace that of all others (one definition rule) and crash older
// processors.
#pragma once

#include "core/field/kernel/simd.hpp"

#include <cstddef>
#include <cstdint>

namespace wakesurf::core {

/// A cell on an axis of a rectilinear grid and its neighbours, in lengths from the cell's lower end. Cells at
/// the border go on for ever.
struct CellReach {
    float below;  ///< what is below is in a cell before the one before
    float lowest; ///< lower end of the cell before
    float begin;  ///< what is below is not in this cell
    float end;    ///< what is above is not in this cell
    float above;  ///< what is above is in a cell after the one after
    float per_width_before, per_width, per_width_after;
};

/// Finds cells on an axis of a rectilinear grid.
struct AxisTable {
    const double* coordinate;   ///< of nodes
    const std::uint32_t* start; ///< by bucket: a cell near which those of its coordinates are
    double per_bucket;          ///< buckets in a unit of length
    double buckets;
    std::uint32_t last; ///< cell
    const CellReach* cell;
};

/// A time-step in bricks: core/dataset/brick_table.hpp.
struct StoredBricks {
    const float* const* at; ///< by brick; null: missing
    std::uint16_t* used;    ///< by brick
};

/// A byte a cell, by its lowest node, in one piece or in bricks. With neither there is no obstacle.
struct StoredStates {
    const std::uint8_t* whole;         ///< by the grid's node
    const std::uint8_t* const* bricks; ///< by brick, then its node
};

/// The places of cells in bricks. Vectors are x, y, z.
struct BrickPlaces {
    const float* zeros; ///< in place of a brick that is missing
    std::uint16_t age;  ///< for those that are used
    double cells;       ///< on an axis of a brick
    double per_cell;    ///< 1 / cells
    double brick[3];    ///< bricks between neighbours on each axis
    double node[3];     ///< nodes within a brick, likewise
};

/// Two time-steps of a uniform or a rectilinear grid. Vectors are x, y, z.
struct StoredPair {
    const float* velocity0; ///< null: in bricks
    const float* velocity1; ///< null: frozen at the first, or in bricks
    StoredStates cell;      ///< CellMask

    /// Cubic in space and, unless frozen, in time; a neighbour that the series does not have may be any
    /// time-step, of share 0. REQUIRES: at least four nodes on each axis, no velocity that is no number.
    bool smooth;
    const float* before;
    const float* after;
    StoredStates near_solid; ///< not 0: linear in space

    bool in_bricks;                                             ///< the time-steps
    StoredBricks bricks0, bricks1, bricks_before, bricks_after; ///< as the four above
    BrickPlaces places; ///< also of cells' states in bricks, where time-steps are in one piece

    double time0;
    double per_interval; ///< 1 / time between the two
    double origin[3];
    double per_spacing[3]; ///< rectilinear: 1, so that ways are lengths
    double last[3];        ///< index of the last node on each axis
    double last_cell[3];   ///< of the last cell
    const AxisTable* axis; ///< of each of the three; null: the grid is uniform
    double low[3];         ///< the domain, as Box::contains compares
    double high[3];
    double stride[3];  ///< nodes between neighbours on each axis
    float stagnation2; ///< a slower particle (speed squared) may stand still
};

/// The bricks in which the lanes of a batch were last found: most are found there again, stage by stage and
/// step by step, without reading the tables. They are valid while nothing is removed from memory, for the
/// time-steps in `of`.
struct BrickReferences {
    static constexpr std::size_t lanes = 32;
    /// Counts 4^3 nodes, and what the last load reads beyond.
    static constexpr std::size_t block_floats = 64 * 3 + 4;

    StoredBricks of[4] = {}; ///< what has been looked up, by slot
    std::size_t slot[4] = {0, 1, 2,
                           3}; ///< of the pair's first time-step, its second, before, after
    std::uint64_t absent = 0;  ///< a bit a lane: its brick is missing
    /// The first cell after the brick on each axis; 0: none is kept.
    alignas(64) float beyond[3][lanes] = {};
    /// The place of the node there by slot, were it in the brick, in floats from BrickPlaces::zeros.
    alignas(64) std::int64_t end[4][lanes];

    // Tell cubics where nodes of several bricks were brought together.
    alignas(64) float block_at[3][lanes] = {}; ///< 1 + the lowest node; 0: there is none
    alignas(64) float block[4][lanes][block_floats];
};

/// Particles that take a step together, stage by stage: while one waits for its samples another computes (one
/// at a time is 1.5-1.8 times slower: docs/measurements.md, The limit of the kernel). One array a coordinate:
/// what is no load from the field is computed for 4 to 16 particles at once. Lanes beyond `count` hold any
/// numbers.
struct Rk4Batch {
    static constexpr std::size_t most = BrickReferences::lanes;

    using Bits = std::uint64_t; ///< a bit a lane

    std::size_t count = 0;

    // A particle between steps, in double so that accuracy does not drift.
    alignas(64) double position[3][most] = {};
    alignas(64) double tangent[most][8] = {}; ///< along_s, expansion; along_t, any number
    alignas(64) double start[most] = {};      ///< time at its first step
    alignas(64) double dt[most] = {};
    alignas(64) double taken[most] = {}; ///< steps
    alignas(64) double steps[most] = {}; ///< to take

    /// The shares of the four time-steps of the smooth field at the step's start, middle and end.
    alignas(64) float share[3][4][most] = {};

    /// 0 for one step; else the number of steps taken at once, all of particles that have the same start, dt
    /// and taken. Position, tangent and taken are then those after the last step, slow and outside the union
    /// over all of them. The shares of all are those of `share_of_steps`, 3 x 4 a step.
    std::size_t straight = 0;
    const float* share_of_steps = nullptr;

    /// Asks for no step: velocity is found where the particles are, at the times they have; `straight` says
    /// that these are the same.
    bool velocity_only = false;
    alignas(64) float velocity[most][4];

    // The kernel writes the members below. Sets are bits of lanes.
    alignas(64) double next[3][most];
    alignas(64) double next_tangent[most][8];
    Bits slow = 0;    ///< may stand still
    Bits outside = 0; ///< next is outside the domain, or in a cell with a solid node
    Bits last = 0;    ///< this step is the last to take
    Bits missing = 0; ///< a brick was missing: nothing else of the lane counts
    std::uint32_t missing_brick[most]; ///< of lanes that miss one: its number

    BrickReferences bricks; ///< between calls; of any earlier lanes
};

/// Takes one step of every particle, or several at once where `straight` says so; fills next, slow, outside,
/// last and missing.
using Rk4Kernel = void (*)(const StoredPair&, Rk4Batch&, bool tangents);

void rk4_portable(const StoredPair& field, Rk4Batch& batch, bool tangents);

/// The kernel compiled for x86-64-v3. REQUIRES: avx2_compiled() and a processor that has it.
void rk4_avx2(const StoredPair& field, Rk4Batch& batch, bool tangents);

bool avx2_compiled();

/// The kernel compiled for x86-64-v4. REQUIRES: avx512_compiled() and a processor that has it.
void rk4_avx512(const StoredPair& field, Rk4Batch& batch, bool tangents);

bool avx512_compiled();

} // namespace wakesurf::core
