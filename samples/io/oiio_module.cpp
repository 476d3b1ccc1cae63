// OpenImageIO behind two C functions; see oiio_module.hpp. No exception leaves the module.
#include "samples/io/oiio_module.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace relevo::io {
namespace {

OIIO::TypeDesc type_of(NumberKind kind) {
    return kind == NumberKind::Uint8    ? OIIO::TypeDesc::UINT8
           : kind == NumberKind::Uint16 ? OIIO::TypeDesc::UINT16
                                        : OIIO::TypeDesc::FLOAT;
}

NumberKind kind_of(OIIO::TypeDesc type) {
    return type == OIIO::TypeDesc::UINT8    ? NumberKind::Uint8
           : type == OIIO::TypeDesc::UINT16 ? NumberKind::Uint16
                                            : NumberKind::Float;
}

// What happened to an action: 0, or 1 and a message of one line.
struct Report {
    char* message;
    std::size_t size;

    int failed(std::string text) const {
        std::replace(text.begin(), text.end(), '\n', ' ');
        std::snprintf(message, size, "%s", text.c_str());
        return 1;
    }
};

int read_image(const char* path, Allocate allocate, void* user, const Report& report) {
    OIIO::ImageSpec request;
    request.attribute("oiio:UnassociatedAlpha", 1);  // colours as stored, not multiplied by alpha
    const auto input = OIIO::ImageInput::open(path, &request);
    if (!input) return report.failed(OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    const ImageShape shape{spec.width, spec.height, spec.nchannels, kind_of(spec.format)};
    void* const numbers = allocate(user, &shape);
    if (numbers == nullptr) return report.failed("");
    const bool complete = input->read_image(0, 0, 0, shape.channels, type_of(shape.kind), numbers);
    // A JPEG file that was cut off counts as read, with grey below: only the message tells.
    const std::string trouble = input->geterror();
    if (!complete || !trouble.empty()) return report.failed(trouble.empty() ? "unknown reason" : trouble);
    return 0;
}

int encode_image(const ImageShape& shape, const void* rows, TakeBytes take, void* user,
                 const Report& report) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput file(bytes);
    const char* const name = shape.kind == NumberKind::Float ? "image.exr" : "image.png";
    const auto output = OIIO::ImageOutput::create(name, &file);
    if (!output) return report.failed(OIIO::geterror());
    OIIO::ImageSpec spec(shape.width, shape.height, shape.channels, type_of(shape.kind));
    if (shape.kind == NumberKind::Float) {
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", "");  // else the hour is written, and no two files have the same bytes
    }
    if (shape.kind == NumberKind::Float && shape.channels == 1) spec.channelnames = {"Z"}, spec.z_channel = 0;
    if (!output->open(name, spec) || !output->write_image(spec.format, rows) || !output->close())
        return report.failed(output->geterror());
    take(user, bytes.data(), bytes.size());
    return 0;
}

template <class Action>
int without_exceptions(const Report& report, const Action& action) {
    try {
        return action();
    } catch (const std::exception& exception) {
        return report.failed(exception.what());
    }
}

}  // namespace
}  // namespace relevo::io

#define RELEVO_EXPORT extern "C" __attribute__((visibility("default")))

RELEVO_EXPORT int relevo_oiio_read_image(const char* path, relevo::io::Allocate allocate, void* user,
                                         char* message, std::size_t message_size) {
    const relevo::io::Report report{message, message_size};
    return relevo::io::without_exceptions(
        report, [&] { return relevo::io::read_image(path, allocate, user, report); });
}

RELEVO_EXPORT int relevo_oiio_encode_image(const relevo::io::ImageShape* shape, const void* rows,
                                           relevo::io::TakeBytes take, void* user, char* message,
                                           std::size_t message_size) {
    const relevo::io::Report report{message, message_size};
    return relevo::io::without_exceptions(
        report, [&] { return relevo::io::encode_image(*shape, rows, take, user, report); });
}
