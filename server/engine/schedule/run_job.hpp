// Runs a job on a thread that must survive the exceptions of the job.
#pragma once

#include "logging/log.hpp"

#include <exception>
#include <utility>

namespace server::engine {

// Jobs handle their own errors. An exception leaves a job only if no memory is left for its error message.
template <class Job>
void run_job(Job&& job) noexcept {
    try {
        try {
            std::forward<Job>(job)();
        } catch (const std::exception& error) {
            logging::log_event(logging::LogLevel::error, "a job was given up", {{"reason", error.what()}});
        }
    } catch (const std::exception&) { // there is no memory for the log line either
    }
}

} // namespace server::engine
