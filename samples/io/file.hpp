// Whole files in and out. What is written appears complete or not at all.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "samples/io/place.hpp"

namespace relevo::io {

// Text files (scenes, meshes) above this size are refused before memory is taken.
inline constexpr std::size_t max_text_file = std::size_t(512) << 20;

// All bytes of a file. Errors: missing, a directory, unreadable, larger than `size_limit` bytes.
FileResult<std::string> read_file(const std::string& path, std::size_t size_limit);

// read_file for text: an empty file and one with zero bytes inside (a binary file) are errors too, and a
// byte order mark of UTF-8 is dropped.
FileResult<std::string> read_text(const std::string& path, std::size_t size_limit = max_text_file);

// Writes to a temporary file in the same folder and renames it, so that `path` holds the old bytes or all of
// the new ones. A failure (full disk, file-size limit, folder that is missing or not writable) leaves nothing
// behind. A device or a pipe is written directly.
Failure write_file(const std::string& path, std::string_view bytes);

// write_file for files that belong together: each is whole under its temporary name before the first one is
// renamed, so that a full disk leaves the old ones or nothing.
struct FileToWrite {
    std::string path, bytes;
};
Failure write_files(std::span<const FileToWrite> files);

}  // namespace relevo::io
