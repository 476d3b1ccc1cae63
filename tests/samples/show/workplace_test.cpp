// Folders that appear all at once or not at all.
#include "samples/show/workplace.hpp"

#include <gtest/gtest.h>

#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::show {
namespace {

using io::bytes_of;

TEST(FillFolder, FilesOfFoldersBelowAppearToo) {
    const io::TemporaryFolder folder;
    const auto failure = fill_folder(folder.path("out"), [](Workplace& place) {
        EXPECT_FALSE(place.write("a.txt", "1"));
        EXPECT_FALSE(place.write("deep/er/b.txt", "2"));
        return place.write("deep/c.png", Picture(1, 1, ink));
    });
    ASSERT_FALSE(failure) << failure->text();
    EXPECT_EQ(bytes_of(folder.path("out/deep/er/b.txt")), "2");
    EXPECT_EQ(bytes_of(folder.path("out/deep/c.png")).substr(1, 3), "PNG");
    std::size_t entries = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path("out")))
        entries += entry.exists() ? 1u : 0u;
    EXPECT_EQ(entries, 5u) << "nothing else is left";
}

TEST(FillFolder, AFailureLeavesWhatWasThere) {
    const io::TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("kept"));
    folder.write("kept/a.txt", "old");
    for (const std::string& target : {folder.path("kept"), folder.path("new/deep")}) {
        const auto failure = fill_folder(target, [](Workplace& place) {
            EXPECT_FALSE(place.write("a.txt", "fresh"));
            EXPECT_FALSE(place.write("below/b.txt", "fresh"));
            return io::Failure(io::error_in("x", "is wrong"));
        });
        ASSERT_TRUE(failure);
        EXPECT_EQ(failure->text(), "x: is wrong");
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"kept"});
    EXPECT_EQ(bytes_of(folder.path("kept/a.txt")), "old");
    const std::filesystem::directory_iterator entries(folder.path("kept"));
    EXPECT_EQ(std::distance(begin(entries), end(entries)), 1) << "no draft is left, either";
}

// A folder stands where a file should go, or a file where a folder should: found before the first file moves.
TEST(FillFolder, WhatIsInTheWayIsNamedAndNothingIsWritten) {
    const io::TemporaryFolder folder;
    std::filesystem::create_directories(folder.path("out/b.txt"));
    folder.write("out/c", "a file");
    for (const auto& [file, why] : {std::pair("b.txt", "Is a directory"), {"c/d.txt", "Not a directory"}}) {
        const auto failure = fill_folder(folder.path("out"), [file = file](Workplace& place) {
            EXPECT_FALSE(place.write("a.txt", "1"));
            return place.write(file, "2");
        });
        ASSERT_TRUE(failure);
        EXPECT_EQ(folder.without_path(failure->text()),
                  std::string("out/") + file + ": cannot write this file: " + why);
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path("out/a.txt")));
    EXPECT_EQ(bytes_of(folder.path("out/c")), "a file");
}

}  // namespace
}  // namespace relevo::show
