#include "importer/base/failure_words.hpp"

#include "importer/base/told_words.hpp"

#include <filesystem>
#include <new>
#include <stdexcept>

namespace wakesurf::importer {

using core::Error;

Error error_of(const std::exception& thrown, const std::string& what) {
    if (dynamic_cast<const std::bad_alloc*>(&thrown) != nullptr)
        return {Error::Code::OverLimit, "there is not enough memory to read " + what, {}};
    if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&thrown))
        return {Error::Code::Io, "cannot read " + what + ": " + file->code().message(), {}};
    // The standard library throws these for an index or size beyond a container: the text names the container
    // only.
    if (dynamic_cast<const std::logic_error*>(&thrown) != nullptr)
        return {Error::Code::Corrupt, what + " contains an impossible size or number",
                "it is probably damaged; copy or write it again"};
    const std::string words = sentence_of_library(thrown.what());
    return {Error::Code::Io, "cannot read " + what + (words.empty() ? "" : " (" + words + ")"),
            "it is probably damaged; copy or write it again"};
}

} // namespace wakesurf::importer
