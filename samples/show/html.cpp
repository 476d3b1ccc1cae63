#include "samples/show/html.hpp"

#include <fmt/format.h>

namespace relevo::show {
namespace {

constexpr std::string_view common_style = R"(
:root { color-scheme: light dark; --ink: #181e25; --soft: #56616d; --paper: #ffffff; --tint: #f3f5f8; --line: #dde2e8; --link: #0062a0; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8ecf1; --soft: #a3afbc; --paper: #14191f; --tint: #1e252d; --line: #343e49; --link: #6cb8ea; }
}
* { box-sizing: border-box; }
html { scroll-behavior: smooth; }
body { margin: 0 auto; max-width: 82rem; padding: 1.5rem clamp(.8rem, 3vw, 2.5rem) 4rem; background: var(--paper); color: var(--ink);
  font: 1.0625rem/1.55 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: clamp(1.6rem, 4vw, 2.3rem); line-height: 1.2; margin: .5rem 0; overflow-wrap: anywhere; }
h2 { font-size: 1.5rem; margin: 0 0 .2rem; }
h2 span { color: var(--soft); font-weight: 400; margin-right: .35em; font-variant-numeric: tabular-nums; }
p { margin: .3rem 0 .8rem; max-width: 65rem; }
a { color: var(--link); }
.soft { color: var(--soft); }
)";

}  // namespace

std::string escaped(std::string_view words) {
    std::string out;
    for (const char c : words) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

std::string html_head(const std::string& title, std::string_view style) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n<title>{}</title>\n<style>{}{}</style>\n</head>\n<body id=\"top\">\n",
        title, common_style, style);
}

}  // namespace relevo::show
