// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "output.hpp"

#include "failure.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace oroforge::live_client {
namespace {

constexpr std::size_t kUsualWidth = 100, kUsualHeight = 24;

bool hasColours(int descriptor) {
    const char* const terminal = std::getenv("TERM");
    const char* const none = std::getenv("NO_COLOR");
    return isatty(descriptor) && !(none && *none) && terminal && std::strcmp(terminal, "dumb") != 0;
}

/** Bytes of a character that turns the direction of the text around it; 0 if none is there. */
std::size_t sizeOfTurn(const std::string& text, std::size_t at) {
    if (text.compare(at, 2, "\xE2\x80") != 0 && text.compare(at, 2, "\xE2\x81") != 0) return 0;
    const auto last = at + 2 < text.size() ? static_cast<unsigned char>(text[at + 2]) : 0;
    const bool turns = text[at + 1] == '\x80' ? last >= 0xAA && last <= 0xAE : last >= 0xA6 && last <= 0xA9;
    return turns ? 3 : 0;
}

}  // namespace

Output::Output(int descriptor)
    : descriptor_(descriptor),
      terminal_(isatty(descriptor) != 0),
      theme_(hasColours(descriptor) ? Theme::Dark : Theme::NoColors) {}

void Output::write(const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t count = ::write(descriptor_, text.data() + done, text.size() - done);
        if (count > 0) {
            done += static_cast<std::size_t>(count);
        } else if (errno == EAGAIN) {
            pollfd room{descriptor_, POLLOUT, 0};
            poll(&room, 1, -1);
        } else if (errno == EPIPE) {
            throw NobodyReads();
        } else if (errno != EINTR) {
            throw Failure(Status::Refused, std::string("cannot write the output: ") + std::strerror(errno));
        }
    }
}

void Output::table(const Table& table, const std::string& indent) {
    std::ostringstream text;
    table.write(text, theme_, indent, tableWidth());
    write(text.str());
}

std::size_t Output::size(bool ofLine) const {
    winsize size = {};
    if (!terminal_ || ioctl(descriptor_, TIOCGWINSZ, &size) != 0) return ofLine ? kUsualWidth : kUsualHeight;
    const std::size_t found = ofLine ? size.ws_col : size.ws_row;
    return found ? found : ofLine ? kUsualWidth : kUsualHeight;
}

std::string printable(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const auto c = static_cast<unsigned char>(text[at]);
        const auto next = at + 1 < text.size() ? static_cast<unsigned char>(text[at + 1]) : 0;
        if (c == '\n' || c == '\t')
            result += ' ';
        else if (c < ' ' || c == 0x7F)
            result += '?';
        else if (c == 0xC2 && next >= 0x80 && next < 0xA0)  // the control characters beyond ASCII
            result += '?', ++at;
        else if (const std::size_t turns = sizeOfTurn(text, at))
            result += '?', at += turns - 1;
        else
            result += text[at];
    }
    return result;
}

}  // namespace oroforge::live_client
