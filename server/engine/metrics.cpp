#include "engine/metrics.hpp"

#include "engine/process_figures.hpp"

#include <algorithm>
#include <cstdio>
#include <locale>
#include <sstream>

namespace server::engine {
namespace {

void family(std::ostream& out, const char* name, const char* type, const char* help) {
    out << "# HELP " << name << ' ' << help << "\n# TYPE " << name << ' ' << type << '\n';
}

template <class Value>
void single(std::ostream& out, const char* name, const char* type, const char* help, Value value) {
    family(out, name, type, help);
    out << name << ' ' << value << '\n';
}

std::string escaped(const std::string& label) {
    std::string text;
    for (const char c : label) {
        if (c == '\\' || c == '"') text += '\\';
        text += c == '\n' ? ' ' : c;
    }
    return text;
}

#ifdef __clang__
constexpr const char* compiler = __VERSION__; // the text of Clang begins with "Clang"
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

} // namespace

void DurationHistogram::add(double seconds) {
    const auto bound = std::lower_bound(bounds.begin(), bounds.end(), seconds);
    ++counts_[static_cast<std::size_t>(bound - bounds.begin())];
    sum_ += seconds;
}

void DurationHistogram::write(std::ostream& out, const char* family, const std::string& labels) const {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        count += counts_[i];
        std::array<char, 16> bound{"+Inf"};
        if (i < bounds.size()) std::snprintf(bound.data(), bound.size(), "%g", bounds[i]);
        out << family << "_bucket{" << labels << ",le=\"" << bound.data() << "\"} " << count << '\n';
    }
    out << family << "_sum{" << labels << "} " << sum_ << '\n'
        << family << "_count{" << labels << "} " << count << '\n';
}

void Metrics::count_frame(bool still, std::size_t bytes, const FrameTimes& times) {
    ++(still ? stills_ : interactive_);
    bytes_ += bytes;
    const std::scoped_lock lock(mutex_);
    (still ? still_seconds_ : interactive_seconds_).add((times.extract + times.draw + times.encode) / 1000);
    seconds_.wait += times.wait / 1000;
    seconds_.extract += times.extract / 1000;
    seconds_.draw += times.draw / 1000;
    seconds_.encode += times.encode / 1000;
}

void Metrics::count_call(const std::string& method, double seconds) {
    const std::scoped_lock lock(mutex_);
    calls_[method].add(seconds);
}

void Metrics::count_picture(std::size_t bytes) {
    ++pictures_;
    bytes_ += bytes;
}

void Metrics::count_request(const std::string& method) {
    const std::scoped_lock lock(mutex_);
    ++requests_[method];
}

void Metrics::count_error(int code) {
    const std::scoped_lock lock(mutex_);
    ++errors_[code];
}

std::string Metrics::text(const Gauges& gauges) const {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    family(out, "ciel_frames_total", "counter", "Frames sent to views.");
    out << "ciel_frames_total{kind=\"interactive\"} " << interactive_ << "\nciel_frames_total{kind=\"still\"} "
        << stills_ << '\n';
    single(out, "ciel_frames_cancelled_total", "counter",
           "Frames cancelled: superseded, no longer wanted, or postponed.", cancelled_.load());
    single(out, "ciel_frames_failed_total", "counter", "Frames that failed.", failed_.load());
    single(out, "ciel_pictures_total", "counter", "Pictures returned by picture.render.", pictures_.load());
    single(out, "ciel_image_bytes_total", "counter", "Bytes of frames and pictures.", bytes_.load());

    const std::scoped_lock lock(mutex_);
    family(out, "ciel_frame_seconds_total", "counter", "Time spent on frames, by stage.");
    for (const auto& [stage, seconds] : {std::pair{"wait", seconds_.wait}, std::pair{"extract", seconds_.extract},
                                         std::pair{"draw", seconds_.draw}, std::pair{"encode", seconds_.encode}})
        out << "ciel_frame_seconds_total{stage=\"" << stage << "\"} " << seconds << '\n';
    family(out, "ciel_rpc_requests_total", "counter", "JSON-RPC requests, by method.");
    for (const auto& [method, count] : requests_)
        out << "ciel_rpc_requests_total{method=\"" << method << "\"} " << count << '\n';
    family(out, "ciel_rpc_errors_total", "counter", "JSON-RPC error answers, by code.");
    for (const auto& [code, count] : errors_) out << "ciel_rpc_errors_total{code=\"" << code << "\"} " << count << '\n';

    family(out, "ciel_call_duration_seconds", "histogram", "Time that JSON-RPC calls took, by method.");
    for (const auto& [method, durations] : calls_)
        durations.write(out, "ciel_call_duration_seconds", "method=\"" + method + "\"");
    family(out, "ciel_frame_duration_seconds", "histogram", "Time that frames took to extract, draw and encode.");
    interactive_seconds_.write(out, "ciel_frame_duration_seconds", "kind=\"interactive\"");
    still_seconds_.write(out, "ciel_frame_duration_seconds", "kind=\"still\"");

    single(out, "ciel_sessions", "gauge", "Sessions kept.", gauges.sessions);
    single(out, "ciel_connections", "gauge", "Open WebSockets.", gauges.connections);
    single(out, "ciel_views", "gauge", "Open views.", gauges.views);
    single(out, "ciel_frame_workers_busy", "gauge", "Workers that draw a frame or a picture.", gauges.busy_workers);
    single(out, "ciel_slow_calls", "gauge", "Slow calls (pictures, exports) that run.", gauges.slow_calls);
    single(out, "ciel_slow_calls_waiting", "gauge", "Slow calls (pictures, exports) that wait.",
           gauges.slow_calls_waiting);
    single(out, "ciel_session_bytes", "gauge", "Query state and surfaces of all sessions.", gauges.session_bytes);
    single(out, "ciel_datasets", "gauge", "Datasets in memory.", gauges.datasets);
    single(out, "ciel_dataset_bytes", "gauge", "Topologies and cached fields of all datasets.", gauges.dataset_bytes);
    family(out, "ciel_memory_bytes", "gauge", "Memory held for clients and datasets, by kind.");
    for (std::size_t i = 0; i < limits::held_names.size(); ++i)
        out << "ciel_memory_bytes{kind=\"" << limits::held_names[i] << "\"} " << gauges.held_bytes[i] << '\n';
    out << "ciel_memory_bytes{kind=\"datasets\"} " << gauges.dataset_bytes << '\n';
    single(out, "ciel_memory_limit_bytes", "gauge", "Limit on the sum of ciel_memory_bytes.", gauges.memory_limit);
    family(out, "ciel_gl_info", "gauge", "OpenGL renderer and back end.");
    out << "ciel_gl_info{renderer=\"" << escaped(gauges.gl_renderer) << "\",backend=\"" << escaped(gauges.backend)
        << "\"} 1\n";
    family(out, "ciel_build_info", "gauge", "Version and compiler of the program.");
    out << "ciel_build_info{version=\"" << escaped(gauges.version) << "\",compiler=\"" << escaped(compiler)
        << "\"} 1\n";
    write_process_figures(out);
    return out.str();
}

} // namespace server::engine
