#include "samples/io/file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/samples/io/size_limit.hpp"
#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::io {
namespace {

using Names = std::vector<std::string>;

template <class Result>
std::string message(const TemporaryFolder& folder, const Result& result) {
    return result ? "no error" : folder.without_path(result.error().text());
}
std::string message(const TemporaryFolder& folder, const Failure& failure) {
    return failure ? folder.without_path(failure->text()) : "no error";
}

TEST(ReadFile, ReturnsEveryByte) {
    const TemporaryFolder folder;
    const std::string bytes("a\0b\r\n\xff", 6);
    const auto read = read_file(folder.write("x", bytes), 6);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, bytes);
}

TEST(ReadFile, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    EXPECT_EQ(message(folder, read_file(folder.path("x"), 10)), "x: there is no such file");
    EXPECT_EQ(message(folder, read_file(folder.path("."), 10)), ".: is a directory, a file is needed");
    folder.write("file", "abc");
    EXPECT_EQ(message(folder, read_file(folder.path("file/x"), 10)),
              "file/x: cannot be opened: Not a directory");
    EXPECT_EQ(message(folder, read_file(folder.path("file"), 2)),
              "file: is 3 bytes large, at most 2 bytes are accepted");
}

TEST(ReadFile, AnEndlessFileIsRefused) {
    EXPECT_EQ(read_file("/dev/zero", 100).error().text(),
              "/dev/zero: is more than 100 bytes large, at most 100 bytes are accepted");
}

TEST(ReadText, OneGigabyteIsRefusedBeforeMemoryIsTaken) {
    const TemporaryFolder folder;
    std::filesystem::resize_file(folder.write("x.obj", ""), 1u << 30);
    EXPECT_EQ(message(folder, read_text(folder.path("x.obj"))),
              "x.obj: is 1073741824 bytes large, at most 536870912 bytes are accepted");
}

TEST(ReadText, RefusesEmptyAndBinaryFiles) {
    const TemporaryFolder folder;
    EXPECT_EQ(message(folder, read_text(folder.write("x", ""))), "x: the file is empty");
    const std::string_view binary("ab\ncd\0e", 7);
    EXPECT_EQ(message(folder, read_text(folder.write("x", binary))),
              "x:2:3: a zero byte: this is a binary file, a text file is needed");
    EXPECT_EQ(message(folder, read_text(folder.write("x", binary.substr(5)))),
              "x:1:1: a zero byte: this is a binary file, a text file is needed");
}

TEST(ReadText, DropsTheByteOrderMark) {
    const TemporaryFolder folder;
    EXPECT_EQ(*read_text(folder.write("x", "\xef\xbb\xbfv")), "v");
}

TEST(WriteFile, WritesAndReplaces) {
    const TemporaryFolder folder;
    const std::string bytes("a\0b", 3);
    EXPECT_EQ(message(folder, write_file(folder.path("x"), bytes)), "no error");
    EXPECT_EQ(bytes_of(folder.path("x")), bytes);
    EXPECT_EQ(message(folder, write_file(folder.path("x"), "new")), "no error");
    EXPECT_EQ(bytes_of(folder.path("x")), "new");
    EXPECT_EQ(folder.names(), Names{"x"});
}

TEST(WriteFile, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    EXPECT_EQ(message(folder, write_file(folder.path("no/x"), "a")),
              "no/x: cannot be written: No such file or directory");
    folder.write("file", "abc");
    EXPECT_EQ(message(folder, write_file(folder.path("file/x"), "a")),
              "file/x: cannot be written: Not a directory");
    std::filesystem::create_directory(folder.path("folder"));
    EXPECT_EQ(message(folder, write_file(folder.path("folder"), "a")),
              "folder: cannot be written: Is a directory");
    EXPECT_EQ(write_file("/proc/x.png", "a")->text(),
              "/proc/x.png: cannot be written: No such file or directory");
    EXPECT_EQ(folder.names(), (Names{"file", "folder"}));
}

TEST(WriteFile, AFullDiskLeavesNothingBehind) {
    const TemporaryFolder folder;
    folder.write("old", "old bytes");
    {
        const SizeLimit limit(1000);
        EXPECT_EQ(message(folder, write_file(folder.path("x"), std::string(5000, 'a'))),
                  "x: cannot be written: File too large");
        EXPECT_EQ(message(folder, write_file(folder.path("old"), std::string(5000, 'a'))),
                  "old: cannot be written: File too large");
        EXPECT_EQ(message(folder, write_file(folder.path("small"), std::string(1000, 'a'))), "no error");
    }
    EXPECT_EQ(bytes_of(folder.path("old")), "old bytes");
    EXPECT_EQ(folder.names(), (Names{"old", "small"}));
}

TEST(WriteFiles, AllAreWrittenOrNone) {
    const TemporaryFolder folder;
    folder.write("old", "old bytes");
    const FileToWrite small{folder.path("small"), "abc"}, replaced{folder.path("old"), "new bytes"},
        large{folder.path("large"), std::string(5000, 'a')};
    {
        const SizeLimit limit(1000);
        const FileToWrite files[] = {small, replaced, large};
        EXPECT_EQ(message(folder, write_files(files)), "large: cannot be written: File too large");
    }
    EXPECT_EQ(folder.names(), Names{"old"});
    EXPECT_EQ(bytes_of(folder.path("old")), "old bytes");
    const FileToWrite files[] = {small, replaced, large};
    EXPECT_EQ(message(folder, write_files(files)), "no error");
    EXPECT_EQ(folder.names(), (Names{"large", "old", "small"}));
    EXPECT_EQ(bytes_of(folder.path("old")), "new bytes");
}

TEST(WriteFile, ADeviceIsWrittenAndStaysADevice) {
    EXPECT_EQ(write_file("/dev/full", "a")->text(), "/dev/full: cannot be written: No space left on device");
    EXPECT_FALSE(write_file("/dev/null", "a"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(WriteFile, ALinkStaysALink) {
    const TemporaryFolder folder;
    folder.write("file", "old");
    std::filesystem::create_symlink("file", folder.path("link"));
    EXPECT_EQ(message(folder, write_file(folder.path("link"), "new")), "no error");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
    EXPECT_EQ(bytes_of(folder.path("file")), "new");
}

TEST(WriteFile, KeepsTheRightsOfTheFileItReplaces) {
    const TemporaryFolder folder;
    ::chmod(folder.write("file", "old").c_str(), 0640);
    ASSERT_FALSE(write_file(folder.path("file"), "new"));
    EXPECT_EQ(std::filesystem::status(folder.path("file")).permissions(), std::filesystem::perms(0640));
}

}  // namespace
}  // namespace relevo::io
