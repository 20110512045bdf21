#include "processes/child_process.hpp"

#include "ciel/types.hpp"
#include "store/files/files.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <optional>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace server::processes {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int poll_milliseconds = 50;
constexpr std::chrono::seconds patience{5};
constexpr std::size_t max_errors = 64 * 1024;
constexpr std::size_t max_line = 1024 * 1024;
constexpr int could_not_start = 127;
constexpr double silent_factor = 8; // longest time without a line of output, as a multiple of stalled_seconds

struct Pipe {
    store::Descriptor read, write;
};

Pipe make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw ciel::Error(std::string("cannot make a pipe: ") + std::strerror(errno));
    return {store::Descriptor(ends[0]), store::Descriptor(ends[1])};
}

void limit(int resource, rlim_t value) {
    const rlimit limits{value, value};
    ::setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

// Runs between fork and exec. Makes only async-signal-safe calls, because the parent has threads.
[[noreturn]] void become(char* const* arguments, const ChildLimits& limits, int output, int errors, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(could_not_start); // the parent died before prctl
    ::setpgid(0, 0);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(errors, STDERR_FILENO);
    sigset_t none_blocked;
    sigemptyset(&none_blocked);
    ::sigprocmask(SIG_SETMASK, &none_blocked, nullptr);
    ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC); // the sockets of a server, which Asio opens without O_CLOEXEC
    limit(RLIMIT_CORE, 0);
    if (limits.memory_bytes > 0) limit(RLIMIT_DATA, limits.memory_bytes);
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
        if (pid_ < 0) throw ciel::Error(arguments.at(0) + ": cannot be started: " + std::strerror(errno));
        if (pid_ == 0) become(pointers.data(), limits, output_.write.get(), errors_.write.get(), parent);
        output_.write = store::Descriptor();
        errors_.write = store::Descriptor();
    }
    ~Child() { // kills a child that still runs after an exception
        if (reaped_) return;
        signal(SIGKILL);
        reap(0);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    void signal(int number) const {
        if (!reaped_) ::kill(pid_, number);
    }

    // Returns false at the end of both streams.
    bool read(std::string& output, std::string& errors) {
        std::array<pollfd, 2> polled{pollfd{output_.read.get(), POLLIN, 0}, pollfd{errors_.read.get(), POLLIN, 0}};
        if (::poll(polled.data(), polled.size(), poll_milliseconds) < 0 && errno != EINTR) return false;
        if (polled[0].revents != 0) take(output_.read, output);
        if (polled[1].revents != 0) take(errors_.read, errors);
        return output_.read.get() >= 0 || errors_.read.get() >= 0;
    }

    // Returns the bytes read and written by the child (rchar + wchar); 0 if they are not known.
    [[nodiscard]] std::uint64_t transferred() const {
        std::ifstream counters("/proc/" + std::to_string(pid_) + "/io");
        std::uint64_t total = 0, count = 0;
        for (std::string name; counters >> name >> count;)
            if (name == "rchar:" || name == "wchar:") total += count;
        return total;
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
    static void take(store::Descriptor& from, std::string& to) {
        std::array<char, 4096> buffer{};
        const ssize_t count = ::read(from.get(), buffer.data(), buffer.size());
        if (count > 0)
            to.append(buffer.data(), static_cast<std::size_t>(count));
        else if (count == 0 || errno != EINTR)
            from = store::Descriptor(); // closes the descriptor; poll ignores a negative descriptor
    }

    Pipe output_, errors_;
    pid_t pid_ = -1;
    bool reaped_ = false;
};

double seconds_since(Clock::time_point time) { return std::chrono::duration<double>(Clock::now() - time).count(); }

class Watch {
public:
    Watch(const Child& child, const ChildLimits& limits, const std::atomic<bool>& cancel)
        : child_(child), limits_(limits), cancel_(cancel) {}

    void line_came() { last_line_ = last_transfer_ = Clock::now(); }

    void look(ChildEnd& end) {
        if (asked_) {
            if (Clock::now() - *asked_ > patience) child_.signal(SIGKILL);
            return;
        }
        if (cancel_)
            end.cancelled = true;
        else if (limits_.seconds > 0 && seconds_since(start_) > limits_.seconds)
            end.timed_out = true;
        else if (is_stalled())
            end.stalled = true;
        else
            return;
        child_.signal(SIGTERM);
        asked_ = Clock::now();
    }

private:
    bool is_stalled() {
        const double limit = limits_.stalled_seconds;
        if (limit <= 0 || seconds_since(last_transfer_) < limit) return false;
        const std::uint64_t now = child_.transferred();
        if (now == transferred_ || seconds_since(last_line_) > silent_factor * limit) return true;
        transferred_ = now;
        last_transfer_ = Clock::now();
        return false;
    }

    const Child& child_;
    const ChildLimits& limits_;
    const std::atomic<bool>& cancel_;
    Clock::time_point start_ = Clock::now(), last_line_ = start_, last_transfer_ = start_;
    std::optional<Clock::time_point> asked_;
    std::uint64_t transferred_ = 0;
};

void pass_lines(std::string& text, const std::function<void(std::string_view)>& on_line) {
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        on_line(std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
    }
    text.erase(0, begin);
    if (text.size() > max_line) text.clear(); // drops the text, because no valid line is that long
}

} // namespace

ChildEnd run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                   const std::function<void(std::string_view line)>& on_line, const std::atomic<bool>& cancel) {
    Child child(arguments, limits);
    Watch watch(child, limits, cancel);
    ChildEnd end;
    std::string output;
    const auto take_line = [&](std::string_view line) {
        watch.line_came();
        on_line(line);
    };
    while (child.read(output, end.errors)) {
        if (end.errors.size() > max_errors) end.errors.resize(max_errors);
        pass_lines(output, take_line);
        watch.look(end); // called after on_line, because on_line may set `cancel`
    }
    pass_lines(output, take_line);
    std::optional<int> status = child.reap(WNOHANG);
    for (; !status; status = child.reap(WNOHANG)) { // the child closed its streams but still runs
        watch.look(end);
        ::usleep(poll_milliseconds * 1000 / 10);
    }
    if (WIFEXITED(*status)) end.exit_code = WEXITSTATUS(*status);
    if (WIFSIGNALED(*status)) end.signal = WTERMSIG(*status);
    return end;
}

} // namespace server::processes
