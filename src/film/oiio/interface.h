/* The C interface between the program and the module that reads and writes pictures through OpenImageIO. */
#pragma once

#include <cstddef>

extern "C" {

/* Raised whenever a structure or a function below changes. */
inline constexpr int raytrace_images_version = 1;

enum RaytraceSample { raytrace_uint8, raytrace_uint16, raytrace_half, raytrace_float };

struct RaytraceText {
    const char* key;
    const char* value;
};

/* What is to be written: interleaved rows from the top, `sample` as in the file but half (given as float). */
struct RaytracePicture {
    int width, height, channels;
    RaytraceSample sample;
    const void* data;
    const RaytraceText* text;
    std::size_t text_count;
    int srgb; /* integer samples: nonzero if they are sRGB-encoded */
};

/* Receives a picture: `begin` says its size and the largest stored integer (0: floats) and returns where the values go, or null to refuse.
 */
struct RaytraceSink {
    float* (*begin)(void* user, int width, int height, int channels, int max_value);
    void* user;
};

/* Both return null, or what went wrong (valid until the thread's next call). `format` is OpenImageIO's name, as "openexr". */
typedef const char* RaytraceWrite(const char* path, const char* format, const RaytracePicture* picture);
typedef const char* RaytraceRead(const char* path, const RaytraceSink* sink);

struct RaytraceImages {
    int version;
    RaytraceWrite* write;
    RaytraceRead* read;
};

/* The one symbol that is looked up. */
typedef const RaytraceImages* RaytraceEntry();
}
