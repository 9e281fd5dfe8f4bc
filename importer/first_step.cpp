#include "importer/first_step.hpp"

#include "importer/assembly/node_values.hpp"
#include "importer/assembly/same_mesh.hpp"
#include "importer/assembly/wall_assembly.hpp"
#include "importer/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace wakesurf::importer {

using core::Error;

namespace {

// Cell values averaged to a wall's nodes are not zero there even where the flow is at rest, and have no jumps.
bool is_of_points(const ImportPlan& plan) {
    return plan.choice.velocity.arrays.front().source == core::FieldInfo::Source::Point;
}

// Hands out the velocities at all points of the first two time-steps and the last, or of all; those that cannot
// be read are reported when the import reaches them.
core::Result<void> visit_velocities(const ImportPlan& plan,
                                    FirstStepReading& reading,
                                    bool all,
                                    const std::function<void(std::span<const float>)>& take) {
    const auto first = point_values(reading.step.blocks, plan.choice.velocity);
    if (!first)
        return tl::unexpected(first.error());
    take(*first);
    const std::size_t end = plan.times.size();
    for (std::size_t index = 1; index < end; ++index) {
        if (!all && index > 1 && index + 1 < end)
            continue;
        auto step = plan.read(index);
        if (!step || !take_mesh_of(plan, reading.first, index, *step))
            continue;
        if (const auto values = point_values(step->blocks, plan.choice.velocity))
            take(*values);
        if (index + 1 == end)
            reading.last = std::move(*step);
    }
    return {};
}

// Says what of the velocity a slab cannot carry, beyond rounding: of a slice through a flow in space.
std::string note_across(const core::Vec3& normal, std::span<const float> velocity) {
    double highest = 0.0;
    double across = 0.0;
    for (std::size_t i = 0; i + 2 < velocity.size(); i += 3) {
        const core::Vec3 v(velocity[i], velocity[i + 1], velocity[i + 2]);
        if (!std::isfinite(glm::length(v)))
            continue;
        highest = std::max(highest, glm::length(v));
        across = std::max(across, std::abs(glm::dot(v, normal)));
    }
    if (!(across > 1e-5 * highest))
        return {};
    return "left out: the velocity across the plane, up to " +
           length_text(100.0 * across / highest, 2) + "% of the highest speed";
}

core::Result<void> find_faces_at_rest(const ImportPlan& plan, FirstStepReading& reading) {
    if (!std::holds_alternative<core::CellMesh>(reading.first.assembly.grid) || !is_of_points(plan))
        return {};
    const auto first = velocity_of(plan, reading.first, 0, reading.step);
    if (!first)
        return tl::unexpected(first.error());
    auto last = first;
    // One that cannot be read is reported when the import reaches it; the last that can is the one before it.
    const std::size_t end = plan.times.size();
    for (std::size_t index = end - 1; index > 0 && index + 2 >= end; --index) {
        auto step = index + 1 == end && reading.last
                        ? core::Result<SourceStep>(std::move(*reading.last))
                        : plan.read(index);
        if (!step || !take_mesh_of(plan, reading.first, index, *step))
            continue;
        if (auto velocity = velocity_of(plan, reading.first, index, *step))
            last = std::move(velocity);
        if (index + 1 == end)
            reading.last = std::move(*step);
        break;
    }
    add_still_walls(reading.first.assembly, *first, *last);
    return {};
}

// Returns the note on velocities at the points of a mesh that differ on both sides, by more than averaging would.
std::string
note_on_sides(const OppositeNodes& pairs, std::size_t axis, const std::vector<float>& velocity) {
    const auto at = [&](std::size_t node) {
        return core::Vec3(velocity[3 * node], velocity[3 * node + 1], velocity[3 * node + 2]);
    };
    double apart = 0.0;
    double fastest = 0.0;
    for (std::size_t node = 0; 3 * node < velocity.size(); ++node)
        fastest = std::max(fastest, glm::length(at(node)));
    for (const auto& [low, high] : pairs)
        apart = std::max(apart, glm::length(at(high) - at(low)));
    constexpr double little = 0.01;
    return apart <= little * fastest
               ? std::string()
               : "velocities on both sides along " + std::string(1, "xyz"[axis]) +
                     " differ by up to " + length_text(100.0 * apart / fastest, 2) +
                     " % of the highest, and their mean is taken: if the last plane of nodes is "
                     "not the first again, the period is too short";
}

// Finds the nodes that are one where the flow repeats. Along axes that only the files state it does not, where they
// do not match.
core::Result<void> find_opposite_nodes(const ImportPlan& plan, FirstStepReading& reading) {
    GridAssembly& assembly = reading.first.assembly;
    OppositeNodes opposite;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!plan.demanded[axis] && !plan.source->description().periodic[axis])
            continue;
        auto pairs = opposite_nodes(assembly.grid, axis, assembly.source_nodes);
        if (!pairs && plan.demanded[axis])
            return tl::unexpected(about_step(plan, 0, pairs.error()));
        if (!pairs) {
            add_note(assembly.note, "particles end at the sides along " +
                                        std::string(1, "xyz"[axis]) + ": the mesh " +
                                        pairs.error().message);
            continue;
        }
        reading.first.periodic[axis] = true;
        if (std::holds_alternative<core::CellMesh>(assembly.grid) && is_of_points(plan))
            if (const auto velocity =
                    node_values(assembly, reading.step.blocks, plan.choice.velocity))
                add_note(assembly.note, note_on_sides(*pairs, axis, *velocity));
        opposite.insert(opposite.end(), pairs->begin(), pairs->end());
    }
    assembly.opposite = std::move(opposite);
    return {};
}

} // namespace

