"""What the gallery shows: sections of pictures, each a scene with options of the command line and a caption."""

from dataclasses import dataclass, field

FACES = ("+x", "-x", "+y", "-y", "+z", "-z")
FRAMES = 24


# The texts, by the names that `raytrace help shading` has for them.
TEXTS = {
    "S0": "an early real-time demo of Cook and Torrance's model, with a cube map",
    "S1": "a course chapter on microfacet models",
    "S2": "a project that joins Cook and Torrance's highlight with Gooch's tones",
    "S3": "Phong's reflection with three kinds of lamps",
    "S4": "lecture slides",
}


@dataclass
class Picture:
    name: str
    scene: str
    options: list
    caption: str
    size: tuple = (400, 300)
    samples: int = 2
    hall: bool = False  # seen in the hall whose six pictures come first


@dataclass
class Section:
    name: str
    title: str
    source: str
    text: str
    pictures: list
    columns: int = 0  # a table of that many; 0: as many as the window holds
    heads: list = field(default_factory=list)
    animated: bool = False


def words(text):
    return text.split()


def hall():
    return Section(
        "hall", "The hall", "S0: the cube map",
        "Six square pictures of one scene, taken from where the teapot will stand. They are what <code>--environment</code> takes, in this order.",
        [Picture("hall-%d" % i, "surroundings", ["--define", "Face=%d" % i], "towards " + face, (256, 256)) for i, face in enumerate(FACES)])


MODES = {
    "phong-lights": "lamps: Lambert and Blinn-Phong, ambient light",
    "ct-lights": "lamps: Lambert and Cook-Torrance, ambient light",
    "phong-env": "surroundings as in a mirror, weight k<sub>s</sub>",
    "ct-env": "surroundings weighed by Cook-Torrance",
    "phong-both": "lamps and mirror",
    "ct-both": "lamps and surroundings, both by Cook-Torrance",
}
MATERIALS = ("shiny-gold", "dull-gold", "dull-blue", "silver", "mirror")


def demo():
    pictures = [Picture("demo-%s-%s" % (mode, material), "demo", ["--define", "Mode=" + mode, "--define", "Material=" + material],
                        "<b>%s</b>, %s: %s" % (mode, material, text), (320, 240), hall=True)
                for mode, text in MODES.items() for material in MATERIALS]
    return Section(
        "demo", "Six modes by five materials", "S0: the real-time demo",
        "Phong's highlight is white and his mirror has no colour, so every material looks like lacquer; Cook and Torrance's highlight and mirror are "
        "the metal's own colour, which Fresnel's term finds from its index. The mirror's lobe has no width: lamps, which are points, never show in "
        "it. The surroundings are looked up along one ray however dull the material; a real dull surface would blur them.",
        pictures, columns=len(MATERIALS), heads=list(MATERIALS))


def lamps_of_demo():
    pictures = [Picture("lamps-%s-%s" % (first, second), "demo", words("--define Material=dull-gold --define Mode=ct-lights") +
                        ["--define", "First=%s" % first, "--define", "Second=%s" % second],
                        "first lamp %s, second lamp %s" % (first, second), (320, 240), hall=True)
                for first, second in ((1, 0), (0, 1), (1, 1), (0.4, 2.5))]
    return Section("brightness", "The brightness of each lamp", "S0: the real-time demo",
                   "Two variables of the scene, set by <code>--define</code>.", pictures)


def motion():
    pictures = [Picture("motion-%02d" % i, "demo", ["--clock", "%g" % round(i / FRAMES, 6)], "clock %.3f" % (i / FRAMES), hall=True)
                for i in range(FRAMES)]
    return Section("motion", "Two lamps in motion", "S0: the real-time demo",
                   "The lamps circle the teapot in opposite directions once while <code>--clock</code> runs from 0 to 1; a fixed clock is a pause.",
                   pictures, animated=True)


def terms():
    pictures = [Picture("terms-%s-%s-%s" % (D, F, G), "strip", words("--D %s --F %s --G %s" % (D, F, G)),
                        "D = %s, F = %s, G = %s" % (D, F, G), (530, 110), 3)
                for D in ("blinn", "beckmann", "ggx") for F in ("constant", "schlick", "conductor") for G in ("cook-torrance", "ggx", "beckmann")]
    return Section(
        "terms", "Roughness by D, F and G", "S1: the course chapter",
        "r<sub>s</sub> = D G F / (4 (n&middot;l)(n&middot;v)), copper, no diffuse light; from left to right the roughness is 0.25, 0.4, 0.55, 0.7, 0.85 and "
        "alpha its square. D shapes the highlight: GGX has the long tail. F acts where light grazes, at the right edge. G darkens edges of rough "
        "surfaces: Cook and Torrance's bends sharply, Smith's does not.",
        pictures, columns=3, heads=["G = cook-torrance", "G = ggx (Smith)", "G = beckmann (Smith)"])


