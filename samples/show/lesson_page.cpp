#include "samples/show/lesson_page.hpp"

#include <fmt/format.h>

#include "samples/show/html.hpp"
#include "samples/show/lesson_files.hpp"
#include "samples/show/numbers.hpp"

namespace relevo::show {
namespace {

// With scripts (class "js" on <html>) one frame is seen at a time, without them a strip and a list to unfold.
constexpr std::string_view style = R"(
nav ol { list-style: none; margin: 1.5rem 0 0; padding: 0; display: grid; gap: .9rem; grid-template-columns: repeat(auto-fill, minmax(min(11rem, 44%), 1fr)); }
nav a { display: block; text-decoration: none; overflow-wrap: anywhere; line-height: 1.3; }
nav img { display: block; width: 100%; height: auto; margin-bottom: .3rem; border: 1px solid var(--line); border-radius: .35rem; background: #fff; }
section { margin-top: 3rem; padding-top: 1.2rem; border-top: 1px solid var(--line); scroll-margin-top: .5rem; }
figure { margin: 0; }
.result { margin-top: 1.2rem; }
.result img { display: block; max-width: min(100%, 30rem); height: auto; border: 1px solid var(--line); image-rendering: pixelated; }
.strip img, .frames img { display: block; max-width: 100%; height: auto; border: 1px solid var(--line); border-radius: .35rem; background: #fff; }
.frames { list-style: none; margin: 0; padding: 0; }
.frames li { margin: 0 0 2rem; scroll-margin-top: 4rem; }
.frames h3 { font-size: 1.1rem; margin: .6rem 0 .3rem; }
.frames h3 span { color: var(--soft); font-weight: 400; margin-right: .4em; font-variant-numeric: tabular-nums; }
.equation { font: 1.05rem/1.5 ui-monospace, "DejaVu Sans Mono", Consolas, monospace; background: var(--tint); border-left: .3rem solid #0072b2; padding: .4rem .7rem; white-space: pre-wrap; overflow-wrap: anywhere; }
.caption { white-space: pre-line; }
summary { cursor: pointer; margin: .8rem 0; color: var(--link); }
.player, .keys { display: none; }
.js .keys { display: inline; }
.js .player { display: flex; flex-wrap: wrap; align-items: center; gap: .4rem; margin: .8rem 0; position: sticky; top: 0; z-index: 1; padding: .35rem 0; background: var(--paper); }
.player button { font: inherit; min-width: 2.75rem; min-height: 2.5rem; padding: .2rem .7rem; color: var(--ink); background: var(--tint); border: 1px solid var(--line); border-radius: .35rem; cursor: pointer; }
.player button:hover { border-color: var(--link); }
.player button:focus-visible, .player input:focus-visible { outline: 3px solid var(--link); outline-offset: 1px; }
.player input { flex: 1 1 10rem; min-width: 6rem; min-height: 2.5rem; accent-color: var(--link); }
.player output { font-variant-numeric: tabular-nums; min-width: 5.5em; text-align: right; }
.js summary, .js .strip, .js .frames li { display: none; }
.js .frames li.now { display: block; margin: 0; }
@media (min-width: 76rem) {
  .js .frames figure { display: grid; grid-template-columns: minmax(0, 60rem) minmax(15rem, 1fr); gap: 1.4rem; align-items: start; }
  .js .frames h3 { margin-top: 0; }
}
.table { overflow: auto; max-height: 22rem; margin: 1rem 0; max-width: 100%; border: 1px solid var(--line); border-radius: .35rem; width: fit-content; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .8rem; text-align: left; white-space: nowrap; }
thead th { position: sticky; top: 0; background: var(--tint); box-shadow: 0 1px 0 var(--line); }
tbody th { font-weight: 400; color: var(--soft); }
tbody tr + tr > * { border-top: 1px solid var(--line); }
tbody a { color: inherit; }
tr.now > * { background: #f0e442; color: #181e25; }
tr.now > :first-child { box-shadow: inset .3rem 0 0 #181e25; font-weight: 700; }
.turn { display: flex; justify-content: space-between; gap: 1rem; margin-top: .8rem; max-width: none; }
@media print {
  :root { --ink: #000; --soft: #444; --paper: #fff; --tint: #fff; --line: #bbb; --link: #000; }
  body { max-width: none; padding: 0; font-size: 11pt; }
  nav, .turn, .files, details, .js .player, .keys { display: none; }
.js .keys { display: inline; }
  .js .strip { display: block; }
  .strip img { max-height: 74vh; width: auto; }
  section { break-before: page; border: 0; margin: 0; }
  .table { max-height: none; overflow: visible; }
}
)";

// Each lesson shows one frame. Buttons, slider and arrow keys go to another; its row in the table is marked.
constexpr std::string_view script = R"(
(function () {
  'use strict';
  var latest = null;
  function setUp(section) {
    var frames = Array.prototype.slice.call(section.querySelectorAll('.frames > li'));
    var slider = section.querySelector('input'), output = section.querySelector('output');
    var buttons = section.querySelectorAll('.player button'), table = section.querySelector('.table');
    var list = section.querySelector('.frames'), current = -1, timer = 0;
    function soon(i) {
      var picture = frames[i] && frames[i].querySelector('img');
      if (picture) picture.loading = 'eager';
    }
    function show(i) {
      i = Math.max(0, Math.min(frames.length - 1, i));
      if (i === current) return;
      if (current >= 0) frames[current].classList.remove('now');
      frames[i].classList.add('now');
      current = i;
      soon(i), soon(i + 1), soon(i - 1);
      slider.value = i + 1;
      slider.setAttribute('aria-valuetext', 'frame ' + (i + 1) + ' of ' + frames.length);
      output.textContent = (i + 1) + ' of ' + frames.length;
      section.querySelectorAll('tbody tr').forEach(function (row) {
        var here = row.getAttribute('data-frame') === String(i + 1);
        row.classList.toggle('now', here);
        if (!here) return row.removeAttribute('aria-current');
        row.setAttribute('aria-current', 'true');
        var above = row.offsetTop - row.offsetHeight * 2, below = row.offsetTop + row.offsetHeight * 2;
        if (above < table.scrollTop) table.scrollTop = above;
        if (below > table.scrollTop + table.clientHeight) table.scrollTop = below - table.clientHeight;
      });
    }
    function stop() {
      clearInterval(timer);
      timer = 0;
      list.setAttribute('aria-live', 'polite');
      buttons[2].textContent = 'Play';
    }
    function play() {
      if (current === frames.length - 1) show(0);
      list.setAttribute('aria-live', 'off');
      buttons[2].textContent = 'Pause';
      timer = setInterval(function () {
        show(current + 1);
        if (current === frames.length - 1) stop();
      }, 1000);
    }
    var lesson = {
      section: section,
      go: function (i) { stop(), show(i), latest = lesson; },
      step: function (by) { lesson.go(current + by); },
      frames: frames
    };
    slider.addEventListener('input', function () { lesson.go(slider.value - 1); });
    buttons[0].addEventListener('click', function () { lesson.go(0); });
    buttons[1].addEventListener('click', function () { lesson.step(-1); });
    buttons[2].addEventListener('click', function () { latest = lesson; if (timer) stop(); else play(); });
    buttons[3].addEventListener('click', function () { lesson.step(1); });
    buttons[4].addEventListener('click', function () { lesson.go(frames.length - 1); });
    section.querySelector('details').open = true;
    stop();
    show(0);
    return lesson;
  }
  var lessons = Array.prototype.map.call(document.querySelectorAll('section.lesson'), setUp);
  function visible(lesson) {
    var box = lesson.section.getBoundingClientRect();
    return box.bottom > 0.2 * innerHeight && box.top < 0.8 * innerHeight;
  }
  document.addEventListener('keydown', function (event) {
    var by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (!by || event.altKey || event.ctrlKey || event.metaKey || event.shiftKey) return;
    if (event.target.tagName === 'INPUT') return;
    var lesson = latest && visible(latest) ? latest : lessons.filter(visible)[0];
    if (!lesson) return;
    event.preventDefault();
    lesson.step(by);
  });
  function follow() {
    var id = decodeURIComponent(location.hash.slice(1));
    lessons.forEach(function (lesson) {
      lesson.frames.forEach(function (frame, i) {
        if (frame.id !== id) return;
        lesson.go(i);
        lesson.section.querySelector('.player').scrollIntoView();
      });
    });
  }
  addEventListener('hashchange', follow);
  follow();
})();
)";

// "03 Midpoint line": several lessons may have the same title.
std::string numbered_title(const Lesson& lesson) {
    return lesson.name.substr(0, lesson.name.find('-')) + " " + lesson.title;
}

std::string frame_id(const Lesson& lesson, std::size_t frame) {
    return fmt::format("{}-{}", lesson.name, frame + 1);
}

// The words of a frame that stand in its picture, for those who do not see it.
std::string spoken(const LessonFrame& frame) {
    std::string out;
    for (const std::string& part : {frame.title, frame.equation, frame.caption})
        if (!part.empty()) out += (out.empty() ? "" : ". ") + part;
    return out;
}

std::string thumbnail(const LessonRecord& r) {
    const Lesson& lesson = *r.lesson;
    return fmt::format(
        "<li><a href=\"#{0}\"><img src=\"{1}\" width=\"{2}\" height=\"{3}\" alt=\"\" loading=\"lazy\">{4}"
        "</a></li>\n",
        lesson.name, lesson_frame_file(lesson, lesson.frames.size() - 1), r.frame_width, r.frame_height,
        escaped(numbered_title(lesson)));
}

std::string figure(const LessonRecord& r, std::size_t i) {
    const Lesson& lesson = *r.lesson;
    const LessonFrame& f = lesson.frames[i];
    std::string out = fmt::format(
        "<li id=\"{0}\"><figure>\n<img src=\"{1}\" width=\"{2}\" height=\"{3}\" loading=\"lazy\" "
        "alt=\"Frame {4}: {5}\">\n<figcaption>\n<h3><span>{4}</span>{6}</h3>\n",
        frame_id(lesson, i), lesson_frame_file(lesson, i), r.frame_width, r.frame_height, i + 1,
        escaped(spoken(f)), escaped(f.title));
    if (!f.equation.empty()) out += "<p class=\"equation\">" + escaped(f.equation) + "</p>\n";
    if (!f.caption.empty()) out += "<p class=\"caption\">" + escaped(f.caption) + "</p>\n";
    return out + "</figcaption>\n</figure></li>\n";
}

std::string table(const Lesson& lesson) {
    std::string rows;
    for (std::size_t i = 0; i < lesson.frames.size(); ++i) {
        const std::vector<std::string>& row = lesson.frames[i].row;
        if (row.empty()) continue;
        rows += fmt::format("<tr data-frame=\"{0}\"><th scope=\"row\"><a href=\"#{1}\">{0}</a></th>", i + 1,
                            frame_id(lesson, i));
        for (std::size_t c = 0; c < lesson.columns.size(); ++c)
            rows += "<td>" + (c < row.size() ? escaped(row[c]) : std::string()) + "</td>";
        rows += "</tr>\n";
    }
    if (rows.empty()) return "";
    std::string heads = "<th scope=\"col\">frame</th>";
    for (const std::string& column : lesson.columns)
        heads += "<th scope=\"col\">" + escaped(column) + "</th>";
    return "<div class=\"table\" tabindex=\"0\" role=\"region\" aria-label=\"Table of states\"><table>\n"
           "<thead><tr>" +
           heads + "</tr></thead>\n<tbody>\n" + rows + "</tbody>\n</table></div>\n";
}

std::string turn(std::span<const LessonRecord> records, std::size_t i) {
    const auto link = [&](std::size_t k, std::string_view before, std::string_view after) {
        return fmt::format("<a href=\"#{1}\">{0}{2}{3}</a>", before, records[k].lesson->name,
                           escaped(numbered_title(*records[k].lesson)), after);
    };
    return "<p class=\"turn\">" + (i > 0 ? link(i - 1, "← ", "") : std::string("<span></span>")) +
           (i + 1 < records.size() ? link(i + 1, "", " →")
                                   : std::string("<a href=\"#top\">to the top ↑</a>")) +
           "</p>\n";
}

std::string section(std::span<const LessonRecord> records, std::size_t i) {
    const LessonRecord& r = records[i];
    const Lesson& lesson = *r.lesson;
    const std::size_t count = lesson.frames.size();
    std::string out = fmt::format("<section id=\"{0}\" class=\"lesson\">\n<h2>{1}</h2>\n<p>{2}</p>\n",
                                  lesson.name, escaped(numbered_title(lesson)), escaped(lesson.sentence));
    if (!lesson.source.empty()) out += "<p class=\"soft\">Source: " + escaped(lesson.source) + "</p>\n";
    out += fmt::format(
        "<div class=\"player\">\n<button type=\"button\" aria-label=\"First frame\">|&lt;</button>\n"
        "<button type=\"button\">Previous</button>\n<button type=\"button\">Play</button>\n"
        "<button type=\"button\">Next</button>\n<button type=\"button\" aria-label=\"Last "
        "frame\">&gt;|</button>\n"
        "<input type=\"range\" min=\"1\" max=\"{0}\" value=\"1\" aria-label=\"Frame\">\n<output>1 of "
        "{0}</output>\n"
        "</div>\n",
        count);
    out += fmt::format(
        "<p class=\"strip\"><a href=\"{0}.png\"><img src=\"{0}.png\" width=\"{1}\" height=\"{2}\" "
        "loading=\"lazy\" "
        "alt=\"{3}: its frames on one sheet\"></a></p>\n",
        lesson.name, r.strip_width, r.strip_height, escaped(lesson.title));
    out += fmt::format("<details>\n<summary>{} with captions</summary>\n<ol class=\"frames\">\n",
                       counted(std::int64_t(count), "frame"));
    for (std::size_t k = 0; k < count; ++k) out += figure(r, k);
    out += "</ol>\n</details>\n" + table(lesson);
    out += fmt::format(
        "<p class=\"files\">To take away: <a href=\"{0}.png\">a strip to print</a>, "
        "<a href=\"{0}.apng\">the film</a>, the table as <a href=\"{0}.csv\">CSV</a> and "
        "<a href=\"{0}.json\">JSON</a>.</p>\n",
        lesson.name);
    return out + turn(records, i) + "</section>\n";
}

}  // namespace

std::string lesson_page(const scene::LoadedScene& loaded, std::span<const LessonRecord> records,
                        const Picture& final_picture, int factor) {
    const std::string title = escaped(loaded.name) + ": lessons step by step";
    const int times = loaded.zoom * factor;
    std::string page =
        html_head(title, style) +
        fmt::format(
            "<script>document.documentElement.className = 'js';</script>\n<header>\n<h1>{0}</h1>\n"
            "<p class=\"soft\">{1}, {2}, {3} × {4} pixels. The list for programs: <a "
            "href=\"steps.json\">steps.json</a>; how long it took: <a href=\"timing.json\">timing.json</a>."
            " <span class=\"keys\">The arrow keys ← and → turn the frames.</span></p>\n<figure "
            "class=\"result\">\n<a href=\"final.png\"><img src=\"{5}\" width=\"{6}\" "
            "height=\"{7}\" alt=\"The finished picture of the scene\"></a>\n<figcaption class=\"soft\">The "
            "finished picture{8}.</figcaption>\n</figure>\n</header>\n",
            title, counted(std::int64_t(loaded.shapes.shapes.size()), "shape"),
            counted(std::int64_t(records.size()), "lesson"), loaded.width, loaded.height,
            factor > 1 ? "final-enlarged.png" : "final.png", final_picture.width() * factor,
            final_picture.height() * factor,
            times > 1 ? fmt::format(", {} times as large", times) : std::string());
    if (!records.empty()) {
        page += "<nav aria-label=\"Lessons\"><ol>\n";
        for (const LessonRecord& r : records) page += thumbnail(r);
        page += "</ol></nav>\n";
    }
    page += "<main>\n";
    for (std::size_t i = 0; i < records.size(); ++i) page += section(records, i);
    page += "</main>\n";
    if (!records.empty()) page += fmt::format("<script>{}</script>\n", script);
    return page + "</body>\n</html>\n";
}

}  // namespace relevo::show
