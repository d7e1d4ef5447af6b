// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "prompt.hpp"

#include "output.hpp"

#include <console/history.hpp>

#include <histedit.h>

#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <exception>
#include <sstream>
#include <utility>

#include <termios.h>
#include <unistd.h>

namespace oroforge::live_client {
namespace {

constexpr int kRemembered = 1000;

std::string historyFile() {
    const std::string given = OCL::console::fileNamedBy("ORO_HISTFILE");
    const char* const home = std::getenv("HOME");
    return !given.empty() || !home ? given : std::string(home) + "/.oro_history";
}

}  // namespace

struct Prompt::Impl {
    Impl(Wait waiting, Complete completion);
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
    int next(wchar_t* key);
    unsigned char completeLine();
    void prepareTerminal() const;

    const Wait wait;
    const Complete complete;
    OCL::console::History lines{historyFile()};
    EditLine* const edit;
    ::History* const remembered;
    std::string prompt;
    bool dropped = false;
    std::exception_ptr failure;  // must not pass through libedit, which is C
};

Prompt::Impl::Impl(Wait waiting, Complete completion)
    : wait(std::move(waiting)),
      complete(std::move(completion)),
      edit(el_init("oro", stdin, stdout, stderr)),
      remembered(history_init()) {
    std::setlocale(LC_CTYPE, "");
    if (std::strcmp(std::setlocale(LC_CTYPE, nullptr), "C") == 0) std::setlocale(LC_CTYPE, "C.UTF-8");
    HistEvent event;
    ::history(remembered, &event, H_SETSIZE, kRemembered);
    for (const std::string& line : lines.lines()) ::history(remembered, &event, H_ENTER, line.c_str());
    el_set(edit, EL_CLIENTDATA, this);
    el_set(edit, EL_PROMPT, &Impl::showPrompt);
    el_set(edit, EL_GETCFN, &Impl::readKey);
    el_set(edit, EL_HIST, &::history, remembered);
    el_set(edit, EL_EDITOR, "emacs");
    el_set(edit, EL_ADDFN, "oro-complete", "completes the word", &Impl::onTab);
    el_set(edit, EL_ADDFN, "oro-drop", "forgets the line", &Impl::onDrop);
    const char* const keys[][2] = {{"^I", "oro-complete"},       {"^C", "oro-drop"},
                                   {"^R", "em-inc-search-prev"}, {"\\e[1~", "ed-move-to-beg"},
                                   {"\\e[4~", "ed-move-to-end"}, {"\\e[3~", "ed-delete-next-char"}};
    for (const auto& key : keys) el_set(edit, EL_BIND, key[0], key[1], nullptr);
}

Prompt::Impl::~Impl() {
    el_end(edit);
    history_end(remembered);
}

/** libedit sets the terminal when it reads the first key; then Ctrl-C would be a signal until that. */
void Prompt::Impl::prepareTerminal() const {
    el_set(edit, EL_PREP_TERM, 1);
    termios mode = {};
    if (tcgetattr(STDIN_FILENO, &mode) != 0) return;
    mode.c_cc[VINTR] = _POSIX_VDISABLE;
    while (tcsetattr(STDIN_FILENO, TCSADRAIN, &mode) != 0 && errno == EINTR) {
    }
}

/** Gives libedit the next letter, which may have several bytes; 0 at the end. */
int Prompt::Impl::next(wchar_t* key) {
    std::mbstate_t state = {};
    try {
        for (;;) {
            wait();
            char byte = 0;
            const ssize_t got = ::read(STDIN_FILENO, &byte, 1);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return 0;
            const std::size_t used = std::mbrtowc(key, &byte, 1, &state);
            if (used == static_cast<std::size_t>(-1))
                state = {};  // no letter in this encoding
            else if (used != static_cast<std::size_t>(-2))
                return 1;
        }
    } catch (...) {
        failure = std::current_exception();
        return 0;
    }
}

unsigned char Prompt::Impl::completeLine() {
    const LineInfo* const now = el_line(edit);
    const std::string line(now->buffer, now->cursor);
    Words found;
    try {
        found = complete(line);
    } catch (...) {
        return CC_ERROR;  // without completions; what ended shows at the next key
    }
    if (!found.more.empty()) {
        el_insertstr(edit, found.more.c_str());
        return CC_REFRESH;
    }
    if (found.words.size() <= 1) return CC_ERROR;
    std::ostringstream list;
    list << '\n';
    OCL::console::writeColumns(list, found.words, Theme(), Style::Plain, "", Output(STDOUT_FILENO).width());
    std::fputs(list.str().c_str(), stdout);
    return CC_REDISPLAY;
}

Prompt::Prompt(Wait wait, Complete complete) : impl_(new Impl(std::move(wait), std::move(complete))) {}
Prompt::~Prompt() = default;

Prompt::Outcome Prompt::read(const std::string& prompt, std::string& line) {
    Impl& impl = *impl_;
    impl.prompt = prompt;
    impl.dropped = false;
    impl.failure = nullptr;
    impl.prepareTerminal();
    int count = 0;
    const char* const text = el_gets(impl.edit, &count);
    line = text && count > 0 ? std::string(text, static_cast<std::size_t>(count)) : "";
    el_set(impl.edit, EL_PREP_TERM, 0);
    if (impl.dropped) std::fputs("^C", stdout);
    if (impl.dropped || !text || count <= 0) std::fputs("\n", stdout);
    std::fflush(stdout);
    if (impl.failure) std::rethrow_exception(impl.failure);
    if (impl.dropped) return Outcome::Dropped;
    if (!text || count <= 0) return Outcome::End;
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    HistEvent event;
    if (impl.lines.add(line)) ::history(impl.remembered, &event, H_ENTER, line.c_str());
    return Outcome::Line;
}

}  // namespace oroforge::live_client
