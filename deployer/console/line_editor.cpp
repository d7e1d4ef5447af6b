// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "line_editor.hpp"

#include "cursor_row.hpp"
#include "interrupts.hpp"
#include "kept_terminal.hpp"
#include "libedit_parts.hpp"
#include "output_above.hpp"
#include "table.hpp"
#include "terminal_signals.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
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

    static Impl& of(EditLine* edit) { return ownerOf<Impl>(edit); }
    static char* showPrompt(EditLine* edit) { return of(edit).prompt.data(); }
    static int readKey(EditLine* edit, wchar_t* key) { return of(edit).next(key); }
    static unsigned char onTab(EditLine* edit, int) { return of(edit).completeLine(); }
    static unsigned char onDrop(EditLine* edit, int) {
        of(edit).dropped = true;
        return CC_NEWLINE;
    }
    static unsigned char onPaste(EditLine* edit, int) { return of(edit).takePaste(); }
    void bindKeys();
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

    const Complete complete;
    const int endsOn;
    KeptTerminal kept;  // made before libedit changes the terminal
    EditLine* const edit;
    EditHistory lines;
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
    : complete(std::move(completion)),
      endsOn(ends),
      edit(el_init("console", stdin, stdout, stderr)),
      lines(edit, history),
      erases(canErase(edit)),
      above(erases),
      signals(above.descriptor()) {
    el_set(edit, EL_CLIENTDATA, this);
    el_set(edit, EL_PROMPT_ESC, &Impl::showPrompt, kEscape);
    el_set(edit, EL_GETCFN, &Impl::readKey);
    bindKeys();
    // Also while commands are executed: echoed keys would mix with their output and with the next prompt.
    if (echo == Echo::Lines) el_set(edit, EL_SETTY, "-x", "-echo", nullptr);
}

LineEditor::Impl::~Impl() {
    el_set(edit, EL_EDITMODE, 0);  // it would drop keys that were typed meanwhile; `kept` restores the terminal
    el_end(edit);
}

void LineEditor::Impl::bindKeys() {
    bindUsualKeys(edit, &Impl::onTab, &Impl::onDrop);
    el_set(edit, EL_ADDFN, "console-paste", "takes what is pasted", &Impl::onPaste);
    el_set(edit, EL_BIND, kPasteBegins, "console-paste", nullptr);
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
    Letters letters;
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
        if (letters.add(byte, *key)) return true;
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
        prepareTerminal(edit);
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
    prepareTerminal(impl.edit);
    forgetInterrupts();  // from now until the line is complete, Ctrl-C is a key instead of a signal
    impl.above.lock();
    impl.above.makeRoom();
    if (impl.erases) std::fputs(kMarkPaste, stdout);
    setPasteMarked(impl.erases);
    int count = 0;
    const char* const text = el_gets(impl.edit, &count);
    line = lineOf(text, count);
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
    impl.lines.add(line);
    return Outcome::Line;
}

}  // namespace OCL::console
