// Undo and redo of one session's scene documents.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace server::sessions {

using Document = std::shared_ptr<const nlohmann::json>;

// History is not thread-safe; the session's mutex guards it. Copies share the documents.
class History {
public:
    // Keeps at most `steps` documents of at most `bytes` of heap memory, and drops the oldest.
    History(std::size_t steps, std::size_t bytes) : steps_(steps), most_bytes_(bytes) {}

    // Adds an undo step: the document `before` is about to be replaced. Drops all redo steps. Changes with the same
    // non-empty gesture are one step.
    void record(Document before, const std::string& gesture);
    // Both add the step that is farthest from the current document. Both return false if the limits leave no room.
    bool append_undo(Document document);
    bool append_redo(Document document);
    // Both return the document that replaces the current document `now`, or null if there is no step.
    [[nodiscard]] Document undo(Document now);
    [[nodiscard]] Document redo(Document now);
    [[nodiscard]] bool can_undo() const { return !undo_.empty(); }
    [[nodiscard]] bool can_redo() const { return !redo_.empty(); }
    [[nodiscard]] std::size_t bytes() const { return bytes_; } // heap bytes of all kept documents

private:
    struct KeptDocument {
        Document document;
        std::size_t bytes = 0;
    };
    using KeptDocuments = std::deque<KeptDocument>; // the last one is the nearest step

    void push(KeptDocuments& to, Document document);
    bool append(KeptDocuments& to, Document document);
    [[nodiscard]] Document pop(KeptDocuments& from);
    void forget_oldest(KeptDocuments& of);
    void keep_limits();

    std::size_t steps_, most_bytes_, bytes_ = 0;
    KeptDocuments undo_, redo_;
    std::string gesture_; // gesture of the last recorded change; empty: the next change is a separate step
};

} // namespace server::sessions
