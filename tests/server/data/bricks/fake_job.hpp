// The words that start fake_job.py, which misbehaves as its arguments say.
#pragma once

#include "server/data/bricks/job_message.hpp"
#include "tests/support/places.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::tests {

/// @param how    one of those that the script knows
/// @param marks  of the store that the job claims
inline std::vector<std::string>
fake_job(const std::string& how, const server::JobHello& hello, const std::string& marks) {
    std::string words;
    const auto add = [&](std::span<const std::byte> bytes) {
        for (const std::byte each : bytes) {
            constexpr const char* digits = "0123456789abcdef";
            words += digits[std::to_integer<int>(each >> 4)];
            words += digits[std::to_integer<int>(each & std::byte{15})];
        }
    };
    add(std::as_bytes(std::span(&hello, 1)));
    add(std::as_bytes(std::span(marks)));
    return {"/usr/bin/python3", (source_folder() / "tests/server/data/bricks/fake_job.py").string(),
            how, words};
}

} // namespace wakesurf::tests
