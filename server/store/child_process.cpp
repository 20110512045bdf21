#include "store/child_process.hpp"

#include "ciel/types.hpp"
#include "store/files.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ciel::store {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int poll_milliseconds = 50;
constexpr std::chrono::seconds patience{5};
constexpr std::size_t max_errors = 64 * 1024;
constexpr std::size_t max_line = 1024 * 1024;
constexpr int could_not_start = 127;

struct Pipe {
    Descriptor read, write;
};

Pipe make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw Error(std::string("cannot make a pipe: ") + std::strerror(errno));
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

void limit(int resource, rlim_t value) {
    const rlimit limits{value, value};
    ::setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

// Between fork and exec: only what is safe after a fork of a process with threads.
[[noreturn]] void become(char* const* arguments, const ChildLimits& limits, int output, int errors, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(could_not_start); // it died before the line above
    ::setpgid(0, 0);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(errors, STDERR_FILENO);
    sigset_t none_blocked;
    sigemptyset(&none_blocked);
    ::sigprocmask(SIG_SETMASK, &none_blocked, nullptr);
    limit(RLIMIT_CORE, 0);
    if (limits.memory_bytes > 0) limit(RLIMIT_AS, limits.memory_bytes);
    ::execv(arguments[0], arguments);
    ::_exit(could_not_start);
}

class Child {
public:
    Child(const std::vector<std::string>& arguments, const ChildLimits& limits)
        : output_(make_pipe()), errors_(make_pipe()) {
        std::vector<char*> pointers;
        pointers.reserve(arguments.size() + 1);
        for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
        pointers.push_back(nullptr);
        const pid_t parent = ::getpid();
        pid_ = ::fork();
        if (pid_ < 0) throw Error(arguments.at(0) + ": cannot be started: " + std::strerror(errno));
        if (pid_ == 0) become(pointers.data(), limits, output_.write.get(), errors_.write.get(), parent);
        output_.write = Descriptor();
        errors_.write = Descriptor();
    }
    ~Child() { // on the way out of an exception
        if (reaped_) return;
        signal(SIGKILL);
        reap(0);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    void signal(int number) const {
        if (!reaped_) ::kill(pid_, number);
    }

    // Waits for output at most a moment; false at the end of both streams.
    bool read(std::string& output, std::string& errors) {
        std::array<pollfd, 2> polled{pollfd{output_.read.get(), POLLIN, 0}, pollfd{errors_.read.get(), POLLIN, 0}};
        if (::poll(polled.data(), polled.size(), poll_milliseconds) < 0 && errno != EINTR) return false;
        if (polled[0].revents != 0) take(output_.read, output);
        if (polled[1].revents != 0) take(errors_.read, errors);
        return output_.read.get() >= 0 || errors_.read.get() >= 0;
    }

    std::optional<int> reap(int flags) {
        int status = 0;
        pid_t ended = 0;
        do ended = ::waitpid(pid_, &status, flags);
        while (ended < 0 && errno == EINTR);
        if (ended != pid_) return std::nullopt;
        reaped_ = true;
        return status;
    }

private:
    static void take(Descriptor& from, std::string& to) {
        std::array<char, 4096> buffer{};
        const ssize_t count = ::read(from.get(), buffer.data(), buffer.size());
        if (count > 0)
            to.append(buffer.data(), static_cast<std::size_t>(count));
        else if (count == 0 || errno != EINTR)
            from = Descriptor(); // poll ignores a negative descriptor
    }

    Pipe output_, errors_;
    pid_t pid_ = -1;
    bool reaped_ = false;
};

void pass_lines(std::string& text, const std::function<void(std::string_view)>& on_line) {
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        on_line(std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
    }
    text.erase(0, begin);
    if (text.size() > max_line) text.clear(); // no line is as long as that
}

} // namespace

ChildEnd run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                   const std::function<void(std::string_view line)>& on_line, const std::atomic<bool>& cancel) {
    const auto start = Clock::now();
    Child child(arguments, limits);
    ChildEnd end;
    std::string output;
    std::optional<Clock::time_point> asked;
    const auto watch = [&] {
        const auto now = Clock::now();
        const bool late = limits.seconds > 0 && std::chrono::duration<double>(now - start).count() > limits.seconds;
        if (!asked && (cancel || late)) {
            end.cancelled = cancel;
            end.timed_out = !cancel;
            child.signal(SIGTERM);
            asked = now;
        }
        if (asked && now - *asked > patience) child.signal(SIGKILL);
    };
    while (child.read(output, end.errors)) {
        watch();
        if (end.errors.size() > max_errors) end.errors.resize(max_errors);
        pass_lines(output, on_line);
    }
    pass_lines(output, on_line);
    std::optional<int> status = child.reap(WNOHANG);
    for (; !status; status = child.reap(WNOHANG)) { // it closed its streams but goes on
        watch();
        ::usleep(poll_milliseconds * 1000 / 10);
    }
    if (WIFEXITED(*status)) end.exit_code = WEXITSTATUS(*status);
    if (WIFSIGNALED(*status)) end.signal = WTERMSIG(*status);
    return end;
}

} // namespace ciel::store
