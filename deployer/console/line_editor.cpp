// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "line_editor.hpp"

#include "cursor_row.hpp"
#include "interrupts.hpp"
#include "kept_terminal.hpp"
#include "output_above.hpp"
#include "table.hpp"
#include "terminal_signals.hpp"

#include <histedit.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstring>
#include <cwchar>
#include <deque>
#include <exception>
#include <iterator>
#include <sstream>
#include <utility>

#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace OCL::console {
namespace {

// Put around parts of a prompt that do not move the cursor.
constexpr char kEscape = '\1';
constexpr int kRemembered = 1000;
// Milliseconds without output of other threads before the line is drawn again.
constexpr int kPauseOfOutput = 10;
// Milliseconds to wait for the other letters of a key.
constexpr int kPauseOfKeys = 20;

constexpr const char* kPasteBegins = "\\e[200~";
constexpr wchar_t kPasteEnds[] = L"\033[201~";
constexpr std::size_t kTab = 4;  // blanks for a tab

/** The prompt with kEscape around its colour sequences. */
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

bool canErase(EditLine* edit) {
    for (const char* const capability : {"up", "cd"}) {
        char name[3] = {};
        std::strcpy(name, capability);
        char* text = nullptr;
        if (el_get(edit, EL_GETTC, name, &text) != 0 || !text || !*text) return false;
    }
    return true;
}

}  // namespace

std::size_t widthOfTerminal() {
    winsize size = {};
    return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 100;
}

struct LineEditor::Impl {
    Impl(History& history, Complete complete, int endsOn, Echo echo);
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
    static unsigned char onPaste(EditLine* edit, int) { return of(edit).takePaste(); }
    void bindKeys();
    void prepareTerminal();
    int next(wchar_t* key);
    bool readLetter(wchar_t* key);
    void followSearch(wchar_t key);
    unsigned char takePaste();
    Wake waitForKey();
    unsigned char completeLine();
    CursorRow cursorAt(const wchar_t* end) const;
    std::size_t rowsAbove() const { return cursorAt(el_wline(edit)->cursor).row(); }
    std::string toEnd() const;
    void drawAnew(bool shown);
    void draw();

    History& lines;
    const Complete complete;
    const int endsOn;
    KeptTerminal kept;  // made before libedit changes the terminal
    EditLine* edit;
    ::History* remembered;
    const bool erases;
    OutputAbove above;
    TerminalSignals signals;
    std::string prompt;                   // with kEscape
    std::string shownPrompt;              // without
    bool dropped = false, ended = false;  // the present line
    bool searching = false;               // the history, since Ctrl-R
    std::deque<wchar_t> pasted;           // not yet taken
};

LineEditor::Impl::Impl(History& history, Complete completion, int ends, Echo echo)
    : lines(history),
      complete(std::move(completion)),
      endsOn(ends),
      edit(el_init("console", stdin, stdout, stderr)),
      remembered(history_init()),
      erases(canErase(edit)),
      above(erases),
      signals(above.descriptor()) {
    // Needed to read and draw letters beyond ASCII in the encoding of the terminal.
    const auto hasNone = [] { return std::strcmp(std::setlocale(LC_CTYPE, nullptr), "C") == 0; };
    if (hasNone()) std::setlocale(LC_CTYPE, "");
    if (hasNone()) std::setlocale(LC_CTYPE, "C.UTF-8");  // the usual encoding of terminals
    HistEvent event;
    ::history(remembered, &event, H_SETSIZE, kRemembered);
    for (const std::string& line : lines.lines()) ::history(remembered, &event, H_ENTER, line.c_str());
    el_set(edit, EL_CLIENTDATA, this);
    el_set(edit, EL_PROMPT_ESC, &Impl::showPrompt, kEscape);
    el_set(edit, EL_GETCFN, &Impl::readKey);
    el_set(edit, EL_HIST, &::history, remembered);
    bindKeys();
    // Also while commands are executed: echoed keys would mix with their output and with the next prompt.
    if (echo == Echo::Lines) el_set(edit, EL_SETTY, "-x", "-echo", nullptr);
}

LineEditor::Impl::~Impl() {
    el_set(edit, EL_EDITMODE, 0);  // it would drop keys that were typed meanwhile; `kept` restores the terminal
    el_end(edit);
    history_end(remembered);
}

