#include "sessions/history.hpp"

#include "scene/document_size.hpp"

#include <utility>

namespace server::sessions {

void History::record(Document before, const std::string& gesture) {
    const bool continues = !gesture.empty() && gesture == gesture_;
    gesture_ = gesture;
    while (!redo_.empty()) forget_oldest(redo_);
    if (continues) return;
    push(undo_, std::move(before));
    keep_limits();
}

bool History::append_undo(Document document) { return append(undo_, std::move(document)); }
bool History::append_redo(Document document) { return append(redo_, std::move(document)); }

bool History::append(KeptDocuments& to, Document document) {
    const std::size_t bytes = scene::heap_bytes(*document);
    if (undo_.size() + redo_.size() >= steps_ || bytes_ + bytes > most_bytes_) return false;
    to.push_front({std::move(document), bytes});
    bytes_ += bytes;
    return true;
}

Document History::undo(Document now) {
    if (undo_.empty()) return nullptr;
    gesture_.clear();
    Document shown = pop(undo_);
    push(redo_, std::move(now));
    keep_limits();
    return shown;
}

Document History::redo(Document now) {
    if (redo_.empty()) return nullptr;
    gesture_.clear();
    Document shown = pop(redo_);
    push(undo_, std::move(now));
    keep_limits();
    return shown;
}

void History::push(KeptDocuments& to, Document document) {
    const std::size_t bytes = scene::heap_bytes(*document);
    to.push_back({std::move(document), bytes});
    bytes_ += bytes;
}

Document History::pop(KeptDocuments& from) {
    KeptDocument last = std::move(from.back());
    from.pop_back();
    bytes_ -= last.bytes;
    return std::move(last.document);
}

void History::forget_oldest(KeptDocuments& of) {
    bytes_ -= of.front().bytes;
    of.pop_front();
}

// First drops the oldest undo steps, then the redo steps that are farthest from the current document.
void History::keep_limits() {
    while (undo_.size() + redo_.size() > steps_ || bytes_ > most_bytes_) forget_oldest(undo_.empty() ? redo_ : undo_);
}

} // namespace server::sessions
