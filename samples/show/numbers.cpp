#include "samples/show/numbers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace relevo::show {

std::string number(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value < 0 ? "-∞" : "∞";
    if (value == 0) return "0";
    std::string digits = fmt::format("{:.4g}", value);
    const auto exponent = digits.find('e');
    if (exponent == std::string::npos) return digits;
    return digits.substr(0, exponent + 1) + std::to_string(std::stoi(digits.substr(exponent + 1)));
}

std::string decimals(double value, int most) {
    std::string text = fmt::format("{:.{}f}", value, most);
    if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string grouped(std::int64_t count) {
    std::string digits = std::to_string(count);
    const int first = count < 0 ? 1 : 0;
    for (int at = static_cast<int>(digits.size()) - 3; at > first; at -= 3)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

std::string counted(std::int64_t count, const std::string& noun) {
    return grouped(count) + " " + noun + (count == 1 ? "" : "s");
}

double nice_step(double least) {
    if (!(least > 1e-30) || !(least < 1e30)) return 1;
    double decade = 1;
    while (decade > least) decade /= 10;
    while (decade * 10 <= least) decade *= 10;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= least) return factor * decade;
    return 10 * decade;
}

}  // namespace relevo::show