def gooch():
    size = (640, 360)
    return Section(
        "gooch", "Vases in warm and cool tones", "S2: Cook and Torrance with Gooch",
        "Gooch's tone I = x k<sub>warm</sub> + (1 - x) k<sub>cool</sub>, x = (1 + n&middot;l)/2, takes the place of the diffuse term; it is no light and casts no shadow. The highlight "
        "of Cook and Torrance lies over it, and lines follow outlines and creases.",
        [Picture("gooch-lambert", "vases", words("--diffuse lambert --edges off"), "Lambert's diffuse term, for comparison", size),
         Picture("gooch-tones", "vases", words("--s 0 --edges off"), "Gooch's tones alone", size),
         Picture("gooch-highlight", "vases", words("--edges off"), "with Cook and Torrance's highlight", size),
         Picture("gooch-silhouette", "vases", words("--edges silhouette"), "with outlines", size, 3),
         Picture("gooch-drawing", "vases", [], "with outlines and creases: the whole drawing", (960, 540), 3)])


def lamps():
    kinds = (("parallel", "parallel rays, as from the sun: no law of distance"),
             ("point", "a point, 1/(1 + &delta; + &delta;<sup>2</sup>): watch the floor"),
             ("spot", "a spot, max(-l&middot;a, 0)<sup>q</sup> with q = 24, and the same law of distance"), ("all", "all three"))
    return Section("lamps", "Three kinds of lamps", "S3: Phong and his lamps",
                   "L<sub>a</sub> + L<sub>d</sub> + L<sub>s</sub> with L<sub>s</sub> = max(r&middot;v, 0)<sup>p</sup>.",
                   [Picture("lamp-" + kind, "lamps", ["--define", "Lamp=" + kind], text) for kind, text in kinds])


def spots():
    widths = ((1, "60"), (8, "23.5"), (32, "11.9"), (128, "6"))
    return Section("spots", "How narrow a spot is", "S3: Phong and his lamps",
                   "What the text calls the radius of the cone is the exponent q of the cosine: the larger, the narrower.",
                   [Picture("spot-%d" % q, "lamps", ["--define", "Lamp=spot", "--define", "Power=%d" % q],
                            "q = %d: half of the light at %s&deg; from the axis" % (q, degrees)) for q, degrees in widths])


def metals():
    return Section(
        "metals", "Metals by their index", "S4: the lecture",
        "k<sub>s</sub> D G F / (&pi; (v&middot;n)) with D = e<sup>-(tan &beta; / m)&sup2;</sup> / (4 m<sup>2</sup> cos<sup>4</sup> &beta;) and the exact F of a complex index: "
        "gold, copper, silver, aluminium, iron from top to bottom; m = 0.1, 0.2, 0.3, 0.45, 0.65 from left to right. A metal has no diffuse light: "
        "what looks like its colour is the colour of its highlights.",
        [Picture("metals-lamps", "metals", [], "under four lamps", (600, 600), 3),
         Picture("metals-hall", "metals", words("--env albedo"), "the same in the hall, which each sees by the albedo of its lobe", (600, 600), 3, hall=True)])


PRESETS = {
    "modern": "GGX, Smith, Schlick: as S1 chooses", "classic": "Beckmann, Cook and Torrance's G, Schlick: S0 and S4",
    "course-blinn": "Blinn's D, Cook and Torrance's G, Schlick: other terms of S1", "reference": "GGX, height-correlated Smith, exact Fresnel: in none of the texts",
    "effects": "S0 as printed: its lamps have a solid angle of 0.0001, and the highlight is as faint", "lecture": "S4, diffuse weight 1 - k<sub>a</sub> - k<sub>s</sub>",
    "gooch-ct": "S2", "phong-lights": "S3; lamps 55 times brighter, for distance takes it",
}


