#include "server/net/kept_files.hpp"

#include <utility>
#include <vector>

namespace wakesurf::server {

File counted_file(std::string bytes, core::MemoryAccount::Share share) {
    struct Counted {
        std::string bytes;
        core::MemoryAccount::Share share;
    };

    const auto counted = std::make_shared<Counted>(Counted{std::move(bytes), std::move(share)});
    return {counted, &counted->bytes};
}

KeptFiles::KeptFiles(const core::MemoryAccount* account, std::size_t bytes, std::size_t count)
    : most_bytes_(bytes), most_(count) {
    if (account != nullptr)
        asked_ = account->on_need(core::GiveBack::Downloads, [state = state_](std::size_t wanted) {
            state->give_back(wanted);
        });
}

File KeptFiles::State::drop_last() {
    File last = std::move(entries.back().file);
    bytes -= last->size();
    entries.pop_back();
    return last;
}

/// A file that is still being read is released by its last reader.
void KeptFiles::State::give_back(std::size_t wanted) {
    std::vector<File> gone;
    std::size_t free = 0;
    const std::lock_guard lock(mutex);
    while (!entries.empty() && free < wanted) {
        const bool read = entries.back().file.use_count() > 1;
        gone.push_back(drop_last());
        free += read ? 0 : gone.back()->size();
    }
}

File KeptFiles::find(const std::string& tag) {
    const std::lock_guard lock(state_->mutex);
    auto& entries = state_->entries;
    for (auto each = entries.begin(); each != entries.end(); ++each)
        if (each->tag == tag) {
            entries.splice(entries.begin(), entries, each);
            return each->file;
        }
    return nullptr;
}

void KeptFiles::keep(const std::string& tag, File file) {
    std::vector<File> gone;
    const std::lock_guard lock(state_->mutex);
    if (file->size() > most_bytes_)
        return;
    state_->bytes += file->size();
    state_->entries.push_front({tag, std::move(file)});
    while (state_->bytes > most_bytes_ || state_->entries.size() > most_)
        gone.push_back(state_->drop_last());
}

std::size_t KeptFiles::bytes() const {
    const std::lock_guard lock(state_->mutex);
    return state_->bytes;
}

} // namespace wakesurf::server
