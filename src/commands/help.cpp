#include "commands/help.h"

#include <utility>

#include "commands/base/program.h"
#include "commands/base/suggest.h"
#include "commands/commands.h"
#include "commands/job/limit_options.h"
#include "commands/job/model_choices.h"
#include "core/source.h"

namespace rt {

const char* const render_usage = "Usage: raytrace [OPTION...] SCENE.pov    render a scene of POV-Ray 3.7";
const char* const render_footer =
    "Commands: requires compare versus trade explain grade merge brdf version; help\n"
    "on povray scene limits shading edges sampling knobs quality output course exit";
const char* const requires_usage =
    "Usage: raytrace requires [OPTION...] SCENE|FOLDER...\nWhat each scene needs of the program, and what in it is not modelled.";
const char* const requires_footer =
    R"(A render's options and POV-Ray's (+Iscene.pov +Ldir ...) are understood, too.

Of several scenes, which features are missing besides: how many scenes ask for
each, and how many for nothing else; then one after the other, so that most
scenes are complete soonest. Each scene is read in a process of its own: one
that has a mistake, never ends or takes all memory is listed with that.
Exit status: 0; of the scenes that could not be read the worst one's: 1 a
mistake, 4 a limit or the time, 5 a fault of this program; 2 interrupted.)";
const char* const compare_usage = "Usage: raytrace compare [OPTION...] A B\nThe difference of two pictures; A is the reference.";
const char* const compare_footer =
    "Exit status, as idiff's: 0 same, 1 warning, 2 failure, 3 sizes differ,\n4 a picture cannot be read. Also with one dash: -fail 0.01 "
    "...";
const char* const explain_usage =
    "Usage: raytrace explain [OPTION...] A B\nWhere two records of a pixel's rays part and what it usually means; A is right.";
const char* const explain_footer =
    R"(A and B are texts of the course's printrays or pixeltrace, of any program, or
what ours prints with --json, one beside the other as you like:
    raytrace printrays scene.pov 640 480 320 240 --json > ours.json
    ./mine printrays scene.pov 640 480 320 240 > mine.txt
    raytrace explain ours.json mine.txt
The first field that differs is named, in the order of the tree: a ray, what it
meets, light of the surface itself, then the rays that it causes, their sum.
What a record leaves out is not compared. Give a pixel that looks wrong; a rule
that differs may show first as the effect of another one.

Exit status: 0 same, 1 different, 4 a record cannot be read.)";
const char* const grade_usage =
    "Usage: raytrace grade [OPTION...] SUITE --exe PROGRAM\nRuns every test of a suite with any program, contained, and judges it.";
const char* const grade_footer =
    R"(SUITE: a folder as the course lays it out, or a suite file (help suite). Known
results are not run again: an interrupted grading goes on where it was. A wrong
answer has its usual cause in the table, what speaks for it in results.json.
Exit status: 0, or 1 if one program is graded and a required test failed;
2 interrupted, with all reports; 3 not all could be judged or written.)";
const char* const merge_usage = "Usage: raytrace merge [OPTION...] DIR...\nJoins the results of a grading's shards: DIR are their outputs.";
const char* const merge_footer = R"(Results stand in the order of one run; reports are the same bytes. Shards that
are not all of one grading are refused.
Exit status: 0, whatever passed; 2 if tests were not run, with all reports.)";
const char* const versus_usage =
    "Usage: raytrace versus [OPTION...] SCENE|FOLDER...\nPOV-Ray and this program on the same scenes with the same settings.";
const char* const versus_footer =
    R"(POV-Ray's switches (+W320 +A0.3 +Ldir +WT2) work, too: raytrace help versus.
Exit status: 0 all agree, 1 some do not, 2 interrupted, 3 not written,
4 nothing compared: POV-Ray is missing, a mistake in an option or every scene.)";
const char* const brdf_usage =
    "Usage: raytrace brdf eval TABLE < in.csv > out.csv\n       raytrace brdf check [TABLE] FILE...\n       raytrace brdf normalization | "
    "albedo "
    "[OPTION...]\n       raytrace brdf plot [OPTION...] > plot.svg; see raytrace brdf plot --help\nThe shading functions on tables: their "
    "values, and those against known ones.";
