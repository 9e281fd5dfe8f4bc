#include "importer/first_step.hpp"

#include "importer/assembly/same_mesh.hpp"
#include "importer/assembly/wall_assembly.hpp"
#include "importer/base/notes.hpp"

namespace wakesurf::importer {

using core::Error;

namespace {

// Cell values averaged to a wall's nodes are not zero there even where the flow is at rest.
bool shows_rest(const ImportPlan& plan) {
    return plan.choice.velocity.arrays.front().source == core::FieldInfo::Source::Point;
}

core::Result<void> find_faces_at_rest(const ImportPlan& plan, FirstStepReading& reading) {
    if (!std::holds_alternative<core::CellMesh>(reading.first.assembly.grid) || !shows_rest(plan))
        return {};
    const auto first = velocity_of(plan, reading.first, 0, reading.step);
    if (!first)
        return tl::unexpected(first.error());
    auto last = first;
    if (const std::size_t index = plan.times.size() - 1; index > 0) {
        auto step = plan.read(index);
        // A last time-step that cannot be read is reported when the import reaches it.
        if (step && check_mesh_of(plan, reading.first, index, *step)) {
            last = velocity_of(plan, reading.first, index, *step);
            reading.last = std::move(*step);
        }
        if (!last)
            last = first;
    }
    add_still_walls(reading.first.assembly, *first, *last);
    return {};
}

} // namespace

core::Result<FirstStepReading> read_first_step(const ImportPlan& plan, bool with_last) {
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
    auto assembly =
        assemble_grid(reading.step.blocks, {first.mask.solid, of_cells}).map_error(about);
    if (!assembly)
        return tl::unexpected(assembly.error());
    first.assembly = std::move(*assembly);
    if (auto* mesh = std::get_if<core::CellMesh>(&first.assembly.grid))
        mesh->axis = plan.source->description().axis;
    first.blocks = without_values(reading.step.blocks);
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
    reading.walls = wall_geometry(first.assembly, reading.step);
    return reading;
}

} // namespace wakesurf::importer
