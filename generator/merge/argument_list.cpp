// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/argument_list.hpp>

#include <algorithm>
#include <cctype>

#include <merge/text_places.hpp>
#include <model/cpp_type.hpp>

namespace oroforge::merge {

namespace {

/// An argument in the source: its own words, and the text around it up to the commas.
struct Piece {
    std::string before;
    std::string words;
    std::string behind;
};

/// Returns the place after "/*level*/" if it comes next. Beside a written name, any other comment is the user's.
std::size_t behindNameComment(const std::string& text, std::size_t at, std::size_t end, bool named,
                              const std::string& usual) {
    const std::size_t begin = text.find_first_not_of(" \t", at);
    if (begin == std::string::npos || begin >= end || text.compare(begin, 2, "/*") != 0) return at;
    const std::size_t close = text.find("*/", begin + 2);
    if (close == std::string::npos || close >= end) return at;
    const std::string name = text.substr(begin + 2, close - begin - 2);
    const bool isName = named ? withoutLayout(name) == usual : model::isIdentifier(withoutLayout(name));
    return isName ? close + 2 : at;
}

/// Finds the ',' between two arguments, outside comments.
std::size_t commaIn(const std::string& text, std::size_t at, std::size_t end) {
    while (at < end) {
        if (text[at] == ',') return at;
        if (text.compare(at, 2, "//") == 0) {
            at = text.find('\n', at);
        } else if (text.compare(at, 2, "/*") == 0) {
            at = text.find("*/", at + 2);
        }
        if (at == std::string::npos) return end;
        ++at;
    }
    return end;
}

class Rewriter {
public:
    Rewriter(const std::string& text, const model::UserFunction& function, const std::vector<model::TypedName>& from,
             const std::vector<model::TypedName>& to, bool commentNames)
        : text_(text),
          function_(function),
          from_(from),
          to_(to),
          commentNames_(commentNames),
          origin_(matchArguments(from, to)) {}

    NewArguments run() {
        if (function_.parameters.size() != from_.size()) return {"", "it has another number of arguments"};
        if (function_.parameters.empty()) return fromNothing();
        if (!split()) return {"", "its arguments cannot be told apart"};
        checkRemoved();
        for (std::size_t j = 0; j != to_.size(); ++j) add(j);
        if (!to_.empty()) addEnd();
        return {result_, fault_};
    }

private:
    std::string fresh(const model::TypedName& argument) const {
        return argument.type + (commentNames_ ? " /*" + argument.name + "*/" : " " + argument.name);
    }

    NewArguments fromNothing() const {
        const std::string inside = cut(text_, function_.brackets);
        std::string list;
        for (const model::TypedName& argument : to_) list += (list.empty() ? "" : ", ") + fresh(argument);
        const bool nothing = isBlank(inside) || withoutLayout(inside) == "void";
        // The list is "f(void /*nothing*/)".
        if (!nothing && mentions(inside, "void")) return {"", "there is a comment in its argument list"};
        if (nothing) return {list, ""};
        const bool lineComment = inside.find("//") != std::string::npos && inside.find('\n') == std::string::npos;
        return {inside + (lineComment ? "\n" : " ") + list, ""};
    }

    bool split() {
        std::size_t at = function_.brackets.begin;
        for (const model::UserParameter& parameter : function_.parameters) {
            const bool last = &parameter == &function_.parameters.back();
            const std::size_t limit = last ? function_.brackets.end : (&parameter)[1].whole.begin;
            if (parameter.whole.begin < at || parameter.whole.end > limit) return false;
            const std::size_t end = behindNameComment(text_, parameter.whole.end, limit, !parameter.name.empty(),
                                                      from_[pieces_.size()].name);
            const std::size_t comma = last ? limit : commaIn(text_, end, limit);
            if (!last && comma == limit) return false;
            pieces_.push_back({cut(text_, {at, parameter.whole.begin}), cut(text_, {parameter.whole.begin, end}),
                               cut(text_, {end, comma})});
            at = comma + 1;
        }
        return true;
    }

    void checkRemoved() {
        for (std::size_t i = 0; i != pieces_.size(); ++i) {
            if (std::find(origin_.begin(), origin_.end(), static_cast<int>(i)) != origin_.end()) continue;
            const Piece& piece = pieces_[i];
            std::string words = piece.words;
            const std::size_t name = words.find("/*");
            const bool named = !function_.parameters[i].name.empty();
            if (name != std::string::npos &&
                behindNameComment(words, name, words.size(), named, from_[i].name) == words.size())
                words.resize(name);
            if (hasComment(piece.before) || hasComment(piece.behind) || hasComment(words))
                fault_ = "there is a comment beside argument '" + from_[i].name + "', which the manifest no longer has";
            if (function_.parameters[i].isMacro) fault_ = "a macro makes argument '" + from_[i].name + "'";
        }
    }

