#include "core/surface/moving/moving_mesh.hpp"

#include "core/base/for_each_index.hpp"
#include "core/base/with_spare.hpp"

#include <algorithm>

namespace wakesurf::core {

namespace {

template <class Visit>
void for_each_array(MaterialVertices& v, Visit visit) {
    visit(v.position);
    visit(v.along_s);
    visit(v.along_t);
    visit(v.expansion);
    visit(v.time);
    visit(v.end);
    visit(v.s);
    visit(v.t);
    visit(v.velocity);
    visit(v.birth_area);
    visit(v.id);
    visit(v.role);
    visit(v.approximated);
    visit(v.error);
    visit(v.cell);
}

} // namespace

VertexId MaterialVertices::add(const MaterialPoint& point, VertexRole as, double now) {
    const VertexId v = take_slots(1).front();
    begin(v, point, as, now);
    return v;
}

void MaterialVertices::make_room(std::size_t more) {
    const std::size_t needed = slots() + more;
    if (needed > role.capacity())
        for_each_array(*this, [&](auto& array) { array.reserve(with_spare(needed + 256)); });
}

std::vector<VertexId> MaterialVertices::take_slots(std::size_t count) {
    const std::size_t reused = std::min(count, free_.size());
    std::vector<VertexId> taken(free_.rbegin(),
                                free_.rbegin() + static_cast<std::ptrdiff_t>(reused));
    free_.resize(free_.size() - reused);
    make_room(count - reused);
    for (; taken.size() < count; taken.push_back(static_cast<VertexId>(slots() - 1)))
        for_each_array(*this, [](auto& array) { array.emplace_back(); });
    for (const VertexId v : taken) {
        id[v] = next_id_++;
        role[v] = VertexRole::Free;
    }
    fresh_.insert(fresh_.end(), taken.begin(), taken.end());
    return taken;
}

void MaterialVertices::begin(VertexId v, const MaterialPoint& point, VertexRole as, double now) {
    set(v, point);
    time[v] = now;
    velocity[v] = Vec3f(0.0f);
    cell[v] = no_cell;
    end[v] = as == VertexRole::Attached ? CurveEnd::Time : CurveEnd::Running;
    role[v] = as;
}

void MaterialVertices::remove(VertexId v) {
    role[v] = VertexRole::Unused;
    end[v] = CurveEnd::Time;
    free_.push_back(v);
}

MaterialPoint MaterialVertices::point(VertexId v) const {
    return {{position[v], along_s[v], along_t[v], double(expansion[v])},
            s[v],
            t[v],
            birth_area[v],
            approximated[v] != 0,
            error[v]};
}

void MaterialVertices::set(VertexId v, const MaterialPoint& point) {
    position[v] = point.carried.position;
    along_s[v] = point.carried.along_s;
    along_t[v] = point.carried.along_t;
    expansion[v] = static_cast<float>(point.carried.expansion);
    s[v] = point.s;
    t[v] = point.t;
    birth_area[v] = point.birth_area;
    approximated[v] = point.approximated ? 1 : 0;
    error[v] = point.error;
}

Particles MaterialVertices::particles() {
    return {position, along_s, along_t, time, end, {}, {}, cell, expansion};
}

void MaterialVertices::renumber(std::span<const VertexId> order) {
    for_each_array(*this, [&](auto& array) {
        std::remove_reference_t<decltype(array)> sorted;
        sorted.reserve(with_spare(order.size()));
        sorted.resize(order.size());
        for_each_index(order.size(), [&](std::size_t i) { sorted[i] = array[order[i]]; });
        array = std::move(sorted);
    });
    free_.clear();
    fresh_.clear();
}

std::size_t MaterialVertices::bytes() const {
    std::size_t sum = (free_.capacity() + fresh_.capacity()) * sizeof(VertexId);
    for_each_array(const_cast<MaterialVertices&>(*this),
                   [&](auto& array) { sum += array.capacity() * sizeof(array[0]); });
    return sum;
}

} // namespace wakesurf::core
