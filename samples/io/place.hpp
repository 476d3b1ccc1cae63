// Where in a file something is wrong, and the one line that says so.
#pragma once
#include <optional>
#include <string>

#include "pipeline/result.hpp"

namespace relevo::io {

// Lines and columns (in bytes) count from 1; 0 means "the file as a whole".
struct Place {
    std::string file;
    int line = 0, column = 0;
};

struct FileError {
    Place place;
    std::string message;  // one line: what is wrong, what is accepted

    // "file:line:column: message"; what is 0 is left out.
    std::string text() const {
        std::string out = place.file;
        if (place.line > 0) out.append(":").append(std::to_string(place.line));
        if (place.line > 0 && place.column > 0) out.append(":").append(std::to_string(place.column));
        out.append(": ").append(message);
        // One line, whatever strange names are in it.
        for (char& c : out)
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
        return out;
    }
};

// About a file as a whole.
inline FileError error_in(const std::string& file, const std::string& message) {
    FileError error;
    error.place.file = file;
    error.message = message;
    return error;
}

template <class T>
using FileResult = pipeline::Result<T, FileError>;

// Of actions that return nothing: empty when all went well.
using Failure = std::optional<FileError>;

}  // namespace relevo::io
