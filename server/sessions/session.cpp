#include "sessions/session.hpp"

#include "limits/errors.hpp"
#include "protocol/json.hpp"
#include "scene/document_size.hpp"
#include "sessions/notify.hpp"
#include "wire/frame_header.hpp"

#include <exception>

namespace server::sessions {
namespace {

std::string scene_changed(const std::string& session, const SceneVersion& version) {
    protocol::SceneChanged note{session, static_cast<std::int64_t>(version.revision), std::nullopt};
    note.scene.emplace(*version.document);
    std::string text = notification_text(note);
    if (text.size() <= wire::longest_message) return text;
    note.scene.reset(); // too long for one message; the client calls scene.get
    return notification_text(note);
}

// Passes the document after each patch to `take`, until `take` returns false or the text exceeds `most_bytes` bytes.
template <class Take>
void follow(nlohmann::json document, const std::vector<nlohmann::json>& patches, std::size_t most_bytes, Take take) {
    for (const nlohmann::json& patch : patches) {
        document = scene::merge_patch(std::move(document), patch);
        if (scene::text_bytes(document) > most_bytes) return;
        if (!take(std::make_shared<const nlohmann::json>(document))) return;
    }
}

// Sends a text to the connections `to` without `except` (0: none). Calls make_text() only if one of them is open.
void send(const OpenConnections& connections, const std::set<std::uint64_t>& to, std::uint64_t except,
          const std::function<std::string()>& make_text) {
    std::string text;
    for (const auto id : to) {
        if (id == except) continue;
        const auto connection = connections.find(id);
        if (!connection || !connection->send_text) continue;
        if (text.empty()) text = make_text();
        connection->send_text(text);
    }
}

} // namespace

Session::Session(std::string id, const SessionServices& services, std::shared_ptr<const SceneVersion> first,
                 const UndoRedoSteps& steps)
    : id_(std::move(id)), services_(services), version_(std::move(first)),
      history_(services.limits.undo_steps, services.limits.history_bytes),
      documents_(services.memory, limits::Held::scenes), used_(Clock::now()) {
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

SessionStatus Session::change(std::shared_ptr<const SceneVersion> next, History after, const Author& author) {
    documents_.change(next->bytes + after.bytes());
    version_ = std::move(next);
    history_ = std::move(after);
    used_ = Clock::now();
    tell_others(author.connection);
    for (const auto& [id, viewer] : viewers_) viewer.offer(version_);
    return current();
}

void Session::tell_others(std::uint64_t author) const {
    send(services_.connections, subscribers_, author, [this] { return scene_changed(id_, *version_); });
}

void Session::tell(const std::string& notification) const {
    const std::scoped_lock lock(mutex_);
    send(services_.connections, subscribers_, 0, [&] { return notification; });
}

SessionStatus Session::patch(const nlohmann::json& merge_patch, const std::string& gesture, const Author& author) {
    const std::scoped_lock lock(mutex_);
    auto next = accept_scene(services_, scene::merge_patch(*version_->document, merge_patch), version_->revision + 1,
                             author.request);
    if (*next->document == *version_->document) return current();
    History after = history_;
    after.record(version_->document, gesture);
    return change(std::move(next), std::move(after), author);
}

SessionStatus Session::replace(nlohmann::json document, const Author& author) {
    const std::scoped_lock lock(mutex_);
    auto next = accept_scene(services_, std::move(document), version_->revision + 1, author.request);
    if (*next->document == *version_->document) return current();
    History after = history_;
    after.record(version_->document, "");
    return change(std::move(next), std::move(after), author);
}

SessionStatus Session::undo(const Author& author) { return move_in_history(&History::undo, author); }
SessionStatus Session::redo(const Author& author) { return move_in_history(&History::redo, author); }

SessionStatus Session::move_in_history(Document (History::*move)(Document), const Author& author) {
    const std::scoped_lock lock(mutex_);
    History after = history_; // a copy, so that history_ stays unchanged if no step can be shown
    std::exception_ptr refused;
    Document document = version_->document;
    while ((document = (after.*move)(document))) {
        try {
            auto next = accept_scene(services_, *document, version_->revision + 1, author.request);
            return change(std::move(next), after, author);
        } catch (const std::exception&) { // the step's dataset was removed or has changed; tries the next step
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

void Session::add_viewer(std::uint32_t id, Viewer viewer) {
    const std::scoped_lock lock(mutex_);
    if (viewers_.size() >= services_.limits.views_per_session)
        throw limits::LimitReached("a session may have at most " + std::to_string(services_.limits.views_per_session) +
                                   " views; close a view first");
    viewer.offer(version_);
    viewers_[id] = std::move(viewer);
}

void Session::remove_viewer(std::uint32_t id) {
    const std::scoped_lock lock(mutex_);
    const auto found = viewers_.find(id);
    if (found == viewers_.end()) return;
    found->second.close();
    viewers_.erase(found);
}

void Session::disconnect(std::uint64_t connection) {
    const std::scoped_lock lock(mutex_);
    const bool was_here = subscribers_.erase(connection) > 0;
    std::erase_if(viewers_, [&](const auto& entry) {
        if (entry.second.connection != connection) return false;
        entry.second.close();
        return true;
    });
    if (was_here) used_ = Clock::now();
}

void Session::close() {
    const std::scoped_lock lock(mutex_);
    for (const auto& [id, viewer] : viewers_) viewer.close();
    viewers_.clear();
    subscribers_.clear();
}

void Session::dataset_changed() {
    const std::scoped_lock lock(mutex_);
    try {
        version_ = accept_scene(services_, *version_->document, version_->revision, version_->request);
    } catch (const std::exception&) {
        // The session keeps its version, whose data is still mapped and can be shown. The next patch reports the error.
    }
    for (const auto& [id, viewer] : viewers_) viewer.offer(version_);
}

bool Session::is_idle_since(Clock::time_point time) const {
    const std::scoped_lock lock(mutex_);
    return subscribers_.empty() && viewers_.empty() && used_ < time;
}

Clock::time_point Session::last_used() const {
    const std::scoped_lock lock(mutex_);
    return used_;
}

std::size_t Session::viewer_count() const {
    const std::scoped_lock lock(mutex_);
    return viewers_.size();
}

} // namespace server::sessions
