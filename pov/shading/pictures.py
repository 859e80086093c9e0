"""What the gallery shows: sections of pictures, each a scene with options of the command line and a caption."""

from dataclasses import dataclass, field

FACES = ("+x", "-x", "+y", "-y", "+z", "-z")
FRAMES = 24


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
        "hall", "The hall", "Document 0: the cube map",
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
        "demo", "Six modes by five materials", "Document 0: a real-time demo of Cook and Torrance's model",
        "Phong's highlight is white and his mirror has no colour, so every material looks like lacquer; Cook and Torrance's highlight and mirror are "
        "the metal's own colour, which Fresnel's term finds from its index. The mirror's lobe has no width: lamps, which are points, never show in "
        "it. The surroundings are looked up along one ray however dull the material; a real dull surface would blur them.",
        pictures, columns=len(MATERIALS), heads=list(MATERIALS))


def lamps_of_demo():
    pictures = [Picture("lamps-%s-%s" % (first, second), "demo", words("--define Material=dull-gold --define Mode=ct-lights") +
                        ["--define", "First=%s" % first, "--define", "Second=%s" % second],
                        "first lamp %s, second lamp %s" % (first, second), (320, 240), hall=True)
                for first, second in ((1, 0), (0, 1), (1, 1), (0.4, 2.5))]
    return Section("brightness", "The brightness of each lamp", "Document 0: a real-time demo of Cook and Torrance's model",
                   "Two variables of the scene, set by <code>--define</code>.", pictures)


def motion():
    pictures = [Picture("motion-%02d" % i, "demo", ["--clock", "%g" % round(i / FRAMES, 6)], "clock %.3f" % (i / FRAMES), hall=True)
                for i in range(FRAMES)]
    return Section("motion", "Two lamps in motion", "Document 0: a real-time demo of Cook and Torrance's model",
                   "The lamps circle the teapot in opposite directions once while <code>--clock</code> runs from 0 to 1; a fixed clock is a pause.",
                   pictures, animated=True)


def terms():
    pictures = [Picture("terms-%s-%s-%s" % (D, F, G), "strip", words("--D %s --F %s --G %s" % (D, F, G)),
                        "D = %s, F = %s, G = %s" % (D, F, G), (530, 110), 3)
                for D in ("blinn", "beckmann", "ggx") for F in ("constant", "schlick", "conductor") for G in ("cook-torrance", "ggx", "beckmann")]
    return Section(
        "terms", "Roughness by D, F and G", "Document 1: a course chapter on microfacet models",
        "r<sub>s</sub> = D G F / (4 (n&middot;l)(n&middot;v)), copper, no diffuse light; from left to right the roughness is 0.25, 0.4, 0.55, 0.7, 0.85 and "
        "alpha its square. D shapes the highlight: GGX has the long tail. F acts where light grazes, at the right edge. G darkens edges of rough "
        "surfaces: Cook and Torrance's bends sharply, Smith's does not.",
        pictures, columns=3, heads=["G = cook-torrance", "G = ggx (Smith)", "G = beckmann (Smith)"])


