// Every row of the accuracy table is true and honest: the error measured stays within the one allowed, and
// the one allowed is at most four times the one measured.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "samples/scene/accuracy.hpp"
#include "tests/accuracy/measurement.hpp"

namespace relevo::scene {
void PrintTo(const AccuracyRow& row, std::ostream* out) { *out << row.name; }
}  // namespace relevo::scene

namespace relevo::accuracy {
namespace {

using scene::AccuracyRow;

std::map<std::string_view, Measured (*)()> all_measurements() {
    std::map<std::string_view, Measured (*)()> all;
    for (const auto list :
         {elementary_measurements(), geometry_measurements(), surface_measurements(), knob_measurements(),
          line_measurements(), curve_measurements(), plane_measurements(), relief_measurements()})
        for (const Measurement& m : list) EXPECT_TRUE(all.emplace(m.row, m.measure).second) << m.row;
    return all;
}

// What is wrong with the row, or nothing.
std::string verdict(const AccuracyRow& row, const Measured& measured) {
    if (!(measured.error <= row.allowed_error)) return "the error is larger than the table allows";
#ifndef RELEVO_DOUBLE  // the table is about float; in double the machine is better than it says
    if (row.allowed_error > 4 * measured.error) return "the table allows more than four times the error";
#endif
    return "";
}

TEST(Accuracy, EveryRowHasAMeasurementAndEveryMeasurementARow) {
    auto measurements = all_measurements();
    ASSERT_FALSE(scene::accuracy_table().empty());
    for (const AccuracyRow& row : scene::accuracy_table())
        EXPECT_EQ(measurements.erase(row.name), 1u)
            << "nothing measures '" << row.name << "', or twice in the table";
    for (const auto& [name, measure] : measurements) ADD_FAILURE() << "no row is called '" << name << "'";
}

TEST(Accuracy, RowsSayWhatTheyMean) {
    for (const AccuracyRow& row : scene::accuracy_table())
        EXPECT_FALSE(row.reference.empty() || row.domain.empty() || row.unit.empty()) << row.name;
}

TEST(Accuracy, AWrongOrAnIdleRowIsFound) {
    const AccuracyRow row{"x", "y", "z", 2.0, "ulp", 1};
    EXPECT_EQ(verdict(row, {1.0, ""}), "");
    EXPECT_NE(verdict(row, {2.1, ""}), "");
    EXPECT_NE(verdict(row, {NAN, ""}), "");
#ifndef RELEVO_DOUBLE
    EXPECT_NE(verdict(row, {0.4, ""}), "");
#endif
}

class AccuracyRows : public testing::TestWithParam<AccuracyRow> {};

std::string name_of(const testing::TestParamInfo<AccuracyRow>& row) {
    std::string name;
    for (const char c : row.param.name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

TEST_P(AccuracyRows, MeasuredErrorIsWithinTheAllowedOneAndNotFarBelow) {
    const AccuracyRow& row = GetParam();
    const auto measurements = all_measurements();
    const auto found = measurements.find(row.name);
    ASSERT_NE(found, measurements.end());
    const Measured measured = found->second();
    std::printf("%-32s measured %-12.6g allowed %-12.6g %s\n    worst: %s\n", std::string(row.name).c_str(),
                measured.error, row.allowed_error, std::string(row.unit).c_str(), measured.worst.c_str());
    EXPECT_EQ(verdict(row, measured), "") << measured.error << " " << row.unit << " at " << measured.worst;
}

INSTANTIATE_TEST_SUITE_P(Table, AccuracyRows, testing::ValuesIn(scene::accuracy_table()), name_of);

}  // namespace
}  // namespace relevo::accuracy
