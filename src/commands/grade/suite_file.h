// Suites from files: the course's own layout, and a file of our own.
#pragma once

#include <string>

#include "core/source.h"
#include "grading/suite.h"

namespace rt {

/// The suite at `path`: a folder in the course's layout, or a suite file. `inputs`: the folder of scenes; empty: the suite's own.
/// Throws OptionError for what is missing, SceneError with its place for a mistake in a file. Notes go to `messages`.
Suite read_suite(const std::string& path, const std::string& inputs, const MessageSink& messages);

/// The course's layout: a folder with tests.json, a list of {name, type: text | image | additional, required, timeout}, and for each test
/// NAME.args (words of the command line) and NAME.out or NAME.png; or a folder of such folders, whose tests are called FOLDER/NAME. Tests
/// that have files and are not in the list are run too, and counted as not required. Without a time-out a text has 20 s and a picture 60.
/// The scenes are in `inputs`, else in the folder "inputs" or "resources" within the suite or beside it.
Suite read_course_suite(const std::string& folder, const std::string& inputs, const MessageSink& messages);

/// A JSON object (paths are relative to the file):
///     format    "raytrace suite 1"
///     name      title of the reports; default: the file's name
///     inputs    folder of the scenes, seen by programs as ../resources
///     defaults  any member of a test but its name, command and expected
///     tests     list of
///         name            unique
///         kind            text, picture (default) or shown
///         command         list of words, or one string that is split at blanks
///         expected        path of the expected text or picture
///         output          what the program writes (output.png)
///         required        true; weight: of its points (1)
///         timeout         seconds (60); memory: MiB (4096); printed: KiB (1024); file: MiB (256); processes: (64)
///         timed           false; true: run with nothing beside it, its time is a result; repeats: the median of so many runs counts (1),
///                         more than one are timed, whatever `timed` says
///         fuzz            percent for "differing" (5)
///         pass            list of {metric, at_most}, all of which must hold; default: differing at most 1000
///         credit          {metric, curve: [[figure, credit], ...]}: partial credit 0..1, linear between points; default: all or nothing;
///                         a pass, too, has the credit of the curve, which may be less than its weight
///         tolerance       of numbers in a text, relative above 1 (0)
///     metrics: differing (pixels beyond fuzz), differing_1 (beyond 1 %), rmse, p99, flip, neighbourhood
Suite suite_of_json(const Sources& sources, const std::string& inputs);

}  // namespace rt
