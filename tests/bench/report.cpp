#include "tests/bench/report.hpp"

#include <cmath>
#include <cstdio>

namespace relevo::bench {

std::string digits(double value) {
    char text[32];
    const double size = std::abs(value);
    std::snprintf(text, sizeof text, "%.*f", size < 9.995 ? 2 : size < 99.95 ? 1 : 0, value);
    return text;
}

Report::Report(std::string part, const std::string& csv) : part_(std::move(part)), csv_(csv) {
    csv_ << "part,scene,mode,what,value,unit,required,met\n";
}

void Report::say(const std::string& text) const { std::printf("%s\n", text.c_str()), std::fflush(stdout); }

void Report::heading(const std::vector<std::string>& cells) const {
    std::printf("\n");
    row(cells);
    row(std::vector<std::string>(cells.size(), "---"));
}

void Report::row(const std::vector<std::string>& cells) const {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    say(text);
}

void Report::figure(const std::string& scene, const std::string& mode, const std::string& what, double value,
                    const std::string& unit) {
    csv_ << part_ << ',' << scene << ',' << mode << ',' << what << ',' << value << ',' << unit << ",,\n";
}

std::string Report::judge(const std::string& scene, const std::string& mode, const std::string& what,
                          double value, const std::string& unit, double required, bool met) {
    good_ = good_ && met;
    csv_ << part_ << ',' << scene << ',' << mode << ',' << what << ',' << value << ',' << unit << ','
         << required << ',' << (met ? "yes" : "no") << '\n';
    return met ? "yes" : "**no**";
}

bool Report::written() { return csv_.flush() && csv_; }

}  // namespace relevo::bench
