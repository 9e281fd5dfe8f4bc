// The built-in flows: names, parameters with their defaults, domains.
#pragma once

#include "core/field/flow.hpp"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace wakesurf::core {

struct FlowParameter {
    std::string_view name;
    double value;
};

struct AnalyticEntry {
    std::string_view name;
    std::vector<FlowParameter> parameters;
    Box box;
    bool steady;
    std::unique_ptr<Flow> (*make)(std::span<const FlowParameter> p, const Box& box);
};

const std::vector<AnalyticEntry>& analytic_entries();

} // namespace wakesurf::core
