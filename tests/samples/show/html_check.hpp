// Is a page well-formed? Every tag closed in order, attributes quoted, names (id) unique, and every link
// leads to a name of the page. Enough of HTML for the pages that we write: all tags are closed, but those
// that never have an end.
#pragma once
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace relevo::show {

struct HtmlCheck {
    std::string mistake;             // the first; empty: well-formed
    std::vector<std::string> files;  // that src and href name
};

inline HtmlCheck checked_html(std::string_view page) {
    static const std::set<std::string> endless{"meta", "img", "input", "br", "link", "!doctype"};
    HtmlCheck out;
    std::vector<std::string> open, targets;
    std::set<std::string> ids;
    const auto fail = [&](const std::string& what, std::size_t at) {
        if (out.mistake.empty()) out.mistake = what + " near: " + std::string(page.substr(at, 80));
    };
    const auto take_attribute = [&](const std::string& name, const std::string& value, std::size_t at) {
        if (value.find('<') != std::string::npos) fail("'<' in an attribute", at);
        if (name == "id" && !ids.insert(value).second) fail("a second id " + value, at);
        if (name != "src" && name != "href") return;
        if (value.starts_with("#"))
            targets.push_back(value.substr(1));
        else
            out.files.push_back(value);
    };
    for (std::size_t at = 0; (at = page.find('<', at)) != std::string_view::npos && out.mistake.empty();) {
        const std::size_t start = at++;
        const bool closing = at < page.size() && page[at] == '/';
        if (closing) ++at;
        const std::size_t name_end = page.find_first_of(" >\n", at);
        if (name_end == std::string_view::npos) return fail("a tag without end", start), out;
        const std::string tag(page.substr(at, name_end - at));
        at = name_end;
        while (at < page.size() && page[at] != '>') {
            if (page[at] == ' ' || page[at] == '\n') {
                ++at;
                continue;
            }
            const std::size_t end = page.find_first_of(" =>", at);
            const std::string name(page.substr(at, end - at));
            at = end;
            if (page[at] != '=') continue;  // as in <details open>
            if (page[at + 1] != '"') return fail("an attribute without quotes", start), out;
            const std::size_t quote = page.find('"', at + 2);
            if (quote == std::string_view::npos) return fail("a quote without end", start), out;
            take_attribute(name, std::string(page.substr(at + 2, quote - at - 2)), start);
            at = quote + 1;
        }
        if (at++ >= page.size()) return fail("a tag without end", start), out;
        if (closing) {
            if (open.empty() || open.back() != tag) return fail("</" + tag + "> closes nothing", start), out;
            open.pop_back();
        } else if (!endless.contains(tag)) {
            open.push_back(tag);
        }
        if (!closing && (tag == "script" || tag == "style"))  // no tags within
            at = std::min(page.find("</" + tag + ">", at), page.size());
    }
    if (!open.empty()) fail("<" + open.back() + "> is not closed", page.size());
    for (const std::string& target : targets)
        if (!ids.contains(target)) fail("a link to #" + target + ", which is not there", page.size());
    // '&' only as the start of an entity
    for (std::size_t at = 0; (at = page.find('&', at)) != std::string_view::npos; ++at) {
        const std::size_t in_script = page.rfind("<script>", at), script_end = page.rfind("</script>", at);
        if (in_script != std::string_view::npos &&
            (script_end == std::string_view::npos || script_end < in_script))
            continue;
        const std::string_view rest = page.substr(at);
        if (!rest.starts_with("&amp;") && !rest.starts_with("&lt;") && !rest.starts_with("&gt;") &&
            !rest.starts_with("&quot;"))
            fail("a bare '&'", at);
    }
    return out;
}

}  // namespace relevo::show
