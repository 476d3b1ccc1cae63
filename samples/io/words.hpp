// The words of a text file, each with its place, and the numbers they spell.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "samples/io/place.hpp"

namespace relevo::io {

struct Word {
    std::string_view text;  // into the file's text; empty where there is none
    int line = 1, column = 1;
};

// Walks over a text: words are separated by blanks, a word that starts with `#` ends the line, and a
// backslash before the end of a line continues it on the next one. Lines may end in CR LF.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) {}

    // The next word of this line; an empty one, with the place of the line's end, when there is none left.
    Word in_line();
    // The rest of the line without blanks around it: a name that may contain blanks.
    Word rest_of_line();
    // Skips the rest of the line; false at the end of the text.
    bool next_line();
    // The next word on this line or a later one; an empty one at the end of the text.
    Word anywhere();
    // Bytes that have not been read.
    std::size_t remaining() const { return text_.size() - at_; }

  private:
    bool skip_continuation();
    Word word(std::size_t begin, std::size_t end) const;

    std::string_view text_;
    std::size_t at_ = 0, line_start_ = 0;
    int line_ = 1;
};

// The float32 nearest to a decimal number such as -1.5e3 (a leading + is allowed); numbers too small for
// float32 are 0. Nothing for every other text: nan, inf, 1e39, 0x10, 12abc. No locale has a say in it.
std::optional<float> parse_float(std::string_view text);

// A decimal integer that fits int64.
std::optional<std::int64_t> parse_integer(std::string_view text);

// The text in quotes, fit for one line of a message: what is no printable UTF-8 becomes '?', long texts are
// cut.
std::string in_quotes(std::string_view text);

// "file:line:column: message" about a word; `offset` bytes into it.
FileError error_at(const std::string& file, const Word& word, std::string message, std::size_t offset = 0);

}  // namespace relevo::io
