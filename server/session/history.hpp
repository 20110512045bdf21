// Undo and redo of one session's scene documents.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace ciel::session {

using Document = std::shared_ptr<const nlohmann::json>;

// Not thread-safe: its session has a lock.
class History {
public:
    explicit History(std::size_t steps) : steps_(steps) {}

    // `before` is about to be replaced. Changes in a row with the same gesture (not empty) are one step. The oldest
    // step is forgotten when there are more than the limit.
    void record(Document before, const std::string& gesture);
    // The document to show, or null when there is none; `now` is what it replaces.
    [[nodiscard]] Document undo(Document now);
    [[nodiscard]] Document redo(Document now);
    [[nodiscard]] bool can_undo() const { return !undo_.empty(); }
    [[nodiscard]] bool can_redo() const { return !redo_.empty(); }

private:
    std::size_t steps_;
    std::deque<Document> undo_;
    std::vector<Document> redo_;
    std::string gesture_; // of the last recorded change; empty: the next change is a step of its own
};

} // namespace ciel::session
