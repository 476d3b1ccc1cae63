// Relevo, cairo and Anti-Grain Geometry draw the same random primitives, pass by pass in turn, in one process
// on one thread. Writes a table in Markdown (standard output) and CSV: thousands of primitives a second of
// CPU time (median of the passes), and the ratio of ours to the faster peer. Only ratios mean anything on a
// shared machine.
//
// usage: against_cairo_agg TABLE.csv [primitives a pass] [passes]
//
// Aliased outlines and discs start from whole pixels, as AGG's renderer_primitives has it; AGG's binary
// scanlines set every touched pixel. Antialiased lines are one pixel wide across; Wu's is one pixel high or
// wide, so it is told but not counted. Exit status 1 when a ratio is below 0.95, or when the triangles are
// not the same work as cairo's.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "raster/area_coverage.hpp"
#include "raster/circle_midpoint.hpp"
#include "raster/composite.hpp"
#include "raster/curve_coverage.hpp"
#include "raster/disc.hpp"
#include "raster/line_gupta_sproull.hpp"
#include "raster/line_midpoint.hpp"
#include "raster/line_outline.hpp"
#include "raster/line_wu.hpp"
#include "raster/triangle_scan.hpp"
#include "tests/bench/plane_peers.hpp"

namespace relevo::bench {
namespace {

using namespace raster;
using Primitives = std::vector<Primitive>;

constexpr PixelBox box{0, 0, plane_size - 1, plane_size - 1};

// Windows have their centres at +0.5, the plane at whole numbers.
glm::dvec2 place(const Primitive& p, int k) { return {p.x[k] - 0.5, p.y[k] - 0.5}; }
int below(float v) { return static_cast<int>(v + 4096) - 4096; }  // floor of what is above -4096
Pixel pixel(const Primitive& p, int k) { return {below(p.x[k]), below(p.y[k])}; }
SnappedPoint corner(const Primitive& p, int k) {
    const glm::dvec2 at = place(p, k);
    return snapped(at.x, at.y);
}

void clear(Picture& picture) { fill_run(picture.row(0), 0, plane_size * plane_size, Rgba8{}); }

// Clears the picture and hands each primitive to `draw` with what sets pixels of its colour.
template <class Draw>
void aliased(Picture& picture, const Primitives& all, Draw&& draw) {
    clear(picture);
    for (const Primitive& p : all)
        draw(
            p,
            [pixels = picture.row(0), color = p.color](int x, int y) { pixels[y * plane_size + x] = color; },
            [pixels = picture.row(0), color = p.color](int y, int x0, int x1) {
                std::fill(pixels + y * plane_size + x0, pixels + y * plane_size + x1, color);
            });
}
template <class Draw>
void smooth(Picture& picture, const Primitives& all, Draw&& draw) {
    clear(picture);
    for (const Primitive& p : all)
        draw(p, [&, color = p.color](int y, int x0, int x1, int coverage) {
            over(picture.row(y), x0, x1, color, coverage);
        });
}

struct Contestant {
    std::string name;
    std::function<void()> draw;
    std::function<Picture()> picture;
    bool ours = false, counts = true;
    std::vector<double> seconds = {};
    double rate = 0;  // primitives a second
};

double cpu_seconds() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

double median(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + std::ptrdiff_t(v.size() / 2), v.end());
    return v[v.size() / 2];
}

// The share of pixels that differ by more than `most` of 255 in a channel.
double unlike(const Picture& a, const Picture& b, int most) {
    std::size_t different = 0;
    for (std::size_t k = 0; k < a.pixels().size(); ++k) {
        const Rgba8 p = a.pixels()[k], q = b.pixels()[k];
        different += std::abs(p.r - q.r) > most || std::abs(p.g - q.g) > most || std::abs(p.b - q.b) > most;
    }
    return static_cast<double>(different) / static_cast<double>(a.pixels().size());
}

class Contest {
  public:
    Contest(int count, int passes, std::ofstream& csv) : count_(count), passes_(passes), csv_(csv) {}

