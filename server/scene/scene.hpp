// The scene document: everything that a view shows, as one JSON document. components/schemas/Scene in
// protocol/openrpc.json defines its form, defaults and limits. The structures are generated from this schema. A change
// is an RFC 7396 merge patch.
#pragma once

#include "protocol/scene.hpp"

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>

namespace ciel::scene {

// Maximum number of bytes of a layer id, a title or a gesture. The limits in the contract count characters instead.
inline constexpr std::size_t most_name_bytes = 256;

// Thrown when a document breaks a rule. `path` is a JSON pointer (RFC 6901) to the offending member.
class Invalid : public std::runtime_error {
public:
    Invalid(std::string path_, const std::string& sentence) : std::runtime_error(sentence), path(std::move(path_)) {}
    std::string path;
};

// Returns the scene of a document that satisfies its schema and the rules of rules.hpp. Its layers are sorted by
// (order, id), without edges, contours and thresholds that are switched off. Throws Invalid. Does not check that arrays
// exist, because this check needs the dataset (checked_scene.hpp).
[[nodiscard]] Scene parse(const nlohmann::json& document);
// Returns `document` with a merge patch (RFC 7396) applied. A null in the patch removes its member, because null and
// absent mean the same in a scene. The caller must check the result with parse() before it replaces the scene.
[[nodiscard]] nlohmann::json merge_patch(nlohmann::json document, const nlohmann::json& patch);
// Returns the merge patch that turns `from` into `to`. `to` must have no nulls.
[[nodiscard]] nlohmann::json diff(const nlohmann::json& from, const nlohmann::json& to);

} // namespace ciel::scene
