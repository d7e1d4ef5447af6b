// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "tcp_session.hpp"

#include <algorithm>
#include <charconv>
#include <new>

namespace OCL::reporting {
namespace {

constexpr std::string_view kBlanks(" \t");
/** An empty backlog gives back more memory than this. */
constexpr std::size_t kKept = 256 * 1024;

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/** Upper case of ASCII, whatever the locale is. */
std::string upper(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return result;
}

bool isOneWord(std::string_view text) { return !text.empty() && text.find_first_of(kBlanks) == text.npos; }

}  // namespace

const TcpSession::Command TcpSession::kCommands[] = {
    {"VERSION", "1.0", &TcpSession::version, Command::Before},
    {"HELP", "[<command>]", &TcpSession::help, Command::Always},
    {"QUIT", "", &TcpSession::quit, Command::Always},
    {"EXIT", "", &TcpSession::quit, Command::Always},
    {"LISTEXTENSIONS", "", &TcpSession::listExtensions, Command::After},
    {"HEADERS", "", &TcpSession::headers, Command::After},
    {"SUBSCRIBE", "<name>", &TcpSession::subscribe, Command::After},
    {"UNSUBSCRIBE", "<name>", &TcpSession::unsubscribe, Command::After},
    {"SUBS", "", &TcpSession::subs, Command::After},
    {"SILENCE", "ON | OFF", &TcpSession::silence, Command::After},
    {"SETLIMIT", "<frame>", &TcpSession::setLimit, Command::After},
};

TcpSession::TcpSession(const std::vector<std::string>& names, const TcpLimits& limits)
    : names_(names), limits_(limits) {
    reply("100", "Orocos 1.0 TcpReporting Server 1.0");
}

void TcpSession::reply(std::string_view code, std::string_view rest) {
    out_ += code;
    if (!rest.empty()) (out_ += ' ') += rest;
    out_ += '\n';
}

void TcpSession::receive(std::string_view bytes) {
    if (ended_) return;
    in_ += bytes;
    executeLines();
}

void TcpSession::sent(std::size_t bytes) {
    sent_ += bytes;
    if (sent_ == out_.size()) {
        out_.clear();
        sent_ = 0;
        if (out_.capacity() > kKept) out_.shrink_to_fit();
    } else if (sent_ > out_.size() / 2) {
        out_.erase(0, sent_);
        sent_ = 0;
    }
    executeLines();
}

void TcpSession::executeLines() {
    std::size_t begin = 0;
    while (!ended_ && !full()) {
        const std::size_t end = in_.find('\n', begin);
        if (end == in_.npos) break;
        std::string_view line(in_.data() + begin, end - begin);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        const bool tooLong = tooLong_ || line.size() > limits_.line;
        tooLong_ = false;
        begin = end + 1;
        if (tooLong)
            reply("105", "Command not found");
        else
            execute(line);
    }
    in_.erase(0, begin);
    // With room for a CR.
    if (in_.size() > limits_.line + 1 && in_.find('\n') == in_.npos) tooLong_ = true;
    if (ended_ || (tooLong_ && in_.find('\n') == in_.npos)) in_.clear();
}

const TcpSession::Command* TcpSession::find(std::string_view name) const {
    for (const Command& command : kCommands)
        if (command.name == name) {
            const bool known = command.when == Command::Always || (command.when == Command::After) == greeted_;
            return known ? &command : nullptr;
        }
    return nullptr;
}

void TcpSession::execute(std::string_view line) {
    line = trimmed(line);
    const std::string_view name = line.substr(0, std::min(line.find_first_of(kBlanks), line.size()));
    const Command* const command = find(upper(name));
    if (!command) return reply("105", "Command not found");
    if ((this->*command->run)(trimmed(line.substr(name.size())))) return;
    reply("102", "Syntax: " + std::string(command->name) + (*command->syntax ? " " : "") + command->syntax);
}

// --- commands ------------------------------------------------------------------------------------------------------

bool TcpSession::version(std::string_view arguments) {
    if (!isOneWord(arguments)) return false;
    if (arguments != "1.0") {
        reply("106", "Not supported");
        return true;
    }
    greeted_ = true;
    silenced_ = false;
    reply("101", "OK");
    return true;
}

bool TcpSession::help(std::string_view arguments) {
    if (arguments.empty()) {
        reply("Use HELP <command>");
        for (const Command& command : kCommands)
            if (find(command.name)) reply(command.name);
        reply(".");
        return true;
    }
    if (!isOneWord(arguments)) return false;
    if (const Command* const command = find(upper(arguments))) {
        reply("Name:", command->name);
        reply("Usage:", std::string(command->name) + (*command->syntax ? " " : "") + command->syntax);
    } else {
        reply("105", "Command not found");
    }
    return true;
}

bool TcpSession::quit(std::string_view arguments) {
    if (!arguments.empty()) return false;
    out_ += "104 Bye bye";
    ended_ = true;
    return true;
}

bool TcpSession::listExtensions(std::string_view arguments) {
    if (arguments.empty()) reply("103", "none");
    return arguments.empty();
}

bool TcpSession::headers(std::string_view arguments) {
    if (!arguments.empty()) return false;
    for (const std::string& name : names_) reply("305", name);
    reply("306", "End of list");
    return true;
}

std::size_t TcpSession::indexOf(std::string_view name) const {
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
}

bool TcpSession::subscribe(std::string_view arguments) {
    const std::size_t index = indexOf(arguments);
    const bool known = index != names_.size();
    if (!known && !isOneWord(arguments)) return false;  // names may have blanks
    const bool fresh = known && std::find(subscribed_.begin(), subscribed_.end(), index) == subscribed_.end();
    if (fresh) subscribed_.push_back(index);
    reply(fresh ? "302" : "301", onOneLine(arguments));
    return true;
}

bool TcpSession::unsubscribe(std::string_view arguments) {
    const std::size_t index = indexOf(arguments);
    if (index == names_.size() && !isOneWord(arguments)) return false;
    const auto found = std::find(subscribed_.begin(), subscribed_.end(), index);
    const bool was = found != subscribed_.end();
    if (was) subscribed_.erase(found);
    reply(was ? "303" : "304", onOneLine(arguments));
    return true;
}

bool TcpSession::subs(std::string_view arguments) {
    if (!arguments.empty()) return false;
    for (const std::size_t index : subscribed_) reply("305", names_[index]);
    reply("306", "End of list");
    return true;
}

bool TcpSession::silence(std::string_view arguments) {
    const std::string wanted = upper(arguments);
    if (wanted != "ON" && wanted != "OFF") return false;
    silenced_ = wanted == "ON";
    reply("107", "Silence " + wanted);
    return true;
}

bool TcpSession::setLimit(std::string_view arguments) {
    std::uint64_t limit = 0;
    const char* const end = arguments.data() + arguments.size();
    const std::from_chars_result result = std::from_chars(arguments.data(), end, limit);
    if (result.ec != std::errc() || result.ptr != end) return false;
    limit_ = limit;
    limitTold_ = false;
    reply("101", "OK");
    return true;
}

// --- frames --------------------------------------------------------------------------------------------------------

bool TcpSession::appendFrame(const FrameText& row, const std::string& number) {
    const std::size_t before = out_.size();
    try {
        reply("201", number + " -- begin of frame");
        for (const std::size_t index : subscribed_) out_ += row.part(index);
        reply("203", number + " -- end of frame");
        if (before == sent_ || backlog().size() <= limits_.backlog) return true;
    } catch (const std::bad_alloc&) {
        // Dropped as for lack of room in the backlog.
    }
    out_.resize(before);
    return false;
}

bool TcpSession::addFrame(const FrameText& row) {
    if (!wantsFrames()) return true;
    bool room = true;
    if (limit_ == 0 || frame_ <= limit_) {
        room = appendFrame(row, std::to_string(frame_));
        ++frame_;
    }
    if (limit_ != 0 && frame_ > limit_ && !limitTold_) {
        limitTold_ = true;
        reply("204", "Limit reached");
    }
    return room;
}

}  // namespace OCL::reporting
