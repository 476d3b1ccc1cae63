// The one place that knows toml++ (which compiles slowly).
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#include "samples/scene/document.hpp"

#include <fmt/format.h>

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

}  // namespace

io::FileResult<Value> parse_document(std::string_view text, const std::string& path) {
    const toml::parse_result result = toml::parse(text, path);
    if (!result)
        return io::FileError{place_of(result.error().source(), path),
                             "this is not TOML: " + std::string(result.error().description())};
    return Value{{path, 1, 1}, convert_table(result.table(), path)};
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
