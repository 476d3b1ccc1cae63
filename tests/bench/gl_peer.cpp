#include "tests/bench/gl_peer.hpp"

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace relevo::bench {
namespace {

[[noreturn]] void give_up(const std::string& why) {
    std::fprintf(stderr, "no peer to measure against: %s\n", why.c_str());
    std::exit(2);
}

void open_context_once() {
    static const bool opened = [] {
        const auto get_display =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        if (get_display == nullptr) give_up("EGL has no eglGetPlatformDisplayEXT");
        const EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
            give_up("EGL does not start");
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
        const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
    }();
    if (!opened) give_up("there is no OpenGL 3.3 context");
}

// The light equation of pipeline/light.hpp.
constexpr const char* light_equation = R"(
    uniform vec3 light_position, base_color;
    uniform vec4 material;
    vec2 reflection(vec3 point, vec3 normal) {
        vec3 n = normalize(normal), l = normalize(light_position - point), v = normalize(-point);
        float nl = max(dot(n, l), 0.0);
        float rv = max(dot(2.0 * nl * n - l, v), 0.0);
        return vec2(material.x + material.y * nl, nl > 0.0 ? material.z * pow(rv, material.w) : 0.0);
    })";

std::string vertex_shader(Mode mode) {
    std::string text = "#version 330 core\n";
    text += light_equation;
    text += R"(
    layout(location = 0) in vec3 position; layout(location = 1) in vec3 normal; layout(location = 2) in vec2 uv;
    uniform mat4 eye_from_object, clip_from_eye;
    out vec3 eye_position, eye_normal, corner_color; out vec2 corner_uv;
    void main() {
        vec4 eye = eye_from_object * vec4(position, 1.0);
        gl_Position = clip_from_eye * eye;
)";
    if (mode == Mode::Gouraud)
        text +=
            "vec2 a = reflection(eye.xyz, mat3(eye_from_object) * normal); corner_color = base_color * a.x + "
            "a.y;";
    if (mode == Mode::Phong || mode == Mode::Textured)
        text += "eye_position = eye.xyz; eye_normal = mat3(eye_from_object) * normal; corner_uv = uv;";
    return text + "}";
}

std::string fragment_shader(Mode mode) {
    std::string text = "#version 330 core\n";
    text += light_equation;
    text +=
        "in vec3 eye_position, eye_normal, corner_color; in vec2 corner_uv; uniform sampler2D image;\n"
        "out vec4 color; void main() {\n";
    switch (mode) {
        case Mode::Unlit:
        case Mode::Flat:
            return text + "color = vec4(base_color, 1.0); }";
        case Mode::Gouraud:
            return text + "color = vec4(corner_color, 1.0); }";
        case Mode::Phong:
            return text +
                   "vec2 a = reflection(eye_position, eye_normal); color = vec4(base_color * a.x + a.y, "
                   "1.0); }";
        case Mode::Textured:
            return text +
                   "vec2 a = reflection(eye_position, eye_normal);"
                   "color = vec4(texture(image, corner_uv).rgb * a.x + a.y, 1.0); }";
    }
    return text;
}

GLuint compile(GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const char* lines = text.c_str();
    glShaderSource(shader, 1, &lines, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return shader;
    std::array<char, 1024> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    give_up(std::string("a shader does not compile: ") + log.data());
}

std::array<float, 16> columns(const glm::dmat4& m) {
    std::array<float, 16> out;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) out[std::size_t(4 * c + r)] = static_cast<float>(m[c][r]);
    return out;
}

// OpenGL's clip volume is -w <= z <= w: z' = 2 z - w.
glm::dmat4 to_gl(glm::dmat4 m) {
    for (int c = 0; c < 4; ++c) m[c][2] = 2 * m[c][2] - m[c][3];
    return m;
}

}  // namespace

GlPeer::GlPeer(const Workload& workload, Mode mode, int width, int height)
    : workload_(workload), width_(width), height_(height) {
    open_context_once();
    program_ = glCreateProgram();
    glAttachShader(program_, compile(GL_VERTEX_SHADER, vertex_shader(mode)));
    glAttachShader(program_, compile(GL_FRAGMENT_SHADER, fragment_shader(mode)));
    glLinkProgram(program_);
    glUseProgram(program_);

    const auto& mesh = workload.mesh;
    glGenVertexArrays(1, &vertex_array_);
    glBindVertexArray(vertex_array_);
    glGenBuffers(2, buffers_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(pipeline::Vertex)),
                 mesh.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * 4), mesh.indices.data(),
                 GL_STATIC_DRAW);
    const std::size_t offsets[3] = {offsetof(pipeline::Vertex, position), offsetof(pipeline::Vertex, normal),
                                    offsetof(pipeline::Vertex, uv)};
    for (GLuint k = 0; k < 3; ++k) {
        glEnableVertexAttribArray(k);
        glVertexAttribPointer(k, k == 2 ? 2 : 3, GL_FLOAT, GL_FALSE, sizeof(pipeline::Vertex),
                              reinterpret_cast<const void*>(offsets[k]));
    }

    const auto uniform = [&](const char* name) { return glGetUniformLocation(program_, name); };
    const auto surface = material();
    const auto seen = camera(width, height, pipeline::DepthRange::Forward);
    const glm::dvec4 place = seen.eye_from_world.m * glm::dvec4(light().position.v, 1);
    glUniform3f(uniform("light_position"), float(place.x), float(place.y), float(place.z));
    glUniform3f(uniform("base_color"), surface.color.r, surface.color.g, surface.color.b);
    glUniform4f(uniform("material"), surface.ambient, surface.diffuse, surface.specular, surface.shininess);
    glUniformMatrix4fv(uniform("clip_from_eye"), 1, GL_FALSE, columns(to_gl(seen.clip_from_eye.m)).data());

    if (mode == Mode::Textured) {
        const auto image = checkerboard();
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture_size, texture_size, 0, GL_RGB, GL_UNSIGNED_BYTE,
                     image.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }

    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glGenRenderbuffers(2, renderbuffers_);
    const GLenum formats[2] = {GL_RGBA8, GL_DEPTH_COMPONENT24},
                 places[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int k = 0; k < 2; ++k) {
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[k]);
        glRenderbufferStorage(GL_RENDERBUFFER, formats[k], width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[k], GL_RENDERBUFFER, renderbuffers_[k]);
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        give_up("the framebuffer is incomplete");
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glClearColor(background.r, background.g, background.b, 1);
}

GlPeer::~GlPeer() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(2, renderbuffers_);
    glDeleteTextures(1, &texture_);
    glDeleteBuffers(2, buffers_);
    glDeleteVertexArrays(1, &vertex_array_);
    glDeleteProgram(program_);
}

void GlPeer::draw(int frame) {
    const auto seen = camera(width_, height_, pipeline::DepthRange::Forward);
    const auto eye_from_object = seen.eye_from_world * placement(workload_, frame);
    glUniformMatrix4fv(glGetUniformLocation(program_, "eye_from_object"), 1, GL_FALSE,
                       columns(eye_from_object.m).data());
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, GLsizei(workload_.mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
    glFinish();
}

raster::Image<raster::Rgba8> GlPeer::picture() const {
    raster::Image<raster::Rgba8> upside_down(width_, height_), out(width_, height_);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.pixels().data());
    for (int y = 0; y < height_; ++y) std::copy_n(upside_down.row(height_ - 1 - y), width_, out.row(y));
    return out;
}

std::string GlPeer::renderer() {
    open_context_once();
    const auto text = [](GLenum what) {
        return std::string(reinterpret_cast<const char*>(glGetString(what)));
    };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace relevo::bench
