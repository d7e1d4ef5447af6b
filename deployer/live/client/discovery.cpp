// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "discovery.hpp"

#include "failure.hpp"
#include "short_path.hpp"

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <utility>

#include <dirent.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace oroforge::live_client {
namespace {

constexpr const char* kSuffix = ".sock";

bool exists(pid_t pid) { return kill(pid, 0) == 0 || errno != ESRCH; }

/** Whether only this user, or root, can have made what is in the folder. */
bool isTrusted(const std::string& folder) {
    struct stat found = {};
    if (lstat(folder.c_str(), &found) != 0 || !S_ISDIR(found.st_mode)) return false;
    return found.st_uid == geteuid() && (found.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

std::vector<std::string> filesOf(const std::string& folder) {
    std::vector<std::string> names;
    const std::unique_ptr<DIR, int (*)(DIR*)> open(opendir(folder.c_str()), closedir);
    if (!open) return names;
    while (const dirent* const entry = readdir(open.get())) names.emplace_back(entry->d_name);
    return names;
}

/** Whether nobody listens at the socket. */
bool refusesConnections(const std::string& path) {
    const ShortPath fits(path);
    sockaddr_un address = {};
    if (fits.text().size() >= sizeof address.sun_path) return false;
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, fits.text().c_str(), fits.text().size() + 1);
    const int probe = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (probe < 0) return false;
    const bool refused =
        connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 && errno == ECONNREFUSED;
    close(probe);
    return refused;
}

/** As in proc(5): 'R', 'S', 'T' …; 0 if that cannot be found out. */
char stateOf(pid_t pid) {
    std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
    std::string text;
    std::getline(in, text);
    const std::size_t name = text.rfind(')');  // the name of the process may have parentheses
    return name != std::string::npos && name + 2 < text.size() ? text[name + 2] : '\0';
}

/** "'arm' (pid 12), 'base' (pid 13)". */
std::string listed(const std::vector<Deployment>& all) {
    std::string text;
    for (const Deployment& one : all)
        text += (text.empty() ? "'" : ", '") + one.name + "' (pid " + std::to_string(one.pid) + ")";
    return text;
}

Deployment ofPath(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    Deployment one = fromFileName(path.substr(0, slash), path.substr(slash + 1));
    if (access(path.c_str(), F_OK) != 0)
        throw Failure(Status::NoDeployment, "there is no socket '" + path + "'; 'oro list' shows the deployments");
    one.socket = path;
    if (one.name.empty()) one.name = path;
    return one;
}

}  // namespace

std::string socketFolder() {
    const char* const session = std::getenv("XDG_RUNTIME_DIR");
    if (session && *session == '/') return std::string(session) + "/oroforge";
    return "/tmp/oroforge-" + std::to_string(geteuid());
}

Deployment fromFileName(const std::string& folder, const std::string& file) {
    const std::string suffix = kSuffix;
    const std::size_t hyphen = file.find('-');
    if (hyphen == 0 || hyphen == std::string::npos || file.size() <= hyphen + 1 + suffix.size()) return {};
    if (file.compare(file.size() - suffix.size(), suffix.size(), suffix) != 0) return {};
    const std::string number = file.substr(0, hyphen);
    constexpr std::size_t kDigits = 9;  // of a pid; more do not fit into one
    if (number.size() > kDigits || number.find_first_not_of("0123456789") != std::string::npos) return {};
    const auto pid = static_cast<pid_t>(std::atol(number.c_str()));
    if (pid <= 0) return {};
    return {pid, file.substr(hyphen + 1, file.size() - hyphen - 1 - suffix.size()), folder + "/" + file};
}

std::vector<Deployment> runningDeployments() {
    std::vector<Deployment> all;
    const std::string folder = socketFolder();
    if (!isTrusted(folder)) return all;
    for (const std::string& file : filesOf(folder)) {
        const Deployment one = fromFileName(folder, file);
        struct stat found = {};
        if (one.pid == 0 || lstat(one.socket.c_str(), &found) != 0 || !S_ISSOCK(found.st_mode)) continue;
        // A process of another container with the same folder has no number here, but listens.
        if (!exists(one.pid) && refusesConnections(one.socket))
            unlink(one.socket.c_str());
        else
            all.push_back(one);
    }
    std::sort(all.begin(), all.end(), [](const Deployment& a, const Deployment& b) {
        return std::make_pair(a.name, a.pid) < std::make_pair(b.name, b.pid);
    });
    return all;
}

Deployment chosenDeployment(const std::string& wanted) {
    if (wanted.find('/') != std::string::npos) return ofPath(wanted);
    const std::vector<Deployment> all = runningDeployments();
    if (all.empty())
        throw Failure(Status::NoDeployment, "no deployment is running in '" + socketFolder() +
                                                "'; start one with 'deployer', as the same user, "
                                                "with the same XDG_RUNTIME_DIR and without --no-live");
    std::vector<Deployment> matching;
    std::copy_if(all.begin(), all.end(), std::back_inserter(matching), [&](const Deployment& one) {
        return wanted.empty() || one.name == wanted || std::to_string(one.pid) == wanted;
    });
    // The number of a process that was killed may be that of another one now, as in a container that is started again.
    if (matching.size() > 1) {
        const auto left = std::remove_if(matching.begin(), matching.end(),
                                         [](const Deployment& one) { return refusesConnections(one.socket); });
        if (left != matching.begin()) matching.erase(left, matching.end());
    }
    if (matching.size() == 1) return matching.front();
    if (matching.empty()) {
        std::vector<std::string> names;
        for (const Deployment& one : all) names.push_back(one.name);
        throw Failure(Status::NoDeployment, "there is no deployment '" + wanted + "'" +
                                                diag::didYouMean(wanted, names) + "; running: " + listed(all));
    }
    throw Failure(Status::NoDeployment, (wanted.empty() ? "there is more than one deployment: "
                                                        : "there is more than one deployment '" + wanted + "': ") +
                                            listed(matching) + "; choose one with --deployment or ORO_DEPLOYMENT");
}

bool isStopped(pid_t pid) {
    const char state = stateOf(pid);
    return state == 'T' || state == 't';
}

bool hasEnded(pid_t pid) {
    const char state = stateOf(pid);
    return state == 'Z' || state == 'X' || (state == 0 && !exists(pid));
}

}  // namespace oroforge::live_client
