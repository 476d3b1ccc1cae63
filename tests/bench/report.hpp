// Where the figures go: tables in Markdown to standard output, every single figure as a line of CSV.
#pragma once
#include <fstream>
#include <string>
#include <vector>

namespace relevo::bench {

class Report {
  public:
    // `csv` is written anew, with its heading.
    Report(std::string part, const std::string& csv);

    // A table of Markdown; a row has as many cells as the heading.
    void say(const std::string& text) const;
    void heading(const std::vector<std::string>& cells) const;
    void row(const std::vector<std::string>& cells) const;

    // One figure; or one that had to be something: its word for the table, and a miss is remembered.
    void figure(const std::string& scene, const std::string& mode, const std::string& what, double value,
                const std::string& unit);
    std::string judge(const std::string& scene, const std::string& mode, const std::string& what,
                      double value, const std::string& unit, double required, bool met);
    // Something that no figure can make good.
    void fail() { good_ = false; }
    bool good() const { return good_; }
    bool written();

  private:
    std::string part_;
    std::ofstream csv_;
    bool good_ = true;
};

// 0.53, 5.31, 53.1, 531
std::string digits(double value);

}  // namespace relevo::bench
