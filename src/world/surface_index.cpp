#include "world/surface_index.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/slots.h"
#include "world/embree_index.h"
#include "world/local_frame.h"

namespace rt {

namespace {

/// With no more surfaces than this a list is as fast as the index, and starting Embree costs a millisecond. Measured: 4 spheres 37 ns a ray
/// in the list and 40 in the index, 4 boxes 61 and 57; 16 spheres 148 and 114, 16 boxes 247 and 132.
constexpr std::size_t list_limit = 4;
/// Coordinates beyond this are left to the list: their squares come near the end of doubles.
constexpr double largest_indexed = 1e140;
/// Rounding in Embree is relative to the whole scene, so a few objects that dwarf all others would blur them: they go to the list.
constexpr std::size_t most_outliers = 8;
constexpr double outlier_ratio = 16.0;

struct Reach {
    double distance;
    std::uint32_t object;
};

/// Largest distance of a box from a point, by components.
double reach(const Bounds& box, const Vec3& from) {
    const Vec3 a = from - box.min;
    const Vec3 b = box.max - from;
    return std::fmax(max_component(a), max_component(b));
}

Vec3 median_centre(std::vector<Bounds> boxes) {
    Vec3 median(0.0);
    const auto middle = boxes.begin() + static_cast<std::ptrdiff_t>(boxes.size() / 2);
    for (int axis = 0; axis < 3; ++axis) {
        const auto centre = [axis](const Bounds& b) { return 0.5 * b.min[axis] + 0.5 * b.max[axis]; };
        std::nth_element(boxes.begin(), middle, boxes.end(), [&](const Bounds& a, const Bounds& b) { return centre(a) < centre(b); });
        median[axis] = centre(*middle);
    }
    return median;
}

/// Moves the few objects from `indexed` to `listed` that reach much farther than all the others.
void list_outliers(const Surfaces& surfaces, std::vector<std::uint32_t>& indexed, std::vector<std::uint32_t>& listed) {
    if (indexed.size() < 2) return;
    std::vector<Bounds> boxes;
    boxes.reserve(indexed.size());
    for (const std::uint32_t object : indexed) boxes.push_back(surfaces.bounds(object));
    std::vector<Reach> reaches;
    reaches.reserve(indexed.size());
    const Vec3 centre = median_centre(boxes);
    for (std::size_t i = 0; i < indexed.size(); ++i) reaches.push_back({reach(boxes[i], centre), indexed[i]});
    const std::size_t considered = std::min(most_outliers + 1, reaches.size());
    std::partial_sort(reaches.begin(), reaches.begin() + static_cast<std::ptrdiff_t>(considered), reaches.end(),
                      [](const Reach& a, const Reach& b) { return a.distance > b.distance; });
    std::size_t outliers = 0;
    for (std::size_t k = 1; k < considered; ++k) {
        if (surfaces.objects[reaches[k - 1].object].count > most_outliers) break;
        if (reaches[k - 1].distance > outlier_ratio * reaches[k].distance) outliers = k;
    }
    for (std::size_t k = 0; k < outliers; ++k) {
        listed.push_back(reaches[k].object);
        indexed.erase(std::find(indexed.begin(), indexed.end(), reaches[k].object));
    }
}

std::size_t primitive_count(const Surfaces& surfaces, const std::vector<std::uint32_t>& objects) {
    std::size_t n = 0;
    for (const std::uint32_t object : objects) n += surfaces.objects[object].count;
    return n;
}

bool is_costly(const Surfaces& surfaces, std::uint32_t object) {
    const Surface& s = surfaces.objects[object];
    return (s.kind == SurfaceKind::part ? surfaces.parts[s.part].kind : s.kind) == SurfaceKind::further;
}

std::uint8_t bit(RayKind kind) {
    switch (kind) {
        case RayKind::image:
            return seen_by::image;
        case RayKind::reflected:
            return seen_by::reflected;
        case RayKind::shadow:
            return seen_by::shadow;
    }
    return 0;
}

/// False for rays with an infinity or a NaN in them, which meet nothing; asked here once so that no shape and no index has to survive them.
bool is_ray(const Ray& ray) {
    const Vec3 zeros = 0.0 * ray.origin + 0.0 * ray.direction;
    return zeros.x + zeros.y + zeros.z == 0.0;
}

}  // namespace

SurfaceIndex::SurfaceIndex(Surfaces surfaces, const CompileOptions& options)
    : surfaces_(std::move(surfaces)), exact_(options.precision == Precision::exact) {
    std::vector<std::uint32_t> indexed;
    std::vector<bool> late(surfaces_.late.empty() ? 0 : surfaces_.objects.size());
    for (const LateBody& body : surfaces_.late)
        for (const std::uint32_t object : body.objects) late[object] = true;
    for (std::uint32_t object = 0; object < surfaces_.objects.size(); ++object) {
        const Surface& surface = surfaces_.objects[object];
        if (surface.count == 0 || surface.seen == seen_by::masked_light || (!late.empty() && late[object])) continue;
        const Bounds box = surfaces_.bounds(object);
        const bool fits = options.index != IndexKind::brute_force && box.is_finite() && reach(box, Vec3(0.0)) < largest_indexed;
        (fits ? indexed : listed_).push_back(object);
    }
    list_outliers(surfaces_, indexed, listed_);
    if (options.index == IndexKind::automatic && primitive_count(surfaces_, indexed) <= list_limit) {
        listed_.insert(listed_.end(), indexed.begin(), indexed.end());
        indexed.clear();
    }
    for (const std::uint32_t object : listed_) {
        const Surface& s = surfaces_.objects[object];
        if (s.kind == SurfaceKind::sphere && indexed.empty())
            listed_spheres_.push_back({surfaces_.spheres[s.first], object, s.first_primitive, s.seen});
        else
            listed_others_.push_back(object);
    }
    // A costly search ends at what the others were met at before it.
    std::stable_partition(listed_others_.begin(), listed_others_.end(),
                          [&](std::uint32_t object) { return !is_costly(surfaces_, object); });
    if (!indexed.empty()) embree_ = std::make_unique<EmbreeIndex>(surfaces_, indexed, options.precision, options.threads);
}

SurfaceIndex::~SurfaceIndex() = default;

bool SurfaceIndex::nearest(const Ray& ray, const Interval& range, RayKind kind, Hit& hit) const {
    if (!is_ray(ray)) return false;
    Interval inside = range;
    const auto entry = embree_ ? embree_->enter(ray, inside) : EmbreeIndex::Entry::none;
    if (entry == EmbreeIndex::Entry::none && listed_.empty() && surfaces_.late.empty()) return false;
    Query query(ray, range, bit(kind));
    ask_listed(query);
    if (entry != EmbreeIndex::Entry::none) embree_->nearest(query, entry, inside);
    if (!surfaces_.late.empty()) ask_late(query);
    if (query.found) hit = query.best;
    return query.found;
}

std::uint32_t SurfaceIndex::nearest(std::span<const Ray> rays, const Interval& range, RayKind kind, std::span<Hit> hits) const {
    std::uint32_t found = 0;
    if (!embree_ || !exact_) {
        for (std::size_t i = 0; i < rays.size(); ++i) found |= std::uint32_t{nearest(rays[i], range, kind, hits[i])} << i;
        return found;
    }
    Slots<Query, packet_size> queries;
    std::array<Query*, packet_size> asked{}, entering;
    std::array<Interval, packet_size> inside;
    std::size_t count = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!is_ray(rays[i])) continue;
        inside[count] = range;
        const auto entry = embree_->enter(rays[i], inside[count]);
        if (entry == EmbreeIndex::Entry::none && listed_.empty() && surfaces_.late.empty()) continue;
        Query& query = queries.emplace(i, rays[i], range, bit(kind));
        asked[i] = &query;
        ask_listed(query);
        if (entry == EmbreeIndex::Entry::far) embree_->nearest(query, entry, inside[count]);
        if (entry == EmbreeIndex::Entry::inside) entering[count++] = &query;
    }
    if (count > 0) embree_->nearest(std::span(entering).first(count), inside);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (asked[i] == nullptr) continue;
        if (!surfaces_.late.empty()) ask_late(*asked[i]);
        if (!asked[i]->found) continue;
        hits[i] = asked[i]->best;
        found |= 1u << i;
    }
    return found;
}

