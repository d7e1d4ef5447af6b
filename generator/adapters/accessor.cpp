// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <adapters/accessor.hpp>

#include <algorithm>
#include <cctype>

#include <diag/nearest_match.hpp>

namespace oroforge::adapters {

namespace {

bool isWordChar(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

class Parser {
public:
    Parser(const Accessor& into, const std::vector<std::string>& words, diag::Sink& sink)
        : text_(into.text), where_(into.where), words_(words), sink_(sink) {}

    void parse(Accessor& into) {
        skipBlanks();
        if (at_ < text_.size() && (isDigit(text_[at_]) || text_[at_] == '$')) {
            into.number = number();
        } else if (at_ == text_.size()) {
            fail("is empty, expected such as 'x()'");
        } else {
            parseStep(into);
            while (!failed_ && at_ < text_.size()) parseStep(into);
        }
        skipBlanks();
        if (!failed_ && at_ < text_.size()) fail(found() + " behind a number, expected its end");
        if (failed_) {
            into.steps.clear();
            into.number.clear();
        }
    }

private:
    void parseStep(Accessor& into) {
        Step step;
        const char c = text_[at_];
        const bool first = into.steps.empty();
        if (c == '(' || c == '[') {
            step.kind = c == '(' ? Step::Kind::Call : Step::Kind::Index;
            ++at_;
            parseArguments(c == '(' ? ')' : ']', step.arguments);
            if (!failed_ && c == '[' && step.arguments.size() != 1) fail("needs one index between '[' and ']'");
        } else if (first || c == '.') {
            if (c == '.') ++at_;
            skipBlanks();
            step.name = word();
            if (step.name.empty() || isDigit(step.name[0])) {
                at_ -= step.name.size();
                fail(found() + ", expected the name of a member");
            }
        } else {
            fail(found() + ", expected '.', '(', '[' or the end");
        }
        into.steps.push_back(step);
        skipBlanks();
    }

    void parseArguments(char end, std::vector<std::string>& arguments) {
        skipBlanks();
        while (!failed_ && (at_ == text_.size() || text_[at_] != end)) {
            if (!arguments.empty()) expect(',');
            if (!failed_) arguments.push_back(argument());
            skipBlanks();
        }
        if (!failed_) ++at_;
    }

    std::string argument() {
        skipBlanks();
        if (at_ < text_.size() && (isDigit(text_[at_]) || text_[at_] == '$')) return number();
        const std::string name = word();
        if (name.empty()) {
            fail(found() + ", expected an argument");
        } else if (std::find(words_.begin(), words_.end(), name) == words_.end()) {
            at_ -= name.size();
            const std::string choices = words_.empty() ? "a number" : diag::oneOf(words_) + " or a number";
            fail("argument '" + name + "', expected " + choices + diag::didYouMean(name, words_));
        }
        return name;
    }

    std::string number() {
        const std::size_t begin = at_++;
        while (at_ < text_.size() && isWordChar(text_[at_])) ++at_;
        const std::string result = text_.substr(begin, at_ - begin);
        const bool isNumber = std::all_of(result.begin(), result.end(), isDigit) && result.size() < 10;
        const bool isVariable = result[0] == '$' && result.size() > 1 && !isDigit(result[1]);
        if (!isNumber && !isVariable) {
            at_ = begin;
            fail("'" + result + "', expected a whole number below 1000000000 or a variable such as '$N'");
        }
        return result;
    }

    std::string word() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && isWordChar(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    void expect(char wanted) {
        skipBlanks();
        if (at_ < text_.size() && text_[at_] == wanted) {
            ++at_;
        } else {
            fail(found() + ", expected '" + std::string(1, wanted) + "'");
        }
    }

    void skipBlanks() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }

    std::string found() const {
        if (at_ >= text_.size()) return "the end";
        const auto c = static_cast<unsigned char>(text_[at_]);
        return c < 0x20 || c >= 0x7f ? "a character that C++ names do not have"
                                     : "'" + std::string(1, text_[at_]) + "'";
    }

    void fail(const std::string& what) {
        if (failed_) return;
        failed_ = true;
        diag::Location at = where_;
        if (at.column != 0) at.column += static_cast<unsigned>(at_);
        sink_.error(at, "TK071", "in accessor '" + text_ + "': " + what)
            .hint("an accessor is what C++ code would write behind the object: 'x()', 'M', 'data[2]', '(row, column)'");
    }

    const std::string& text_;
    const diag::Location& where_;
    const std::vector<std::string>& words_;
    diag::Sink& sink_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

std::string valueOf(const std::string& word, const std::map<std::string, std::string>& variables) {
    const auto known = word.empty() || word[0] != '$' ? variables.end() : variables.find(word.substr(1));
    return known == variables.end() ? word : known->second;
}

}  // namespace

bool Accessor::uses(const std::string& word) const {
    return std::any_of(steps.begin(), steps.end(), [&](const Step& step) {
        return std::find(step.arguments.begin(), step.arguments.end(), word) != step.arguments.end();
    });
}

Accessor parseAccessor(const std::string& text, const diag::Location& where, const std::vector<std::string>& words,
                       diag::Sink& sink) {
    Accessor result;
    result.text = text;
    result.where = where;
    Parser(result, words, sink).parse(result);
    return result;
}

Accessor bound(const Accessor& accessor, const std::map<std::string, std::string>& variables) {
    Accessor result = accessor;
    result.number = valueOf(accessor.number, variables);
    for (Step& step : result.steps)
        for (std::string& argument : step.arguments) argument = valueOf(argument, variables);
    return result;
}

std::string cppOf(const Accessor& accessor) {
    std::string cpp = accessor.number;
    for (const Step& step : accessor.steps) {
        if (step.kind == Step::Kind::Name) {
            cpp += "." + step.name;
            continue;
        }
        std::string arguments;
        for (const std::string& argument : step.arguments) arguments += (arguments.empty() ? "" : ", ") + argument;
        cpp += step.kind == Step::Kind::Call ? "(" + arguments + ")" : "[" + arguments + "]";
    }
    return cpp;
}

}  // namespace oroforge::adapters