    bool aliased_row(Kind kind) {
        all_ = primitives(kind, count_);
        start(kind);
        switch (kind) {
            case Kind::Lines:
                ours("midpoint", [this] {
                    aliased(picture_, all_, [](const Primitive& p, auto plot, auto) {
                        line_midpoint(pixel(p, 0), pixel(p, 1), box, plot);
                    });
                });
                break;
            case Kind::Circles:
                ours("midpoint", [this] {
                    aliased(picture_, all_, [](const Primitive& p, auto plot, auto) {
                        circle_midpoint(pixel(p, 0), static_cast<int>(p.radius), box, plot);
                    });
                });
                break;
            case Kind::Discs:
                ours("disc", [this] {
                    aliased(picture_, all_, [](const Primitive& p, auto, auto span) {
                        disc(pixel(p, 0), static_cast<int>(p.radius), static_cast<int>(p.radius), box, span);
                    });
                });
                break;
            case Kind::Triangles:
                ours("scanline", [this] {
                    aliased(picture_, all_, [](const Primitive& p, auto, auto span) {
                        triangle_scan({corner(p, 0), corner(p, 1), corner(p, 2)}, FillRule::TopLeft, box,
                                      span);
                    });
                });
                break;
        }
        cairo("cairo NONE", CairoMode::None);
        agg("AGG primitives", AggMode::Primitives);
        agg("AGG scanline bin", AggMode::ScanlineBin);
        return measure(kind, "aliased");
    }

    bool smooth_row(Kind kind) {
        all_ = primitives(kind, count_);
        start(kind);
        switch (kind) {
            case Kind::Lines:
                ours("area", [this] {
                    smooth(picture_, all_, [](const Primitive& p, auto cover) {
                        area_coverage(line_outline(place(p, 0), place(p, 1), 1), box, cover);
                    });
                });
                ours("Gupta-Sproull", [this] {
                    smooth(picture_, all_, [](const Primitive& p, auto cover) {
                        line_gupta_sproull(place(p, 0), place(p, 1), 1, box, cover);
                    });
                });
                ours("Wu", [this] {
                    smooth(picture_, all_, [](const Primitive& p, auto cover) {
                        line_wu(place(p, 0), place(p, 1), box, cover);
                    });
                });
                contestants_.back().counts = false;
                break;
            case Kind::Circles:
                ours("ring", [this] {
                    smooth(picture_, all_, [](const Primitive& p, auto cover) {
                        ring_coverage(place(p, 0), p.radius, p.radius, 1, box, cover);
                    });
                });
                break;
            case Kind::Discs:
                ours("disc", [this] {
                    smooth(picture_, all_, [](const Primitive& p, auto cover) {
                        disc_coverage(place(p, 0), p.radius, p.radius, box, cover);
                    });
                });
                break;
            case Kind::Triangles:
                ours("area", [this] {
                    smooth(picture_, all_, [](const Primitive& p, auto cover) {
                        const glm::dvec2 corners[3] = {place(p, 0), place(p, 1), place(p, 2)};
                        area_coverage(corners, box, cover);
                    });
                });
                break;
        }
        cairo("cairo FAST", CairoMode::Fast);
        cairo("cairo GOOD", CairoMode::Good);
        cairo("cairo BEST", CairoMode::Best);
        agg("AGG scanline aa", AggMode::ScanlineSmooth);
        agg("AGG outline aa", AggMode::OutlineSmooth);
        return measure(kind, "antialiased");
    }

  private:
    void start(Kind kind) {
        contestants_.clear();
        kind_ = kind;
    }
    void ours(std::string name, std::function<void()> draw) {
        contestants_.push_back({std::move(name), std::move(draw), [this] { return picture_; }, true});
    }
    void cairo(std::string name, CairoMode mode) {
        contestants_.push_back({std::move(name), [this, mode] { cairo_.draw(kind_, mode, all_); },
                                [this] { return cairo_.picture(); }});
    }
    void agg(std::string name, AggMode mode) {
        if (Agg::draws(kind_, mode))
            contestants_.push_back({std::move(name), [this, mode] { agg_.draw(kind_, mode, all_); },
                                    [this] { return agg_.picture(); }});
    }

