#include "samples/scene/fields.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "samples/io/suggest.hpp"

namespace relevo::scene {
namespace {

const Table empty_table;

// Whole numbers are numbers too.
std::optional<double> plain_number(const Value& value) {
    if (const auto* number = std::get_if<double>(&value.data)) return *number;
    if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole);
    return std::nullopt;
}

}  // namespace

std::string joined(std::span<const std::string_view> words) {
    return fmt::format("{}", fmt::join(words.begin(), words.end(), ", "));
}

Fields::Fields(const Value& table, std::string name, std::span<const std::string_view> known,
               Diagnosis& diagnosis)
    : place_(table.place),
      name_(std::move(name)),
      table_(std::get_if<Table>(&table.data)),
      diagnosis_(&diagnosis) {
    if (!table_) {
        diagnosis.say(table.place, fmt::format("{} is {}, accepted: a table", name_, describe(table)));
        table_ = &empty_table;
    }
    for (const Entry& entry : *table_)
        if (std::find(known.begin(), known.end(), entry.key) == known.end())
            diagnosis.say(entry.place, fmt::format("unknown key {}.{}, accepted: {}{}", name_, entry.key,
                                                   joined(known), io::suggestion(entry.key, known)));
}

const Value* Fields::find(std::string_view key) const {
    for (const Entry& entry : *table_)
        if (entry.key == key) return &entry.value;
    return nullptr;
}

io::Place Fields::place(std::string_view key) const {
    const Value* value = find(key);
    return value ? value->place : place_;
}

void Fields::refuse(const Value& value, std::string_view key, std::string_view accepted) const {
    diagnosis_->say(value.place, fmt::format("{} is {}, accepted: {}", full(key), describe(value), accepted));
}

void Fields::refuse(std::string_view key, std::string_view accepted) const {
    if (const Value* value = find(key)) return refuse(*value, key, accepted);
    diagnosis_->say(place_, fmt::format("{} is missing, accepted: {}", full(key), accepted));
}

std::optional<double> Fields::as_number(const Value& value, std::string_view key, const Range& range) const {
    const std::optional<double> number = plain_number(value);
    if (number && range.holds(*number)) return number;
    refuse(value, key, number ? std::string(range.accepted) : fmt::format("a number, {}", range.accepted));
    return std::nullopt;
}

double Fields::number(std::string_view key, double fallback, const Range& range) const {
    const Value* value = find(key);
    return value ? as_number(*value, key, range).value_or(fallback) : fallback;
}

int Fields::whole(std::string_view key, int fallback, int low, int high) const {
    const Value* value = find(key);
    if (!value) return fallback;
    const auto* whole = std::get_if<std::int64_t>(&value->data);
    if (whole && low <= *whole && *whole <= high) return static_cast<int>(*whole);
    refuse(*value, key, fmt::format("a whole number from {} to {}", low, high));
    return fallback;
}

std::string Fields::text(std::string_view key, const std::string& fallback) const {
    const Value* value = find(key);
    if (!value) return fallback;
    if (const auto* text = std::get_if<std::string>(&value->data)) return *text;
    refuse(*value, key, "a text in quotes");
    return fallback;
}

bool Fields::flag(std::string_view key, bool fallback) const {
    const Value* value = find(key);
    if (!value) return fallback;
    if (const auto* flag = std::get_if<bool>(&value->data)) return *flag;
    refuse(*value, key, "true or false");
    return fallback;
}

std::vector<double> Fields::numbers(const Value& value, std::string_view key,
                                    std::span<const Range> ranges) const {
    constexpr std::string_view counts[] = {"no", "one", "two", "three", "four"};
    std::vector<double> out(ranges.size());
    const auto* list = std::get_if<std::vector<Value>>(&value.data);
    if (!list || list->size() != ranges.size()) {
        const std::string found = list ? fmt::format("a list of {}", list->size()) : describe(value);
        diagnosis_->say(value.place,
                        fmt::format("{} is {}, accepted: {} numbers in brackets, each {}", full(key), found,
                                    counts[ranges.size()], ranges[0].accepted));
        return out;
    }
    for (std::size_t i = 0; i < ranges.size(); ++i)
        out[i] = as_number((*list)[i], fmt::format("{}[{}]", key, i), ranges[i]).value_or(0);
    return out;
}

glm::dvec3 Fields::triple(std::string_view key, glm::dvec3 fallback, const Range& range) const {
    const Value* value = find(key);
    if (!value) return fallback;
    const Range ranges[] = {range, range, range};
    const std::vector<double> n = numbers(*value, key, ranges);
    return {n[0], n[1], n[2]};
}

pipeline::LinearRgb Fields::color(std::string_view key, pipeline::LinearRgb fallback,
                                  const Range& range) const {
    const glm::dvec3 c = triple(key, {fallback.r, fallback.g, fallback.b}, range);
    using pipeline::Scalar;
    return {static_cast<Scalar>(c.x), static_cast<Scalar>(c.y), static_cast<Scalar>(c.z)};
}

std::optional<std::size_t> Fields::word(std::string_view key, std::span<const std::string_view> names) const {
    const Value* value = find(key);
    if (!value) return std::nullopt;
    const auto* text = std::get_if<std::string>(&value->data);
    if (!text) return refuse(*value, key, joined(names)), std::nullopt;
    const auto found = std::find(names.begin(), names.end(), *text);
    if (found == names.end())
        return refuse(*value, key, joined(names) + io::suggestion(*text, names)), std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

}  // namespace relevo::scene