const char* const brdf_footer =
    R"(eval appends a column got_X of 17 digits for each value X of the table; comment
lines (#) and the cells of a row stay; value columns may be missing.
check judges a table's value columns: rows, largest error as a fraction of its
tolerance, and every row beyond it. A file's name says which table it is, or
TABLE in front of the files does; - is standard input.

Tables: contract general_r seed0_effectsbrowser seed2_gooch seed3_phong_lights
seed4_lecture terms_D terms_F terms_G
Exit status: 0, or 1 if a row is beyond its tolerance or a table has a mistake;
the other files are judged all the same.)";
const char* const brdf_plot_usage =
    "Usage: raytrace brdf plot [OPTION...] > plot.svg\nThe lobe of the chosen terms as the viewer sees it, and curves of D, G and F.";
const char* const brdf_plot_footer =
    R"(The terms: --preset --material --shading --D --G --F as in help shading; so are
the numbers --eta --k --f0 (one or R,G,B) --exponent --dw and the variants
--fresnel-arg nv --half nv --raw on --norm ct1982|ct4m2 --denominator clamped
--blinn-power inverse-roughness --units physical --clamp after --phong-gate off

Left, a polar plot of n.l rs (rs with --raw on) for light in the plane of view,
each curve divided by its maximum, which the legend tells. Right, D over the
half angle, G over the angle of the light, F over the angle of incidence.)";

namespace {

constexpr const char* povray_topic =
    R"(POV-Ray's command line: switches (+W320, -D), settings (Width=320), INI files
(scene.ini, scene.ini[section]) may be mixed with our own options in any order.

+Ifile +Ofile      scene and picture; the type's ending is appended to +O
+Wn +Hn            size                    +SCn +ECn +SRn +ERn   region, from 1
+FN[bits]          N png, P ppm, T C tga, J jpeg, B bmp, E exr, H hdr; -F none
+A[t] +AMn +Rn     anti-aliasing, as with -J (no jitter); +AGx its gamma
+Qn                quality 0..11           +UA   alpha channel
+Ldir              include folder          +MVx  language version
+WTn               threads                 +Kx   clock of a single picture
+KFIn +KFFn        frames, clock 0 to 1    +KIx +KFx +KC  its ends; cyclic
+SFx +EFx          those to render         -GA quiet, +V -V progress
Declare=NAME=VALUE Dither=on File_Gamma=2.2|srgb

Include_Header=FILE (+HI) is read before the scene. $POVINI, else ./povray.ini,
comes first. Commands (Pre_Scene_Command) are never started. What has no
meaning here (displays, bounding, buffers, message files) is named in one note.
)";

constexpr const char* scene_topic =
    R"(Scenes are those of POV-Ray 3.7. What is not modelled is an error that names
it, or a warning under --lenient; 'raytrace requires SCENE' lists it.

Includes are searched beside the including file, in the current folder, in the
folders of -L (Library_Path), in $RAYTRACE_LIBRARY_PATH and in POV-Ray's own.

A scene may state its own choices in comments, which POV-Ray skips:
    //! raytrace: shading=povray precision=exact
Keys: distances, precision and those of help shading; inside finish {} for that
finish alone, but for att, range, spot (clamp is there about the highlight).
File < finish < command line: a later one wins. In each: presets, then
materials, then shading, then single terms, whatever their order. A material
leaves k_d to the pigment.
--define NAME=VALUE declares a number or a string; --clock X sets clock.
)";

constexpr const char* shading_head =
    R"(--shading povray is POV-Ray's own finish model; general (default) and others:
r = ka + sum lc (n.l) [(1-s) kd rd + s D G F / (4 n.l n.v)] and its relatives.
--environment FILE (or six of a cube: +x,-x,+y,-y,+z,-z): seen past the scene.
S0 demo, S1 course, S2 Gooch, S3 lamps, S4 lecture are texts, X is in none.
)";
constexpr const char* shading_foot =
    R"(--alpha roughness2|povray|direct|X, not below --alpha-floor X. --env replaces
