// Writes the whole image experiment: a table in Markdown to standard output, every figure as a line of CSV.
//   image_table FILE.csv        (tests/relief/table builds and runs it)
// Exit status 1 when a figure misses what is asked of it.
#include <cstdio>

#include "tests/bench/report.hpp"
#include "tests/relief/image_rows.hpp"

int main(int count, char** words) {
    using namespace relevo;
    if (count != 2) return std::fprintf(stderr, "image_table FILE.csv\n"), 2;
    bench::Report report("relief", words[1]);
    const auto number = [](const char* format, double value) {
        char text[40];
        std::snprintf(text, sizeof text, format, value);
        return std::string(text);
    };
    for (const auto scene : tests::image_scenes) {
        report.say("\n### " + std::string(scene));
        report.heading({"view", "way", "PSNR dB", "asked", "missing %", "extra %", "depth", "bad %", "met"});
        for (const double azimuth : tests::image_azimuths) {
            const auto rows = tests::image_rows(scene, azimuth);
            if (rows.empty()) report.say("no mesh (it is in the package glmark2-data)"), report.fail();
            for (const auto& row : rows) {
                const std::string where = std::string(scene) + number(" %.0f", azimuth), way(row.way);
                const bool good = tests::met(row);
                const std::string word =
                    report.judge(where, way, "PSNR", row.error.psnr, "dB", row.asked.psnr, good);
                report.figure(where, way, "missing", row.error.missing_percent, "%");
                report.figure(where, way, "extra", row.error.extra_percent, "%");
                report.figure(where, way, "depth error", row.error.mean_depth_error, "world units");
                report.figure(where, way, "bad", row.error.bad_percent, "%");
                report.row({number("%.0f", azimuth), way, number("%.2f", row.error.psnr),
                            number("%.2f", row.asked.psnr) + (row.psnr_by_design ? "" : " (first)"),
                            number("%.2f", row.error.missing_percent),
                            number("%.2f", row.error.extra_percent),
                            number("%.4f", row.error.mean_depth_error), number("%.2f", row.error.bad_percent),
                            word});
            }
        }
    }
    return report.written() && report.good() ? 0 : 1;
}