core::Result<FirstStepReading>
read_first_step(const ImportPlan& plan, bool with_last, bool with_all) {
    auto step = plan.read(0);
    if (!step)
        return tl::unexpected(step.error());
    FirstStepReading reading{{}, std::move(*step), {}, {}};
    FirstStep& first = reading.first;
    const auto about = [&](Error error) { return about_step(plan, 0, std::move(error)); };
    auto mask = read_mask(reading.step.blocks, plan.choice).map_error(about);
    if (!mask)
        return tl::unexpected(mask.error());
    first.mask = std::move(*mask);
    const bool of_cells =
        plan.choice.velocity.arrays.front().source == core::FieldInfo::Source::Cell ||
        std::any_of(plan.choice.scalars.begin(), plan.choice.scalars.end(),
                    [](const ChosenScalar& scalar) {
                        return scalar.field.source == core::FieldInfo::Source::Cell;
                    });
    first.blocks = without_values(reading.step.blocks);
    AssemblyRequest request{first.mask.solid, of_cells};
    if (is_of_points(plan))
        request.velocities = [&](const auto& take) {
            return visit_velocities(plan, reading, with_all, take);
        };
    auto assembly = assemble_grid(reading.step.blocks, request).map_error(about);
    if (!assembly)
        return tl::unexpected(assembly.error());
    first.assembly = std::move(*assembly);
    if (first.assembly.across)
        if (const auto velocity =
                node_values(first.assembly, reading.step.blocks, plan.choice.velocity, {}))
            add_note(first.assembly.note, note_across(*first.assembly.across, *velocity));
    if (auto* mesh = std::get_if<core::CellMesh>(&first.assembly.grid))
        mesh->axis = plan.source->description().axis;
    if (auto found = find_opposite_nodes(plan, reading); !found)
        return tl::unexpected(found.error());
    Walls walls = find_walls(first.assembly, reading.step);
    if (walls.unmatched > 0)
        add_note(first.assembly.note, std::to_string(walls.unmatched) +
                                          " faces of walls are not on the mesh's boundary");
    first.still = std::move(walls.still);
    for (std::size_t node = 0; node < first.mask.fluid.size(); ++node)
        if (first.mask.fluid[node] == 0)
            first.still.push_back(static_cast<std::uint32_t>(node));
    if (with_last)
        if (auto found = find_faces_at_rest(plan, reading); !found)
            return tl::unexpected(found.error());
    reading.walls = wall_geometry(first.assembly, reading.step, walls);
    return reading;
}

} // namespace wakesurf::importer
