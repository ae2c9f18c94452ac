// SPDX-License-Identifier: LGPL-2.1-or-later
#include "child_process.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace benchmark
{
namespace
{

static_assert(std::is_trivially_copyable_v<Outcome>);

//! Reads one outcome. \return its bytes that arrived in time; -1 after the limit.
ssize_t receive(int from, Outcome &outcome, double limit_s)
{
    pollfd waiting{from, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(1000.0 * limit_s)) == 0)
        return -1;
    return read(from, &outcome, sizeof outcome);
}

[[noreturn]] void work_and_leave(const std::function<Outcome()> &work, int to)
{
    const Outcome outcome = work();
    const bool sent = write(to, &outcome, sizeof outcome) == sizeof outcome;
    _exit(sent ? 0 : 1);
}

} // namespace

ChildResult run_in_child(const std::function<Outcome()> &work, double limit_s)
{
    int ends[2];
    if (pipe(ends) != 0)
        throw std::runtime_error("no pipe for a measurement");
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child < 0)
        throw std::runtime_error("no process for a measurement");
    if (child == 0)
        work_and_leave(work, ends[1]);
    close(ends[1]);
    ChildResult result;
    const ssize_t received = receive(ends[0], result.outcome, limit_s);
    close(ends[0]);
    if (received < 0)
        kill(child, SIGKILL);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    if (received != sizeof result.outcome)
    {
        result.outcome = Outcome{};
        std::strcpy(result.outcome.status, received < 0 ? "timeout" : "crash");
    }
    result.peak_mib = static_cast<double>(usage.ru_maxrss) / 1024.0;
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
    result.wall_ms = spent.count();
    return result;
}

} // namespace benchmark
