#include "raster/fast/draw_fast.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <vector>

#include "raster/clip_triangle.hpp"
#include "raster/fast/bins.hpp"
#include "raster/fast/buffer.hpp"
#include "raster/fast/stages.hpp"
#include "raster/fast/workers.hpp"
#include "raster/image.hpp"
#include "raster/model_setup.hpp"
#include "raster/triangle_edge.hpp"

namespace relevo::raster::fast {
namespace {

struct ModelMemory {
    Buffer<SnappedCorner> window;
    Buffer<Scalar> carried;
};

struct ChunkMemory {
    Buffer<TileList> lists;
    Buffer<std::uint32_t> words;
    std::size_t max_words = 0;
    std::vector<std::uint32_t> wide;
    std::vector<PieceName> names;
    std::vector<Piece> pieces;  // the first of them, at most max_pieces
    std::size_t max_pieces = 0;
};

struct WorkerMemory {
    Buffer<Scalar> nearness;
    Buffer<std::uint32_t> visible, color, ids, fragment_place;
    Buffer<std::int32_t> fragment_e1, fragment_e2;
    Buffer<std::byte> kept, waiting, painting, fragment_groups;
    TileScratch scratch;
    std::uint64_t shaded_pixels = 0;
};

template <class T>
std::size_t bytes_of(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

}  // namespace

struct Workspace::Memory {
    std::vector<ModelMemory> models;
    std::vector<ChunkMemory> chunks;
    std::vector<WorkerMemory> workers;
    std::vector<ModelState> states;
    std::vector<Chunk> chunk_states;
    std::vector<Pieces> pieces;
    std::vector<pipeline::EyeLight> lights;
    std::vector<int> touched, empty;  // tiles
};

Workspace::Workspace() : memory_(std::make_unique<Memory>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

std::size_t Workspace::bytes() const {
    std::size_t sum = sizeof(Memory);
    for (const ModelMemory& m : memory_->models) sum += m.window.bytes() + m.carried.bytes();
    for (const ChunkMemory& c : memory_->chunks)
        sum += c.lists.bytes() + c.words.bytes() + bytes_of(c.wide) + bytes_of(c.names) + bytes_of(c.pieces);
    for (const WorkerMemory& w : memory_->workers)
        sum += w.nearness.bytes() + w.visible.bytes() + w.color.bytes() + w.ids.bytes() + w.kept.bytes() +
               w.waiting.bytes() + w.painting.bytes() + w.fragment_place.bytes() + w.fragment_e1.bytes() +
               w.fragment_e2.bytes() + w.fragment_groups.bytes();
    return sum + bytes_of(memory_->models) + bytes_of(memory_->chunks) + bytes_of(memory_->workers) +
           bytes_of(memory_->touched) + bytes_of(memory_->empty) + bytes_of(memory_->states) +
           bytes_of(memory_->chunk_states) + bytes_of(memory_->pieces);
}

std::string_view name(InstructionSet set) {
    constexpr std::string_view names[] = {"SSE4", "AVX2", "AVX-512"};
    return names[static_cast<int>(set)];
}

#if RELEVO_FAST_PATH

std::span<const InstructionSet> instruction_sets() {
    static constexpr std::array all{InstructionSet::Sse4, InstructionSet::Avx2, InstructionSet::Avx512};
    static const std::size_t count = [] {
        const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                          __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
        const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                            __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                            __builtin_cpu_supports("avx512vl");
        return avx512 ? 3u : avx2 ? 2u : __builtin_cpu_supports("sse4.2") ? 1u : 0u;
    }();
    return std::span(all).first(count);
}

namespace {

const Stages& stages_of(InstructionSet set) {
    switch (set) {
        case InstructionSet::Sse4:
            return stages_sse4;
        case InstructionSet::Avx2:
            return stages_avx2;
        case InstructionSet::Avx512:
            break;
    }
    return stages_avx512;
}

// The chunk as the stages see it stands at the front of this.
struct GrowingChunk : Chunk {
    ChunkMemory* memory = nullptr;
};

}  // namespace

bool grow_words(Chunk& chunk) {
    ChunkMemory& memory = *static_cast<GrowingChunk&>(chunk).memory;
    const std::size_t count =
        std::min(std::max<std::size_t>(1 << 14, 2 * std::size_t{chunk.word_capacity}), memory.max_words);
    if (count < std::size_t{chunk.word_count} + later_block) return false;
    chunk.words = memory.words.grow(count);
    chunk.word_capacity = static_cast<std::uint32_t>(count);
    return true;
}

void append_wide(Chunk& chunk, std::uint32_t id) {
    std::vector<std::uint32_t>& wide = static_cast<GrowingChunk&>(chunk).memory->wide;
    if (!wide.empty() && wide.back() == id) return;
    wide.push_back(id);
    chunk.wide = wide.data(), chunk.wide_count = static_cast<std::uint32_t>(wide.size());
}

namespace {

// What a corner carries towards a side, as Program::corner gives it.
using Carried = std::array<Scalar, max_carried>;
Carried carried_of(const ModelSetup& setup, Shading shading, bool textured, const pipeline::Vertex& vertex,
                   bool back) {
    Carried carried{};
    with_program(shading, textured, [&]<class Program>(Program) {
        const auto numbers = varying_of<Program>(setup, vertex, back);
        std::copy(numbers.begin(), numbers.end(), carried.begin());
    });
    return carried;
}

}  // namespace

namespace {

// A triangle with a clip code, and what clipping makes of it. What a corner carries stands there twice where
// back faces are lit by their own normals: towards the front, towards the back.
struct ClippedPrimitive {
    pipeline::ClipCodes crossed = 0, outside = 0;  // planes that a corner, that all corners are beyond
    ClippedTriangle<2 * max_carried> polygon;
};
ClippedPrimitive clip_primitive(const DrawState& draw, const ModelState& model, std::uint32_t primitive) {
    ClippedPrimitive out;
    const std::uint32_t* index = &model.indices[3 * (std::size_t{primitive} - model.first_primitive)];
    pipeline::HPoint<pipeline::Clip> clip[3];
    out.outside = pipeline::code_planes;
    for (int k = 0; k < 3; ++k) {
        clip[k] = model.setup.clip_from_object * model.vertices[index[k]].position;
        const pipeline::ClipCodes codes = pipeline::clip_codes(clip[k]);
        out.crossed |= codes, out.outside &= codes;
    }
    if ((out.crossed & (pipeline::code_non_finite | pipeline::code_origin)) != 0 || out.outside != 0)
        return out;

    constexpr std::size_t n = max_carried;
    pipeline::ClipPolygon<2 * n> triangle;
    for (int k = 0; k < 3; ++k) {
        pipeline::ClipCorner<2 * n> corner{glm::dvec4(clip[k].v), {}, 0};
        for (int side = 0; side < (model.setup.both_sides ? 2 : 1); ++side) {
            const Carried carried =
                carried_of(model.setup, model.shading, model.textured, model.vertices[index[k]], side == 1);
            std::copy(carried.begin(), carried.end(), corner.varying.begin() + std::ptrdiff_t(n) * side);
        }
        triangle.push(corner);
    }
    out.polygon = clip_triangle(triangle, out.crossed, draw.viewport);
    return out;
}

template <std::size_t n>
Piece make_piece(const ModelState& model, const ClippedTriangle<n>& polygon, std::size_t a, std::size_t b,
                 std::size_t c) {
    const std::size_t corner[3] = {a, b, c};
    Piece made{{polygon.window[a], polygon.window[b], polygon.window[c]}, {}};
    const std::int64_t area = area2(made.window[0], made.window[1], made.window[2]);
    const bool back = model.setup.both_sides && pipeline::facing(area, model.setup.mirrored) == Facing::Back;
    for (int k = 0; k < 3; ++k)
        std::copy_n(polygon.varying[corner[k]].begin() + (back ? max_carried : 0), max_carried,
                    made.carried[k]);
    return made;
}

}  // namespace

Piece clipped_piece(const DrawState& draw, const PieceName& name) {
    const ModelState& model = draw.models[model_of(draw, name.primitive)];
    const ClippedPrimitive clipped = clip_primitive(draw, model, name.primitive);
    Piece made{};
    std::uint32_t part = 0;
    for_each_fan_triangle(clipped.polygon, [&](std::size_t a, std::size_t b, std::size_t c) {
        if (part++ == name.part) made = make_piece(model, clipped.polygon, a, b, c);
    });
    return made;
}

void clip_into_bins(const DrawState& draw, Chunk& chunk, const ModelState& model, std::uint32_t primitive) {
    const auto reject = [&](Rejection reason) { ++chunk.counts.rejected[static_cast<int>(reason)]; };
    const ClippedPrimitive clipped = clip_primitive(draw, model, primitive);
    if (clipped.crossed & pipeline::code_non_finite) return reject(Rejection::NonFinite);
    if (clipped.crossed & pipeline::code_origin) return reject(Rejection::ZeroArea);
    if (clipped.outside != 0 || clipped.polygon.result == Clipped::Outside) return reject(Rejection::Outside);
    if (clipped.polygon.result == Clipped::NonFinite) return reject(Rejection::NonFinite);
    ++chunk.counts.clipped;

    ChunkMemory& memory = *static_cast<GrowingChunk&>(chunk).memory;
    std::uint32_t part = 0;
    for_each_fan_triangle(clipped.polygon, [&](std::size_t a, std::size_t b, std::size_t c) {
        const PieceName name{primitive, part++};
        const SnappedCorner window[3] = {clipped.polygon.window[a], clipped.polygon.window[b],
                                         clipped.polygon.window[c]};
        const std::int64_t area = area2(window[0], window[1], window[2]);
        if (area == 0) return reject(Rejection::ZeroArea);
        if (pipeline::is_culled(pipeline::facing(area, model.setup.mirrored), draw.settings.cull))
            return reject(Rejection::Culled);
        const PixelBox box = pixel_box(window, draw.viewport.width, draw.viewport.height);
        if (box.empty()) return reject(Rejection::NoPixel);
        const std::uint32_t id =
            piece_bit | chunk.number << piece_index_bits | static_cast<std::uint32_t>(memory.names.size());
        memory.names.push_back(name);
        if (memory.names.size() <= memory.max_pieces)
            memory.pieces.push_back(make_piece(model, clipped.polygon, a, b, c));
        append(draw, chunk, id, box.x0 / draw.tile, box.y0 / draw.tile, box.x1 / draw.tile,
               box.y1 / draw.tile);
    });
}

namespace {

// Everything of one draw, stage after stage.
class FastDraw {
  public:
    FastDraw(const Scene& scene, const Settings& settings, Frame& frame, Workspace::Memory& memory,
             const Options& options)
        : scene_(scene), memory_(memory), options_(options), stages_(stages_of(options.instruction_set)) {
        draw_.settings = settings;
        draw_.viewport = {frame.depth.width(), frame.depth.height()};
        draw_.tile = options.tile;
        draw_.tiles_across = (draw_.viewport.width + options.tile - 1) / options.tile;
        draw_.tiles_down = (draw_.viewport.height + options.tile - 1) / options.tile;
        draw_.background = scene.background;
        draw_.background8 = to_rgba8(scene.background, settings.output);
        draw_.color = frame.color.row(0);
        draw_.depth = frame.depth.row(0);
        draw_.linear = frame.linear.empty() ? nullptr : frame.linear.row(0);
        if (options.visible != nullptr) {
            *options.visible = Image<std::uint32_t>(draw_.viewport.width, draw_.viewport.height);
            draw_.visible = options.visible->row(0);
        }
    }

    Counts run() {
        prepare_models();
        transform();
        bin();
        return draw_tiles();
    }

  private:
    int workers() const { return options_.workers == nullptr ? 1 : options_.workers->count(); }
    template <class Work>
    void each(int items, Work&& work) {
        if (options_.workers == nullptr)
            for (int item = 0; item < items; ++item) work(item, 0);
        else
            options_.workers->run(items, work);
    }

    void prepare_models() {
        memory_.lights = lights_in_eye_space(scene_);
        if (memory_.models.size() < scene_.models.size()) memory_.models.resize(scene_.models.size());
        memory_.states.assign(scene_.models.size(), {});
        for (std::size_t m = 0; m < scene_.models.size(); ++m) {
            const Model& model = scene_.models[m];
            ModelState& state = memory_.states[m];
            state.number = static_cast<std::uint32_t>(m);
            state.vertices = model.mesh->vertices;
            state.indices = model.mesh->indices;
            state.first_primitive = triangles_;
            state.triangles = static_cast<std::uint32_t>(model.mesh->triangles());
            state.setup = make_setup(scene_.camera, model, memory_.lights, draw_.settings);
            state.shading = draw_.settings.shading;
            state.textured = model.texture != nullptr;
            with_program(state.shading, state.textured,
                         [&]<class Program>(Program) { state.size = static_cast<int>(Program::size); });
            state.stride = state.size == 0 ? 0 : state.size <= 4 ? 4 : 8;
            const std::size_t room = (state.vertices.size() + 15) / 16 * 16;
            state.window = memory_.models[m].window.room_for(room);
            state.carried = memory_.models[m].carried.room_for(room * std::size_t(state.stride));
            triangles_ += state.triangles;
            counts_.vertices += state.vertices.size();
        }
        draw_.models = memory_.states;
        draw_.paints = can_be_painted(draw_);
    }

    void transform() {
        constexpr std::size_t block = 4096;  // vertices
        for (const ModelState& model : draw_.models) {
            const std::size_t count = model.vertices.size();
            each(static_cast<int>((count + block - 1) / block), [&](int item, int) {
                const std::size_t first = block * std::size_t(item);
                stages_.transform(model, draw_.viewport, static_cast<std::uint32_t>(first),
                                  static_cast<std::uint32_t>(std::min(first + block, count)));
            });
        }
    }

    void bin() {
        const std::size_t tiles = std::size_t(draw_.tiles_across) * std::size_t(draw_.tiles_down);
        const std::uint32_t wanted = workers() == 1 ? 1 : 8 * static_cast<std::uint32_t>(workers());
        const std::uint32_t needed = (triangles_ + max_chunk_triangles - 1) / max_chunk_triangles;
        // so many that in each one every tile's list may have its two first blocks
        const std::size_t words = list_room / 4 + triangles_;
        const std::uint32_t fitting = static_cast<std::uint32_t>(
            std::min<std::size_t>(words / (tiles * (first_block + later_block)), max_chunks));
        chunk_count_ =
            std::clamp(std::max(std::min({wanted, triangles_ / 4096, fitting}), needed), 1u, max_chunks + 0u);
        if (memory_.chunks.size() < chunk_count_) memory_.chunks.resize(chunk_count_);
        chunks_.resize(chunk_count_);
        memory_.pieces.resize(chunk_count_);
        for (std::uint32_t c = 0; c < chunk_count_; ++c) {
            ChunkMemory& memory = memory_.chunks[c];
            GrowingChunk& chunk = chunks_[c];
            const auto bound = [&](std::uint32_t k) {
                return static_cast<std::uint32_t>(std::uint64_t{triangles_} * k / chunk_count_);
            };
            chunk.number = c, chunk.first = bound(c), chunk.last = bound(c + 1);
            chunk.memory = &memory;
            chunk.lists = memory.lists.room_for(tiles);
            std::fill_n(chunk.lists, tiles, TileList{});
            chunk.words = memory.words.room_for(0);
            chunk.word_capacity = static_cast<std::uint32_t>(memory.words.capacity());
            memory.max_words =
                std::max((list_room / chunk_count_ + 8 * std::size_t{chunk.last - chunk.first}) / 4,
                         memory.words.capacity());
            memory.wide.clear();
            memory.names.clear(), memory.pieces.clear();
            memory.max_pieces = piece_room / chunk_count_ / sizeof(Piece);
        }
        each(static_cast<int>(chunk_count_),
             [&](int c, int) { stages_.bin(draw_, chunks_[std::size_t(c)]); });
        memory_.chunk_states.assign(chunks_.begin(), chunks_.end());
        for (std::uint32_t c = 0; c < chunk_count_; ++c)
            memory_.pieces[c] = {memory_.chunks[c].names, memory_.chunks[c].pieces};
        draw_.pieces = memory_.pieces;
    }

    Counts draw_tiles() {
        const int stride = draw_.tile + 16;
        const std::size_t pixels = std::size_t(stride) * std::size_t(draw_.tile) + 16;
        if (memory_.workers.size() < std::size_t(workers())) memory_.workers.resize(std::size_t(workers()));
        const std::size_t fragments = 4 * pixels, with_slack = fragments + fragment_slack;
        const std::size_t group_bytes = 20 * fragments;  // of 16 lanes: for groups of 26 fragments
        for (WorkerMemory& worker : memory_.workers) {
            worker.scratch = {.tile = {stride, worker.nearness.room_for(pixels + std::size_t(stride)),
                                       shows_one_color(draw_) ? nullptr : worker.visible.room_for(pixels),
                                       worker.color.room_for(pixels)},
                              .kept = worker.kept.room_for(kept_bytes),
                              .waiting = worker.waiting.room_for(waiting_bytes),
                              .painting = worker.painting.room_for(painting_bytes),
                              .fragments = {.place = worker.fragment_place.room_for(with_slack),
                                            .e1 = worker.fragment_e1.room_for(with_slack),
                                            .e2 = worker.fragment_e2.room_for(with_slack),
                                            .room = static_cast<int>(fragments),
                                            .groups = worker.fragment_groups.room_for(group_bytes),
                                            .group_bytes = group_bytes}};
            worker.shaded_pixels = 0;
        }
        const auto listed = [&](int tile) {
            return listed_in(memory_.chunk_states.data(), static_cast<int>(chunk_count_), tile);
        };
        // touched tiles, each with some of the others to write meanwhile; then what is left of these
        std::vector<int>&touched = memory_.touched, &empty = memory_.empty;
        touched.clear(), empty.clear();
        for (int tile = 0; tile < draw_.tiles_across * draw_.tiles_down; ++tile)
            (listed(tile) > 0 ? touched : empty).push_back(tile);
        const std::size_t items = touched.size(), shared = std::min(empty.size(), 4 * items);
        each(static_cast<int>(items + empty.size() - shared), [&](int item, int w) {
            WorkerMemory& worker = memory_.workers[std::size_t(w)];
            const std::size_t k = std::size_t(item);
            const int tile = k < items ? touched[k] : empty[shared + (k - items)];
            worker.scratch.ids = worker.ids.room_for(listed(tile) + first_block);
            if (k < items) {
                const std::size_t first = shared * k / items, last = shared * (k + 1) / items;
                worker.scratch.background = {empty.data() + first, static_cast<int>(last - first)};
            } else {
                worker.scratch.background = {&empty[shared + (k - items)], 1};
            }
            worker.shaded_pixels += stages_.draw_tile(draw_, memory_.chunk_states.data(),
                                                      static_cast<int>(chunk_count_), worker.scratch, tile);
        });
        for (const Chunk& chunk : memory_.chunk_states) {
            counts_.triangles += chunk.counts.triangles;
            counts_.clipped += chunk.counts.clipped;
            for (std::size_t r = 0; r < std::size(counts_.rejected); ++r)
                counts_.rejected[r] += chunk.counts.rejected[r];
        }
        for (const WorkerMemory& worker : memory_.workers) counts_.shaded_pixels += worker.shaded_pixels;
        return counts_;
    }

    static constexpr std::size_t list_room = std::size_t{24} << 20,  // bytes, besides 8 a triangle
        piece_room = std::size_t{8} << 20;                           // bytes

    const Scene& scene_;
    Workspace::Memory& memory_;
    const Options& options_;
    const Stages& stages_;
    DrawState draw_;
    std::vector<GrowingChunk> chunks_;
    std::uint32_t triangles_ = 0, chunk_count_ = 0;
    Counts counts_;
};

}  // namespace

Counts draw(const Scene& scene, const Settings& settings, Frame& frame, Workspace& workspace,
            const Options& options) {
    assert(options.tile == 32 || options.tile == 64 || options.tile == max_tile);
    return FastDraw(scene, settings, frame, workspace.memory(), options).run();
}

#else

std::span<const InstructionSet> instruction_sets() { return {}; }

Counts draw(const Scene&, const Settings&, Frame&, Workspace&, const Options&) { std::abort(); }

#endif

}  // namespace relevo::raster::fast
