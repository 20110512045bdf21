// The scene document: everything that a view shows. Its schema is components/schemas/Scene in protocol/openrpc.json,
// from which the structures are generated. A change is an RFC 7396 merge patch.
#pragma once

#include "protocol/scene.hpp"

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>

namespace server::scene {

// Maximum number of bytes of a layer id, a title or a gesture. The limits in the contract count characters instead.
inline constexpr std::size_t most_name_bytes = 256;

// Thrown when a document breaks a rule. `path` is a JSON pointer (RFC 6901) to the offending member.
class Invalid : public std::runtime_error {
public:
    Invalid(std::string path_, const std::string& sentence) : std::runtime_error(sentence), path(std::move(path_)) {}
    std::string path;
};

// Returns the scene of a document. The layers are sorted by (order, id), without edges, contours and thresholds that
// are switched off. Throws Invalid. Does not check that arrays exist, because this check needs the dataset
// (checked_scene.hpp).
[[nodiscard]] Scene parse(const nlohmann::json& document);
// Applies a merge patch to the document. A null removes its member, because null and absent mean the same in a scene.
// The caller must check the result.
[[nodiscard]] nlohmann::json merge_patch(nlohmann::json document, const nlohmann::json& patch);
// Returns the merge patch that turns `from` into `to`. `to` must have no nulls.
[[nodiscard]] nlohmann::json diff(const nlohmann::json& from, const nlohmann::json& to);

} // namespace server::scene
