// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cursor_row.hpp"

#include <cwchar>

namespace OCL::console {
namespace {

constexpr std::size_t kTab = 8;
constexpr std::size_t kControl = 2;  // columns of "^A"

/** The end of the colour sequence that begins at `at`; `at` if there is none. */
std::size_t endOfSequence(const std::string& text, std::size_t at) {
    if (text.compare(at, 2, "\033[") != 0) return at;
    const std::size_t end = text.find_first_not_of("0123456789;?", at + 2);
    return end == std::string::npos ? text.size() : end + 1;
}

}  // namespace

void CursorRow::add(const std::string& text) {
    std::mbstate_t state = {};
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = endOfSequence(text, at);
        if (end != at) {
            at = end;
            continue;
        }
        wchar_t letter = 0;
        const std::size_t used = std::mbrtowc(&letter, text.data() + at, text.size() - at, &state);
        if (used == 0 || used > text.size()) {  // not a letter in this encoding
            state = {};
            advance(1);
            ++at;
            continue;
        }
        add(letter);
        at += used;
    }
}

void CursorRow::add(wchar_t letter) {
    if (letter == L'\n') {
        ++row_;
        column_ = 0;
    } else if (letter == L'\r') {
        column_ = 0;
    } else if (letter == L'\t') {
        advance(kTab - column_ % kTab);
    } else if (letter < L' ' || letter == L'\177') {
        advance(kControl);
    } else {
        const int columns = wcwidth(letter);
        if (columns > 0) advance(static_cast<std::size_t>(columns));
    }
}

void CursorRow::advance(std::size_t columns) {
    if (column_ + columns > width_) {  // a wide letter that does not fit
        ++row_;
        column_ = 0;
    }
    column_ += columns;
    if (column_ < width_) return;
    ++row_;
    column_ = 0;
}

}  // namespace OCL::console
