#include "draw/figure/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace wander::figure {

namespace {

constexpr char done = '+', failed = '-';  // what the child's message begins with

[[noreturn]] void fail(int error_number) {
  throw std::runtime_error(
      fmt::format("no process can be started: {}", std::generic_category().message(error_number)));
}

struct Pipe {
  int read_end, write_end;
};

Pipe open_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno);
  return {ends[0], ends[1]};
}

// Any error is that the other side is gone.
void send(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string receive(int descriptor) {
  std::string bytes;
  std::array<char, 1 << 16> piece{};
  for (;;) {
    const ssize_t got = read(descriptor, piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return bytes;
    bytes.append(piece.data(), static_cast<std::size_t>(got));
  }
}

// An end without destructors, which belong to the other process.
[[noreturn]] void be_the_child(const std::function<std::string()>& work, int to) {
  if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0)
    dup2(nowhere, STDERR_FILENO);
  std::string message;
  try {
    message = done + work();
  } catch (const std::bad_alloc&) {
    message = failed + std::generic_category().message(ENOMEM);
  } catch (const std::exception& problem) {
    message = failed + std::string(problem.what());
  }
  send(to, message);
  _exit(0);
}

int status_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) fail(errno);
  return status;
}

}  // namespace

std::string in_a_child(const std::function<std::string()>& work, const std::string& given_up) {
  const Pipe pipe = open_pipe();
  const pid_t child = fork();
  if (child == 0) be_the_child(work, pipe.write_end);
  const int reason = errno;
  close(pipe.write_end);
  std::string message = child > 0 ? receive(pipe.read_end) : "";
  close(pipe.read_end);
  if (child < 0) fail(reason);
  const int status = status_of(child);
  if (WIFSIGNALED(status)) throw std::runtime_error(given_up);
  if (message.empty()) throw std::runtime_error(given_up);
  const bool is_done = message.front() == done;
  message.erase(0, 1);
  if (!is_done) throw std::runtime_error(message);
  return message;
}

}  // namespace wander::figure
