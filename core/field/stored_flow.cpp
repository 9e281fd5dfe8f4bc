#include "core/field/stored_flow.hpp"

#include "core/field/cells/cell_sampling.hpp"
#include "core/field/interval_flow.hpp"
#include "core/field/uniform_sampling.hpp"

namespace wakesurf::core {

namespace {

template <class Sampling>
std::unique_ptr<Flow> make_flow(std::shared_ptr<TimeStepCache> cache,
                                std::shared_ptr<const Clock> clock,
                                std::unique_ptr<const Sampling> sampling) {
    return std::make_unique<IntervalFlow<Sampling>>(std::move(cache), std::move(clock),
                                                    std::move(sampling));
}

} // namespace

std::unique_ptr<Flow> make_stored_flow(std::shared_ptr<TimeStepCache> cache,
                                       std::shared_ptr<const Clock> clock,
                                       Simd simd) {
    const TimeStepSource& source = cache->source();
    if (std::holds_alternative<CellMesh>(source.grid()))
        return make_flow(std::move(cache), std::move(clock),
                         std::make_unique<const CellSampling>(source));
    return make_flow(std::move(cache), std::move(clock),
                     std::make_unique<const UniformSampling>(source, simd));
}

} // namespace wakesurf::core