void LineEditor::Impl::bindKeys() {
    el_set(edit, EL_EDITOR, "emacs");
    el_set(edit, EL_ADDFN, "console-complete", "completes the word", &Impl::onTab);
    el_set(edit, EL_ADDFN, "console-drop", "forgets the line", &Impl::onDrop);
    el_set(edit, EL_ADDFN, "console-paste", "takes what is pasted", &Impl::onPaste);
    const char* const keys[][2] = {
        {"^I", "console-complete"},   {"^C", "console-drop"},       {kPasteBegins, "console-paste"},
        {"^R", "em-inc-search-prev"}, {"\\e[1~", "ed-move-to-beg"}, {"\\e[4~", "ed-move-to-end"},
        {"\\e[H", "ed-move-to-beg"},  {"\\e[F", "ed-move-to-end"},  {"\\e[3~", "ed-delete-next-char"},
        {"\\e[1;5C", "em-next-word"}, {"\\e[1;5D", "ed-prev-word"}};
    for (const auto& key : keys) el_set(edit, EL_BIND, key[0], key[1], nullptr);
}

/**
 * Sets the terminal before the prompt: libedit does so only when it reads the first key, so keys typed before that
 * would be shown twice. Also disables the key for SIGINT, which libedit cannot; it restores the terminal after the
 * line.
 */
void LineEditor::Impl::prepareTerminal() {
    el_set(edit, EL_PREP_TERM, 1);
    termios mode = {};
    if (tcgetattr(STDIN_FILENO, &mode) != 0) return;
    mode.c_cc[VINTR] = _POSIX_VDISABLE;
    while (tcsetattr(STDIN_FILENO, TCSADRAIN, &mode) != 0 && errno == EINTR) {
    }
}

/** Gives libedit the next key; 0 at the end of the input. */
int LineEditor::Impl::next(wchar_t* key) {
    if (!pasted.empty() && !isReadable(endsOn)) {
        *key = pasted.front();
        pasted.pop_front();
        return 1;
    }
    if (!readLetter(key)) return 0;
    followSearch(*key);
    return 1;
}

/** A search ends at the first letter of an arrow key, whose other letters would go into the line. */
void LineEditor::Impl::followSearch(wchar_t key) {
    constexpr wchar_t kEscapeKey = L'\033', kKeysOfSearch[] = {L'\022', L'\023', L'\b', L'\027'};
    const bool opens = key == kKeysOfSearch[0] || key == kKeysOfSearch[1];
    const bool more = std::find(std::begin(kKeysOfSearch), std::end(kKeysOfSearch), key) != std::end(kKeysOfSearch);
    if (searching && key == kEscapeKey && waitForInput(STDIN_FILENO, -1, -1, kPauseOfKeys) == Wake::Input)
        pasted.push_front(kEscapeKey);
    searching = opens || (searching && (key >= L' ' || more));
}

/** Reads a letter, which may have several bytes, from the terminal. */
bool LineEditor::Impl::readLetter(wchar_t* key) {
    std::mbstate_t state = {};
    for (;;) {
        const Wake woken = waitForKey();
        if (woken == Wake::Signal) continue;
        if (woken == Wake::End) {
            ended = true;
            if (!maySetTerminal()) el_set(edit, EL_EDITMODE, 0);  // it would stop the process
            return false;
        }
        char byte = 0;
        const ssize_t got = ::read(STDIN_FILENO, &byte, 1);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        const bool begun = !std::mbsinit(&state);
        std::size_t used = std::mbrtowc(key, &byte, 1, &state);
        if (used == static_cast<std::size_t>(-1)) {
            // Not a letter in this encoding: dropped, unless the byte begins another letter.
            state = {};
            if (begun) used = std::mbrtowc(key, &byte, 1, &state);
            if (!begun || used == static_cast<std::size_t>(-1)) {
                state = {};
                continue;
            }
        }
        if (used != static_cast<std::size_t>(-2)) return true;
    }
}

/** Takes pasted text. Its lines are executed as if typed, but its letters are not keys: a tab completes nothing. */
unsigned char LineEditor::Impl::takePaste() {
    std::wstring text;
    const std::wstring end = kPasteEnds;
    for (wchar_t letter = 0; readLetter(&letter);) {
        text += letter;
        if (text.size() < end.size() || text.compare(text.size() - end.size(), end.size(), end) != 0) continue;
        text.resize(text.size() - end.size());
        break;
    }
    for (const wchar_t letter : text) {
        if (letter == L'\t')
            pasted.insert(pasted.end(), kTab, L' ');
        else if (letter == L'\r' || letter == L'\n')
            pasted.push_back(L'\r');
        else if (letter >= L' ' && letter != L'\177')
            pasted.push_back(letter);
    }
    return CC_NORM;
}

