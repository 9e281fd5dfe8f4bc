#include "importer/step_conversion.hpp"

#include "core/base/half.hpp"
#include "core/base/vec3.hpp"
#include "importer/assembly/node_values.hpp"
#include "importer/assembly/same_mesh.hpp"
#include "store/value_writing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

namespace wakesurf::importer {

using core::Error;

namespace {

std::vector<std::uint16_t> halves_of(std::span<const float> values) {
    std::vector<std::uint16_t> halves(values.size());
    core::to_half(values, halves);
    return halves;
}

class StepWriting {
  public:
    StepWriting(const ImportPlan& plan,
                std::size_t index,
                const store::StoreLayout& layout,
                store::StoreWriter& writer)
        : plan_(plan), index_(index), layout_(layout), writer_(writer) {}

    /// Writes the values of the next column.
    core::Result<void> write(const std::string& field, std::span<const float> values) {
        if (layout_.precision == core::Precision::Half && std::isinf(rounding_error(values)))
            return core::fail(
                Error::Code::Unsupported,
                plan_.step_name(index_) + " has values of " + field +
                    " beyond 65504, which half precision cannot hold",
                "import without --precision half, or name other fields with --fields");
        return store::write_values(writer_, layout_, record.checksums.size(), index_, values)
            .map([&](std::uint32_t checksum) { record.checksums.push_back(checksum); });
    }

    StepRecord record;

  private:
    const ImportPlan& plan_;
    std::size_t index_;
    const store::StoreLayout& layout_;
    store::StoreWriter& writer_;
};

tl::unexpected<Error>
differs(const ImportPlan& plan, std::size_t index, const char* what, const char* hint) {
    return core::fail(Error::Code::Unsupported,
                      plan.step_name(index) + " has another " + what + " than " + plan.step_name(0),
                      hint);
}

core::Result<std::vector<float>>
scalar_of(const FirstStep& first, const SourceStep& step, const ChosenScalar& scalar) {
    auto values =
        node_values(first.assembly, step.blocks, {{scalar.field}, {}, scalar.field.components});
    return scalar.is_magnitude() ? std::move(values).map(magnitudes) : std::move(values);
}

} // namespace

std::vector<float> magnitudes(const std::vector<float>& vectors) {
    std::vector<float> out(vectors.size() / 3);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const core::Vec3 v(vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]);
        // std::hypot of three loses a NaN if the others are 0 (libstdc++ 12).
        out[i] = static_cast<float>(glm::length(v));
    }
    return out;
}

double rounding_error(std::span<const float> values) {
    const auto halves = halves_of(values);
    std::vector<float> back(values.size());
    core::from_half(halves, back);
    double largest = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i]))
            largest = std::max(
                largest, std::abs(static_cast<double>(values[i]) - static_cast<double>(back[i])));
    return largest;
}

void Range::include(const Range& other) {
    lo = std::min(lo, other.lo);
    hi = std::max(hi, other.hi);
}

