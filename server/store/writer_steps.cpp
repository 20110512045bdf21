#include "ciel/types.hpp"
#include "store/valid_text.hpp"
#include "store/writer_state.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace server::store {

void Writer::add_step(double time, std::size_t mesh, std::size_t coordinates, std::span<const ArrayValues> arrays) {
    begin_step(time, mesh, coordinates);
    std::set<std::string> seen;
    for (const ArrayValues& array : arrays) { // checks all arrays before it writes the first array
        const ArrayValues named{with_valid_text(array.info), array.values};
        state_->check_array(named, state_->mesh(mesh));
        if (!seen.insert(named.info.name).second) throw ciel::Error("array '" + named.info.name + "' is given twice");
    }
    for (const ArrayValues& array : arrays) add_values(array);
    end_step();
}

void Writer::begin_step(double time, std::size_t mesh, std::size_t coordinates) {
    State& state = *state_;
    state.take_back();
    const WrittenMesh& written = state.mesh(mesh);
    if (!std::isfinite(time)) throw ciel::Error("the time of a step must be a finite number");
    if (state.last_time && !(time > *state.last_time))
        throw ciel::Error("time " + std::to_string(time) + " is not later than the last step, which is at time " +
                          std::to_string(*state.last_time));
    if (coordinates >= written.attributes.coordinate_checksums.size())
        throw ciel::Error("mesh " + std::to_string(mesh) + " has no coordinate set " + std::to_string(coordinates));
    state.under_way = std::make_unique<StepUnderWay>(StepUnderWay{{time, mesh, coordinates, {}}, {}, {}});
}

void Writer::add_values(const ArrayValues& array) {
    State& state = *state_;
    if (!state.under_way) throw ciel::Error("array '" + array.info.name + "' belongs to no step; begin a step first");
    try {
        const ArrayInfo info = state.with_type(array.info, array.values);
        const MarkedStep& step = state.under_way->step;
        state.check_array({info, array.values}, state.mesh(step.mesh));
        if (step.arrays.count(info.name) > 0) throw ciel::Error("array '" + info.name + "' is given twice");
        state.put_values(info, converted(array.values, info.doubles));
    } catch (...) {
        state.take_back();
        throw;
    }
}

void Writer::add_late_step(double time, std::size_t mesh, std::size_t coordinates, std::span<const ArrayInfo> arrays) {
    begin_step(time, mesh, coordinates);
    StepUnderWay& under_way = *state_->under_way;
    for (const ArrayInfo& array : arrays) {
        ArrayInfo typed = with_valid_text(array);
        if (const ArrayInfo* known = state_->find(typed.name)) typed = *known;
        under_way.step.arrays.emplace(typed.name, MarkedArray{state_->mesh(mesh).steps, "", std::nullopt, true});
        under_way.arrays.push_back(std::move(typed));
    }
    end_step();
}

void Writer::end_step() {
    State& state = *state_;
    if (!state.under_way) throw ciel::Error("there is no step to end; begin a step first");
    try {
        state.place_extremes(state.under_way->step);
        state.check_used();
    } catch (...) {
        state.take_back();
        throw;
    }
    const double time = state.under_way->step.time;
    if (!state.appending()) {
        state.learn_arrays(*state.under_way);
        state.marker.steps.push_back(std::move(state.under_way->step));
        state.last_time = time;
        return state.under_way.reset();
    }
    const std::vector<WrittenMesh> meshes = state.meshes;
    const std::size_t known_meshes = state.marker.meshes;
    try {
        state.learn_arrays(*state.under_way);
        state.put_documents();
    } catch (...) {
        state.meshes = meshes;
        state.take_back();
        throw;
    }
    state.marker.meshes = state.meshes.size();
    state.marker.steps.push_back(state.under_way->step);
    state.under_way.reset(); // keeps the chunks if put throws, because put may have replaced the marker before
    try {
        state.commit().put(state.marker);
    } catch (...) {
        state.meshes = meshes;
        state.marker.meshes = known_meshes;
        state.marker.steps.pop_back();
        throw;
    }
    state.last_time = time;
    // The step is committed, so an error of this move is ignored. The next step tries the move again.
    try {
        (void)state.commit().move_steps_to_table(state.marker);
    } catch (const std::exception&) {
        state.commit().read_table_again(state.marker);
    }
}

} // namespace server::store
