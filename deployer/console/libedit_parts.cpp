// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "libedit_parts.hpp"

#include <cerrno>
#include <clocale>
#include <cstring>

#include <termios.h>
#include <unistd.h>

namespace OCL::console {
namespace {

constexpr int kRemembered = 1000;

void useEncodingOfTerminal() {
    const auto hasNone = [] { return std::strcmp(std::setlocale(LC_CTYPE, nullptr), "C") == 0; };
    if (hasNone()) std::setlocale(LC_CTYPE, "");
    if (hasNone()) std::setlocale(LC_CTYPE, "C.UTF-8");  // the usual encoding of terminals
}

}  // namespace

EditHistory::EditHistory(EditLine* edit, History& lines) : lines_(lines), remembered_(history_init()) {
    useEncodingOfTerminal();
    HistEvent event;
    ::history(remembered_, &event, H_SETSIZE, kRemembered);
    for (const std::string& line : lines.lines()) ::history(remembered_, &event, H_ENTER, line.c_str());
    el_set(edit, EL_HIST, &::history, remembered_);
}

EditHistory::~EditHistory() { history_end(remembered_); }

void EditHistory::add(const std::string& line) {
    HistEvent event;
    if (lines_.add(line)) ::history(remembered_, &event, H_ENTER, line.c_str());
}

void bindUsualKeys(EditLine* edit, unsigned char (*onTab)(EditLine*, int), unsigned char (*onDrop)(EditLine*, int)) {
    el_set(edit, EL_EDITOR, "emacs");
    el_set(edit, EL_ADDFN, "console-complete", "completes the word", onTab);
    el_set(edit, EL_ADDFN, "console-drop", "forgets the line", onDrop);
    const char* const keys[][2] = {{"^I", "console-complete"},   {"^C", "console-drop"},
                                   {"^R", "em-inc-search-prev"}, {"\\e[1~", "ed-move-to-beg"},
                                   {"\\e[4~", "ed-move-to-end"}, {"\\e[H", "ed-move-to-beg"},
                                   {"\\e[F", "ed-move-to-end"},  {"\\e[3~", "ed-delete-next-char"},
                                   {"\\e[1;5C", "em-next-word"}, {"\\e[1;5D", "ed-prev-word"}};
    for (const auto& key : keys) el_set(edit, EL_BIND, key[0], key[1], nullptr);
}

void prepareTerminal(EditLine* edit) {
    el_set(edit, EL_PREP_TERM, 1);
    termios mode = {};
    if (tcgetattr(STDIN_FILENO, &mode) != 0) return;
    mode.c_cc[VINTR] = _POSIX_VDISABLE;
    while (tcsetattr(STDIN_FILENO, TCSADRAIN, &mode) != 0 && errno == EINTR) {
    }
}

bool Letters::add(char byte, wchar_t& letter) {
    constexpr auto kNone = static_cast<std::size_t>(-1), kMore = static_cast<std::size_t>(-2);
    const bool begun = !std::mbsinit(&state_);
    std::size_t used = std::mbrtowc(&letter, &byte, 1, &state_);
    if (used == kNone) {
        state_ = {};
        if (begun) used = std::mbrtowc(&letter, &byte, 1, &state_);  // it may begin another letter
        if (used == kNone) {
            state_ = {};
            return false;
        }
    }
    return used != kMore;
}

std::string lineOf(const char* text, int count) {
    std::string line = text && count > 0 ? std::string(text, static_cast<std::size_t>(count)) : "";
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    return line;
}

}  // namespace OCL::console
