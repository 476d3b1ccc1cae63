#include "samples/show/index_page.hpp"

#include <fmt/format.h>

#include "samples/show/html.hpp"
#include "samples/show/numbers.hpp"

namespace relevo::show {
namespace {

constexpr std::string_view style = R"(
nav ol { list-style: none; margin: 1.5rem 0 0; padding: 0; display: grid; gap: .8rem; grid-template-columns: repeat(auto-fill, minmax(8.5rem, 1fr)); }
nav a { display: block; text-decoration: none; }
nav img { display: block; width: 100%; aspect-ratio: 4 / 3; object-fit: cover; object-position: top left; border: 1px solid var(--line); border-radius: .35rem; background: #fff; }
section { margin-top: 3rem; padding-top: 1.2rem; border-top: 1px solid var(--line); scroll-margin-top: .5rem; }
figure { margin: 0; }
figure img { display: block; max-width: 100%; height: auto; margin: 0 auto; border: 1px solid var(--line); border-radius: .35rem; background: #fff; }
dl { display: flex; flex-wrap: wrap; gap: .4rem; margin: .9rem 0 0; }
dl div { background: var(--tint); border-radius: .35rem; padding: .15rem .7rem; }
dt { display: inline; color: var(--soft); }
dt::after { content: ": "; }
dd { display: inline; margin: 0; font-variant-numeric: tabular-nums; }
.turn { display: flex; justify-content: space-between; margin-top: .8rem; max-width: none; }
@media print {
  :root { --ink: #000; --soft: #444; --paper: #fff; --tint: #fff; --line: #bbb; --link: #000; }
  body { max-width: none; padding: 0; font-size: 11pt; }
  nav, .turn { display: none; }
  section { break-inside: avoid; break-before: page; border: 0; margin: 0; }
  section:first-of-type { break-before: auto; }
  figure img { max-height: 75vh; width: auto; }
}
)";

std::string shown(const Count& count) {
    if (const auto* whole = std::get_if<std::int64_t>(&count.value)) return grouped(*whole);
    return number(std::get<double>(count.value));
}

std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string thumbnail(const StageRecord& r) {
    return fmt::format(
        "<li><a href=\"#{0}\"><img src=\"{1}\" alt=\"\" loading=\"lazy\">{2:02} {0}</a></li>\n", r.name,
        r.file, r.number);
}

std::string turn(std::span<const StageRecord> records, std::size_t i) {
    const auto link = [&](std::size_t k, std::string_view before, std::string_view after) {
        return fmt::format("<a href=\"#{0}\">{1}{0}{2}</a>", records[k].name, before, after);
    };
    return "<p class=\"turn\">" + (i > 0 ? link(i - 1, "← ", "") : std::string("<span></span>")) +
           (i + 1 < records.size() ? link(i + 1, "", " →")
                                   : std::string("<a href=\"#top\">to the top ↑</a>")) +
           "</p>\n";
}

std::string section(std::span<const StageRecord> records, std::size_t i) {
    const StageRecord& r = records[i];
    std::string counts;
    for (const Count& count : r.counts)
        counts +=
            fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(spaced(count.name)), shown(count));
    return fmt::format(
        "<section "
        "id=\"{0}\">\n<h2><span>{1:02}</span>{0}</h2>\n<figure>\n<figcaption><p>{2}</p></figcaption>\n"
        "<a href=\"{3}\"><img src=\"{3}\" width=\"{4}\" height=\"{5}\" loading=\"lazy\" alt=\"Step picture "
        "of stage {0}: {2}\"></a>\n</figure>\n<dl>\n{6}</dl>\n{7}</section>\n",
        r.name, r.number, escaped(r.caption), r.file, r.width, r.height, counts, turn(records, i));
}

}  // namespace

std::string index_page(const scene::LoadedScene& loaded, std::span<const StageRecord> records) {
    std::int64_t triangles = 0;
    const auto count = [&](const std::vector<raster::Model>& models) {
        for (const raster::Model& m : models) triangles += static_cast<std::int64_t>(m.mesh->triangles());
    };
    count(loaded.scene.models);
    for (const scene::ReliefObject& object : loaded.reliefs) count(object.models->models);
    std::string things;
    if (!loaded.scene.models.empty())
        things = counted(std::int64_t(loaded.scene.models.size()), "model") + ", ";
    if (!loaded.reliefs.empty())
        things += counted(std::int64_t(loaded.reliefs.size()), "object") + " by pictures, ";
    if (triangles > 0) things += counted(triangles, "triangle") + ", ";
    const std::string title = escaped(loaded.name) + ": the pipeline step by step";
    std::string page =
        html_head(title, style) +
        fmt::format(
            "<header>\n<h1>{0}</h1>\n<p class=\"soft\">{1}{2} × {3} pixels. "
            "The same numbers for programs: <a href=\"steps.json\">steps.json</a>; how long it took: <a "
            "href=\"timing.json\">timing.json</a>.</p>\n</header>\n<nav aria-label=\"Stages\"><ol>\n",
            title, things, loaded.width, loaded.height);
    for (const StageRecord& r : records) page += thumbnail(r);
    page += "</ol></nav>\n<main>\n";
    for (std::size_t i = 0; i < records.size(); ++i) page += section(records, i);
    return page + "</main>\n</body>\n</html>\n";
}

}  // namespace relevo::show