Range speed_range(std::span<const float> velocity, std::span<const std::uint8_t> fluid) {
    // Several values are compared at a time, without branches: NaN compares false and changes nothing.
    constexpr std::size_t lanes = 8;
    std::array<double, lanes> lo;
    std::array<double, lanes> hi;
    lo.fill(std::numeric_limits<double>::infinity());
    hi.fill(-std::numeric_limits<double>::infinity());
    const auto include = [&](std::size_t node, std::size_t lane) {
        const double x = velocity[3 * node];
        const double y = velocity[3 * node + 1];
        const double z = velocity[3 * node + 2];
        const double square = x * x + y * y + z * z; // of float values: no overflow
        lo[lane] = square < lo[lane] ? square : lo[lane];
        hi[lane] = square > hi[lane] ? square : hi[lane];
    };
    const std::size_t nodes = velocity.size() / 3;
    std::size_t node = 0;
    for (; fluid.empty() && node + lanes <= nodes; node += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            include(node + lane, lane);
    for (; node < nodes; ++node)
        if (fluid.empty() || fluid[node] != 0)
            include(node, 0);
    const Range range{*std::min_element(lo.begin(), lo.end()),
                      *std::max_element(hi.begin(), hi.end())};
    return range.empty() ? range : Range{std::sqrt(range.lo), std::sqrt(range.hi)};
}

Range value_range(std::span<const float> values) {
    Range range;
    for (const float value : values)
        if (std::isfinite(value))
            range.include({value, value});
    return range;
}

core::Result<void>
take_mesh_of(const ImportPlan& plan, const FirstStep& first, std::size_t index, SourceStep& step) {
    if (!same_mesh(first.blocks, step.blocks)) {
        auto ordered = values_on(first.blocks, step.blocks);
        if (!ordered)
            return differs(plan, index, "mesh",
                           "all time-steps must share one mesh: a moving mesh cannot be read");
        step.blocks = std::move(*ordered);
    }
    auto mask = read_mask(step.blocks, plan.choice);
    if (!mask)
        return tl::unexpected(about_step(plan, index, mask.error()));
    if (*mask != first.mask)
        return differs(
            plan, index, "mask",
            "a body that moves can be left out at each time, by --mask gap, or its mask taken "
            "for a scalar, by --mask scalar");
    return {};
}

core::Result<std::vector<float>> velocity_of(const ImportPlan& plan,
                                             const FirstStep& first,
                                             std::size_t index,
                                             const SourceStep& step) {
    auto velocity =
        node_values(first.assembly, step.blocks, plan.choice.velocity, first.still)
            .map_error([&](Error error) { return about_step(plan, index, std::move(error)); });
    if (const auto& across = first.assembly.across; velocity && across)
        for (std::size_t i = 0; i < velocity->size(); i += 3) {
            const core::Vec3 v((*velocity)[i], (*velocity)[i + 1], (*velocity)[i + 2]);
            const core::Vec3 within = v - glm::dot(v, *across) * *across;
            for (std::size_t k = 0; k < 3; ++k)
                (*velocity)[i + k] = static_cast<float>(within[static_cast<int>(k)]);
        }
    return velocity;
}

core::Result<StepRecord> write_step(const ImportPlan& plan,
                                    const FirstStep& first,
                                    std::size_t index,
                                    const SourceStep& step,
                                    const store::StoreLayout& layout,
                                    store::StoreWriter& writer) {
    StepWriting writing(plan, index, layout, writer);
    StepRecord& record = writing.record;
    {
        const auto velocity = velocity_of(plan, first, index, step);
        if (!velocity)
            return tl::unexpected(velocity.error());
        record.speed = speed_range(*velocity, first.mask.fluid);
        if (!first.assembly.meeting.empty())
            if (const auto all = point_values(step.blocks, plan.choice.velocity))
                record.tears = first.assembly.meeting.tears(*all);
        auto written = writing.write(plan.choice.velocity_name, *velocity);
        if (!written)
            return tl::unexpected(written.error());
    }
    for (const auto& scalar : plan.choice.scalars) {
        const auto values = scalar_of(first, step, scalar);
        if (!values)
            return tl::unexpected(about_step(plan, index, values.error()));
        record.scalars.push_back(value_range(*values));
        if (auto written = writing.write(scalar.stored.name, *values); !written)
            return tl::unexpected(written.error());
    }
    return std::move(record);
}

core::Result<StepRecord> convert_step(const ImportPlan& plan,
                                      const FirstStep& first,
                                      std::size_t index,
                                      const SourceStep* read,
                                      const store::StoreLayout& layout,
                                      store::StoreWriter& writer) {
    try {
        if (read != nullptr)
            return write_step(plan, first, index, *read, layout, writer);
        auto step = plan.read(index);
        if (!step)
            return tl::unexpected(step.error());
        if (auto same = take_mesh_of(plan, first, index, *step); !same)
            return tl::unexpected(same.error());
        return write_step(plan, first, index, *step, layout, writer);
    } catch (const std::bad_alloc&) {
        return core::fail(Error::Code::OverLimit,
                          "there is not enough memory to convert " + plan.step_name(index));
    }
}

} // namespace wakesurf::importer
