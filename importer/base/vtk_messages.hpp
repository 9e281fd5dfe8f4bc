// Catches everything VTK would print: its readers report damage only there, and go on with what they have.
#pragma once

#include "core/base/result.hpp"

#include <string>
#include <vector>

namespace wakesurf::importer {

/// Keeps VTK from printing while it lives; only one may live at a time.
class VtkMessages {
  public:
    /// @param expected  words of messages that are no fault
    explicit VtkMessages(std::vector<std::string> expected = {});
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    /// Returns Corrupt with VTK's first error or warning, as one sentence about `file`, if there was one.
    core::Result<void> verdict(const std::string& file) const;
};

} // namespace wakesurf::importer
