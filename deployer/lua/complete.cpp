// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "complete.hpp"

#include "complete_names.hpp"

#include <cctype>

namespace OCL::lua {

namespace {

constexpr const char* kKeywords[] = {"and", "break",    "do",     "else", "elseif", "end",   "false",
                                     "for", "function", "if",     "in",   "local",  "nil",   "not",
                                     "or",  "repeat",   "return", "then", "true",   "until", "while"};

bool isNameLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/** Where the quotes begin within which the line ends; npos if there are none. */
std::size_t openQuote(const std::string& line) {
    std::size_t open = std::string::npos;
    for (std::size_t at = 0; at != line.size(); ++at) {
        const char c = line[at];
        const bool isOpen = open != std::string::npos;
        if (isOpen && c == '\\' && at + 1 != line.size())
            ++at;
        else if (isOpen && c == line[open])
            open = std::string::npos;
        else if (!isOpen && (c == '"' || c == '\''))
            open = at;
    }
    return open;
}

/** The names of a path such as `a.b:c` at the end of a text; the last one may be empty. */
struct Path {
    explicit Path(const std::string& text) {
        begin = text.size();
        names.emplace_back();
        for (; begin != 0; --begin) {
            const char c = text[begin - 1];
            if (isNameLetter(c)) {
                names.front().insert(names.front().begin(), c);
            } else if ((c == '.' || c == ':') && !(names.size() > 1 && names.front().empty())) {
                names.emplace(names.begin());
                if (names.size() == 2) last = begin;
            } else {
                break;
            }
        }
        if (names.size() == 1) last = begin;
        // Two dots join texts: what follows them is a path of its own.
        if (names.size() > 1 && names.front().empty() && begin != 0 && text[begin - 1] == '.') {
            names.erase(names.begin());
            ++begin;
        }
        isValid = names.size() == 1 || !names.front().empty();
        isMethod = names.size() > 1 && text[last - 1] == ':';
    }

    std::vector<std::string> names;
    std::size_t begin, last = 0;  ///< of the whole, of the last name
    bool isValid = false;
    bool isMethod = false;  ///< a colon is in front of the last name
};

/** Pushes the value that all names but the last one stand for. */
void pushOwner(lua_State* lua, const Path& path) {
    lua_pushvalue(lua, LUA_GLOBALSINDEX);
    for (std::size_t i = 0; i + 1 < path.names.size(); ++i) takeField(lua, path.names[i]);
}

bool beginsWith(const std::string& text, const std::string& begin) { return text.compare(0, begin.size(), begin) == 0; }

void completeQuoted(lua_State* lua, const std::string& line, std::size_t quote, Completed& found) {
    std::size_t end = quote;
    while (end != 0 && (line[end - 1] == ' ' || line[end - 1] == '(')) --end;
    const Path path(line.substr(0, end));
    if (!path.isValid || path.names.back().empty()) return;
    pushOwner(lua, path);
    found.begin = quote + 1;
    const std::string typed = line.substr(found.begin);
    Names sorted;
    for (const std::string& name : argumentsOf(lua, path.names.back()))
        if (beginsWith(name, typed)) sorted.emplace(name, false);
    for (const auto& [name, isFunction] : sorted) found.words.push_back(name);
    if (found.words.size() == 1) found.behind = line[quote];
}

void completeName(lua_State* lua, const std::string& line, Completed& found) {
    const Path path(line);
    if (!path.isValid) return;
    pushOwner(lua, path);
    found.begin = path.last;
    const std::string& typed = path.names.back();
    const bool isFirst = path.names.size() == 1;
    if (isFirst && (typed.empty() || std::isdigit(static_cast<unsigned char>(typed[0])))) return;
    Names names = namesOf(lua);
    if (isFirst)
        for (const char* const word : kKeywords) names.emplace(word, false);
    bool isFunction = false;
    for (const auto& [name, isOneFunction] : names) {
        if (!beginsWith(name, typed) || (path.isMethod && !isOneFunction)) continue;
        found.words.push_back(name);
        isFunction = isOneFunction;
    }
    if (isFunction && found.words.size() == 1) found.behind = "(";
}

}  // namespace

Completed complete(State& state, const std::string& line) {
    Completed found;
    found.begin = line.size();
    std::string error;
    const bool done = state.protect(error, [&](lua_State* lua) {
        const std::size_t quote = openQuote(line);
        if (quote == std::string::npos)
            completeName(lua, line, found);
        else
            completeQuoted(lua, line, quote, found);
    });
    if (!done) found.words.clear();
    return found;
}

}  // namespace OCL::lua