def gooch():
    size = (640, 360)
    return Section(
        "gooch", "Vases in warm and cool tones", "Document 2: Cook-Torrance and Gooch",
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
    return Section("lamps", "Three kinds of lamps", "Document 3: Phong's reflection and its lamps",
                   "L<sub>a</sub> + L<sub>d</sub> + L<sub>s</sub> with L<sub>s</sub> = max(r&middot;v, 0)<sup>p</sup>.",
                   [Picture("lamp-" + kind, "lamps", ["--define", "Lamp=" + kind], text) for kind, text in kinds])


def spots():
    widths = ((1, "60"), (8, "23.5"), (32, "11.9"), (128, "6"))
    return Section("spots", "How narrow a spot is", "Document 3: Phong's reflection and its lamps",
                   "What the text calls the radius of the cone is the exponent q of the cosine: the larger, the narrower.",
                   [Picture("spot-%d" % q, "lamps", ["--define", "Lamp=spot", "--define", "Power=%d" % q],
                            "q = %d: half of the light at %s&deg; from the axis" % (q, degrees)) for q, degrees in widths])


def metals():
    return Section(
        "metals", "Metals by their index", "Document 4: lecture slides",
        "k<sub>s</sub> D G F / (&pi; (v&middot;n)) with D = e<sup>-(tan &beta; / m)&sup2;</sup> / (4 m<sup>2</sup> cos<sup>4</sup> &beta;) and the exact F of a complex index: "
        "gold, copper, silver, aluminium, iron from top to bottom; m = 0.1, 0.2, 0.3, 0.45, 0.65 from left to right. A metal has no diffuse light: "
        "what looks like its colour is the colour of its highlights.",
        [Picture("metals-lamps", "metals", [], "under four lamps", (600, 600), 3),
         Picture("metals-hall", "metals", words("--env albedo"), "the same in the hall, which each sees by the albedo of its lobe", (600, 600), 3, hall=True)])


PRESETS = {
    "modern": "GGX, Smith, Schlick: document 1 as its course chooses", "classic": "Beckmann, Cook and Torrance's G, Schlick: documents 0 and 4",
    "course-blinn": "Blinn's D, Cook and Torrance's G, Schlick: the course's lecture", "reference": "GGX, height-correlated Smith, exact Fresnel",
    "effects": "document 0 as printed: its lamps have a solid angle of 0.0001, and the highlight is as faint", "lecture": "document 4, diffuse weight 1 - k<sub>a</sub> - k<sub>s</sub>",
    "gooch-ct": "document 2", "phong-lights": "document 3; lamps 55 times brighter, for distance takes it",
}


def presets():
    pictures = [Picture("preset-" + name, "still", ["--preset", name] + (words("--define Brightness=55") if name == "phong-lights" else []),
                        "<b>%s</b>: %s" % (name, text)) for name, text in PRESETS.items()]
    return Section("presets", "The presets", "All documents", "One still life that makes no choice of its own, under each <code>--preset</code>.", pictures)


CLASSIC = "--D beckmann --G cook-torrance"
GLASSY = CLASSIC + " --eta 1.5 --k 0 --define Brightness=3"
VARIANTS = (  # number of the erratum, scene, options of both, options of the variant, what differs
    ("E1", "strip", GLASSY, "--F schlick-linear", "document 0 prints Schlick's term without the fifth power: far too bright where light grazes"),
    ("E2", "strip", GLASSY, "--fresnel-arg nv", "Fresnel's cosine n&middot;v instead of v&middot;h: the lamp behind loses its bright rim, and the model its reciprocity"),
    ("E3", "strip", CLASSIC, "--half nv", "h between n and v: the highlight stays in the middle wherever the lamp is"),
    ("E4", "strip", CLASSIC, "--norm ct1982", "D of 1982 is not normalised: four times as bright"),
    ("E6", "strip", CLASSIC, "--raw on", "document 2 without n&middot;l: the edge of the light is bright and sharp"),
    ("E8", "strip", CLASSIC + " --define Brightness=40", "--dw 1e-3",
     "document 0's constant for the lamp's solid angle, here 0.001: even 40 times brighter lamps leave little"),
    ("E10", "strip", "--shading phong --exponent 40", "--shading blinn-phong", "(n&middot;h)<sup>40</sup> in place of (r&middot;v)<sup>40</sup>: twice as wide, and longer where light grazes"),
    ("E12", "strip", "--D blinn --G cook-torrance", "--blinn-power inverse-roughness", "Blinn's power 1/roughness does not integrate to 1: small roughness gives far too much light"),
    ("E13", "strip", CLASSIC, "--alpha direct", "the width is the roughness itself, not its square: every highlight is wider"),
    ("E14", "strip", GLASSY, "--units physical", "the other way round: printed on the left; on the right the highlight in the units of the diffuse light, &pi; times as bright"),
    ("E27", "strip", "--shading phong --exponent 6", "--clamp after", "the power is taken before the clamp: an even one lights the opposite side as well"),
    ("E28", "strip", "--shading phong --exponent 6", "--phong-gate off", "Phong's highlight where n&middot;l &lt; 0: light that leaks around the edge"),
    ("E16", "still", "--shading phong", "--ambient per-light", "ambient light once for each lamp: shadows are lifted and tinted"),
    ("E25", "vases", "--edges off", "--gooch as-printed", "with l towards the lamp the printed formula paints the lit side cool"),
    ("E29", "lamps", "--define Lamp=point --ambient per-light", "--attenuate-ambient on", "ambient light thins out with distance, too: what is far is black"),
    ("E33", "demo", "--define Mode=ct-env", "--define Weight=ct-effects --dw 0.005",
     "document 0's weight of the surroundings grows without bound at edges; with its own 0.0001 for the solid angle all else would be black"),
)
VARIANT_SIZES = {"strip": (700, 145), "still": (480, 360), "lamps": (480, 360), "vases": (640, 360), "demo": (480, 360)}


def variants():
    pictures = []
    for erratum, scene, base, variant, text in VARIANTS:
        for suffix, options, caption in (("default", "", "default"), ("variant", variant, "<b>%s</b> %s" % (variant, text))):
            pictures.append(Picture("variant-%s-%s" % (erratum, suffix), scene, words(base + " " + options), erratum + ": " + caption,
                                    VARIANT_SIZES[scene], hall=scene == "demo"))
    return Section("variants", "What the texts print", "Errata of all documents",
                   "On the left what the program does, on the right the text to the letter. The numbers are those of the list of errata.", pictures, columns=2)


def sections():
    return [hall(), demo(), lamps_of_demo(), motion(), terms(), gooch(), lamps(), spots(), metals(), presets(), variants()]
