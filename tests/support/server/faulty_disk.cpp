#include "tests/support/server/faulty_disk.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>
#include <stdexcept>
#include <utility>

namespace wakesurf::tests {

namespace {

constexpr std::size_t sector = 512;

void grow(std::vector<char>& bytes, std::size_t size) {
    if (bytes.size() < size)
        bytes.resize(size);
}

void copy_sector(const std::vector<char>& from, std::vector<char>& to, std::size_t index) {
    const std::size_t begin = index * sector;
    const std::size_t end = std::min(begin + sector, from.size());
    if (begin >= end)
        return;
    grow(to, end);
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(begin), end - begin,
                to.begin() + static_cast<std::ptrdiff_t>(begin));
}

} // namespace

struct FaultyDisk::Handle {
    sqlite3_file base; // first: SQLite sees only this
    FaultyDisk* disk;
    std::shared_ptr<File> file;
};

/// Implements SQLite's interface, in the order of its tables.
struct FaultyDisk::Calls {
    static Handle& of(sqlite3_file* file) { return *reinterpret_cast<Handle*>(file); }

    static FaultyDisk& of(sqlite3_vfs* vfs) { return *static_cast<FaultyDisk*>(vfs->pAppData); }

    static int close(sqlite3_file* file) {
        of(file).~Handle();
        return SQLITE_OK;
    }

    static int read(sqlite3_file* file, void* out, int amount, sqlite3_int64 offset) {
        Handle& self = of(file);
        const std::lock_guard lock(self.disk->mutex_);
        const auto& seen = self.file->seen;
        const auto begin = static_cast<std::size_t>(offset);
        const auto wanted = static_cast<std::size_t>(amount);
        const std::size_t there = begin < seen.size() ? std::min(seen.size() - begin, wanted) : 0;
        std::memset(out, 0, wanted);
        if (there > 0)
            std::memcpy(out, seen.data() + begin, there);
        return there == wanted ? SQLITE_OK : SQLITE_IOERR_SHORT_READ;
    }

    static int write(sqlite3_file* file, const void* bytes, int amount, sqlite3_int64 offset) {
        Handle& self = of(file);
        const std::lock_guard lock(self.disk->mutex_);
        const int code = self.disk->verdict();
        const auto begin = static_cast<std::size_t>(offset);
        const auto done = static_cast<std::size_t>(code == SQLITE_OK ? amount : amount / 2);
        if (done > 0) {
            grow(self.file->seen, begin + done);
            std::memcpy(self.file->seen.data() + begin, bytes, done);
            for (std::size_t each = begin / sector; each * sector < begin + done; ++each)
                self.file->unsynced.insert(each);
        }
        return code;
    }

    static int truncate(sqlite3_file* file, sqlite3_int64 size) {
        Handle& self = of(file);
        const std::lock_guard lock(self.disk->mutex_);
        const int code = self.disk->verdict();
        if (code == SQLITE_OK)
            self.file->seen.resize(static_cast<std::size_t>(size));
        return code;
    }

    static int sync(sqlite3_file* file, int) {
        Handle& self = of(file);
        const std::lock_guard lock(self.disk->mutex_);
        const int code = self.disk->verdict();
        File& f = *self.file;
        if (code == SQLITE_OK) {
            for (const std::size_t each : f.unsynced)
                copy_sector(f.seen, f.kept, each);
            f.kept.resize(f.seen.size());
        }
        f.unsynced.clear(); // the kernel marks pages as clean after an error, too
        return code;
    }

    static int size(sqlite3_file* file, sqlite3_int64* out) {
        Handle& self = of(file);
        const std::lock_guard lock(self.disk->mutex_);
        *out = static_cast<sqlite3_int64>(self.file->seen.size());
        return SQLITE_OK;
    }

    static int lock(sqlite3_file*, int) { return SQLITE_OK; }

    static int is_locked(sqlite3_file*, int* out) {
        *out = 0;
        return SQLITE_OK;
    }

    static int control(sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; }

    static int sector_size(sqlite3_file*) { return static_cast<int>(sector); }

    static int traits(sqlite3_file*) { return 0; }

    static int
    open(sqlite3_vfs* vfs, sqlite3_filename name, sqlite3_file* file, int flags, int* out_flags) {
        FaultyDisk& disk = of(vfs);
        const std::lock_guard lock(disk.mutex_);
        file->pMethods = nullptr;
        std::shared_ptr<File> content;
        if (name == nullptr) {
            content = std::make_shared<File>();
        } else {
            const auto found = disk.files_.find(name);
            if (found == disk.files_.end() && (flags & SQLITE_OPEN_CREATE) == 0)
                return SQLITE_CANTOPEN;
            content = found != disk.files_.end()
                          ? found->second
                          : disk.files_.emplace(name, std::make_shared<File>()).first->second;
        }
        new (file) Handle{{&methods}, &disk, std::move(content)};
        if (out_flags != nullptr)
            *out_flags = flags;
        return SQLITE_OK;
    }

