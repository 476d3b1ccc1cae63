// What the OpenImageIO module offers: two C functions that picture.cpp finds by name when it opens the
// module.
#pragma once
#include <cstddef>

namespace relevo::io {

enum class NumberKind : int { Uint8, Uint16, Float };

struct ImageShape {
    int width, height, channels;
    NumberKind kind;
};

// Gives memory for all numbers of an image of this shape, or null when it is refused.
using Allocate = void* (*)(void* user, const ImageShape* shape);
// Takes a finished file.
using TakeBytes = void (*)(void* user, const void* bytes, std::size_t size);

// Both return 0 when all went well. Else `message` (of `message_size` bytes, ends in zero) says in one line
// what went wrong; it is empty when `allocate` refused.
using ReadImageFunction = int(const char* path, Allocate allocate, void* user, char* message,
                              std::size_t message_size);
// Float numbers become an EXR file (lossless; a single channel is called Z), integers a PNG file.
using EncodeImageFunction = int(const ImageShape* shape, const void* rows, TakeBytes take, void* user,
                                char* message, std::size_t message_size);

inline constexpr char module_file[] = "lib/relevo/relevo_oiio.so";
inline constexpr char read_image_name[] = "relevo_oiio_read_image";
inline constexpr char encode_image_name[] = "relevo_oiio_encode_image";

}  // namespace relevo::io
