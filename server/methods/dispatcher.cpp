#include "methods/dispatcher.hpp"

#include "engine/metrics.hpp"
#include "engine/schedule/slow_call_queue.hpp"
#include "methods/call_context.hpp"
#include "methods/error_answer.hpp"
#include "methods/raw_ids.hpp"
#include "methods/request.hpp"
#include "scene/document_size.hpp"
#include "scene/read_json.hpp"
#include "wire/frame_header.hpp"

#include <algorithm>
#include <future>

namespace server::methods {
namespace {

using nlohmann::json;
using Outcome = engine::SlowCallQueue::Outcome;

// Checked before parsing, so that no parser or destructor recurses deeper.
bool is_deeper_than(std::string_view text, std::size_t limit) {
    std::size_t depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            if (++depth > limit) return true;
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return false;
}

// Invalid UTF-8 is replaced, because a name from a file system may contain it.
std::string text_of(const json& answer) { return answer.dump(-1, ' ', false, json::error_handler_t::replace); }

// `id`: literal text that replaces the parsed id; empty if the parser has not changed the id.
std::string text_of(const json& answer, const std::string& id) {
    if (id.empty() || !answer["id"].is_number()) return text_of(answer);
    json rest = answer;
    rest.erase("id");
    return text_of(rest).insert(1, "\"id\":" + id + ",");
}

// The parser changes -0 and all numbers except 64-bit integers.
bool changes_id(const json& request) {
    const auto id = request.is_object() ? request.find("id") : request.end();
    if (!request.is_object() || id == request.end()) return false;
    return id->is_number_float() || (id->is_number_integer() && !id->is_number_unsigned() && *id == 0);
}

struct Read { // NOLINT(bugprone-exception-escape): moving a string does not throw
    json requests;
    std::vector<std::string> ids; // result of raw_ids(); empty if the parser changed no id
};

// Quick requests run on the current thread, slow requests in the queue of slow calls.
class Requests : public std::enable_shared_from_this<Requests> {
public:
    Requests(engine::Server& server, std::shared_ptr<sessions::Connection> connection, Read read, Answer answer)
        : connection_(std::move(connection)),
          cancellation_(connection_->stop, server.call_stop()), context_{server, *connection_, cancellation_.token()},
          is_batch_(read.requests.is_array()),
          requests_(is_batch_ ? std::move(read.requests) : json::array({std::move(read.requests)})),
          ids_(std::move(read.ids)), answer_(std::move(answer)), held_(server.memory(), limits::Held::answers),
          asked_(server.memory(), limits::Held::requests) {}

    void begin() {
        try {
            count(asked_, scene::heap_bytes(requests_));
        } catch (const limits::LimitReached&) {
            for (; next_ < requests_.size(); ++next_) {
                context_.begin();
                add(refuse(context_, requests_[next_]));
            }
            return finish();
        }
        go_on();
    }

private:
    void go_on() {
        for (; next_ < requests_.size(); ++next_) {
            if (!is_wanted())
                add(cancelled());
            else if (!is_slow(requests_[next_]))
                add(handle(context_, requests_[next_]));
            else if (enqueue_slow_request())
                return;
        }
        finish();
    }

    [[nodiscard]] bool is_wanted() const { return !cancelled_ && !context_.stop.stop_requested(); }

    bool enqueue_slow_request() {
        context_.begin();
        auto& slow_calls = context_.server.slow_calls();
        auto job = [self = shared_from_this()](Outcome outcome) { self->take(outcome); };
        try {
            if (was_queued_)
                slow_calls.post_next(connection_->id, std::move(job));
            else
                slow_calls.post(connection_->id, std::move(job));
            return true;
        } catch (...) {
            add(refuse(context_, requests_[next_]));
            return false;
        }
    }

    void take(Outcome outcome) {
        was_queued_ = true;
        cancelled_ = outcome == Outcome::cancelled;
        if (!turn_.is_again)
            turn_.waited = std::chrono::duration<double>(engine::Clock::now() - context_.begun).count();
        try {
            add(is_wanted() ? handle(context_, requests_[next_], turn_) : cancelled());
        } catch (const AwaitsStep&) {
            if (enqueue_again()) return;
        }
        turn_ = {};
        tries_ = 0;
        ++next_;
        go_on();
    }

    bool enqueue_again() {
        turn_.is_again = true;
        context_.making.note(0);
        auto job = [self = shared_from_this()](Outcome outcome) { self->take(outcome); };
        try {
            context_.server.slow_calls().post_after(engine::SlowCallQueue::pause_after(++tries_), connection_->id,
                                                    std::move(job));
            return true;
        } catch (...) {
            add(refuse(context_, requests_[next_]));
            return false;
        }
    }

    std::optional<json> cancelled() {
        context_.begin();
        try {
            throw ciel::Error("the call was cancelled: the connection has ended, or the server is about to stop");
        } catch (...) {
            return refuse(context_, requests_[next_]);
        }
    }

    // Short requests and answers pass when the server's memory is full, so that clients can close sessions.
    static void count(limits::Memory::Charge& charge, std::size_t bytes) {
        constexpr std::size_t always_accepted = 64 << 10;
        bytes <= always_accepted ? charge.note(bytes) : charge.change(bytes);
    }

    // Converts the answer to text at once, so that a batch holds no second copy of its answers.
    void add(std::optional<json> one) {
        if (!one) return context_.making.note(0);
        const std::string id = ids_.empty() ? std::string() : ids_[next_];
        answered_.push_back({(*one)["id"], id});
        const bool is_refusal = one->contains("error");
        try {
            const std::string text = text_of(*one, id);
            one.reset();
            context_.making.note(0);                    // append() counts the text
            constexpr std::size_t usual_refusal = 4096; // it is logged and counted, so no other refusal replaces it
            append(text, is_refusal && text.size() <= usual_refusal);
        } catch (...) { // the answer exceeds the limit of the batch or the server's memory
            context_.making.note(0);
            append(text_of(refuse(context_, requests_[next_]).value_or(json()), id), true);
        }
    }

