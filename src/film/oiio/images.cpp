// The module: the only code that knows OpenImageIO. No exception leaves it.
#include <OpenImageIO/half.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <vector>

#include "film/oiio/interface.h"

namespace {

thread_local std::string last_error;

/// One picture at a time in the caller's thread: a pool would cost more than it saves, and outlive the picture. Said of each picture,
/// because OpenImageIO's setting for all of them starts the pool before it ends it.
constexpr int in_caller_thread = 1;

const char* complain(const std::string& text) {
    last_error = text.empty() ? "unknown error" : text;
    while (!last_error.empty() && last_error.back() == '\n') last_error.pop_back();
    return last_error.c_str();
}

OIIO::TypeDesc type_of(RaytraceSample sample) {
    switch (sample) {
        case raytrace_uint8:
            return OIIO::TypeDesc::UINT8;
        case raytrace_uint16:
            return OIIO::TypeDesc::UINT16;
        case raytrace_half:
            return OIIO::TypeDesc::HALF;
        case raytrace_float:
            break;
    }
    return OIIO::TypeDesc::FLOAT;
}

/// The attribute under which a format keeps a PNG text of this name.
const char* attribute(const std::string& key) {
    if (key == "Title") return "DocumentName";
    if (key == "Comment" || key == "Description") return "ImageDescription";
    if (key == "Author") return "Artist";
    return key.c_str();
}

OIIO::ImageSpec spec_of(const RaytracePicture& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, type_of(picture.sample));
    const bool integers = picture.sample == raytrace_uint8 || picture.sample == raytrace_uint16;
    for (std::size_t i = 0; i < picture.text_count; ++i) spec.attribute(attribute(picture.text[i].key), picture.text[i].value);
    if (integers) {
        spec.attribute("oiio:UnassociatedAlpha", 1);
        if (picture.srgb) spec.attribute("oiio:ColorSpace", "sRGB");
        spec.attribute("compression", "lzw");
        spec.attribute("CompressionQuality", 95);
    } else {
        spec.attribute("oiio:ColorSpace", "Linear");
        spec.attribute("compression", "zip");
    }
    return spec;
}

/// The same values as the file has them, put into `halves`: where OpenImageIO converts them it starts its threads.
const half* as_halves(const RaytracePicture& picture, std::vector<half>& halves) {
    const auto* values = static_cast<const float*>(picture.data);
    halves.assign(values, values + static_cast<std::size_t>(picture.width) * picture.height * picture.channels);
    return halves.data();
}

const char* write(const char* path, const char* format, const RaytracePicture* picture) try {
    auto output = OIIO::ImageOutput::create(format);
    if (!output) return complain(OIIO::geterror());
    output->threads(in_caller_thread);
    std::vector<half> halves;
    const void* data = picture->data;
    if (picture->sample == raytrace_half) data = as_halves(*picture, halves);
    if (!output->open(path, spec_of(*picture)) || !output->write_image(type_of(picture->sample), data)) return complain(output->geterror());
    if (!output->close()) return complain(output->geterror());
    return nullptr;
} catch (const std::exception& error) {
    return complain(error.what());
}

const char* read(const char* path, const RaytraceSink* sink) try {
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    auto input = OIIO::ImageInput::open(path, &wishes);
    if (!input) return complain(OIIO::geterror());
    input->threads(in_caller_thread);
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.depth > 1) return complain("it is a volume, not a picture");
    const int channels = std::min(spec.nchannels, 4);
    const bool floats = spec.format.is_floating_point();
    const int max_value = floats ? 0 : spec.format.size() == 1 ? 255 : 65535;
    float* values = sink->begin(sink->user, spec.width, spec.height, channels, max_value);
    if (!values) return complain("the picture is too large");
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values)) return complain(input->geterror());
    const std::size_t count = static_cast<std::size_t>(spec.width) * spec.height * channels;
    // OpenImageIO hands integers out as fractions of 1; the nearest integer is the stored one.
    if (!floats) std::transform(values, values + count, values, [&](float v) { return std::round(v * static_cast<float>(max_value)); });
    return nullptr;
} catch (const std::exception& error) {
    return complain(error.what());
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const RaytraceImages* raytrace_images() {
    OIIO::attribute("exr_threads", -1);  // none of OpenEXR's own
    static const RaytraceImages functions{raytrace_images_version, write, read};
    return &functions;
}
