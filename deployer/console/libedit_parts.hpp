// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the editors of lines have in common that use libedit: that of the console, and the prompt of oro.
#ifndef OROFORGE_CONSOLE_LIBEDIT_PARTS_HPP
#define OROFORGE_CONSOLE_LIBEDIT_PARTS_HPP

#include "history.hpp"

#include <histedit.h>

#include <cwchar>
#include <string>

namespace OCL::console {

/** The object that is libedit's client data. */
template <class Owner>
Owner& ownerOf(EditLine* edit) {
    void* self = nullptr;
    el_get(edit, EL_CLIENTDATA, &self);
    return *static_cast<Owner*>(self);
}

/** The lines that the keys for it go through. */
class EditHistory {
public:
    /** Letters beyond ASCII are read and drawn in the encoding of the terminal from then on. */
    EditHistory(EditLine* edit, History& lines);
    ~EditHistory();
    EditHistory(const EditHistory&) = delete;
    EditHistory& operator=(const EditHistory&) = delete;

    /** Adds a line to both, unless that does not remember it. */
    void add(const std::string& line);

private:
    History& lines_;
    ::History* const remembered_;
};

/** The usual keys, those that terminals send for Home, End and Delete, and Tab and Ctrl-C with these functions. */
void bindUsualKeys(EditLine* edit, unsigned char (*onTab)(EditLine*, int), unsigned char (*onDrop)(EditLine*, int));

/** Sets the terminal before the prompt: libedit does so only when it reads the first key, so keys typed before that
    would be shown twice. Also disables the key for SIGINT, which libedit cannot; it restores the terminal after the
    line. */
void prepareTerminal(EditLine* edit);

/** Makes letters of bytes. What is no letter in the encoding is dropped. */
class Letters {
public:
    /** True if the letter is complete. */
    bool add(char byte, wchar_t& letter);

private:
    std::mbstate_t state_ = {};
};

/** What el_gets() has given, without the end of the line. */
std::string lineOf(const char* text, int count);

}  // namespace OCL::console

#endif
