// Undo and redo of one session's scene documents.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace ciel::sessions {

using Document = std::shared_ptr<const nlohmann::json>;

// Not thread-safe; the session locks. Copies share the documents.
class History {
public:
    // Drops the oldest documents beyond `steps` in number or `bytes` of heap.
    History(std::size_t steps, std::size_t bytes) : steps_(steps), most_bytes_(bytes) {}

    // Records `before`, which is about to be replaced. Consecutive changes with the same nonempty gesture are one step.
    void record(Document before, const std::string& gesture);
    // Adds a step before the oldest undo, or after the last redo step. Returns false if the limits leave no room.
    bool append_undo(Document document);
    bool append_redo(Document document);
    // Returns the document to show, or null if there is none. `now`: the current document, which it replaces.
    [[nodiscard]] Document undo(Document now);
    [[nodiscard]] Document redo(Document now);
    [[nodiscard]] bool can_undo() const { return !undo_.empty(); }
    [[nodiscard]] bool can_redo() const { return !redo_.empty(); }
    [[nodiscard]] std::size_t bytes() const { return bytes_; } // heap bytes of all documents kept

private:
    struct Step {
        Document document;
        std::size_t bytes = 0;
    };
    using Steps = std::deque<Step>; // the oldest first

    void push(Steps& to, Document document);
    bool append(Steps& to, Document document);
    [[nodiscard]] Document pop(Steps& from);
    void forget_oldest(Steps& of);
    void keep_limits();

    std::size_t steps_, most_bytes_, bytes_ = 0;
    Steps undo_, redo_;
    std::string gesture_; // of the last recorded change; empty: the next change is a step of its own
};

} // namespace ciel::sessions