    /// Returns the words of a kept argument, with its new type.
    std::string changed(std::size_t i, const model::TypedName& to) {
        if (model::normalised(from_[i].type) == model::normalised(to.type)) return pieces_[i].words;
        const model::UserParameter& parameter = function_.parameters[i];
        const std::string old = parameter.type.empty() ? "" : cut(text_, parameter.type);
        if (old.empty() || hasComment(old)) {
            fault_ = "the type of argument '" + from_[i].name + "' is not written plainly";
            return pieces_[i].words;
        }
        std::string rest = pieces_[i].words.substr(old.size());
        const bool touches =
            !rest.empty() && (std::isalnum(static_cast<unsigned char>(rest[0])) != 0 || rest[0] == '_');
        return to.type + (touches ? " " : "") + rest;
    }

    /// Returns the text between a comma and a new argument.
    std::string usualGap() const {
        for (std::size_t i = 1; i < pieces_.size(); ++i)
            if (isBlank(pieces_[i].before)) return pieces_[i].before;
        return " ";
    }

    void add(std::size_t j) {
        const int i = origin_[j];
        if (i < 0 && hasDefault_) fault_ = "argument '" + to_[j].name + "' would follow one with a default value";
        hasDefault_ =
            hasDefault_ || (i >= 0 && pieces_[static_cast<std::size_t>(i)].words.find('=') != std::string::npos);
        const std::string words = i < 0 ? fresh(to_[j]) : changed(static_cast<std::size_t>(i), to_[j]);
        const std::string before = i < 0 ? std::string() : pieces_[static_cast<std::size_t>(i)].before;
        if (j == 0) {
            const bool ownGap = i == 0 || hasComment(before);
            result_ += (ownGap ? before : isBlank(pieces_[0].before) ? pieces_[0].before : "") + words;
            return;
        }
        const int previous = origin_[j - 1];
        const std::string behind = previous < 0 ? "" : pieces_[static_cast<std::size_t>(previous)].behind;
        if (i > 0 && previous == i - 1) {
            result_ += behind + "," + before + words;
            return;
        }
        const bool comment = hasComment(behind);
        // A comment before a comma stays there; after the last argument, its line ends first.
        const bool hadComma = previous + 1 < static_cast<int>(pieces_.size());
        if (comment && hadComma) result_ += behind;
        result_ += ",";
        if (comment && !hadComma) result_ += behind;
        const bool freshLine = comment && !result_.empty() && behind.find('\n') != std::string::npos;
        if (i >= 0 && hasComment(before)) {
            result_ += before + words;
        } else {
            result_ += (freshLine ? "" : i == 0 ? " " : i > 0 ? before : usualGap()) + words;
        }
    }

    void addEnd() {
        const std::string& behind = pieces_.back().behind;
        const bool lastStays = origin_.back() == static_cast<int>(pieces_.size()) - 1;
        if (lastStays || isBlank(behind)) {
            result_ += behind;
        } else if (origin_.back() >= 0 && hasComment(pieces_[static_cast<std::size_t>(origin_.back())].behind)) {
            result_ += pieces_[static_cast<std::size_t>(origin_.back())].behind;
        }
    }

    const std::string& text_;
    const model::UserFunction& function_;
    const std::vector<model::TypedName>& from_;
    const std::vector<model::TypedName>& to_;
    const bool commentNames_;
    const std::vector<int> origin_;
    std::vector<Piece> pieces_;
    std::string result_;
    std::string fault_;
    bool hasDefault_ = false;
};

}  // namespace

std::vector<int> matchArguments(const std::vector<model::TypedName>& from, const std::vector<model::TypedName>& to) {
    const std::size_t n = from.size(), m = to.size();
    const auto likeness = [&](std::size_t i, std::size_t j) {
        return (from[i].name == to[j].name ? 2 : 0) +
               (model::normalised(from[i].type) == model::normalised(to[j].type) ? 1 : 0);
    };
    // best[i][j] is the highest total likeness of from[i…] and to[j…], matched in order.
    std::vector<std::vector<int>> best(n + 1, std::vector<int>(m + 1, 0));
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = m; j-- > 0;) {
            best[i][j] = std::max(best[i + 1][j], best[i][j + 1]);
            if (likeness(i, j) > 0) best[i][j] = std::max(best[i][j], likeness(i, j) + best[i + 1][j + 1]);
        }
    }
    std::vector<int> origin(m, -1);
    for (std::size_t i = 0, j = 0; i < n && j < m;) {
        if (likeness(i, j) > 0 && best[i][j] == likeness(i, j) + best[i + 1][j + 1]) {
            origin[j++] = static_cast<int>(i++);
        } else if (best[i][j] == best[i + 1][j]) {
            ++i;
        } else {
            ++j;
        }
    }
    return origin;
}

NewArguments changedArguments(const std::string& text, const model::UserFunction& function,
                              const std::vector<model::TypedName>& from, const std::vector<model::TypedName>& to,
                              bool commentNames) {
    return Rewriter(text, function, from, to, commentNames).run();
}

}  // namespace oroforge::merge
