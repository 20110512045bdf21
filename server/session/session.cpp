#include "session/session.hpp"

#include "protocol/json.hpp"
#include "scene/document_size.hpp"
#include "session/errors.hpp"
#include "session/notify.hpp"
#include "session/open_dataset.hpp"
#include "session/view.hpp"
#include "wire/frame_header.hpp"

#include <algorithm>
#include <exception>

namespace ciel::session {
namespace {

void check_size(const nlohmann::json& document, const Limits& limits) {
    const std::size_t bytes = scene::text_bytes(document);
    if (bytes > limits.scene_bytes)
        throw LimitReached("the scene would have " + std::to_string(bytes) + " bytes; it may have at most " +
                           std::to_string(limits.scene_bytes) + ". Remove layers, values or patches from it");
}

void check_limits(const scene::Scene& scene, const Limits& limits) {
    if (scene.layers.size() > limits.layers)
        throw LimitReached("a scene may have at most " + std::to_string(limits.layers) + " layers; remove some");
    for (const scene::Layer& layer : scene.layers)
        if (const auto* iso = std::get_if<scene::IsoLayer>(&layer.kind))
            if (iso->values.size() > limits.values_per_layer)
                throw LimitReached("layer " + layer.id + " may have " + std::to_string(limits.values_per_layer) +
                                   " values; remove some");
}

} // namespace

std::shared_ptr<const SceneVersion> make_version(const Services& services, nlohmann::json document,
                                                 std::uint64_t revision) {
    auto version = std::make_shared<SceneVersion>();
    // Null and absent mean the same in a scene; a merge patch can only make the latter, so only the latter is kept.
    document = scene::merge_patch(nlohmann::json::object(), document);
    check_size(document, services.limits);
    version->scene = scene::parse(document);
    check_limits(version->scene, services.limits);
    version->loaded = open_dataset(services.catalog, version->scene.dataset);
    check_names(version->scene, *version->loaded->dataset());
    version->revision = revision;
    version->bytes = 2 * scene::heap_bytes(document); // parsed it has about as much
    version->document = std::make_shared<const nlohmann::json>(std::move(document));
    version->changed = Clock::now();
    return version;
}

namespace {

std::string scene_changed(const std::string& session, const SceneVersion& version) {
    protocol::SceneChanged note{session, static_cast<std::int64_t>(version.revision), std::nullopt};
    note.scene.emplace(*version.document);
    std::string text = notification_text(note);
    if (text.size() <= wire::longest_message) return text;
    note.scene.reset(); // the client asks for it
    return notification_text(note);
}

// The documents that the patches lead to, one after the other, as long as `take` returns true.
template <class Take>
void follow(nlohmann::json document, const std::vector<nlohmann::json>& patches, std::size_t most_bytes, Take take) {
    for (const nlohmann::json& patch : patches) {
        document = scene::merge_patch(std::move(document), patch);
        if (scene::text_bytes(document) > most_bytes) return;
        if (!take(std::make_shared<const nlohmann::json>(document))) return;
    }
}

} // namespace

Session::Session(std::string id, const Services& services, std::shared_ptr<const SceneVersion> first,
                 const Steps& steps)
    : id_(std::move(id)), services_(services), version_(std::move(first)),
      history_(services.limits.undo_steps, services.limits.history_bytes), documents_(services.memory, Held::scenes),
      used_(Clock::now()), scene_geometry_(services.extraction), surfaces_(services.memory, Held::surfaces) {
    const std::size_t most = services.limits.scene_bytes;
    follow(*version_->document, steps.undo, most, [&](Document step) { return history_.append_undo(std::move(step)); });
    follow(*version_->document, steps.redo, most, [&](Document step) { return history_.append_redo(std::move(step)); });
    documents_.change(version_->bytes + history_.bytes());
}

SessionStatus Session::current() const { return {version_, history_.can_undo(), history_.can_redo()}; }

SessionStatus Session::status() const {
    const std::scoped_lock lock(mutex_);
    used_ = Clock::now();
    return current();
}

std::shared_ptr<const SceneVersion> Session::newest() const {
    const std::scoped_lock lock(mutex_);
    return version_;
}

SessionStatus Session::change(std::shared_ptr<const SceneVersion> next, History after, std::uint64_t author) {
    documents_.change(next->bytes + after.bytes());
    version_ = std::move(next);
    history_ = std::move(after);
    used_ = Clock::now();
    tell_others(author);
    for (const auto& [id, view] : views_) view->offer(version_);
    return current();
}

void Session::tell_others(std::uint64_t author) const {
    std::string text;
    for (const auto connection_id : subscribers_) {
        if (connection_id == author) continue;
        const auto connection = services_.connections.find(connection_id);
        if (!connection || !connection->send_text) continue;
        if (text.empty()) text = scene_changed(id_, *version_);
        connection->send_text(text);
    }
}

SessionStatus Session::patch(const nlohmann::json& merge_patch, const std::string& gesture, std::uint64_t author) {
    const std::scoped_lock lock(mutex_);
    auto next = make_version(services_, scene::merge_patch(*version_->document, merge_patch), version_->revision + 1);
    if (*next->document == *version_->document) return current();
    History after = history_;
    after.record(version_->document, gesture);
    return change(std::move(next), std::move(after), author);
}

SessionStatus Session::replace(nlohmann::json document, std::uint64_t author) {
    const std::scoped_lock lock(mutex_);
    auto next = make_version(services_, std::move(document), version_->revision + 1);
    if (*next->document == *version_->document) return current();
    History after = history_;
    after.record(version_->document, "");
    return change(std::move(next), std::move(after), author);
}

SessionStatus Session::undo(std::uint64_t author) { return move_in_history(&History::undo, author); }
SessionStatus Session::redo(std::uint64_t author) { return move_in_history(&History::redo, author); }

SessionStatus Session::move_in_history(Document (History::*move)(Document), std::uint64_t author) {
    const std::scoped_lock lock(mutex_);
    History after = history_; // the old one stays when there is nothing that can be shown
    std::exception_ptr refused;
    Document document = version_->document;
    while ((document = (after.*move)(document))) {
        try {
            auto next = make_version(services_, *document, version_->revision + 1);
            return change(std::move(next), after, author);
        } catch (const std::exception&) { // its dataset is gone, or has other arrays: the step before may do
            if (!refused) refused = std::current_exception();
        }
    }
    if (refused) std::rethrow_exception(refused);
    return current();
}

void Session::subscribe(std::uint64_t connection) {
    const std::scoped_lock lock(mutex_);
    subscribers_.insert(connection);
    used_ = Clock::now();
}

void Session::add_view(const std::shared_ptr<View>& view) {
    const std::scoped_lock lock(mutex_);
    if (views_.size() >= services_.limits.views_per_session)
        throw LimitReached("a session may have " + std::to_string(services_.limits.views_per_session) +
                           " views; close one first");
    views_[view->id()] = view;
    view->offer(version_);
}

void Session::remove_view(std::uint32_t view) {
    const std::scoped_lock lock(mutex_);
    const auto found = views_.find(view);
    if (found == views_.end()) return;
    found->second->close();
    views_.erase(found);
}

void Session::disconnect(std::uint64_t connection) {
    const std::scoped_lock lock(mutex_);
    const bool was_here = subscribers_.erase(connection) > 0;
    std::erase_if(views_, [&](const auto& entry) {
        if (entry.second->connection_id() != connection) return false;
        entry.second->close();
        return true;
    });
    if (was_here) used_ = Clock::now();
}

void Session::close() {
    const std::scoped_lock lock(mutex_);
    for (const auto& [id, view] : views_) view->close();
    views_.clear();
    subscribers_.clear();
}

void Session::dataset_changed() {
    const std::scoped_lock lock(mutex_);
    try {
        if (open_dataset(services_.catalog, version_->scene.dataset) != version_->loaded)
            version_ = make_version(services_, *version_->document, version_->revision);
    } catch (const std::exception&) {
        // The scene does not fit what stands there now: the next patch is told so, and what is mapped can still be
        // shown.
    }
    for (const auto& [id, view] : views_) view->offer(version_);
}

std::shared_ptr<const Geometry> Session::geometry(const SceneVersion& version, const std::stop_token& stop,
                                                  bool moving) {
    const std::scoped_lock lock(geometry_mutex_);
    const std::uint64_t own = services_.limits.session_memory_bytes;
    const std::uint64_t left = surfaces_.bytes() + services_.memory.room();
    try {
        auto made = scene_geometry_.update(version.scene, version.loaded, stop, std::min(own, left), moving);
        charge_surfaces();
        return made;
    } catch (const LimitReached&) {
        forget_surfaces();
        if (left >= own) throw;
        throw LimitReached(services_.memory.refusal());
    }
}

void Session::charge_surfaces() {
    surface_bytes_ = scene_geometry_.memory_bytes();
    surfaces_.change(surface_bytes_);
}

void Session::forget_surfaces() {
    scene_geometry_ = SceneGeometry(services_.extraction);
    charge_surfaces();
}

void Session::release_geometry() {
    const std::scoped_lock lock(geometry_mutex_);
    forget_surfaces();
}

bool Session::is_idle_since(Clock::time_point time) const {
    const std::scoped_lock lock(mutex_);
    return subscribers_.empty() && views_.empty() && used_ < time;
}

Clock::time_point Session::last_used() const {
    const std::scoped_lock lock(mutex_);
    return used_;
}

std::size_t Session::view_count() const {
    const std::scoped_lock lock(mutex_);
    return views_.size();
}

} // namespace ciel::session