'reflection', times s, at most --env-clamp X. Numbers: --s --eta --k --f0 (one
or R,G,B) --exponent --sigma --dw --range --att-coefficients C,L,Q. Variants:
--blinn-power inverse-roughness --attenuate-ambient on --spot exponent --raw on
--denominator clamped --ambient per-light --gooch as-printed --units physical
--fresnel-arg nv --half nv --norm ct1982|ct4m2 --clamp after --phong-gate off
)";
const std::string& shading_topic() {
    static const std::string text = shading_head + catalogue_text() + shading_foot;
    return text;
}

constexpr const char* edges_topic =
    R"(Lines over the picture, with every shading and sampling; --ss 3 smooths them.

--edges silhouette  outlines: where another object, nothing, or a farther part
                    of the same object is seen
        crease      where a surface turns abruptly
        all, off    both; none (default)
--edge-width X      in pixels (1)
--edge-color R,G,B  or one number for all three, linear (0: black)
--edge-angle X      degrees between normals that make a crease (30)

Objects are those of the scene; all triangles of a mesh are one, and so are all
triangles outside of meshes. Half a line's width is on either side of its edge.
As Gooch draws: --preset gooch-ct --edges all. In a scene:
//! raytrace: edges=all edge-width=2
)";

constexpr const char* sampling_topic =
    R"(Without any of these a pixel is one ray through its centre, as in POV-Ray.

-ss=N, --ss N       N x N rays in every pixel, averaged
--aa 1[,T[,R]]      POV-Ray's method 1: neighbours that differ by T (0.3) or
                    more get R x R more rays (R 3)
--aa 2[,T[,R]]      POV-Ray's method 2: adaptive, R levels
+A[T] +AMn +Rn      the same, as POV-Ray writes it; rendered as with -J
--max-error E       rays where they lessen the error most, until the estimated
                    RMSE of encoded channels (0..1) is below E: that of the
                    part, with --crop
--time S            the same until the program has run S seconds, writing
                    included; a shorter time makes up what is not traced
--preview           writes the picture with every 16th pixel of every 16th row
                    traced and the rest made up, then with every 8th, 4th, 2nd,
                    until it is the one without --preview. Ctrl-C keeps the
                    best so far under its name
--crop X0,X1,Y0,Y1  only columns X0 to X1-1 and rows Y0 to Y1-1, from 0; the
                    rest stays black. A part has the same bytes as in the whole
                    picture, but with --max-error and --time
)";

constexpr const char* knobs_topic =
    R"(What trades the accuracy of a picture for time. Without any of these it is what
the scene says, one ray a pixel.

--ss N, --aa M,T,R    rays through a pixel: help sampling
--scale N             an N-th of the rows and columns is traced and enlarged
                      (1); not with --max-error, --time and --preview
--max-trace-level N   at most N rays follow one another, the camera's counted
--adc-bailout X       a ray that matters less than X is not followed; 0: all
--shadows full        every surface keeps light away; what is transparent tints
                      it (default)
          opaque      what has a transparent place anywhere casts no shadow
          none        nothing casts one
--light-samples N     an area light has at most N lamps along each side, over
                      the same area, as if the scene said so, 'adaptive' too;
                      1 is a point at its centre; all (default)
--F --D --G NAME      terms of highlights: help shading
--precision fast      triangles are found in single precision
--specular-aa on      microfacet highlights that the camera sees are as wide as
                      a sample at least, so that none is missed (off)
-gi_samples=A,B       under the course's rules alone: help course

--shadows and --light-samples go with every shading but the course's,
--specular-aa with none but the general one.
)";

constexpr const char* output_topic =
    R"(-o FILE             the ending chooses the type (png exr hdr tif jpg ppm tga
                    bmp); to another ending .png is appended