    static int erase(sqlite3_vfs* vfs, const char* name, int) {
        FaultyDisk& disk = of(vfs);
        const std::lock_guard lock(disk.mutex_);
        if (const int code = disk.verdict(); code != SQLITE_OK)
            return code;
        return disk.files_.erase(name) == 1 ? SQLITE_OK : SQLITE_IOERR_DELETE_NOENT;
    }

    static int access(sqlite3_vfs* vfs, const char* name, int, int* out) {
        FaultyDisk& disk = of(vfs);
        const std::lock_guard lock(disk.mutex_);
        *out = disk.files_.contains(name) ? 1 : 0;
        return SQLITE_OK;
    }

    static int full_path(sqlite3_vfs*, const char* name, int size, char* out) {
        sqlite3_snprintf(size, out, "%s", name);
        return SQLITE_OK;
    }

    static const sqlite3_io_methods methods;
};

const sqlite3_io_methods FaultyDisk::Calls::methods = [] {
    sqlite3_io_methods out{};
    out.iVersion = 1; // no shared memory: the write-ahead log works with exclusive locking only
    out.xClose = close;
    out.xRead = read;
    out.xWrite = write;
    out.xTruncate = truncate;
    out.xSync = sync;
    out.xFileSize = size;
    out.xLock = lock;
    out.xUnlock = lock;
    out.xCheckReservedLock = is_locked;
    out.xFileControl = control;
    out.xSectorSize = sector_size;
    out.xDeviceCharacteristics = traits;
    return out;
}();

FaultyDisk::FaultyDisk() : vfs_(std::make_unique<sqlite3_vfs>()) {
    static std::atomic<int> next{1};
    name_ = "faulty-disk-" + std::to_string(next++);
    const sqlite3_vfs& usual = *sqlite3_vfs_find(nullptr);
    vfs_->iVersion = 1;
    vfs_->szOsFile = sizeof(Handle);
    vfs_->mxPathname = 256;
    vfs_->zName = name_.c_str();
    vfs_->pAppData = this;
    vfs_->xOpen = Calls::open;
    vfs_->xDelete = Calls::erase;
    vfs_->xAccess = Calls::access;
    vfs_->xFullPathname = Calls::full_path;
    vfs_->xRandomness = usual.xRandomness;
    vfs_->xSleep = usual.xSleep;
    vfs_->xCurrentTime = usual.xCurrentTime;
    vfs_->xGetLastError = usual.xGetLastError;
    if (sqlite3_vfs_register(vfs_.get(), 0) != SQLITE_OK)
        throw std::runtime_error("SQLite takes no further disk");
}

FaultyDisk::~FaultyDisk() {
    sqlite3_vfs_unregister(vfs_.get());
}

int FaultyDisk::verdict() {
    if (until_refusal_ < 0)
        return SQLITE_OK;
    if (until_refusal_ > 1) {
        --until_refusal_;
        return SQLITE_OK;
    }
    refused_ = true;
    if (!for_good_)
        until_refusal_ = -1;
    return code_;
}

void FaultyDisk::refuse(int at, int code, bool for_good) {
    const std::lock_guard lock(mutex_);
    until_refusal_ = at;
    code_ = code;
    for_good_ = for_good;
    refused_ = false;
}

bool FaultyDisk::heal() {
    const std::lock_guard lock(mutex_);
    until_refusal_ = -1;
    return refused_;
}

void FaultyDisk::survive(File& file, std::mt19937_64& random) {
    for (const std::size_t each : file.unsynced)
        if (random() % 2 == 0)
            copy_sector(file.seen, file.kept, each);
    file.unsynced.clear();
    file.seen = file.kept;
}

void FaultyDisk::cut_power(std::mt19937_64& random) {
    const std::lock_guard lock(mutex_);
    for (auto& [name, file] : files_)
        survive(*file, random);
}

void FaultyDisk::cut_power_onto(FaultyDisk& other, std::mt19937_64& random) const {
    const std::scoped_lock lock(mutex_, other.mutex_);
    other.files_.clear();
    for (const auto& [name, file] : files_) {
        auto copy = std::make_shared<File>(*file);
        survive(*copy, random);
        other.files_[name] = std::move(copy);
    }
}

} // namespace wakesurf::tests
