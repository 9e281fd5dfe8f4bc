#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/data/dataset_argument.hpp"
#include "server/data/import_process.hpp"

namespace wakesurf::server {

int run_import(const ImportOptions& options) {
    const auto source = resolve_dataset(options.dataset);
    if (!source)
        return report_failure(source.error());
    if (source->kind != DatasetArgument::Kind::Source)
        return report_failure({core::Error::Code::InvalidArgument,
                               options.dataset + " needs no import", "use it as it is"});
    const StopOnSignal signals;
    const auto imported = run_import_process(
        {source->path,
         options.store,
         options.fields,
         options.times,
         {},
         options.precision,
         options.jobs,
         options.memory,
         options.taken,
         options.layout},
        [](const store::ImportProgress& progress) { store::show_progress(progress, stdout); },
        signals.token());
    if (!imported)
        return report_refusal(imported.error());
    return 0;
}

} // namespace wakesurf::server
