#include "samples/io/place.hpp"

#include <gtest/gtest.h>

namespace relevo::io {
namespace {

TEST(Place, AnErrorNamesFileLineAndColumn) {
    EXPECT_EQ((FileError{{"a.obj", 3, 7}, "broken"}.text()), "a.obj:3:7: broken");
}

TEST(Place, WhatIsUnknownIsLeftOut) {
    EXPECT_EQ((FileError{{"a.obj", 3}, "broken"}.text()), "a.obj:3: broken");
    EXPECT_EQ((FileError{{"a.obj"}, "broken"}.text()), "a.obj: broken");
}

TEST(Place, AnErrorIsOneLine) {
    EXPECT_EQ((FileError{{"a\nb", 1, 2}, "broken\r\n\x7f"}.text()),
              "a?b:1:2: broken"
              "?"
              "?"
              "?");
}

}  // namespace
}  // namespace relevo::io
