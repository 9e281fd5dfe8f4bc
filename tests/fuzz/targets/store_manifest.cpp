// A store's manifest: what is read describes a store whose parts agree, and is read again from what is written.
#include "tests/fuzz/targets/all.hpp"
#include "tests/support/sample_manifest.hpp"

namespace wakesurf::fuzz {

namespace {

void run(Input input) {
    const auto manifest = store::parse_store_manifest(text_of(input));
    if (!manifest)
        return;
    const std::string text = store::store_manifest_text(*manifest);
    const auto again = store::parse_store_manifest(text);
    demand(again.has_value(), "a manifest that was written can be read");
    demand(store::store_manifest_text(*again) == text,
           "a manifest is the same after it was written and read");
}

std::vector<std::string> seeds() {
    const std::string whole = store::store_manifest_text(tests::sample_manifest());
    return {whole, whole.substr(0, whole.size() / 2), "{}"};
}

} // namespace

const Target store_manifest_target{"store_manifest", run, seeds, true};

} // namespace wakesurf::fuzz
