#pragma once
// Runs a program as a user does: its output, its errors, its exit code.

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace enfilade::test {

struct Outcome {
    int exit_code = -1;  ///< 128 + signal where one ended the program
    std::string out;
    std::string err;
};

/// Runs `words` (the program first, no shell) in `folder` to its end, without input.
[[nodiscard]] inline Outcome run_program(const std::vector<std::string>& words, const std::filesystem::path& folder) {
    std::array<int, 2> out_pipe;
    std::array<int, 2> err_pipe;
    if (pipe2(out_pipe.data(), O_CLOEXEC) != 0 || pipe2(err_pipe.data(), O_CLOEXEC) != 0)
        throw std::runtime_error("pipe");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out_pipe[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err_pipe[1], STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t child = 0;
    const int failed = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(out_pipe[1]);
    close(err_pipe[1]);
    if (failed != 0) throw std::runtime_error("cannot run " + words[0]);

    Outcome outcome;
    std::array<pollfd, 2> ends = {pollfd{out_pipe[0], POLLIN, 0}, pollfd{err_pipe[0], POLLIN, 0}};
    const std::array<std::string*, 2> texts = {&outcome.out, &outcome.err};
    for (int open_ends = 2; open_ends > 0;) {
        poll(ends.data(), ends.size(), -1);
        for (std::size_t i = 0; i < ends.size(); ++i) {
            if (ends[i].fd < 0 || ends[i].revents == 0) continue;
            std::array<char, 4096> buffer;
            const ssize_t size = read(ends[i].fd, buffer.data(), buffer.size());
            if (size > 0) {
                texts[i]->append(buffer.data(), std::size_t(size));
                continue;
            }
            close(ends[i].fd);
            ends[i].fd = -1;
            --open_ends;
        }
    }
    int status = 0;
    waitpid(child, &status, 0);
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
}

}  // namespace enfilade::test
