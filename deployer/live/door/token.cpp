// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "token.hpp"

#include <rtt/os/descriptor.hpp>

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>

namespace OCL::live {

using RTT::os::detail::Descriptor;
namespace {

constexpr std::size_t kBytes = 16, kShortest = 16, kLongest = 256;
const char kAllowed[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~";

}  // namespace

std::string newToken() {
    unsigned char bytes[kBytes];
    if (::getrandom(bytes, sizeof bytes, 0) != static_cast<ssize_t>(sizeof bytes)) return std::string();
    std::string text;
    for (const unsigned char byte : bytes) {
        text += "0123456789abcdef"[byte >> 4U];
        text += "0123456789abcdef"[byte & 15U];
    }
    return text;
}

std::string readToken(const std::string& file, std::string& error) {
    const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat found {};
    if (!opened || ::fstat(opened.get(), &found) != 0) {
        error = std::string("the token cannot be read: ") + std::strerror(errno);
        return std::string();
    }
    if (!S_ISREG(found.st_mode) || (found.st_mode & 077U) != 0 || (found.st_uid != ::geteuid() && found.st_uid != 0)) {
        error = "the file of the token must belong to this user, and others must have no access: chmod 600";
        return std::string();
    }
    char bytes[kLongest + 2];
    const ssize_t size = ::read(opened.get(), bytes, sizeof bytes);
    const std::string text(bytes, size > 0 ? static_cast<std::size_t>(size) : 0);
    const std::string token = text.substr(0, text.find_first_of("\r\n"));
    if (token.size() >= kShortest && token.size() <= kLongest && token.find_first_not_of(kAllowed) == std::string::npos)
        return token;
    error = "the first line must be a token of 16 to 256 letters, digits, '-', '_', '.' and '~'";
    return std::string();
}

bool areEqual(std::string_view given, std::string_view expected) {
    unsigned differences = given.size() == expected.size() ? 0 : 1;
    for (std::size_t i = 0; i != expected.size(); ++i) {
        const char at = given.empty() ? '\0' : given[i % given.size()];
        differences |= static_cast<unsigned char>(at) ^ static_cast<unsigned char>(expected[i]);
    }
    // An empty token opens nothing.
    return differences == 0 && !expected.empty();
}

}  // namespace OCL::live
