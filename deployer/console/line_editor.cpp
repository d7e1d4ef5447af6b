// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "line_editor.hpp"

#include "table.hpp"

#include <histedit.h>

#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <cwchar>
#include <iostream>
#include <utility>

#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace OCL::console {
namespace {

// Around what moves no cursor in a prompt.
constexpr char kEscape = '\1';
constexpr int kRemembered = 1000;

volatile sig_atomic_t resized = 0;

void onResize(int) { resized = 1; }

/** With kEscape around the sequences of colours. */
std::string marked(const std::string& prompt) {
    std::string text;
    for (std::size_t at = 0; at < prompt.size();) {
        const std::size_t end = prompt[at] == '\033' ? prompt.find('m', at) : std::string::npos;
        if (end == std::string::npos) {
            text += prompt[at++];
            continue;
        }
        text += kEscape + prompt.substr(at, end + 1 - at) + kEscape;
        at = end + 1;
    }
    return text;
}

}  // namespace

std::size_t widthOfTerminal() {
    winsize size = {};
    return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 100;
}

struct LineEditor::Impl {
    Impl(History& history, Complete complete, int endsOn);
    ~Impl();

    static Impl& of(EditLine* edit) {
        void* self = nullptr;
        el_get(edit, EL_CLIENTDATA, &self);
        return *static_cast<Impl*>(self);
    }
    static char* showPrompt(EditLine* edit) { return of(edit).prompt.data(); }
    static int readKey(EditLine* edit, wchar_t* key) { return of(edit).next(key); }
    static unsigned char onTab(EditLine* edit, int) { return of(edit).completeLine(); }
    static unsigned char onDrop(EditLine* edit, int) {
        of(edit).dropped = true;
        return CC_NEWLINE;
    }
    void bindKeys();
    void prepareTerminal();
    int next(wchar_t* key);
    unsigned char completeLine();

    History& lines;
    const Complete complete;
    const int endsOn;
    EditLine* edit;
    ::History* remembered;
    std::string prompt;
    bool dropped = false, ended = false;  // of the present line
    struct sigaction previous = {};
};

LineEditor::Impl::Impl(History& history, Complete completion, int ends)
    : lines(history),
      complete(std::move(completion)),
      endsOn(ends),
      edit(el_init("console", stdin, stdout, stderr)),
      remembered(history_init()) {
    // Letters beyond ASCII are read and drawn as the user's terminal has them.
    if (std::strcmp(std::setlocale(LC_CTYPE, nullptr), "C") == 0) std::setlocale(LC_CTYPE, "");
    HistEvent event;
    ::history(remembered, &event, H_SETSIZE, kRemembered);
    for (const std::string& line : lines.lines()) ::history(remembered, &event, H_ENTER, line.c_str());
    el_set(edit, EL_CLIENTDATA, this);
    el_set(edit, EL_PROMPT_ESC, &Impl::showPrompt, kEscape);
    el_set(edit, EL_GETCFN, &Impl::readKey);
    el_set(edit, EL_HIST, &::history, remembered);
    bindKeys();
    struct sigaction action = {};
    action.sa_handler = onResize;
    sigaction(SIGWINCH, &action, &previous);
}

LineEditor::Impl::~Impl() {
    sigaction(SIGWINCH, &previous, nullptr);
    el_end(edit);
    history_end(remembered);
}

void LineEditor::Impl::bindKeys() {
    el_set(edit, EL_EDITOR, "emacs");
    el_set(edit, EL_ADDFN, "console-complete", "completes the word", &Impl::onTab);
    el_set(edit, EL_ADDFN, "console-drop", "forgets the line", &Impl::onDrop);
    const char* const keys[][2] = {{"^I", "console-complete"},   {"^C", "console-drop"},
                                   {"^R", "em-inc-search-prev"}, {"\\e[1~", "ed-move-to-beg"},
                                   {"\\e[4~", "ed-move-to-end"}, {"\\e[H", "ed-move-to-beg"},
                                   {"\\e[F", "ed-move-to-end"},  {"\\e[3~", "ed-delete-next-char"},
                                   {"\\e[1;5C", "em-next-word"}, {"\\e[1;5D", "ed-prev-word"}};
    for (const auto& key : keys) el_set(edit, EL_BIND, key[0], key[1], nullptr);
}

/** libedit does it only when the first key is read: what is typed as soon as the prompt is there would be seen twice. It cannot
    do without the key for SIGINT; it restores the terminal after the line. */
void LineEditor::Impl::prepareTerminal() {
    el_set(edit, EL_PREP_TERM, 1);
    termios mode = {};
    if (tcgetattr(STDIN_FILENO, &mode) != 0) return;
    mode.c_cc[VINTR] = _POSIX_VDISABLE;
    tcsetattr(STDIN_FILENO, TCSADRAIN, &mode);
}

/** A letter of the terminal, which may have several bytes. */
int LineEditor::Impl::next(wchar_t* key) {
    std::mbstate_t state = {};
    for (;;) {
        bool interrupted = false;
        if (!waitForInput(STDIN_FILENO, endsOn, interrupted)) {
            if (resized) {
                resized = 0;
                el_resize(edit);
            }
            if (interrupted) continue;
            ended = true;
            return 0;
        }
        char byte = 0;
        const ssize_t got = ::read(STDIN_FILENO, &byte, 1);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return 0;
        const std::size_t used = std::mbrtowc(key, &byte, 1, &state);
        if (used == static_cast<std::size_t>(-2)) continue;
        if (used != static_cast<std::size_t>(-1)) return 1;
        state = {};  // no letter of this encoding: forgotten
    }
}

unsigned char LineEditor::Impl::completeLine() {
    const LineInfo* const now = el_line(edit);
    const std::string line(now->buffer, now->cursor);
    const Completion found = complete(line);
    if (found.words.empty()) return CC_ERROR;
    const std::string more = found.common().substr(line.size() - found.begin);
    if (!more.empty()) {
        el_insertstr(edit, more.c_str());
        return CC_REFRESH;
    }
    if (found.words.size() == 1) return CC_ERROR;
    std::cout << '\n';
    writeColumns(std::cout, found.words, Theme(), Style::Plain, "", widthOfTerminal());
    std::cout.flush();
    return CC_REDISPLAY;
}

LineEditor::LineEditor(History& history, Complete complete, int endsOn)
    : impl_(new Impl(history, std::move(complete), endsOn)) {}

LineEditor::~LineEditor() = default;

LineSource::Outcome LineEditor::read(const std::string& prompt, std::string& line) {
    Impl& impl = *impl_;
    impl.prompt = marked(prompt);
    impl.dropped = impl.ended = false;
    if (resized) {
        resized = 0;
        el_resize(impl.edit);
    }
    impl.prepareTerminal();
    int count = 0;
    const char* const text = el_gets(impl.edit, &count);
    line = text && count > 0 ? std::string(text, static_cast<std::size_t>(count)) : "";
    if (impl.dropped) {
        std::cout << "^C\n" << std::flush;
        return Outcome::Dropped;
    }
    if (!text || count <= 0 || impl.ended) {
        std::cout << '\n' << std::flush;
        return Outcome::End;
    }
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    HistEvent event;
    if (impl.lines.add(line)) ::history(impl.remembered, &event, H_ENTER, line.c_str());
    return Outcome::Line;
}

}  // namespace OCL::console
