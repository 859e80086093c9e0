// Help on what trades time for accuracy.
#include "commands/help.h"

namespace rt {

const char* const trade_usage = "Usage: raytrace trade [OPTION...] SCENE\nTime against error: many settings of a scene, measured.";
const char* const trade_footer =
    R"(What is measured is kept: the same command goes on where it was. An option that
turns a knob (--max-trace-level, --F ...) fixes it. See raytrace help trade.
Exit status: 0, 1 a mistake, 2 interrupted (with reports of what there is),
3 not written, 4 too slow or too large.)";

const char* const trade_topic =
    R"(raytrace trade scene.pov -W 640 -H 480 -o results

A reference is made first: the exact preset, sampled by grids of growing size
until its RMSE, estimated from its two halves, is below --reference-error, or
its fifth of --seconds is over. Errors below twice its own are not told apart.
Then the presets (help quality), every value of each knob around "good", a step
up and down around the others, and what may beat the best of these; no knob
that this scene does not feel. The runs of different settings take turns, until
each median is stable to 3 %, or there were 9 runs (--runs) or 6 s of them.

Of each: seconds of the clock and of processors to read, build, trace and
encode; rays; RMSE, 99th percentile, maximum and mean FLIP against the
reference as both are shown, before rounding to 8 bits. Of each value the error
it makes alone, everything else exact: by source (sampling, model, precision)
their squares add up to that of the whole. Of the presets the pixels that hang
by the last bits of numbers ("unstable").

In the folder: trade.html (a page of all that: time against error, pictures,
what a step of each knob costs), results.json, results.csv, pictures/. Known
results stay until the scene, its includes, an option, the program or the
machine change, or --fresh. On a busy machine --cost cpu tells more.
)";

const char* const quality_topic =
    R"(raytrace scene.pov --quality good

draft, fast, good and exact set what help trade measures, from quick to exact.
Any option beside it wins, in any order; so does what a comment of the scene
chooses. draft and fast never make finer what a scene's global_settings state,
good and exact never coarser. Without --quality a run is POV-Ray's: one ray a
pixel, depth and bailout as the scene states them.
)";

}  // namespace rt
