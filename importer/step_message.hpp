// What a process that converts time-steps tells the one that started it, as bytes in a pipe.
#pragma once

#include "core/base/result.hpp"
#include "importer/step_conversion.hpp"

#include <optional>

namespace wakesurf::importer {

struct StepMessage {
    std::size_t index = 0;
    core::Result<StepRecord> outcome = StepRecord();
};

/// False when the other side is gone.
bool send(int pipe, const StepMessage& message);

/// Nothing at the end of the pipe, also when it ends within a message.
std::optional<StepMessage> receive(int pipe);

} // namespace wakesurf::importer
