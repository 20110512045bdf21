// ciel serve [DATA ...]
#include "app/commands.hpp"
#include "app/import_view.hpp"
#include "app/limit_options.hpp"
#include "app/scene_options.hpp"
#include "ciel/parallel.hpp"
#include "ciel/types.hpp"
#include "gateway/gateway.hpp"
#include "render/renderer.hpp"
#include "session/server.hpp"
#include "store/import_missing.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace ciel::app {
namespace {

namespace fs = std::filesystem;

// Where a user's programs keep what they can make again.
fs::path default_import_folder() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
        return fs::path(cache) / "ciel";
    const char* home = std::getenv("HOME");
    return fs::path(home != nullptr ? home : ".") / ".cache" / "ciel";
}

struct ServeOptions {
    std::vector<fs::path> data;
    fs::path import_folder = default_import_folder();
    std::string gl = "auto", log_level = "info";
    ExtractionOptions extraction;
    unsigned render_workers = 1, threads = 0;
    session::Limits limits;
    bool allow_append = false;
    gateway::GatewayOptions gateway;
};

// One input that cannot be imported does not take the others with it; when none can, there is nothing to serve.
std::vector<store::Servable> import_what_is_foreign(const ServeOptions& options) {
    ImportView view(stderr); // stdout has the address alone
    CancelOnSignal signals;
    auto servable =
        store::import_missing(options.data, options.import_folder, {}, view.listener(), signals.cancelled());
    view.clear();
    signals.end();
    const auto failed = [](const store::Servable& each) { return !each.problem.empty(); };
    if (!servable.empty() && std::all_of(servable.begin(), servable.end(), failed)) throw Error(servable[0].problem);
    return servable;
}

// A folder is watched for datasets; what else lies in it is not imported unasked.
void warn_of_files_to_import(const fs::path& folder) {
    if (folder.extension() == ".ciel" || !fs::is_directory(folder)) return;
    fs::path first;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".ciel") return;
        if (entry.is_regular_file() && (first.empty() || entry.path() < first)) first = entry.path();
    }
    if (!first.empty())
        spdlog::warn("{} has no dataset (NAME.ciel); to have a file imported and served, name it: ciel serve {}",
                     folder.string(), first.string());
}

// Where the web client is when this program was built, and when it was installed.
fs::path find_webclient() {
    std::error_code failure;
    const fs::path folder = fs::read_symlink("/proc/self/exe", failure).parent_path();
    for (const char* relative : {"../webclient/dist", "webclient/dist", "../share/ciel/webclient"})
        if (fs::exists(folder / relative / "index.html", failure)) return folder / relative;
    return {};
}

void start_log(const std::string& level) {
    auto logger = spdlog::stderr_color_mt("ciel");
    logger->set_pattern("%Y-%m-%d %H:%M:%S.%e %^%l%$ %v");
    logger->set_level(spdlog::level::from_str(level));
    logger->flush_on(spdlog::level::info);
    spdlog::set_default_logger(std::move(logger));
}

// A token given by hand stays out of the process list and the shell's history in the environment.
void complete_token(gateway::GatewayOptions& options, bool allow_append) {
    if (const char* token = std::getenv("CIEL_TOKEN"); token != nullptr && options.token.empty()) options.token = token;
    const bool needs_one = allow_append || !gateway::is_loopback(options.host);
    if (options.token.empty() && needs_one) options.token = gateway::generate_token();
}

// The one line on stdout that scripts and people wait for.
void print_address(const gateway::GatewayOptions& options, const gateway::Listening& listening) {
    std::cout << "CIEL listening on http://" << listening.host << ':' << listening.port << listening.prefix << '/'
              << (options.token.empty() ? "" : "?token=" + options.token) << std::endl;
}

void log_renderer(session::Server& server) {
    const auto readiness = server.readiness();
    if (readiness.ready)
        spdlog::info("drawing with {} ({}, OpenGL {})", readiness.gl_renderer, readiness.backend, readiness.gl_version);
    else
        spdlog::error("cannot draw: {}", readiness.problem);
}

int serve(ServeOptions& options) {
    start_log(options.log_level);
    complete_token(options.gateway, options.allow_append);
    set_thread_count(options.threads);
    if (options.gateway.webclient.empty()) options.gateway.webclient = find_webclient();
    if (options.gateway.webclient.empty()) spdlog::warn("no web client found; name its folder with --webclient");

    session::ServerOptions server_options;
    const auto servable = import_what_is_foreign(options);
    for (const auto& each : servable)
        if (each.problem.empty()) server_options.data.push_back(each.path);
    server_options.backend = render::backend_named(options.gl);
    server_options.extraction = options.extraction.chosen();
    server_options.render_workers = options.render_workers;
    server_options.limits = options.limits;
    server_options.allow_append = options.allow_append;
    for (const auto& path : server_options.data) warn_of_files_to_import(path);
    session::Server server(std::move(server_options));
    for (const auto& each : servable)
        if (!each.problem.empty()) server.catalog().add_failed(each.path, each.problem);
    options.gateway.version = CIEL_VERSION;
    return gateway::serve(server, options.gateway, [&](const gateway::Listening& listening) {
        log_renderer(server);
        for (const auto& entry : server.catalog().list())
            entry.problem.empty() ? spdlog::info("dataset {}", entry.name)
                                  : spdlog::error("dataset {}: {}", entry.name, entry.problem);
        print_address(options.gateway, listening);
    });
}

} // namespace

void add_serve(CLI::App& app, Run& run) {
    auto options = std::make_shared<ServeOptions>();
    auto& gateway = options->gateway;
    CLI::App* command = app.add_subcommand("serve", "Serve datasets to browsers and scripts");
    command->add_option("DATA", options->data, "datasets (NAME.ciel), folders of them, or files to import first");
    command->add_option("--data-dir", options->import_folder, "where what is imported is kept")->capture_default_str();
    command->add_option("--host", gateway.host, "address to listen on; others than loopback need a token")
        ->capture_default_str();
    command->add_option("--port", gateway.port, "0: any free one")->capture_default_str();
    command->add_option("--prefix", gateway.prefix, "path below which a proxy offers the server, such as /ciel");
    command->add_option("--token", gateway.token, "what clients must know; also CIEL_TOKEN; generated when needed");
    command->add_option("--origin", gateway.origins,
                        "another site whose pages may use this server, such as https://example.org");
    command->add_option("--allowed-host", gateway.allowed_hosts, "a host name that a proxy in front is reached by");
    command->add_option("--gl", options->gl, "what draws")
        ->check(CLI::IsMember({"auto", "egl-device", "egl-surfaceless", "osmesa"}))
        ->capture_default_str();
    options->extraction.add_to(*command);
    command->add_option("--workers", options->render_workers, "frames drawn at the same time")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    command->add_option("--threads", options->threads, "threads of the extraction; 0: one per core")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command->add_flag("--allow-append", options->allow_append,
                      "let clients that send the token push steps to datasets (append.begin)");
    command->add_option("--webclient", gateway.webclient, "folder of the built web client");
    command->add_option("--log-level", options->log_level, "how much to log on stderr")
        ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
        ->capture_default_str();
    add_limits(*command, options->limits);
    command->callback([options, &run] { run = [options] { return serve(*options); }; });
}

} // namespace ciel::app
