#include "commands/job/encoding.h"

#include <fmt/format.h>

#include "commands/base/names.h"

namespace rt {

Encoding encoding_of(const RenderJob& job, const Gamma& gamma) {
    Encoding encoding;
    encoding.raw = gamma.kind == Gamma::Kind::legacy || job.profile == Profile::csc473;
    encoding.working = {gamma.kind == Gamma::Kind::srgb ? Curve::Kind::srgb : Curve::Kind::power, gamma.power};
    encoding.file = job.file_gamma;
    encoding.bits = job.bits.value_or(encoding.bits);
    encoding.alpha = job.output_alpha;
    encoding.dither = job.dither;
    return encoding;
}

std::vector<std::string> format_losses(const RenderJob& job, ImageFormat format) {
    const FormatLimits limits = limits_of(format);
    const std::string_view name = name_of(format_names, format);
    std::vector<std::string> losses;
    const int bits = job.bits.value_or(limits.fewest_bits);
    if (bits != limits.fewest_bits && bits != limits.most_bits) {
        const std::string has = limits.fewest_bits == limits.most_bits ? fmt::format("{}", limits.most_bits)
                                                                       : fmt::format("{} or {}", limits.fewest_bits, limits.most_bits);
        losses.push_back(fmt::format("{} holds {} bits per channel, not {}: {} are written", name, has, bits, limits.bits_for(bits)));
    }
    if (job.output_alpha && !limits.alpha)
        losses.push_back(fmt::format("{} holds no alpha channel: the picture is written without one", name));
    if (job.dither && limits.linear) losses.push_back(fmt::format("{} holds linear light: it is not dithered", name));
    if (job.file_gamma != RenderJob().file_gamma && limits.linear)
        losses.push_back(fmt::format("{} holds linear light: the file gamma is left out", name));
    return losses;
}

}  // namespace rt
