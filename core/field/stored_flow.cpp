#include "core/field/stored_flow.hpp"

#include "core/field/interval_flow.hpp"
#include "core/field/uniform_sampling.hpp"

namespace wakesurf::core {

std::unique_ptr<Flow> make_stored_flow(std::shared_ptr<TimeStepCache> cache,
                                       std::shared_ptr<const Clock> clock,
                                       Simd simd) {
    const TimeStepSource& source = cache->source();
    auto sampling = std::make_unique<const UniformSampling>(source, simd);
    return std::make_unique<IntervalFlow<UniformSampling>>(std::move(cache), std::move(clock),
                                                           std::move(sampling));
}

} // namespace wakesurf::core
