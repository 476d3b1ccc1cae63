#include "samples/io/words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace relevo::io {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }

constexpr std::string_view without_plus(std::string_view text) {
    return text.size() > 1 && text[0] == '+' && (is_digit(text[1]) || text[1] == '.') ? text.substr(1) : text;
}

// For a decimal number that float32 cannot hold: is it too small (else it is too large)? The sign of its
// decimal exponent d tells, 0.f * 10^d with f's first digit not 0, since it is far from 1.
bool is_tiny(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const std::string_view digits = text.substr(0, e);
    const std::size_t first = digits.find_first_of("123456789"),
                      point = std::min(digits.find('.'), digits.size());
    const double position = static_cast<double>(point) - static_cast<double>(first) + (first > point ? 1 : 0);
    if (e == std::string_view::npos) return position < 0;
    const std::string_view exponent = without_plus(text.substr(e + 1));
    std::int64_t value = 0;
    const auto [end, status] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), value);
    if (status == std::errc::result_out_of_range) return exponent[0] == '-';
    return position + static_cast<double>(value) < 0;
}

// Bytes of the printable UTF-8 character at the start of a text; 0 when there is none.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return 0x20 <= byte(0) && byte(0) < 0x7f ? 1 : 0;
    const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    return length;
}

}  // namespace

bool Words::skip_continuation() {
    if (text_[at_] != '\\') return false;
    std::size_t end = at_ + 1;
    if (end < text_.size() && text_[end] == '\r') ++end;
    if (end == text_.size() || text_[end] != '\n') return false;
    at_ = line_start_ = end + 1;
    ++line_;
    return true;
}

Word Words::word(std::size_t begin, std::size_t end) const {
    return {text_.substr(begin, end - begin), line_, static_cast<int>(begin - line_start_) + 1};
}

Word Words::in_line() {
    while (at_ < text_.size() && (is_blank(text_[at_]) || skip_continuation()))
        if (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    if (at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '#') return word(at_, at_);
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n') {
        if (text_[at_] == '\\' && at_ + 1 < text_.size() &&
            (text_[at_ + 1] == '\n' || text_[at_ + 1] == '\r'))
            break;
        ++at_;
    }
    return word(begin, at_);
}

Word Words::rest_of_line() {
    const Word first = in_line();
    Word last = first;
    for (Word next = first; !next.text.empty(); next = in_line()) last = next;
    const char* end = last.text.data() + last.text.size();
    return {{first.text.data(), static_cast<std::size_t>(end - first.text.data())}, first.line, first.column};
}

bool Words::next_line() {
    while (!in_line().text.empty()) {
    }
    at_ = std::min(text_.find('\n', at_), text_.size());  // past a comment
    if (at_ == text_.size()) return false;
    line_start_ = ++at_;
    ++line_;
    return true;
}

Word Words::anywhere() {
    Word next = in_line();
    while (next.text.empty() && next_line()) next = in_line();
    return next;
}

std::optional<float> parse_float(std::string_view text) {
    text = without_plus(text);
    float value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, value);
    if (stop != end || status == std::errc::invalid_argument) return std::nullopt;
    if (status == std::errc::result_out_of_range) return is_tiny(text) ? std::optional(0.f) : std::nullopt;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
    text = without_plus(text);
    std::int64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, value);
    return stop == end && status == std::errc() ? std::optional(value) : std::nullopt;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string out = "'";
    std::size_t at = 0;
    while (at < std::min(text.size(), longest)) {
        const std::size_t length = character_length(text.substr(at));
        out += length == 0 ? "?" : text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
    return out + (at < text.size() ? "...'" : "'");
}

FileError error_at(const std::string& file, const Word& word, std::string message, std::size_t offset) {
    return {{file, word.line, word.column + static_cast<int>(offset)}, std::move(message)};
}

}  // namespace relevo::io
