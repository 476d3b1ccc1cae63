#include "samples/io/json_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "samples/io/file.hpp"
#include "samples/io/suggest.hpp"
#include "samples/io/words.hpp"

namespace relevo::io {
namespace {

using Json = nlohmann::json;

constexpr std::size_t most_bytes = std::size_t(1) << 20;
constexpr int most_nested = 16;

Place place_of(const std::string& file, std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t last_break = before.rfind('\n');
    const std::size_t line_start = last_break == std::string_view::npos ? 0 : last_break + 1;
    return {file, static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
            static_cast<int>(before.size() - line_start) + 1};
}

// Hears the parser, keeps nothing but where it stopped.
struct Check : nlohmann::json_sax<Json> {
    int nested = 0;
    std::size_t stopped_at = 0;
    std::string why;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool key(string_t&) override { return true; }
    bool start_object(std::size_t) override { return enter(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_object() override { return --nested, true; }
    bool end_array() override { return --nested, true; }
    bool parse_error(std::size_t position, const std::string&, const Json::exception& error) override {
        stopped_at = position > 0 ? position - 1 : 0;
        why = error.what();  // "[kind] parse error at line 1, column 2: reason" or "[kind] reason"
        const std::size_t column = why.find(", column ");
        const std::size_t end =
            why.find(column == std::string::npos ? "] " : ": ", column == std::string::npos ? 0 : column);
        if (end != std::string::npos) why.erase(0, end + 2);
        return false;
    }

  private:
    bool enter() {
        if (++nested <= most_nested) return true;
        why = fmt::format("nested more than {} deep", most_nested);
        return false;
    }
};

// Walks over a text that is JSON.
class Walk {
  public:
    explicit Walk(std::string_view text) : text_(text) {}

    // Where the value at the end of the path begins; as far as the path can be followed.
    std::size_t offset_of(const JsonPath& path) {
        space();
        for (const std::string& step : path) {
            const std::optional<std::size_t> next = child(step);
            if (!next) break;
            at_ = *next;
        }
        return at_;
    }

  private:
    char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void space() {
        while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos)
            ++at_;
    }
    std::string_view string() {  // between its quotes, as it is written
        const std::size_t begin = ++at_;
        while (here() != '"' && at_ < text_.size()) at_ += here() == '\\' ? 2 : 1;
        return text_.substr(begin, at_++ - begin);
    }
    void value() {
        if (here() == '"') {
            string();
        } else if (here() == '{' || here() == '[') {
            const bool object = here() == '{';
            for_each_child(object, [](std::string_view, std::size_t) {});
        } else {
            while (at_ < text_.size() && std::string_view(",]} \t\r\n").find(text_[at_]) == text_.npos) ++at_;
        }
    }
    template <class Visit>
    void for_each_child(bool object, Visit&& visit) {
        ++at_, space();
        for (std::size_t i = 0; at_ < text_.size() && here() != '}' && here() != ']'; ++i) {
            const std::string number = std::to_string(i);
            std::string_view name = number;
            if (object) name = string(), space(), ++at_, space();
            visit(name, at_);
            value(), space();
            if (here() == ',') ++at_, space();
        }
        ++at_;
    }
    std::optional<std::size_t> child(const std::string& step) {
        if (here() != '{' && here() != '[') return {};
        std::optional<std::size_t> found;  // of equal names the parser takes the last
        Walk inside = *this;
        inside.for_each_child(here() == '{', [&](std::string_view name, std::size_t offset) {
            if (name == step) found = offset;
        });
        return found;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

// "camera.a.2"; "the file" for the whole.
std::string spelled(const JsonPath& path) {
    return path.empty() ? "the file" : fmt::format("{}", fmt::join(path, "."));
}

const Json* follow(const Json& root, const JsonPath& path) {
    const Json* json = &root;
    for (const std::string& step : path) {
        if (json->is_object() && json->contains(step)) {
            json = &(*json)[step];
        } else {
            return nullptr;
        }
    }
    return json;
}

std::string joined(std::initializer_list<std::string_view> words) {
    std::string out;
    for (const std::string_view word : words) out += (out.empty() ? "" : ", ") + in_quotes(word);
    return out;
}

}  // namespace

JsonFields::JsonFields(const std::string& path) : file_(path), root_(new Json) {
    auto text = read_text(path, most_bytes);
    if (!text) {
        failure_ = text.error();
        return;
    }
    text_ = *std::move(text);
    Check check;
    if (Json::sax_parse(text_, &check)) {
        *root_ = Json::parse(text_, nullptr, false);
    } else {
        failure_ = FileError{place_of(file_, text_, check.stopped_at), "this is no JSON: " + check.why};
        if (check.nested > most_nested) failure_ = FileError{{file_}, check.why};
    }
}
JsonFields::~JsonFields() { delete root_; }

void JsonFields::refuse(const JsonPath& path, const std::string& message) {
    if (failure_) return;
    failure_ = FileError{place_of(file_, text_, Walk(text_).offset_of(path)), spelled(path) + ": " + message};
}

bool JsonFields::has(const JsonPath& path) const { return !failure_ && follow(*root_, path); }

const Json* JsonFields::find(const JsonPath& path, std::string_view needed) {
    if (failure_) return nullptr;
    const Json* const found = follow(*root_, path);
    if (!found) refuse(path, fmt::format("is missing, {} is needed", needed));
    return found;
}

double JsonFields::number(const JsonPath& path) {
    constexpr std::string_view needed = "a number";
    const Json* const json = find(path, needed);
    if (json && json->is_number()) return json->get<double>();  // JSON has no infinities
    if (json) refuse(path, fmt::format("{} is needed", needed));
    return 0;
}

int JsonFields::integer(const JsonPath& path) {
    constexpr std::string_view needed = "a whole number";
    const Json* const json = find(path, needed);
    constexpr auto most = std::numeric_limits<int>::max();
    if (json && json->is_number_integer() && std::abs(json->get<double>()) <= most)
        return static_cast<int>(json->get<double>());
    if (json) refuse(path, fmt::format("{} is needed", needed));
    return 0;
}

glm::dvec3 JsonFields::vector(const JsonPath& path) {
    constexpr std::string_view needed = "an array of 3 numbers";
    const Json* const json = find(path, needed);
    glm::dvec3 v(0);
    if (!json) return v;
    if (!json->is_array() || json->size() != 3) return refuse(path, fmt::format("{} is needed", needed)), v;
    for (std::size_t k = 0; k < 3; ++k) {
        if ((*json)[k].is_number()) {
            v[int(k)] = (*json)[k].get<double>();
            continue;
        }
        JsonPath element = path;
        element.push_back(std::to_string(k));
        refuse(element, "a number is needed");
    }
    return v;
}

std::string JsonFields::text(const JsonPath& path) {
    constexpr std::string_view needed = "a text in quotes";
    const Json* const json = find(path, needed);
    if (json && json->is_string() && !json->get_ref<const std::string&>().empty())
        return json->get<std::string>();
    if (json) refuse(path, fmt::format("{} is needed", needed));
    return "";
}

std::size_t JsonFields::choice(const JsonPath& path, std::initializer_list<std::string_view> accepted) {
    const std::string word = text(path);
    const auto found = std::find(accepted.begin(), accepted.end(), word);
    if (!failure_ && found == accepted.end())
        refuse(path, fmt::format("{} is not known, accepted are {}", in_quotes(word), joined(accepted)));
    return failure_ ? 0 : static_cast<std::size_t>(found - accepted.begin());
}

void JsonFields::no_others(const JsonPath& path, std::initializer_list<std::string_view> accepted) {
    const Json* const json = find(path, "an object of fields");
    if (!json) return;
    if (!json->is_object()) return refuse(path, "an object of fields is needed: { ... }");
    for (const auto& item : json->items()) {
        if (std::find(accepted.begin(), accepted.end(), item.key()) != accepted.end()) continue;
        JsonPath field = path;
        field.push_back(item.key());
        return refuse(field, fmt::format("there is no such field{}",
                                         suggestion(item.key(), {accepted.begin(), accepted.size()})));
    }
}

}  // namespace relevo::io