    void append(const std::string& one, bool in_any_case = false) {
        const std::uint64_t limit = context_.server.limits().batch_answer_bytes;
        if (is_batch_ && !in_any_case && text_.size() + one.size() > limit)
            throw limits::LimitReached("the answers of this batch would have more than the " +
                                       std::to_string(limit >> 20) +
                                       " MB that a batch may have; send this request alone");
        const std::size_t bytes = text_.size() + one.size();
        in_any_case ? held_.note(bytes) : count(held_, bytes);
        if (is_batch_) text_ += text_.empty() ? '[' : ',';
        text_ += one;
    }

    void finish() {
        if (is_batch_ && !text_.empty()) text_ += ']';
        if (connection_->is_streaming() && text_.size() > wire::longest_message) refuse_as_too_long(text_.size());
        held_.note(0); // from here on, the sender counts the text
        answer_(std::move(text_));
    }

    // The error does not name the answer that made a batch too long, because this would not help the client.
    void refuse_as_too_long(std::size_t bytes) {
        const std::string reason = "the answer is " + std::to_string(bytes) +
                                   " bytes long, and a message on a WebSocket may have at most " +
                                   std::to_string(wire::longest_message) + " bytes; send the call with POST /rpc";
        const json error = refuse_text(context_, too_long_error(reason))["error"];
        text_.clear();
        for (const auto& [id, as_it_came] : answered_) {
            if (is_batch_) text_ += text_.empty() ? '[' : ',';
            text_ += text_of({{"jsonrpc", "2.0"}, {"id", id}, {"error", error}}, as_it_came);
        }
        if (is_batch_) text_ += ']';
        if (text_.size() > wire::longest_message) // the ids alone are too long
            text_ = text_of({{"jsonrpc", "2.0"}, {"id", nullptr}, {"error", error}});
    }

    struct Answered {
        json id;
        std::string as_it_came; // literal text of the id; empty if the parser has not changed it
    };
    const std::shared_ptr<sessions::Connection> connection_;
    Cancellation cancellation_;
    CallContext context_;
    const bool is_batch_;
    const json requests_;
    const std::vector<std::string> ids_;
    const Answer answer_;
    std::vector<Answered> answered_; // ids of the answers in text_
    std::string text_;
    limits::Memory::Charge held_, asked_; // count text_ and requests_
    std::size_t next_ = 0;
    Turn turn_;          // of the slow request that is handled now
    unsigned tries_ = 0; // runs of this request that waited for a late step
    bool was_queued_ = false, cancelled_ = false;
};

void note_ids(Read& read, std::string_view text, const std::map<std::size_t, std::string>& large) {
    const json& requests = read.requests;
    const bool changes_ids =
        requests.is_array() ? std::any_of(requests.begin(), requests.end(), changes_id) : changes_id(requests);
    if (changes_ids) read.ids = raw_ids(text);
    for (const auto& [request, id] : large) read.ids.at(request) = id;
}

// Throws the exceptions of json::parse, but accepts ids outside the range of a double.
void read_requests(const limits::Limits& limits, std::string_view text, Read& read) {
    try {
        read.requests = scene::read_json(text);
        note_ids(read, text, {});
    } catch (const json::out_of_range&) {
        const auto in_range = ids_in_range(text, limits.batch_requests);
        if (!in_range) throw;
        read.requests = scene::read_json(in_range->text);
        note_ids(read, in_range->text, in_range->large);
    }
}

std::optional<json> refusal(const limits::Limits& limits, std::string_view text, Read& read) {
    if (text.size() > limits.message_bytes)
        return limit_error("a message may have at most " + std::to_string(limits.message_bytes) +
                           " bytes; send a shorter message");
    if (is_deeper_than(text, limits.json_depth))
        return limit_error("JSON may be at most " + std::to_string(limits.json_depth) +
                           " levels deep; send a flatter message");
    try {
        read_requests(limits, text, read);
    } catch (const scene::TwiceNamed& error) {
        return invalid_request(error.what());
    } catch (const json::out_of_range&) {
        return parse_error("a number in the message is too large; the largest is about 1.8e308");
    } catch (const json::exception&) {
        return parse_error("the message is not valid JSON");
    }
    const json& requests = read.requests;
    if (!requests.is_array()) return {};
    if (requests.empty()) return invalid_request("a batch must not be empty; send at least one request");
    if (requests.size() > limits.batch_requests)
        return limit_error("a batch may have at most " + std::to_string(limits.batch_requests) +
                           " requests; send smaller batches");
    return {};
}

} // namespace

void dispatch(engine::Server& server, std::shared_ptr<sessions::Connection> connection, std::string_view text,
              Answer answer) {
    Read read;
    if (auto error = refusal(server.limits(), text, read)) {
        CallContext context{server, *connection};
        return answer(text_of(refuse_text(context, std::move(*error))));
    }
    std::make_shared<Requests>(server, std::move(connection), std::move(read), std::move(answer))->begin();
}

std::string dispatch(engine::Server& server, sessions::Connection& connection, std::string_view text) {
    // The promise is shared, because set_value may still run when this function returns.
    const auto answered = std::make_shared<std::promise<std::string>>();
    const std::shared_ptr<sessions::Connection> borrowed(std::shared_ptr<void>(), &connection);
    dispatch(server, borrowed, text, [answered](std::string answer) { answered->set_value(std::move(answer)); });
    return answered->get_future().get();
}

} // namespace server::methods
