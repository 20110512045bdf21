#include "methods/error_answer.hpp"

#include "methods/call_context.hpp"
#include "store/files/files.hpp"

namespace server::methods {
namespace {

using nlohmann::json;

json error(int code, const char* message, const std::string& reason) {
    return {{"code", code}, {"message", message}, {"data", {{"reason", reason}}}};
}

json error_at(int code, const char* message, const std::string& path, const std::string& reason) {
    return {{"code", code}, {"message", message}, {"data", {{"path", path}, {"reason", reason}}}};
}

} // namespace

json parse_error(const std::string& reason) { return error(-32700, "Parse error", reason); }
json invalid_request(const std::string& reason) { return error(-32600, "Invalid Request", reason); }
json limit_error(const std::string& reason) { return error(protocol::Limit, "Limit exceeded", reason); }
json too_long_error(const std::string& reason) {
    return error(protocol::AnswerTooLong, "Answer too long for a WebSocket", reason);
}

json error_of_current_exception() {
    try {
        throw;
    } catch (const InvalidRequest& e) {
        return invalid_request(e.what());
    } catch (const MethodNotFound& e) {
        return error(-32601, "Method not found", e.what());
    } catch (const InvalidParams& e) {
        return error_at(-32602, "Invalid params", e.path, e.what());
    } catch (const scene::Invalid& e) {
        return error_at(protocol::InvalidScene, "Invalid scene", e.path, e.what());
    } catch (const limits::NotFound& e) {
        return error(protocol::NotFound, "Not found", e.what());
    } catch (const limits::LimitReached& e) {
        return limit_error(e.what());
    } catch (const limits::NotAllowed& e) {
        return error(protocol::NotAllowed, "Not allowed", e.what());
    } catch (const NeedsWebSocket& e) {
        return error(protocol::NeedsWebSocket, "Needs a WebSocket", e.what());
    } catch (const ciel::Error& e) {
        return error(protocol::Failed, "Failed", store::sentence_for_clients(e));
    } catch (const std::exception& e) {
        if (store::is_out_of_memory(e)) return limit_error(store::sentence_for_clients(e));
        return error(-32603, "Internal error", store::sentence_for_clients(e));
    } catch (...) {
        return error(-32603, "Internal error", "an exception of an unknown type");
    }
}

} // namespace server::methods
