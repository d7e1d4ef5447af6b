// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "prompt.hpp"

#include "output.hpp"

#include <console/libedit_parts.hpp>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <utility>

#include <termios.h>
#include <unistd.h>

namespace oroforge::live_client {
namespace {

std::string historyFile() {
    const std::string given = OCL::console::fileNamedBy("ORO_HISTFILE");
    const char* const home = std::getenv("HOME");
    return !given.empty() || !home ? given : std::string(home) + "/.oro_history";
}

}  // namespace

struct Prompt::Impl {
    Impl(Wait waiting, Complete completion);
    ~Impl();

    static Impl& of(EditLine* edit) { return OCL::console::ownerOf<Impl>(edit); }
    static char* showPrompt(EditLine* edit) { return of(edit).prompt.data(); }
    static int readKey(EditLine* edit, wchar_t* key) { return of(edit).next(key); }
    static unsigned char onTab(EditLine* edit, int) { return of(edit).completeLine(); }
    static unsigned char onDrop(EditLine* edit, int) {
        of(edit).dropped = true;
        return CC_NEWLINE;
    }
    int next(wchar_t* key);
    unsigned char completeLine();

    const Wait wait;
    const Complete complete;
    OCL::console::History history{historyFile()};
    EditLine* const edit;
    OCL::console::EditHistory lines;
    std::string prompt;
    bool dropped = false;
    std::exception_ptr failure;  // must not pass through libedit, which is C
};

Prompt::Impl::Impl(Wait waiting, Complete completion)
    : wait(std::move(waiting)),
      complete(std::move(completion)),
      edit(el_init("oro", stdin, stdout, stderr)),
      lines(edit, history) {
    el_set(edit, EL_CLIENTDATA, this);
    el_set(edit, EL_PROMPT, &Impl::showPrompt);
    el_set(edit, EL_GETCFN, &Impl::readKey);
    OCL::console::bindUsualKeys(edit, &Impl::onTab, &Impl::onDrop);
}

Prompt::Impl::~Impl() { el_end(edit); }

/** Gives libedit the next letter, which may have several bytes; 0 at the end. */
int Prompt::Impl::next(wchar_t* key) {
    OCL::console::Letters letters;
    try {
        for (;;) {
            wait();
            char byte = 0;
            const ssize_t got = ::read(STDIN_FILENO, &byte, 1);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return 0;
            if (letters.add(byte, *key)) return 1;
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
    OCL::console::prepareTerminal(impl.edit);
    int count = 0;
    const char* const text = el_gets(impl.edit, &count);
    line = OCL::console::lineOf(text, count);
    el_set(impl.edit, EL_PREP_TERM, 0);
    if (impl.dropped) std::fputs("^C", stdout);
    if (impl.dropped || !text || count <= 0) std::fputs("\n", stdout);
    std::fflush(stdout);
    if (impl.failure) std::rethrow_exception(impl.failure);
    if (impl.dropped) return Outcome::Dropped;
    if (!text || count <= 0) return Outcome::End;
    impl.lines.add(line);
    return Outcome::Line;
}

}  // namespace oroforge::live_client