-o DIR/             the scene's name there;  -o - is standard output
+Oname              POV-Ray's rule: the ending of the type (+F) is appended
                    unless the name has it
(nothing)           the scene's name in the current folder
--bits N            8 or 16 (png, tiff, ppm); half or single precision: 16 or
                    32 (exr). What a format cannot hold is a warning
--file-gamma G      encode with 1/G instead of sRGB; 1 is linear
--dither on, --output-alpha on

A picture appears whole or not at all. Ctrl-C (SIGTERM, SIGHUP) finishes the
tiles in hand and leaves NAME.partial.png; a second one ends it all at once.
)";

constexpr const char* suite_topic =
    R"(What raytrace grade reads: a folder with tests.json, NAME.args and NAME.out or
NAME.png, or a folder of such folders, as the course lays its tests out, with
the scenes in "inputs" or "resources"; or a JSON file, its paths beside it:

  {"format": "raytrace suite 1", "name": "Winter", "inputs": "scenes",
   "defaults": {"timeout": 30, "memory": 1024},
   "tests": [{"name": "ray", "kind": "text", "expected": "ray.txt",
              "command": "pixelray ../resources/a.pov 640 480 320 240"},
             {"name": "glass", "expected": "glass.png", "weight": 2,
              "command": "render ../resources/glass.pov 640 480"}]}

A test may also have: kind text|picture|shown, output (output.png), required
(true), weight (1), tolerance of a text's numbers (0), timeout in seconds (60),
memory and file in MiB (4096, 256), printed in KiB (1024), processes (64),
timed (run with nothing beside it), repeats (timed, the median counts), fuzz in
percent (5), and for pictures
  pass    [{"metric": "differing", "at_most": 1000}], all of which must hold
  credit  {"metric": "rmse", "curve": [[0.01, 1], [0.1, 0]]}: partial credit
          (of a pass, too, which may then be worth less than its weight)
Metrics: differing (pixels beyond fuzz) differing_1 (beyond 1 %) rmse p99 flip
neighbourhood. "defaults" has any of these for all tests.
)";
constexpr const char* course_topic =
    R"(Commands of Cal Poly's CSC 473 and its own rules: right-handed, camera vectors
as written, rotation z y x, Blinn-Phong, round(255 c); silent.

raytrace render SCENE WIDTH HEIGHT       writes output.png
raytrace raycast SCENE WIDTH HEIGHT      pigments alone
raytrace sceneinfo | printbvh SCENE      what it says; boxes halved in x, y, z
raytrace pixelray|firsthit|pixelcolor|printrays|pixeltrace SCENE W H X Y
  a pixel's ray, what it meets, its colour, all its rays as a list or a tree
  (--json: with every number; pixeltrace --html FILE: a page, see help pixel).
  X and Y count from 0 at the bottom left (with --profile povray: top left);
  the numbers are the picture's.

-ss=N     N x N rays a pixel           -fresnel  glass mirrors by Schlick's law
-altbrdf  Cook-Torrance, GGX           -beers    glass fades with its thickness
-sds      always so: an index          -normals  (normal + 1) / 2 as colours
-gi       indirect light for ambient; -gi_samples=64,16 -gi_bounces=2

Mirrored and transmitted rays begin 0.001 along themselves, shadow rays 0.001
along the normal; six follow the camera's. Our long options and -q -t -L work,
too (-o where a picture is written); --shading povray or another tells of that,
--profile povray of our picture.
)";

constexpr const char* pixel_topic =
    R"(Why a pixel looks as it does: every ray that brought its light, with the
picture's own numbers, by the course's rules or (--profile povray) any other.

raytrace pixeltrace SCENE W H X Y                 a tree to read
raytrace pixeltrace SCENE W H X Y --json          every number, for programs
raytrace pixeltrace SCENE W H X Y --html FILE     a page for a browser
raytrace explain A B                              where two records part

The page holds the picture; a click on it shows the rays of the nearest traced
pixel as a tree and in space, with what each ray brings. It is one file, needs
no network, and FILE#X,Y opens it at a pixel.
--grid N        every N pixels one is traced (0: only those asked for); without
                it as many as make a page of a few megabytes
