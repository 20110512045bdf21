// Accepts or refuses a document as the next scene of a session. An accepted scene is a SceneVersion.
#pragma once

#include "scene/checked_scene.hpp"
#include "sessions/history.hpp"
#include "sessions/session_services.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>

namespace server::sessions {

using Clock = std::chrono::steady_clock;

// A SceneVersion is immutable.
struct SceneVersion {
    std::uint64_t revision = 0;
    Document document;
    scene::CheckedScene checked; // the parsed document with its dataset
    std::size_t bytes = 0;       // estimated heap bytes of the document and the parsed scene
    Clock::time_point changed;
    std::string request; // id of the request that made this version, for the log and for errors

    [[nodiscard]] const scene::Scene& scene() const { return checked.scene(); }
};

// Opens the document's dataset, and checks the names against it. Throws scene::Invalid, NotFound, LimitReached.
[[nodiscard]] std::shared_ptr<const SceneVersion> accept_scene(const SessionServices& services, nlohmann::json document,
                                                               std::uint64_t revision, std::string request);

} // namespace server::sessions
