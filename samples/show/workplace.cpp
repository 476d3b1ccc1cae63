#include "samples/show/workplace.hpp"

#include <stdlib.h>

#include "samples/io/file.hpp"
#include "samples/io/png.hpp"

namespace relevo::show {
namespace {

namespace fs = std::filesystem;

// The failure as the user knows the file: by its final name.
io::Failure named(io::Failure failure, const fs::path& file) {
    if (failure) failure->place.file = file.string();
    return failure;
}

io::FileError unwritable(const fs::path& file, const std::error_code& error) {
    return io::error_in(file.string(), "cannot write this file: " + error.message());
}

}  // namespace

// Files are written into a folder inside of the target and moved out of it when all of them are complete.
io::Failure Workplace::open(const std::string& directory) {
    const auto refuse = [&](const std::string& why) {
        return io::error_in(directory, "cannot write into this folder: " + why);
    };
    target_ = directory;
    std::error_code error;
    for (fs::path p = fs::absolute(target_, error).lexically_normal(); !p.empty() && !fs::exists(p, error);
         p = p.parent_path()) {
        if (p.has_filename()) made_ = p;
        if (p == p.root_path()) break;
    }
    error.clear();
    fs::create_directories(target_, error);
    if (error) return refuse(error.message());
    std::string name = (target_ / ".steps-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        const std::string why = std::generic_category().message(errno);
        if (!made_.empty()) fs::remove_all(made_, error);
        return refuse(why);
    }
    draft_ = name;
    return {};
}

io::FileResult<std::string> Workplace::draft_path(const std::string& file) {
    std::error_code error;
    fs::create_directories((draft_ / file).parent_path(), error);
    if (error) return unwritable(target_ / file, error);
    files_.push_back(file);
    return (draft_ / file).string();
}

io::Failure Workplace::write(const std::string& file, std::string_view bytes) {
    const auto path = draft_path(file);
    return path ? named(io::write_file(*path, bytes), target_ / file) : path.error();
}

io::Failure Workplace::write(const std::string& file, const Picture& picture) {
    const auto path = draft_path(file);
    return path ? named(io::write_png(*path, picture), target_ / file) : path.error();
}

// What can go wrong is tried first: only then is the first file moved.
io::Failure Workplace::publish() const {
    std::error_code error;
    for (const std::string& file : files_) {
        const fs::path path = target_ / file;
        fs::create_directories(path.parent_path(), error);
        if (!error && fs::is_directory(path)) error = std::make_error_code(std::errc::is_a_directory);
        if (error) return unwritable(path, error);
    }
    for (const std::string& file : files_) {
        fs::rename(draft_ / file, target_ / file, error);
        if (error) return unwritable(target_ / file, error);
    }
    fs::remove_all(draft_, error);
    return {};
}

void Workplace::abandon() const {
    std::error_code ignored;
    fs::remove_all(draft_, ignored);
    if (!made_.empty()) fs::remove_all(made_, ignored);
}

io::Failure fill_folder(const std::string& directory, const std::function<io::Failure(Workplace&)>& fill) {
    Workplace place;
    if (io::Failure failure = place.open(directory)) return failure;
    io::Failure failure = fill(place);
    if (!failure) failure = place.publish();
    if (failure) place.abandon();
    return failure;
}

}  // namespace relevo::show
