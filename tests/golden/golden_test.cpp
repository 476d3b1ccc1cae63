// Every golden is what it was, notices its known mistakes, and none is missing.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "tests/golden/exhibit.hpp"
#include "tests/golden/relief/pictures.hpp"
#include "tests/golden/store.hpp"

namespace relevo::golden {
void PrintTo(const Exhibit& which, std::ostream* out) { *out << which.name; }

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

// Within what is allowed nothing is said, just beyond it everything is.
TEST(Comparison, WithATolerance) {
    const Product expected = small_product();
    const auto found = [&](const Allowed& allowed, auto change) {
        Product actual = small_product();
        change(actual);
        return difference_beyond(allowed, expected, actual).has_value();
    };
    const auto number = [](Product& p) { p.numbers.at(3, 2) = 0.5f + 1.4e-4f; };
    EXPECT_TRUE(found({}, number));
    EXPECT_TRUE(found({9e-5, 0, 0}, number));
    EXPECT_FALSE(found({1e-4, 0, 0}, number));
    EXPECT_TRUE(found({0, 0, 0.08}, number));  // of 12: none
    EXPECT_FALSE(found({0, 0, 0.09}, number));
    const auto not_a_number = [](Product& p) { p.numbers.at(1, 1) = NAN; };
    EXPECT_TRUE(found({1e9, 0, 0}, not_a_number));
    const auto levels = [](Product& p) { p.picture.at(2, 1).b += 2; };
    EXPECT_TRUE(found({}, levels));
    EXPECT_TRUE(found({0, 1, 0}, levels));
    EXPECT_FALSE(found({0, 2, 0}, levels));
    const auto hole = [](Product& p) { p.picture.at(0, 0).a = 0; };
    EXPECT_TRUE(found({0, 2, 0}, hole));
    const auto word = [](Product& p) { p.text[5] = 'T'; };
    EXPECT_TRUE(found({1, 255, 1}, word));
    const auto text_number = [](Product& p) { p.text = "one\ntwo 0x1.002p+0\n"; };  // 1 + 2^-11
    EXPECT_TRUE(found({2e-4, 0, 0}, text_number));
    EXPECT_FALSE(found({3e-4, 0, 0}, text_number));
    const auto size = [](Product& p) { p.picture = raster::Image<raster::Rgba8>(3, 4, {1, 2, 3}); };
    EXPECT_TRUE(found({1, 255, 1}, size));
}

TEST(Comparison, OfViewsByTheErrorSet) {
    Product expected{"", raster::Image<raster::Rgba8>(20, 10, {100, 100, 100}),
                     raster::Image<float>(10, 10, 2)};
    Allowed allowed;
    allowed.by_error_set = true;
    allowed.missing = 1, allowed.extra = 0, allowed.psnr = 40, allowed.depth = 1e-3, allowed.bad = 1;
    const auto found = [&](auto change) {
        Product actual = expected;
        change(actual);
        return difference_beyond(allowed, expected, actual).has_value();
    };
    EXPECT_FALSE(found([](Product&) {}));
    EXPECT_FALSE(found([](Product& p) { p.numbers.at(3, 3) = 2.09f; }));  // in the mean over 100
    EXPECT_TRUE(found([](Product& p) { p.numbers.at(3, 3) = 2.11f; }));
    for (const int tile : {0, 1}) {
        EXPECT_FALSE(found([&](Product& p) { p.picture.at(10 * tile, 4).g = 80; }));
        EXPECT_TRUE(found([&](Product& p) { p.picture.at(10 * tile, 4).g = 0; }));  // below 40 dB
        EXPECT_TRUE(found([&](Product& p) { p.picture.at(10 * tile, 4).a = 0; }));
    }
    expected.picture.at(3, 3) = {0, 0, 0, 0};
    EXPECT_TRUE(found([](Product& p) { p.picture.at(3, 3).a = 255; }));  // extra, though it is black
}

// ------------------------------------------------------------------------------------------------ the files
TEST(Goldens, EveryFileHasACaseAndEveryCaseItsFile) {
    std::set<std::string> files, cases;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".toml")
            files.insert(std::filesystem::relative(entry.path(), folder).replace_extension().string());
    for (const Exhibit& e : all_exhibits()) cases.insert(e.name);
    EXPECT_FALSE(cases.empty());
    EXPECT_EQ(files, cases);
}

TEST(Goldens, EveryMistakeIsNoticedByOne) {
    std::set<std::string_view> unnoticed;
    for (const MistakeName& m : all_mistake_names()) EXPECT_TRUE(unnoticed.insert(m.name).second) << m.name;
    for (const Exhibit& e : all_exhibits())
        if (const auto golden = read_golden(folder, e.name))
            for (const std::string& name : golden->mistakes) unnoticed.erase(name);
    for (const std::string_view name : unnoticed) ADD_FAILURE() << "no golden notices '" << name << "'";
}

// ------------------------------------------------------------------------------------------------ each case
class Goldens : public testing::TestWithParam<Exhibit> {
  protected:
    const std::string& name() const { return GetParam().name; }
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

TEST_P(Goldens, IsWhatItWas) {
    const Product actual = GetParam().product();
    const auto golden = read_golden(folder, name());
    ASSERT_TRUE(golden) << golden.error().text();
    const auto expected = read_product(folder, name(), actual);
    if (!expected)
        FAIL() << expected.error().text() << "\nthe new one: " << leave_pictures(name(), actual, actual)
               << advice(name());
    EXPECT_EQ(hash(*expected), golden->hash) << name() << ": its data are not those that were accepted";
    EXPECT_NE(golden->reason, "");
    if (const auto found = GetParam().difference(*expected, actual))
        FAIL() << name() << ": " << *found << "\nsee " << leave_pictures(name(), *expected, actual)
               << advice(name());
}

TEST_P(Goldens, NoticesItsKnownMistakes) {
    const auto golden = read_golden(folder, name());
    ASSERT_TRUE(golden) << golden.error().text();
    EXPECT_GE(golden->mistakes.size(), 3u) << "a golden without known mistakes may test nothing";
    const Product right = GetParam().product();
    for (const std::string& name : golden->mistakes) {
        const auto wrong = GetParam().mistaken(name);
        if (!wrong) ADD_FAILURE() << "no mistake is called '" << name << "' (mistakes.cpp)";
        if (wrong && !GetParam().noticed(right, *wrong))
            ADD_FAILURE() << "'" << name << "' changes nothing here that would be noticed";
    }
}

TEST_P(Goldens, ThePlainFormAgrees) {
    const auto plain = GetParam().plain();
    if (!plain) return;
    const auto found = GetParam().noticed(GetParam().product(), *plain);
    EXPECT_FALSE(found) << *found;
}

std::string name_of(const testing::TestParamInfo<Exhibit>& info) {
    std::string name = info.param.name;
    for (char& c : name)
        if (c == '/' || c == '-') c = '_';
    return name;
}
INSTANTIATE_TEST_SUITE_P(Each, Goldens, testing::ValuesIn(all_exhibits()), name_of);

}  // namespace
}  // namespace relevo::golden
