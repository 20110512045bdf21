#include "sessions/history.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::sessions {
namespace {

// Uses a history as a session does, with numbers as documents.
struct Editor {
    explicit Editor(std::size_t steps, std::size_t bytes = 1 << 20) : history(steps, bytes) {}
    void change(const nlohmann::json& to, const std::string& gesture = "") {
        history.record(shown, gesture);
        shown = std::make_shared<const nlohmann::json>(to);
    }
    void undo() {
        if (const Document document = history.undo(shown)) shown = document;
    }
    void redo() {
        if (const Document document = history.redo(shown)) shown = document;
    }
    History history;
    Document shown = std::make_shared<const nlohmann::json>(0);
};

TEST(history, undo_and_redo) {
    Editor editor(10);
    EXPECT_FALSE(editor.history.can_undo());
    editor.change(1);
    editor.change(2);
    editor.undo();
    EXPECT_EQ(*editor.shown, 1);
    EXPECT_TRUE(editor.history.can_redo());
    editor.undo();
    EXPECT_EQ(*editor.shown, 0);
    EXPECT_FALSE(editor.history.can_undo());
    editor.undo();
    EXPECT_EQ(*editor.shown, 0);
    editor.redo();
    editor.redo();
    EXPECT_EQ(*editor.shown, 2);
    EXPECT_FALSE(editor.history.can_redo());
}

TEST(history, a_gesture_is_one_step) {
    Editor editor(10);
    editor.change(1);
    for (int value : {2, 3, 4}) editor.change(value, "drag 1");
    for (int value : {5, 6}) editor.change(value, "drag 2");
    editor.undo();
    EXPECT_EQ(*editor.shown, 4);
    editor.undo();
    EXPECT_EQ(*editor.shown, 1);
}

TEST(history, a_gesture_does_not_go_on_after_an_undo) {
    Editor editor(10);
    editor.change(1, "drag");
    editor.undo();
    editor.change(2, "drag");
    editor.undo();
    EXPECT_EQ(*editor.shown, 0);
}

TEST(history, changes_without_gesture_are_steps_of_their_own) {
    Editor editor(10);
    editor.change(1);
    editor.change(2);
    editor.undo();
    EXPECT_EQ(*editor.shown, 1);
}

TEST(history, a_change_forgets_what_could_be_redone) {
    Editor editor(10);
    editor.change(1);
    editor.undo();
    editor.change(2);
    EXPECT_FALSE(editor.history.can_redo());
}

TEST(history, keeps_as_many_steps_as_the_limit_says) {
    Editor editor(3);
    for (int value = 1; value <= 10; ++value) editor.change(value);
    int steps = 0;
    while (editor.history.can_undo()) {
        editor.undo();
        ++steps;
    }
    EXPECT_EQ(steps, 3);
    EXPECT_EQ(*editor.shown, 7);
}

std::string of_1000(int number) { return std::string(1000, static_cast<char>('a' + number)); }

TEST(history, forgets_the_oldest_beyond_its_bytes) {
    Editor editor(100, 5000);
    for (int number = 0; number < 20; ++number) {
        editor.change(of_1000(number));
        EXPECT_LE(editor.history.bytes(), 5000U);
    }
    EXPECT_GT(editor.history.bytes(), 4000U);
    for (int steps = 0; steps < 4; ++steps) editor.undo();
    EXPECT_EQ(*editor.shown, of_1000(15));
    EXPECT_FALSE(editor.history.can_undo());
    EXPECT_LE(editor.history.bytes(), 5000U);
    for (int steps = 0; steps < 4; ++steps) editor.redo();
    EXPECT_EQ(*editor.shown, of_1000(19)) << "what was undone is still there";
}

TEST(history, is_filled_from_the_nearest_step_on_as_far_as_its_limits_allow) {
    Editor editor(3);
    const auto document = [](int number) { return std::make_shared<const nlohmann::json>(number); };
    editor.change(10);
    EXPECT_TRUE(editor.history.append_undo(document(-1)));
    EXPECT_TRUE(editor.history.append_redo(document(11)));
    EXPECT_FALSE(editor.history.append_redo(document(12)));
    EXPECT_FALSE(editor.history.append_undo(document(-2)));
    editor.redo();
    EXPECT_EQ(*editor.shown, 11);
    for (int steps = 0; steps < 3; ++steps) editor.undo();
    EXPECT_EQ(*editor.shown, -1);
    EXPECT_FALSE(editor.history.can_undo());
}

TEST(history, a_document_larger_than_all_its_bytes_is_not_kept) {
    Editor editor(100, 500);
    editor.change(of_1000(0));
    editor.change(1);
    EXPECT_FALSE(editor.history.can_undo());
    EXPECT_EQ(editor.history.bytes(), 0U);
}

} // namespace
} // namespace server::sessions
