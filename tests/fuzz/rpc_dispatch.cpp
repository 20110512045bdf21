// Fuzzes a server without datasets with JSON-RPC messages: every answer is empty or valid JSON-RPC 2.0.
#include "engine/server.hpp"
#include "methods/dispatcher.hpp"

#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>

using nlohmann::json;

namespace {

bool is_answer(const json& answer) {
    return answer.is_object() && answer.value("jsonrpc", json()) == "2.0" && answer.contains("id") &&
           answer.contains("result") != answer.contains("error");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static server::engine::Server server({});
    static server::sessions::Connection connection;
    const std::string text = server::methods::dispatch(server, connection, {reinterpret_cast<const char*>(data), size});
    if (text.empty()) return 0;
    const json reply = json::parse(text, nullptr, false);
    bool good = reply.is_array() ? !reply.empty() : is_answer(reply);
    if (reply.is_array())
        for (const json& answer : reply) good = good && is_answer(answer);
    if (!good) std::abort();
    return 0;
}