    // The pictures of a few primitives: ours beside cairo's best, what is far off.
    double difference() {
        Primitives many = std::move(all_);
        all_ = Primitives(many.begin(), many.begin() + std::min<std::ptrdiff_t>(1000, count_));
        Picture mine, its;
        for (const Contestant& c : contestants_) {
            if (!c.ours && c.name.find("cairo") != 0) continue;
            if (c.ours && !mine.empty()) continue;
            c.draw();
            (c.ours ? mine : its) = c.picture();
        }
        all_ = std::move(many);
        return unlike(mine, its, 64);
    }

    bool measure(Kind kind, const char* mode) {
        const double far_off = difference();
        for (int pass = -1; pass < passes_; ++pass)  // one pass to warm up
            for (Contestant& c : contestants_) {
                const double start = cpu_seconds();
                c.draw();
                const double seconds = cpu_seconds() - start;
                if (pass >= 0) c.seconds.push_back(seconds);
            }
        const Contestant *best = nullptr, *peer = nullptr;
        for (Contestant& c : contestants_) {
            c.rate = count_ / median(c.seconds);
            const Contestant*& fastest = c.ours ? best : peer;
            if (c.counts && (!fastest || c.rate > fastest->rate)) fastest = &c;
            csv_ << mode << ',' << kind_names[static_cast<int>(kind)] << ',' << (c.ours ? "Relevo " : "")
                 << c.name << ',' << count_ << ',' << passes_ << ',' << c.rate << '\n';
        }
        const double ratio = best->rate / peer->rate;
        const bool fast = ratio >= 0.95, same = kind != Kind::Triangles || far_off < 0.01;
        std::string others;
        for (const Contestant& c : contestants_)
            if (&c != best && &c != peer) {
                char text[80];
                std::snprintf(text, sizeof text, "%s%s%s %.0f", others.empty() ? "" : ", ",
                              c.ours ? "Relevo " : "", c.name.c_str(), c.rate / 1000);
                others += text;
            }
        std::printf("| %s | %s | %s | %.0f | %s | %.0f | %.2f | %s | %.2f %% | %s |\n", mode,
                    kind_names[static_cast<int>(kind)], best->name.c_str(), best->rate / 1000,
                    peer->name.c_str(), peer->rate / 1000, ratio, others.c_str(), far_off * 100,
                    !same  ? "NOT THE SAME PICTURE"
                    : fast ? "yes"
                           : "TOO SLOW");
        std::fflush(stdout);
        return fast && same;
    }

    int count_, passes_;
    std::ofstream& csv_;
    Kind kind_ = Kind::Lines;
    Primitives all_;
    Picture picture_{plane_size, plane_size};
    Cairo cairo_;
    Agg agg_;
    std::vector<Contestant> contestants_;
};

}  // namespace
}  // namespace relevo::bench

int main(int argc, char** argv) {
    using namespace relevo::bench;
    const int count = argc > 2 ? std::atoi(argv[2]) : 100'000, passes = argc > 3 ? std::atoi(argv[3]) : 5;
    if (argc < 2 || argc > 4 || count < 1 || passes < 1)
        return std::fprintf(stderr, "usage: against_cairo_agg TABLE.csv [primitives a pass] [passes]\n"), 2;
    std::ofstream csv(argv[1]);
    csv << "mode,kind,drawn by,primitives,passes,primitives per cpu second\n";
    std::printf(
        "%d random primitives on %d x %d, cairo %s, AGG: thousands a second of CPU time, one thread, median "
        "of "
        "%d passes in turn. Far off: pixels of 1000 primitives that differ from cairo's by more than 64 of "
        "255.\n\n",
        count, plane_size, plane_size, Cairo::version().c_str(), passes);
    std::printf(
        "| mode | kind | Relevo | k/s | fastest peer | k/s | ratio | others | far off | at least as fast "
        "|\n|---|---|---|---|---|---|---|---|---|---|\n");
    Contest contest(count, passes, csv);
    bool good = true;
    constexpr Kind kinds[] = {Kind::Lines, Kind::Circles, Kind::Discs, Kind::Triangles};
    for (const Kind kind : kinds) good = contest.aliased_row(kind) && good;
    for (const Kind kind : kinds) good = contest.smooth_row(kind) && good;
    csv.flush();
    if (!csv) return std::fprintf(stderr, "cannot write %s\n", argv[1]), 2;
    return good ? 0 : 1;
}
