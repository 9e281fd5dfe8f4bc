#include "importer/filter/pipeline_source.hpp"

#include "importer/first_step.hpp"
#include "importer/sources/blocks/block_roles.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"

#include <span>
#include <utility>

namespace wakesurf::importer {

using core::Error;

namespace {

class PipelineSource final : public Source {
  public:
    PipelineSource(std::vector<PipelineStep> steps, std::string velocity)
        : steps_(std::move(steps)), velocity_(std::move(velocity)) {}

    core::Result<void> open() {
        description_.name = "the input";
        description_.reader = "VTK pipeline";
        for (const PipelineStep& each : steps_)
            description_.times.push_back(each.time);
        auto blocks = fluid(leaves_of(steps_.front().data));
        if (!blocks)
            return tl::unexpected(blocks.error());
        BlockRoles roles = block_roles(*blocks, velocity_);
        fluid_ = std::move(roles.fluid);
        description_.fields = std::move(roles.fields);
        return {};
    }

    core::Result<std::vector<store::SourceFile>> shared_files() const override { return {}; }

    core::Result<std::vector<store::SourceFile>> files(std::size_t) const override { return {}; }

    core::Result<SourceStep> read(std::size_t step,
                                  const std::vector<core::FieldInfo>& fields) override {
        const auto leaves = leaves_of(steps_[step].data);
        auto blocks = fluid(leaves);
        if (!blocks)
            return tl::unexpected(blocks.error());
        if (blocks->size() != fluid_.size())
            return core::fail(Error::Code::Unsupported, "the input has other blocks at the time " +
                                                            std::to_string(steps_[step].time));
        SourceStep out;
        for (std::size_t i = 0; i < blocks->size(); ++i) {
            if (!fluid_[i]) {
                out.solids.push_back(boundary_of(*(*blocks)[i]));
                continue;
            }
            if (auto there = require_fields(*(*blocks)[i], fields, description_.name); !there)
                return tl::unexpected(there.error());
            out.blocks.push_back((*blocks)[i]);
        }
        for (const Leaf& leaf : leaves) {
            if (has_solid_cells(*leaf.data) || !is_named_wall(leaf.name()))
                continue;
            auto surface = surface_of(*leaf.data, description_.name);
            if (!surface)
                return tl::unexpected(surface.error());
            out.walls.push_back({std::move(*surface), is_still(*leaf.data, fields), leaf.name()});
        }
        return out;
    }

  private:
    core::Result<Blocks> fluid(const std::vector<Leaf>& leaves) const {
        Blocks out;
        for (const Leaf& leaf : leaves) {
            if (leaves.size() > 1 && !has_solid_cells(*leaf.data))
                continue;
            auto part = fluid_part(*leaf.data, description_.name);
            if (!part)
                return tl::unexpected(part.error());
            out.push_back(std::move(*part));
        }
        if (out.empty())
            return core::fail(Error::Code::Unsupported, "the input has no three-dimensional cells");
        return out;
    }

    std::vector<PipelineStep> steps_;
    std::string velocity_;
    std::vector<bool> fluid_;
};

} // namespace

core::Result<std::shared_ptr<const core::StepsInMemory>> steps_of(std::vector<PipelineStep> steps,
                                                                  const std::string& velocity) {
    if (steps.empty())
        return core::fail(Error::Code::NotFound, "the input has no time-steps");
    auto source = std::make_unique<PipelineSource>(std::move(steps), velocity);
    if (auto opened = source->open(); !opened)
        return tl::unexpected(opened.error());
    ImportRequest request;
    request.taken.velocity = velocity;
    auto plan = plan_of(std::move(source), request);
    if (!plan)
        return tl::unexpected(plan.error());
    auto reading = read_first_step(*plan, true, true);
    if (!reading)
        return tl::unexpected(reading.error());
    std::vector<std::vector<float>> velocities;
    for (std::size_t i = 0; i < plan->times.size(); ++i) {
        auto step = plan->read(i);
        if (!step)
            return tl::unexpected(step.error());
        if (auto same = take_mesh_of(*plan, reading->first, i, *step); !same)
            return tl::unexpected(same.error());
        auto values = velocity_of(*plan, reading->first, i, *step);
        if (!values)
            return tl::unexpected(values.error());
        velocities.push_back(std::move(*values));
    }
    return core::StepsInMemory::make(std::move(reading->first.assembly.grid), plan->times,
                                     {velocities.begin(), velocities.end()},
                                     {std::move(reading->first.mask.fluid)});
}

} // namespace wakesurf::importer
