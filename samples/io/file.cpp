#include "samples/io/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace relevo::io {
namespace {

std::string why(int error) { return std::strerror(error); }

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    int number() const { return number_; }
    // Only closing tells whether a network file system took the bytes.
    int close() {
        const int result = number_ < 0 ? 0 : ::close(number_);
        number_ = -1;
        return result;
    }

  private:
    int number_;
};

// Writing beyond the file-size limit (ulimit -f) kills a process by SIGXFSZ unless it looks the other way;
// then write() says EFBIG. A signal that came in the meantime is taken away before the door is opened again.
class SizeLimitSignalHeld {
  public:
    SizeLimitSignalHeld() {
        sigemptyset(&signals_);
        sigaddset(&signals_, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    }
    SizeLimitSignalHeld(const SizeLimitSignalHeld&) = delete;
    SizeLimitSignalHeld& operator=(const SizeLimitSignalHeld&) = delete;
    ~SizeLimitSignalHeld() {
        const timespec at_once{0, 0};
        while (sigtimedwait(&signals_, nullptr, &at_once) == SIGXFSZ) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

  private:
    sigset_t signals_, before_;
};

// 0, or errno.
int write_all(int descriptor, std::string_view bytes) {
    const SizeLimitSignalHeld held;
    while (!bytes.empty()) {
        const ssize_t written =
            ::write(descriptor, bytes.data(), std::min(bytes.size(), std::size_t(1) << 30));
        if (written < 0 && errno != EINTR) return errno;
        if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

// Reads until the end or one byte more than the limit; errno when that fails, else 0.
int read_all(int descriptor, std::size_t expected, std::size_t size_limit, std::string& out) {
    std::size_t used = 0;
    out.resize(std::min(expected, size_limit) + 1);
    for (;;) {
        const ssize_t got = ::read(descriptor, out.data() + used, out.size() - used);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno;
        used += static_cast<std::size_t>(got);
        if (got == 0 || used > size_limit) break;
        if (used == out.size()) out.resize(std::min(2 * used + 4096, size_limit + 1));
    }
    out.resize(used);
    return 0;
}

// Where a link leads to in the end, so that the file behind it is replaced and not the link.
std::string without_links(const std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), &std::free);
    return real ? real.get() : path;
}

FileError not_written(const std::string& path, int error) {
    return error_in(path, "cannot be written: " + why(error));
}

Failure write_directly(const std::string& path, std::string_view bytes) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    const int error = file.number() < 0 ? errno : write_all(file.number(), bytes);
    return error == 0 ? Failure() : not_written(path, error);
}

// Files that are whole under temporary names beside their places. Those that were not put there vanish.
class TemporaryFiles {
  public:
    TemporaryFiles() = default;
    TemporaryFiles(const TemporaryFiles&) = delete;
    TemporaryFiles& operator=(const TemporaryFiles&) = delete;
    ~TemporaryFiles() {
        for (const File& file : files_) ::unlink(file.temporary.c_str());
    }

    Failure write(const std::string& path, std::string_view bytes) {
        const std::string target = without_links(path);
        struct stat status {};
        const bool exists = ::stat(target.c_str(), &status) == 0;
        if (exists && S_ISDIR(status.st_mode)) return not_written(path, EISDIR);
        if (exists && !S_ISREG(status.st_mode)) return write_directly(path, bytes);
        if (exists && ::access(target.c_str(), W_OK) != 0) return not_written(path, errno);

        const std::string temporary = fmt::format("{}.part-{}", target, ::getpid());
        Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
        if (file.number() < 0) return not_written(path, errno);
        files_.push_back({path, target, temporary});
        if (exists) (void)!::fchmod(file.number(), status.st_mode & 07777);
        int error = write_all(file.number(), bytes);
        if (file.close() != 0 && error == 0) error = errno;
        return error == 0 ? Failure() : not_written(path, error);
    }

    Failure put_in_place() {
        for (; !files_.empty(); files_.erase(files_.begin())) {
            const File& file = files_.front();
            if (::rename(file.temporary.c_str(), file.target.c_str()) != 0)
                return not_written(file.path, errno);
        }
        return std::nullopt;
    }

  private:
    struct File {
        std::string path, target, temporary;
    };
    std::vector<File> files_;
};

}  // namespace

FileResult<std::string> read_file(const std::string& path, std::size_t size_limit) {
    const auto failure = [&](std::string message) { return error_in(path, std::move(message)); };
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.number() < 0 && errno == ENOENT) return failure("there is no such file");
    if (file.number() < 0) return failure("cannot be opened: " + why(errno));
    struct stat status {};
    if (::fstat(file.number(), &status) != 0) return failure("cannot be read: " + why(errno));
    if (S_ISDIR(status.st_mode)) return failure("is a directory, a file is needed");
    const auto size = static_cast<std::size_t>(status.st_size);
    const auto too_large = [&](const std::string& how_large) {
        return failure(fmt::format("is {} large, at most {} bytes are accepted", how_large, size_limit));
    };
    if (size > size_limit) return too_large(fmt::format("{} bytes", size));
    std::string bytes;
    if (const int error = read_all(file.number(), size, size_limit, bytes))
        return failure("cannot be read: " + why(error));
    if (bytes.size() > size_limit) return too_large(fmt::format("more than {} bytes", size_limit));
    return bytes;
}

FileResult<std::string> read_text(const std::string& path, std::size_t size_limit) {
    auto text = read_file(path, size_limit);
    if (!text) return text;
    if (text->empty()) return error_in(path, "the file is empty");
    if (text->starts_with("\xef\xbb\xbf")) text->erase(0, 3);
    if (const std::size_t zero = text->find('\0'); zero != std::string::npos) {
        const auto begin = text->begin(), end = begin + static_cast<std::ptrdiff_t>(zero);
        const std::size_t last_break = zero == 0 ? std::string::npos : text->rfind('\n', zero - 1);
        const std::size_t line_start = last_break == std::string::npos ? 0 : last_break + 1;
        return FileError{{path, static_cast<int>(std::count(begin, end, '\n')) + 1,
                          static_cast<int>(zero - line_start) + 1},
                         "a zero byte: this is a binary file, a text file is needed"};
    }
    return text;
}

Failure write_file(const std::string& path, std::string_view bytes) {
    TemporaryFiles files;
    if (const Failure failure = files.write(path, bytes)) return failure;
    return files.put_in_place();
}

Failure write_files(std::span<const FileToWrite> files) {
    TemporaryFiles temporary;
    for (const FileToWrite& file : files)
        if (const Failure failure = temporary.write(file.path, file.bytes)) return failure;
    return temporary.put_in_place();
}

}  // namespace relevo::io
