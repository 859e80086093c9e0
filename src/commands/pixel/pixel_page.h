// `pixeltrace --html`: a page that shows the picture and, for some of its pixels, every ray that brought their light.
#pragma once

#include "commands/job/course_arguments.h"

namespace rt {

/// Renders the picture, traces the pixels asked for and a grid of others on all cores, and writes the page, whole or not at all.
/// `arguments.page` is set. Returns the exit status: 2, and no file, when it was interrupted. Throws OptionError for a pixel outside of
/// what --crop leaves and for a file that the page is made of (the scene, an include, a picture), LimitError for a page that would be too
/// large, OutputError.
///
/// The page's data (in the element "data"): version, scene, width, height, profile, shading and camera as ray_tree_json.h has
/// them, and
///     origin       "top left" or "bottom left": where the y of its pixels is counted from
///     command      words for a shell, and the places of the pixel among them (x, y)
///     encoding     how light becomes the picture's numbers: raw (as it is), working and file: "srgb" or the exponent to linear light
///     side         samples are side x side; averaged: whether the pixel is their mean
///     lights       of the scene: location, toward (of a parallel light, else null)
///     spacing      of the grid, 0 without one
///     pixels       those asked for first: x, y, asked, radiance, left_out (rays that the page does not tell of), samples
/// A ray is that of ray_tree_json.h without object_ray, with left_out where rays below it are not told of; its shadows are one entry for
/// each light: light, samples, hidden (how many see nothing of it), transmitted (their mean), crossed (objects, of all samples).
int write_pixel_page(CourseArguments arguments);

}  // namespace rt
