// Built-in flows by name: `flow:NAME?k=v,...` without the `flow:`, and the catalogue of them. Sampled
// exactly, never through a grid.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/field/flow.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::core {

/// A parameter with its default.
struct FlowParameter {
    std::string_view name;
    double value;
};

/// A built-in flow and its domain.
struct AnalyticEntry {
    std::string_view name;
    std::vector<FlowParameter> parameters;
    Box box;
    bool steady;
    std::unique_ptr<Flow> (*make)(std::span<const FlowParameter> p, const Box& box);
};

const std::vector<AnalyticEntry>& analytic_entries();

std::vector<std::string> analytic_flow_names();

/// Makes the flow of a name with parameters: `lamb-oseen` or `lamb-oseen?gamma=1,rc=0.2`. Error: NotFound
/// with the list of names, InvalidArgument for an unknown or unreadable parameter.
Result<std::unique_ptr<Flow>> make_analytic_flow(std::string_view specification);

/// Describes the flow as `info` shows it: times 0..10 in 21 steps where the flow is unsteady, one time 0
/// where it is steady.
Result<DatasetInfo> describe_analytic_flow(std::string_view specification);

} // namespace wakesurf::core
