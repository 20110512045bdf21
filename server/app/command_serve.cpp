// ciel serve [DATA ...]: imports what is needed and serves the datasets.
#include "app/commands.hpp"
#include "app/engine_service.hpp"
#include "app/import_folder.hpp"
#include "app/import_view.hpp"
#include "app/limit_options.hpp"
#include "app/scene_options.hpp"
#include "ciel/process_threads.hpp"
#include "ciel/types.hpp"
#include "engine/server.hpp"
#include "gateway/gateway.hpp"
#include "importing/import_missing.hpp"
#include "importing/late_step.hpp"
#include "importing/without_folder.hpp"
#include "logging/log.hpp"
#include "render/renderer.hpp"
#include "store/late_files.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <spdlog/spdlog.h>

namespace server::app {
namespace {

namespace fs = std::filesystem;

struct ServeOptions {
    std::vector<fs::path> data;
    fs::path import_folder = default_import_folder(), token_file;
    std::string gl = "auto", log_level = "info", log_format = "text";
    std::string file_access = "auto";
    ExtractionOptions extraction;
    unsigned render_workers = 1, threads = 0;
    int still_samples = frames::default_still_samples;
    limits::Limits limits;
    bool allow_append = false;
    gateway::GatewayOptions gateway;
};

// Imports the inputs that are not datasets. A failed import stops no other. Throws Error if all have failed.
std::vector<importing::Servable> import_what_is_foreign(const ServeOptions& options) {
    ImportView view(stderr); // stdout is only for print_address()
    CancelOnSignal signals;
    auto servable = importing::import_missing(options.data, options.import_folder,
                                              importing::import_limits_of_server(options.limits), view.listener(),
                                              signals.cancelled());
    view.clear();
    signals.end();
    const auto failed = [](const importing::Servable& each) { return !each.problem.empty(); };
    if (!servable.empty() && std::all_of(servable.begin(), servable.end(), failed))
        throw ciel::Error(servable[0].problem);
    return servable;
}

// The server finds new datasets in the folder, but imports other files only if the user names them.
void warn_of_files_to_import(const fs::path& folder) {
    if (folder.extension() == ".ciel" || !fs::is_directory(folder)) return;
    fs::path first;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".ciel") return;
        if (entry.is_regular_file() && (first.empty() || entry.path() < first)) first = entry.path();
    }
    if (first.empty())
        spdlog::warn("{} has no dataset (NAME.ciel) yet; a dataset that is put into the folder is served at once",
                     folder.string());
    else
        spdlog::warn("{} has no dataset (NAME.ciel); to import and serve a file, name the file: ciel serve {}",
                     folder.string(), first.string());
}

fs::path find_webclient() {
    std::error_code failure;
    const fs::path folder = fs::read_symlink("/proc/self/exe", failure).parent_path();
    for (const char* relative : {"../webclient/dist", "webclient/dist", "../share/ciel/webclient"})
        if (fs::exists(folder / relative / "index.html", failure)) return folder / relative;
    return {};
}

std::string token_in(const fs::path& file) {
    std::ifstream stream(file);
    std::string token;
    std::getline(stream, token);
    while (!token.empty() && std::isspace(static_cast<unsigned char>(token.back())) != 0) token.pop_back();
    if (token.empty())
        throw ciel::Error("the token file " + file.string() +
                          " cannot be read, or its first line is empty; name a readable file whose first line is the "
                          "token");
    std::error_code ignored;
    const auto others = fs::perms::group_read | fs::perms::others_read;
    if ((fs::status(file, ignored).permissions() & others) != fs::perms::none)
        spdlog::warn("other users can read the token file {}; set its permissions with chmod 600", file.string());
    return token;
}

// Unlike --token, --token-file and CIEL_TOKEN keep the token out of the process list and the history of the shell.
void complete_token(ServeOptions& options) {
    std::string& token = options.gateway.token;
    if (!options.token_file.empty()) token = token_in(options.token_file);
    if (const char* given = std::getenv("CIEL_TOKEN"); given != nullptr && token.empty()) {
        token = given;
        if (token.empty()) throw ciel::Error("CIEL_TOKEN is empty; give it a long random text, or unset it");
    }
}

// Scripts wait for this line, the only line on stdout. The stdout of a service goes to a log, which must not contain a
// token that stays valid. Therefore the line has the token only if the server generated the token at this start.
void print_address(const gateway::Listening& listening, bool token_is_given) {
    std::cout << "CIEL listening on http://" << listening.host << ':' << listening.port << listening.prefix << '/'
              << (token_is_given ? "" : "?token=" + listening.token) << std::endl;
}

void add_failed(engine::Server& server, const std::vector<importing::Servable>& servable) {
    for (const auto& each : servable) {
        if (each.problem.empty()) continue;
        spdlog::error("not imported: {}", each.problem);
        const std::string sentence = importing::without_folder(each.problem, each.input.parent_path());
        server.catalog().add_failed(each.path, importing::without_folder(sentence, each.path.parent_path()));
    }
}

void log_renderer(engine::Server& server) {
    const auto result = server.draw_test_picture();
    if (result.passed)
        spdlog::info("drawing with {} ({}, OpenGL {})", result.gl_renderer, result.backend, result.gl_version);
    else
        spdlog::error("cannot draw: {}", result.problem);
}

