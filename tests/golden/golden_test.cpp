// Every golden is what it was, notices its known mistakes, and none is missing.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "tests/golden/mistakes.hpp"
#include "tests/golden/store.hpp"

namespace relevo::golden {
void PrintTo(const Case& which, std::ostream* out) { *out << which.name; }

namespace {

const std::string folder = RELEVO_GOLDEN_FOLDER, failed = RELEVO_GOLDEN_FAILED;

// ------------------------------------------------------------------------------------------- the comparison
Product small_product() {
    Product p{"one\ntwo 0x1p+0\n", raster::Image<raster::Rgba8>(4, 3, {1, 2, 3}),
              raster::Image<float>(4, 3, 0.5f)};
    return p;
}

TEST(Comparison, FindsOneBitAnywhere) {
    const Product expected = small_product();
    EXPECT_FALSE(first_difference(expected, small_product()));
    Product text = small_product(), picture = small_product(), numbers = small_product();
    text.text[5] = 'T';
    picture.picture.at(2, 1).b = 4;
    numbers.numbers.at(3, 2) = std::nextafter(0.5f, 1.0f);
    EXPECT_NE(first_difference(expected, text)->find("line 2\n  expected: two"), std::string::npos);
    EXPECT_NE(
        first_difference(expected, picture)->find("the first at pixel (2, 1)\n  expected:   1   2   3 255"),
        std::string::npos);
    EXPECT_NE(first_difference(expected, numbers)->find("1 of 12 values differ, the first at pixel (3, 2)"),
              std::string::npos);
    for (const Product& changed : {text, picture, numbers}) EXPECT_NE(hash(changed), hash(expected));
}

TEST(Comparison, TellsZerosNotANumbersAndSizesApart) {
    Product expected = small_product(), actual = small_product();
    expected.numbers.at(0, 0) = 0.0f, actual.numbers.at(0, 0) = -0.0f;
    EXPECT_TRUE(first_difference(expected, actual));
    actual.numbers.at(0, 0) = NAN;
    EXPECT_TRUE(first_difference(expected, actual));
    expected.numbers.at(0, 0) = NAN;
    EXPECT_FALSE(first_difference(expected, actual));
    actual = small_product();
    actual.picture = raster::Image<raster::Rgba8>(3, 4, {1, 2, 3});
    EXPECT_NE(first_difference(small_product(), actual)->find("4 x 3 expected, 3 x 4 drawn"),
              std::string::npos);
    actual = small_product();
    actual.text += "three\n";
    EXPECT_NE(first_difference(small_product(), actual)->find("(the end)"), std::string::npos);
}

TEST(Comparison, OfAnotherPrecisionForgivesRoundingOnly) {
    Product rounded = small_product();
    rounded.text[10] = 'a';  // 0xap+0 where 0x1p+0 was
    EXPECT_TRUE(large_difference(small_product(), rounded));
    rounded = small_product();
    for (auto& c : rounded.picture.pixels()) ++c.r;
    for (float& v : rounded.numbers.pixels()) v += 1e-6f;
    EXPECT_FALSE(large_difference(small_product(), rounded));
    for (int i = 0; i < 9; ++i) rounded.picture.pixels()[std::size_t(i)].g += 9;
    EXPECT_TRUE(large_difference(small_product(), rounded));
    rounded = small_product();
    for (float& v : rounded.numbers.pixels()) v += 0.01f;
    EXPECT_TRUE(large_difference(small_product(), rounded));
}

TEST(Comparison, CoverageColorsAreDistinct) {
    std::set<std::uint32_t> seen;
    for (std::uint32_t last = 0; last < 300; ++last)
        for (std::uint32_t count = 0; count < 10; ++count) {
            const auto c = coverage_color(last, count);
            EXPECT_TRUE(seen.insert(c.r + 256u * c.g + 65536u * c.b).second) << last << " " << count;
        }
}

// ------------------------------------------------------------------------------------------------ the files
TEST(Goldens, EveryFileHasACaseAndEveryCaseItsFile) {
    std::set<std::string> files, cases;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".toml")
            files.insert(std::filesystem::relative(entry.path(), folder).replace_extension().string());
    for (const Case& c : all_cases()) cases.insert(std::string(c.name));
    EXPECT_FALSE(cases.empty());
    EXPECT_EQ(files, cases);
}

TEST(Goldens, EveryMistakeIsNoticedByOne) {
    std::set<std::string_view> unnoticed;
    for (const Mistake& m : all_mistakes()) EXPECT_TRUE(unnoticed.insert(m.name).second) << m.name;
    for (const Case& c : all_cases())
        if (const auto golden = read_golden(folder, std::string(c.name)))
            for (const std::string& name : golden->mistakes) unnoticed.erase(name);
    for (const std::string_view name : unnoticed) ADD_FAILURE() << "no golden notices '" << name << "'";
}

// ------------------------------------------------------------------------------------------------ each case
class Goldens : public testing::TestWithParam<Case> {
  protected:
    std::string name() const { return std::string(GetParam().name); }
};

// Expected, actual and their difference, for people.
std::string leave_pictures(const std::string& name, const Product& expected, const Product& actual) {
    const std::string path = failed + "/" + name;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    io::Failure failure = write_product(path + "-actual", actual);
    if (!failure) failure = write_product(path + "-expected", expected);
    if (!failure && !actual.picture.empty() && expected.picture.width() == actual.picture.width() &&
        expected.picture.height() == actual.picture.height())
        failure = write_product(path + "-difference", {"", difference_picture(expected, actual), {}});
    return failure ? failure->text() : path + "-*";
}

std::string advice(const std::string& name) {
    return "\nright as it is now? scripts/accept " + name + " --reason 'WHY IT CHANGED'";
}

#ifdef RELEVO_DOUBLE  // the goldens are of float: here they must agree but for rounding
const auto difference = large_difference;
#else
const auto difference = first_difference;
#endif

TEST_P(Goldens, IsWhatItWas) {
    const Product actual = product_of(GetParam().stage, GetParam().make());
    const auto golden = read_golden(folder, name());
    ASSERT_TRUE(golden) << golden.error().text();
    const auto expected = read_product(folder, name(), actual);
    if (!expected)
        FAIL() << expected.error().text() << "\nthe new one: " << leave_pictures(name(), actual, actual)
               << advice(name());
    EXPECT_EQ(hash(*expected), golden->hash) << name() << ": its data are not those that were accepted";
    EXPECT_NE(golden->reason, "");
    if (const auto found = difference(*expected, actual))
        FAIL() << name() << ": " << *found << "\nsee " << leave_pictures(name(), *expected, actual)
               << advice(name());
}

TEST_P(Goldens, NoticesItsKnownMistakes) {
    const auto golden = read_golden(folder, name());
    ASSERT_TRUE(golden) << golden.error().text();
    EXPECT_GE(golden->mistakes.size(), 3u) << "a golden without known mistakes may test nothing";
    const Product right = product_of(GetParam().stage, GetParam().make());
    for (const std::string& name : golden->mistakes) {
        const Mistake* mistake = find_mistake(name);
        if (!mistake) ADD_FAILURE() << "no mistake is called '" << name << "' (tests/golden/mistakes.cpp)";
        if (mistake && !first_difference(right, mistaken(GetParam(), *mistake)))
            ADD_FAILURE() << "'" << name << "' (" << mistake->sentence << ") changes nothing here";
    }
}

TEST_P(Goldens, ThePlainMachineAgrees) {
    const Subject subject = GetParam().make();
    if (!has_plain_form(GetParam().stage, subject)) return;  // shaded: there the mistakes are in the scene
    const auto found = first_difference(product_of(GetParam().stage, subject),
                                        plain_product_of(GetParam().stage, subject, {}));
    EXPECT_FALSE(found) << *found;
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    std::string name(info.param.name);
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(Each, Goldens, testing::ValuesIn(all_cases().begin(), all_cases().end()), name_of);

}  // namespace
}  // namespace relevo::golden
