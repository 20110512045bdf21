// Undo and redo of one session's scene documents.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace ciel::sessions {

using Document = std::shared_ptr<const nlohmann::json>;

// Not thread-safe: its session has a lock. Copies share the documents.
class History {
public:
    // Beyond `steps` documents or `bytes` of heap the oldest are forgotten.
    History(std::size_t steps, std::size_t bytes) : steps_(steps), most_bytes_(bytes) {}

    // `before` is about to be replaced. Changes in a row with the same gesture (not empty) are one step.
    void record(Document before, const std::string& gesture);
    // Puts a step before the oldest, or behind the newest that can be redone; false where the limits leave no room.
    bool append_undo(Document document);
    bool append_redo(Document document);
    // The document to show, or null when there is none; `now` is what it replaces.
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