int serve(ServeOptions& options) {
    logging::start_log(options.log_level,
                       options.log_format == "json" ? logging::LogFormat::json : logging::LogFormat::text);
    complete_token(options);
    const bool token_is_given = !options.gateway.token.empty();
    ciel::set_thread_count(options.threads);
    if (options.gateway.webclient.empty()) options.gateway.webclient = find_webclient();
    if (options.gateway.webclient.empty())
        spdlog::warn("the web client was not found; name the folder of the web client with --webclient");

    engine::ServerOptions server_options;
    const auto servable = import_what_is_foreign(options);
    for (const auto& each : servable)
        if (each.problem.empty()) server_options.data.push_back(each.path);
    server_options.backend = render::backend_named(options.gl);
    server_options.extraction = options.extraction.chosen();
    if (options.file_access != "auto")
        server_options.file_access =
            options.file_access == "copied" ? store::FileAccess::read : store::FileAccess::mapped;
    server_options.render_workers = options.render_workers;
    server_options.still_samples = options.still_samples;
    server_options.limits = options.limits;
    server_options.allow_append = options.allow_append;
    for (const auto& path : server_options.data) warn_of_files_to_import(path);
    server_options.late_folder = late_folder_in(options.import_folder);
    store::remove_forgotten_late_files(server_options.late_folder);
    server_options.read_late_step =
        [folder = server_options.late_folder, limits = importing::import_limits_of_server(options.limits)](
            const store::Dataset& dataset, std::size_t step, const std::atomic<bool>& cancel) {
            return importing::read_late_step(dataset, step, folder, limits, cancel);
        };
    engine::Server server(std::move(server_options));
    add_failed(server, servable);
    options.gateway.version = CIEL_VERSION;
    EngineService service(server);
    return gateway::serve(service, options.gateway, [&](const gateway::Listening& listening) {
        log_renderer(server);
        for (const auto& entry : server.catalog().list())
            entry.problem.empty() ? spdlog::info("dataset {}", entry.name)
                                  : spdlog::error("dataset {}: {}", entry.name, entry.problem);
        print_address(listening, token_is_given);
    });
}

} // namespace

void add_serve(CLI::App& app, Run& run) {
    auto options = std::make_shared<ServeOptions>();
    auto& gateway = options->gateway;
    CLI::App* command = app.add_subcommand("serve", "Serve datasets to browsers and scripts.");
    command->add_option("DATA", options->data, "datasets (NAME.ciel), folders of them, or files to import first");
    command->add_option("--data-dir", options->import_folder, "folder of imported datasets")->capture_default_str();
    command->add_option("--host", gateway.host, "address to listen on")->capture_default_str();
    command->add_option("--port", gateway.port, "port to listen on; 0: any free port")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    command->add_option("--prefix", gateway.prefix, "path below which a proxy offers the server, such as /ciel");
    auto* token = command->add_option("--token", gateway.token,
                                      "token that every client must send. Other users see --token in the process list "
                                      "but not CIEL_TOKEN or --token-file. By default, a new token is made at each "
                                      "start, and on loopback the user who started the server needs no token");
    token->check([](const std::string& text) {
        return text.empty() ? "the token is empty; leave --token out, and the server makes a token" : std::string();
    });
    command->add_option("--token-file", options->token_file, "file that holds the token")->excludes(token);
    command->add_option("--origin", gateway.origins,
                        "another site whose pages may use this server, such as https://example.org");
    command->add_option("--allowed-host", gateway.allowed_hosts,
                        "host name under which clients reach a proxy in front of the server");
    command->add_option(
        "--trusted-proxy", gateway.trusted_proxies,
        "address or range (172.30.0.0/16) of a proxy in front of the server, whose X-Forwarded-For header is trusted");
    command->add_option("--gl", options->gl, "OpenGL back end")
        ->check(CLI::IsMember({"auto", "egl-device", "egl-surfaceless", "osmesa"}))
        ->capture_default_str();
    command
        ->add_option("--file-access", options->file_access,
                     "how records and values are read: mapped, so that all processes share the memory, or copied by "
                     "each process; auto: copied if they are on another machine (NFS, Lustre and others)")
        ->check(CLI::IsMember({"auto", "mapped", "copied"}))
        ->capture_default_str();
    options->extraction.add_to(*command);
    command->add_option("--workers", options->render_workers, "frames drawn at the same time")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    command
        ->add_option("--still-samples", options->still_samples,
                     "samples per pixel of full pictures; 1 draws several times faster in software, with jagged edges")
        ->check(CLI::IsMember({1, 2, 4, 8}))
        ->envname("CIEL_STILL_SAMPLES")
        ->capture_default_str();
    command->add_option("--threads", options->threads, "threads of the extraction; 0: one per core")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command->add_flag("--allow-append", options->allow_append,
                      "let clients that send the token append steps to datasets (append.begin)");
    command->add_option("--webclient", gateway.webclient, "folder of the built web client");
    command->add_option("--log-level", options->log_level, "log level on stderr")
        ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
        ->capture_default_str();
    command->add_option("--log-format", options->log_format, "format of the log; times are UTC")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    add_limits(*command, options->limits);
    command->callback([options, &run] { run = [options] { return serve(*options); }; });
}

} // namespace server::app