def presets():
    pictures = [Picture("preset-" + name, "still", ["--preset", name] + (words("--define Brightness=55") if name == "phong-lights" else []),
                        "<b>%s</b>: %s" % (name, text)) for name, text in PRESETS.items()]
    return Section("presets", "The presets", "All texts", "One still life that makes no choice of its own, under each <code>--preset</code>.", pictures)


CLASSIC = "--D beckmann --G cook-torrance"
GLASSY = CLASSIC + " --eta 1.5 --k 0 --define Brightness=3"
VARIANTS = (  # name, scene, options of both, options of the variant, whose it is and what differs
    ("fresnel-linear", "strip", GLASSY, "--F schlick-linear", "S0 prints Schlick's term once without the fifth power: far too bright where light grazes"),
    ("fresnel-of-view", "strip", GLASSY, "--fresnel-arg nv",
     "S0 takes Fresnel's cosine as n&middot;v, not v&middot;h: the lamp behind loses its bright rim, and the model its reciprocity"),
    ("half-of-normal", "strip", CLASSIC, "--half nv", "S2 has h between n and v: the highlight stays in the middle wherever the lamp is"),
    ("unnormalised", "strip", CLASSIC, "--norm ct1982", "D as in Cook and Torrance's paper of 1982, in none of the five texts, is not normalised: four times as bright"),
    ("no-cosine", "strip", CLASSIC, "--raw on", "S2 prints no n&middot;l: the edge of the light is bright and sharp"),
    ("solid-angle", "strip", CLASSIC + " --define Brightness=40", "--dw 1e-3",
     "S0 has a constant for the lamp's solid angle, here 0.001: even 40 times brighter lamps leave little"),
    ("half-vector", "strip", "--shading phong --exponent 40", "--shading blinn-phong",
     "S0 has (n&middot;h)<sup>40</sup> where S3 has (r&middot;v)<sup>40</sup>: twice as wide, and longer where light grazes"),
    ("blinn-power", "strip", "--D blinn --G cook-torrance", "--blinn-power inverse-roughness",
     "S1 also prints Blinn's power as 1/roughness, which does not integrate to 1: small roughness gives far too much light"),
    ("width-direct", "strip", CLASSIC, "--alpha direct", "S0 and S4 take the roughness itself as the width, S1 its square: every highlight is wider"),
    ("units-physical", "strip", GLASSY, "--units physical",
     "the other way round, S1 is printed on the left: on the right the highlight in the units of the diffuse light, &pi; times as bright"),
    ("clamp-after", "strip", "--shading phong --exponent 6", "--clamp after", "S3 takes the power before the clamp: an even one lights the opposite side as well"),
    ("highlight-behind", "strip", "--shading phong --exponent 6", "--phong-gate off", "S3 has Phong's highlight where n&middot;l &lt; 0, too: light that leaks around the edge"),
    ("ambient-per-lamp", "still", "--shading phong", "--ambient per-light", "S3 adds ambient light once for each lamp: shadows are lifted and tinted"),
    ("gooch-reversed", "vases", "--edges off", "--gooch as-printed", "S2 prints a formula that with l towards the lamp paints the lit side cool"),
    ("ambient-thinned", "lamps", "--define Lamp=point --ambient per-light", "--attenuate-ambient on", "S3 lets ambient light thin out with distance, too: what is far is black"),
    ("surroundings", "demo", "--define Mode=ct-env", "--define Weight=ct-effects --dw 0.005",
     "S0's weight of the surroundings grows without bound at edges; with its own 0.0001 for the solid angle all else would be black"),
)
VARIANT_SIZES = {"strip": (700, 145), "still": (480, 360), "lamps": (480, 360), "vases": (640, 360), "demo": (480, 360)}


def variants():
    pictures = []
    for name, scene, base, variant, text in VARIANTS:
        for suffix, options, caption in (("default", "", "default"), ("variant", variant, "<b>%s</b>: %s" % (variant, text))):
            pictures.append(Picture("variant-%s-%s" % (name, suffix), scene, words(base + " " + options), caption,
                                    VARIANT_SIZES[scene], hall=scene == "demo"))
    return Section("variants", "What the texts print", "All texts",
                   "On the left what the program does, on the right the text to the letter.", pictures, columns=2)


def find(name):
    """The picture of that name."""
    return next(picture for section in sections() for picture in section.pictures if picture.name == name)


def sections():
    return [hall(), demo(), lamps_of_demo(), motion(), terms(), gooch(), lamps(), spots(), metals(), presets(), variants()]