/** Lets other threads write while it waits; draws the line again when they pause. */
Wake LineEditor::Impl::waitForKey() {
    for (bool shown = true;;) {
        above.unlock(rowsAbove(), shown);
        const Wake woken = shown ? waitForInput(STDIN_FILENO, endsOn, above.descriptor())
                                 : waitForInput(STDIN_FILENO, endsOn, -1, kPauseOfOutput);
        shown = above.lock();
        if (woken == Wake::End) return woken;
        if (signals.any() || (!shown && woken != Wake::Other)) {
            drawAnew(shown);
            shown = true;
        }
        if (woken != Wake::Other && woken != Wake::Time) return woken;
    }
}

/** Draws the line again after it was removed from the screen or changed there. */
void LineEditor::Impl::drawAnew(bool shown) {
    if (signals.takeResumed()) {
        // Another program may have changed the terminal and moved the cursor.
        el_set(edit, EL_PREP_TERM, 0);
        prepareTerminal();
        if (erases) std::fputs(kMarkPaste, stdout);
        if (shown) above.erase(0);
    } else if (shown) {
        above.erase(rowsAbove());  // most terminals have wrapped the line
    }
    if (signals.takeResized()) el_resize(edit);
    draw();
}

/** The position of the cursor at that place of the line. */
CursorRow LineEditor::Impl::cursorAt(const wchar_t* end) const {
    CursorRow cursor(widthOfTerminal());
    cursor.add(shownPrompt);
    for (const wchar_t* letter = el_wline(edit)->buffer; letter != end; ++letter) cursor.add(*letter);
    return cursor;
}

/** The sequence that moves the cursor to the end of the line. */
std::string LineEditor::Impl::toEnd() const {
    const CursorRow now = cursorAt(el_wline(edit)->cursor), end = cursorAt(el_wline(edit)->lastchar);
    if (now.row() == end.row() && now.column() == end.column()) return {};
    return std::string(end.row() - now.row(), '\n') + (erases ? "\033[" + std::to_string(end.column() + 1) + "G" : "");
}

/** Draws the whole line at the cursor. */
void LineEditor::Impl::draw() {
    above.makeRoom();
    el_set(edit, EL_REFRESH);
}

unsigned char LineEditor::Impl::completeLine() {
    const LineInfo* const now = el_line(edit);
    const std::string line(now->buffer, now->cursor);
    const std::string below = toEnd();
    above.unlock(rowsAbove(), true);  // completion may call components, which may write
    Completion found;
    try {
        found = complete(line);
    } catch (const std::exception&) {
        // Without completions: an exception must not pass through libedit, which is C.
    }
    if (!above.lock()) draw();
    const std::string more = found.more(line);
    if (!more.empty()) {
        el_insertstr(edit, more.c_str());
        return CC_REFRESH;
    }
    if (found.words.size() <= 1) return CC_ERROR;
    std::ostringstream list;
    list << below << '\n';
    writeColumns(list, found.words, Theme(), Style::Plain, "", widthOfTerminal());
    std::fputs(list.str().c_str(), stdout);
    el_set(edit, EL_REFRESH);
    return CC_NORM;
}

LineEditor::LineEditor(History& history, Complete complete, int endsOn, Echo echo)
    : impl_(new Impl(history, std::move(complete), endsOn, echo)) {}

LineEditor::~LineEditor() = default;

void LineEditor::forget() { impl_->pasted.clear(); }

LineSource::Outcome LineEditor::read(const std::string& prompt, std::string& line) {
    Impl& impl = *impl_;
    impl.prompt = marked(prompt);
    impl.shownPrompt = prompt;
    impl.dropped = impl.ended = impl.searching = false;
    if (impl.signals.takeResized()) el_resize(impl.edit);
    impl.prepareTerminal();
    forgetInterrupts();  // from now until the line is complete, Ctrl-C is a key instead of a signal
    impl.above.lock();
    impl.above.makeRoom();
    if (impl.erases) std::fputs(kMarkPaste, stdout);
    setPasteMarked(impl.erases);
    int count = 0;
    const char* const text = el_gets(impl.edit, &count);
    line = text && count > 0 ? std::string(text, static_cast<std::size_t>(count)) : "";
    setPasteMarked(false);
    if (impl.erases) std::fputs(kUnmarkPaste, stdout);
    if (impl.dropped) {
        impl.above.end(impl.toEnd() + "^C\n");
        return Outcome::Dropped;
    }
    if (!text || count <= 0 || impl.ended) {
        impl.above.end(impl.toEnd() + "\n");
        return Outcome::End;
    }
    impl.above.end("");
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    HistEvent event;
    if (impl.lines.add(line)) ::history(impl.remembered, &event, H_ENTER, line.c_str());
    return Outcome::Line;
}

}  // namespace OCL::console
