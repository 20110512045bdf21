#include "session/history.hpp"

#include <utility>

namespace ciel::session {

void History::record(Document before, const std::string& gesture) {
    const bool continues = !gesture.empty() && gesture == gesture_;
    gesture_ = gesture;
    redo_.clear();
    if (continues) return;
    undo_.push_back(std::move(before));
    if (undo_.size() > steps_) undo_.pop_front();
}

Document History::undo(Document now) {
    if (undo_.empty()) return nullptr;
    gesture_.clear();
    redo_.push_back(std::move(now));
    Document shown = std::move(undo_.back());
    undo_.pop_back();
    return shown;
}

Document History::redo(Document now) {
    if (redo_.empty()) return nullptr;
    gesture_.clear();
    undo_.push_back(std::move(now));
    Document shown = std::move(redo_.back());
    redo_.pop_back();
    return shown;
}

} // namespace ciel::session