std::optional<double> SurfaceIndex::through(const MaskRange& masks, const Ray& ray, const Interval& range) const {
    if (!is_ray(ray)) return std::nullopt;
    Query query(ray, range, seen_by::masked_light);
    for (std::uint32_t i = 0; i < masks.count; ++i) surfaces_.test(masks.first + i, query);
    return query.found ? std::optional(query.best.shape.t) : std::nullopt;
}

bool SurfaceIndex::occluded(const Ray& ray, const Interval& range, Blocker& last) const {
    if (!is_ray(ray)) return false;
    Query query(ray, range, seen_by::blocker);
    if (exact_ && last.object != Blocker::none && surfaces_.test_primitive(last.object, last.primitive, query)) return true;
    Interval inside = range;
    const auto entry = embree_ ? embree_->enter(ray, inside) : EmbreeIndex::Entry::none;
    bool met = false;
    for (std::size_t i = 0; !embree_ && i < listed_spheres_.size() && !met; ++i) met = listed_spheres_[i].test(query);
    for (std::size_t i = 0; i < listed_others_.size() && !met; ++i) met = surfaces_.test(listed_others_[i], query);
    if (!met && entry != EmbreeIndex::Entry::none) met = embree_->occluded(query, entry, inside);
    last = met ? Blocker{query.best.object, query.best.primitive} : Blocker{};
    return met || (!surfaces_.late.empty() && late_occluded(query));
}

/// After everything else, nearest gate first.
void SurfaceIndex::ask_late(Query& query) const {
    std::vector<std::pair<double, const LateBody*>> entered;
    for (const LateBody& body : surfaces_.late)
        if (Interval inside; clip(query.ray, body.gate, inside)) entered.emplace_back(inside.min, &body);
    std::sort(entered.begin(), entered.end());
    for (const auto& [distance, body] : entered) {
        if (query.found && distance >= query.best.shape.t) break;
        for (const std::uint32_t object : body->objects) surfaces_.test(object, query);
    }
}

bool SurfaceIndex::late_occluded(Query& query) const {
    for (const LateBody& body : surfaces_.late) {
        Interval inside{0.0, query.range.max};
        if (!clip(query.ray, body.gate, inside)) continue;
        for (const std::uint32_t object : body.objects)
            if (surfaces_.test(object, query)) return true;
    }
    return false;
}

}  // namespace rt
