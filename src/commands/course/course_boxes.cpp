#include "commands/course/course_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "commands/pixel/course_text.h"
#include "world/surface_index.h"

namespace rt {

namespace {

struct BoxedObject {
    std::uint32_t object = 0;
    Bounds box;
    Vec3 centre{0.0};
};

class TreeText {
public:
    explicit TreeText(const Scene& scene) : scene_(scene) {}

    void add(std::span<BoxedObject> objects, int axis, const std::string& name) {
        Bounds box;
        for (const BoxedObject& o : objects) box.extend(o.box);
        text += fmt::format("{}:\n- Min: {}\n- Max: {}\n", name, vector_text(box.min), vector_text(box.max));
        if (objects.size() == 1) {
            text += fmt::format("- Leaf: (ID #{} - {})\n\n", objects[0].object + 1, type_text(scene_.objects[objects[0].object]));
            return;
        }
        text += fmt::format("- Branch: {} objects\n\n", objects.size());
        std::stable_sort(objects.begin(), objects.end(),
                         [axis](const BoxedObject& a, const BoxedObject& b) { return a.centre[axis] < b.centre[axis]; });
        const std::size_t half = objects.size() / 2;
        add(objects.first(half), (axis + 1) % 3, name + "/L");
        add(objects.subspan(half), (axis + 1) % 3, name + "/R");
    }

    std::string text;

private:
    const Scene& scene_;
};

}  // namespace

std::string printbvh_text(const Scene& scene, const World& world) {
    std::vector<BoxedObject> objects;
    std::string apart;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const Bounds box = world.surfaces->surfaces().bounds(i);
        if (box.is_finite())
            objects.push_back({i, box, 0.5 * (box.min + box.max)});
        else
            apart += fmt::format("(ID #{} - {})\n", i + 1, type_text(scene.objects[i]));
    }
    TreeText tree(scene);
    if (!objects.empty()) tree.add(objects, 0, "Root");
    return apart.empty() ? tree.text : tree.text + "Without a box:\n" + apart;
}

}  // namespace rt