--pixel X,Y     one more pixel, may be repeated
Of a pixel asked for it tells at most 500 rays, of one on the grid 100, and at
least one of each sample: those nearest to the camera; --json tells all. A page
of more than 60000 rays is refused before the picture is made. --shading,
-ss=N, -fresnel ... are those of the picture.
)";

constexpr const char* exit_topic =
    R"(0  done
1  mistake in the scene or an option
2  interrupted; finished tiles are in NAME.partial.png
3  the picture or the text could not be written
4  a limit was exceeded (memory, size, depth): raytrace help limits
5  internal fault

'raytrace compare' has idiff's: 0 same, 1 warning, 2 failure, 3 sizes differ,
4 a picture cannot be read. 'raytrace explain' has 0 same, 1 different, 4.
'raytrace merge' has 2 if tests were not run. 'raytrace versus': 0 all agree,
1 some do not, 2 interrupted, 3, 4 nothing was compared.
)";

constexpr const char* versus_topic =
    R"(raytrace versus pov/ -W 320 -H 240 --aa 2

POV-Ray renders each scene, then this program with --shading povray (same),
then as it is (general). Size, anti-aliasing, threads, -L, --define and clock
go to all, in commands that the reports hold, to be copied. 8-bit pictures are
compared as they are shown: a scene agrees if 98 % of the pixels lie within 2
of 255 in every channel and the RMSE is below 0.01 (--percent, --step, --rmse).
Where both refuse a scene for a mistake in the same line, they agree as well.

The table is worst first, by cause: what differs, and where; what failed; what
is refused by us alone, or by both for other lines; what is not modelled, and
which features would gain most scenes; what POV-Ray alone refuses. Ctrl-C
reports what is done.

The output folder: results.json (the same bytes for the same pictures),
times.json, results.csv, report.html (a page of all that), pictures/SCENE/ with
povray.png, same.png, general.png and differences times 8. POV-Ray's are kept
in known/: it does not run again until the scene, a file that it or its
includes name, the settings or POV-Ray itself change, or with --fresh. All run
in the scene's folder, read what you may read, write nowhere, have no network.
)";

constexpr std::pair<std::string_view, std::string_view> topics[] = {
    {"povray", povray_topic},
    {"scene", scene_topic},
    {"shading", ""},
    {"edges", edges_topic},
    {"sampling", sampling_topic},
    {"knobs", knobs_topic},
    {"output", output_topic},
    {"course", course_topic},
    {"pixel", pixel_topic},
    {"suite", suite_topic},
    {"versus", versus_topic},
    {"trade", ""},
    {"quality", ""},
    {"limits", ""},
    {"exit", exit_topic},
};

}  // namespace

std::vector<std::string> help_topics() {
    std::vector<std::string> names;
    for (const auto& [name, text] : topics) names.emplace_back(name);
    return names;
}

std::string_view help_topic(std::string_view topic) {
    if (topic == "shading") return shading_topic();
    if (topic == "trade") return trade_topic;
    if (topic == "quality") return quality_topic;
    if (topic == "limits") return limits_topic();
    for (const auto& [name, text] : topics)
        if (name == topic) return text;
    return "";
}

int run_help(const Words& words) {
    if (words.empty() || words[0] == "render") return run_render({"--help"});
    if (words[0] == "requires") return run_requires({"--help"});
    if (words[0] == "compare") return run_compare({"--help"});
    if (words[0] == "explain") return run_explain({"--help"});
    if (words[0] == "brdf") return run_brdf({"--help"});
    if (words[0] == "grade") return run_grade({"--help"});
    if (words[0] == "merge") return run_merge({"--help"});
    const std::string_view text = help_topic(words[0]);
    if (text.empty()) throw OptionError("no help on '" + words[0] + "'" + did_you_mean(words[0], help_topics()));
    write_stdout(text);
    return 0;
}

}  // namespace rt
