// What the pages of `relevo steps` share: no network, no outside files, light and dark.
#pragma once
#include <string>
#include <string_view>

namespace relevo::show {

// Words as they stand in text and in attributes.
std::string escaped(std::string_view words);

// From <!doctype html> to the open <body id="top">. The title is escaped already; `style` comes after the
// common one.
std::string html_head(const std::string& title, std::string_view style);

}  // namespace relevo::show
