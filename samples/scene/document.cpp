// The one place that knows toml++ (which compiles slowly).
//
// Its version 3.3 asserts, in place of an error, that some malformed texts ("[= a]") do not exist; with
// assertions off that would be undefined. So a failed assertion is an exception here, and the place is found
// by the shortest beginning of the text that fails: parsing runs from left to right, so every longer one
// fails too.
#include "samples/scene/document.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace {
struct MalformedSomewhere {};
[[noreturn]] void malformed_somewhere() { throw MalformedSomewhere{}; }
}  // namespace
#undef NDEBUG
#define TOML_ASSERT(expression) ((expression) ? static_cast<void>(0) : malformed_somewhere())
#define TOML_EXCEPTIONS 1
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

namespace relevo::scene {
namespace {

io::Place place_of(const toml::source_region& source, const std::string& path) {
    return {path, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

Value convert(const toml::node& node, const std::string& path);

Table convert_table(const toml::table& table, const std::string& path) {
    Table out;
    for (const auto& [key, node] : table)
        out.push_back({std::string(key.str()), place_of(key.source(), path), convert(node, path)});
    return out;
}

std::vector<Value> convert_array(const toml::array& array, const std::string& path) {
    std::vector<Value> out;
    for (const toml::node& node : array) out.push_back(convert(node, path));
    return out;
}

Value convert(const toml::node& node, const std::string& path) {
    const io::Place place = place_of(node.source(), path);
    if (const auto* table = node.as_table()) return {place, convert_table(*table, path)};
    if (const auto* array = node.as_array()) return {place, convert_array(*array, path)};
    if (const auto* text = node.as_string()) return {place, text->get()};
    if (const auto* whole = node.as_integer()) return {place, whole->get()};
    if (const auto* number = node.as_floating_point()) return {place, number->get()};
    if (const auto* flag = node.as_boolean()) return {place, flag->get()};
    return {place, Value::Other{}};
}

bool is_malformed(std::string_view text) {
    try {
        (void)toml::parse(text);
    } catch (const MalformedSomewhere&) {
        return true;
    } catch (const toml::parse_error&) {
    }
    return false;
}

io::Place malformed_place(std::string_view text, const std::string& path) {
    std::size_t fine = 0, malformed = text.size();
    while (malformed - fine > 1) {
        const std::size_t middle = fine + (malformed - fine) / 2;
        (is_malformed(text.substr(0, middle)) ? malformed : fine) = middle;
    }
    const std::string_view before = text.substr(0, fine);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    return {path, static_cast<int>(lines) + 1, static_cast<int>(fine - line_start) + 1};
}

}  // namespace

io::FileResult<Value> parse_document(std::string_view text, const std::string& path) {
    try {
        // Not inside of Value{...}: g++ 12 destroys a place twice when what follows it in the braces throws.
        Table table = convert_table(toml::parse(text, path), path);
        return Value{{path, 1, 1}, std::move(table)};
    } catch (const MalformedSomewhere&) {
        return io::FileError{malformed_place(text, path), "this is not TOML: unexpected here"};
    } catch (const toml::parse_error& error) {
        return io::FileError{place_of(error.source(), path),
                             fmt::format("this is not TOML: {}", error.description())};
    }
}

std::string describe(double number) { return fmt::format("{}", number); }

std::string describe(const Value& value) {
    if (const auto* number = std::get_if<double>(&value.data)) return describe(*number);
    if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return fmt::format("{}", *whole);
    if (const auto* flag = std::get_if<bool>(&value.data)) return *flag ? "true" : "false";
    if (const auto* text = std::get_if<std::string>(&value.data)) return '"' + *text + '"';
    if (std::get_if<std::vector<Value>>(&value.data)) return "a list";
    if (std::get_if<Table>(&value.data)) return "a table";
    return "a date or time";
}

}  // namespace relevo::scene
