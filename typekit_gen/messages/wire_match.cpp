// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/wire_match.hpp>

#include <algorithm>
#include <set>

namespace oroforge::messages {

namespace {

using Wires = std::vector<Wire>;
using Kind = Wire::Kind;

constexpr std::size_t kMostDifferences = 8;
/// Rows of different lengths are walked through element by element.
constexpr std::size_t kMostSteps = 1000000;

bool isOneOf(const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// A value of the struct can be written as the one of the message, and the other way round.
bool fits(const std::string& type, const std::string& message) {
    if (message == "bool") return isOneOf(type, {"bool", "uint8"});
    if (message == "word") return isOneOf(type, {"int32", "uint32"});
    return type == message || (type == "char" && isOneOf(message, {"int8", "uint8"}));
}

/// Walks through values, lists and rows of several values; a row of one value is that value many times.
class Cursor {
public:
    explicit Cursor(const Wires& all) : levels_{{&all, 0, 1}} { settle(); }

    const Wire* at() const { return levels_.empty() ? nullptr : &(*levels_.back().all)[levels_.back().at]; }
    /// The value here, or null.
    const Wire* value() const {
        const Wire* const here = at();
        return isRun(here) ? &here->parts[0] : here->kind == Kind::Value ? here : nullptr;
    }
    bool is(Kind kind) const { return at()->kind == kind && !isRun(at()); }
    /// How often the value is here.
    std::uint64_t left() const { return left_; }
    void take(std::uint64_t count) {
        left_ -= count;
        if (left_ != 0) return;
        ++levels_.back().at;
        settle();
    }
    void pass() { take(left_); }
    void enter() {
        levels_.push_back({&at()->parts, 0, at()->count});
        settle();
    }

private:
    struct Level {
        const Wires* all;
        std::size_t at;
        std::uint64_t rounds;
    };
    static bool isRun(const Wire* here) {
        return here->kind == Kind::Row && here->parts.size() == 1 && here->parts[0].kind == Kind::Value;
    }
    void settle() {
        while (!levels_.empty() && levels_.back().at == levels_.back().all->size()) {
            Level& last = levels_.back();
            last.at = 0;
            if (!last.all->empty() && --last.rounds != 0) continue;
            levels_.pop_back();
            if (!levels_.empty()) ++levels_.back().at;
        }
        left_ = at() != nullptr && isRun(at()) ? at()->count : 1;
    }

    std::vector<Level> levels_;
    std::uint64_t left_ = 1;
};

bool areEqual(const Wires& type, const Wires& message, Pairs& pairs, std::size_t& steps) {
    Cursor one(type), other(message);
    const std::size_t known = pairs.size();
    while (one.at() && other.at()) {
        if (++steps > kMostSteps) return false;
        const Wire *const value = one.value(), *const its = other.value();
        if (value && its) {
            if (!fits(value->word, its->word)) break;
            pairs.emplace_back(value, its);
            const std::uint64_t count = std::min(one.left(), other.left());
            one.take(count);
            other.take(count);
            continue;
        }
        const bool areRows = one.is(Kind::Row) && other.is(Kind::Row) && one.at()->count == other.at()->count;
        const bool areLists = one.is(Kind::List) && other.is(Kind::List);
        if ((areRows || areLists) && areEqual(one.at()->parts, other.at()->parts, pairs, steps)) {
            one.pass();
            other.pass();
        } else if (one.is(Kind::Row)) {
            one.enter();
        } else if (other.is(Kind::Row)) {
            other.enter();
        } else {
            break;
        }
    }
    const bool isEqual = one.at() == nullptr && other.at() == nullptr;
    if (!isEqual) pairs.resize(known);
    return isEqual;
}

std::string shown(const Wire& wire) {
    switch (wire.kind) {
        case Kind::Value: return wire.word == "word" ? "int32 or uint32" : wire.word;
        case Kind::Row: return "an array of " + std::to_string(wire.count);
        case Kind::List: return "a list of any length";
        case Kind::None: break;
    }
    return "nothing that a message can hold";
}

/// Says what is different, field by field, as if all others were where they belong.
class Teller {
public:
    std::vector<Difference> differences;

    void compare(const Wires& type, const Wires& message) {
        Cursor one(type), other(message);
        for (std::size_t steps = 0; differences.size() < kMostDifferences && steps != kMostSteps; ++steps) {
            if (!one.at() || !other.at()) break;
            step(one, other);
        }
        if (differences.size() >= kMostDifferences) return;
        if (one.at() && !other.at()) tell(*one.at(), {}, "field '" + one.at()->path + "' is more than the message has");
        if (!one.at() && other.at())
            differences.push_back({{},
                                   "nothing for field '" + other.at()->path + "' of the message, " + shown(*other.at()),
                                   other.at()->where});
    }

private:
    void tell(const Wire& wire, const diag::Location& there, const std::string& message) {
        if (told_.insert({wire.path, there}).second) differences.push_back({wire.where, message, there});
    }

    void step(Cursor& one, Cursor& other) {
        const Wire &here = *one.at(), &there = *other.at();
        const Wire *const value = one.value(), *const its = other.value();
        const bool areRows = here.kind == Kind::Row && there.kind == Kind::Row && !value == !its;
        if (here.kind == Kind::None) {
            tell(here, there.where, "field '" + here.path + "' cannot be in a message: " + here.word);
        } else if (areRows && here.count != there.count) {
            tell(here, there.where,
                 "field '" + here.path + "' is an array of " + std::to_string(here.count) +
                     ", the message has one of " + std::to_string(there.count) + " there, '" + there.path + "'");
        } else if (areRows || (one.is(Kind::List) && other.is(Kind::List))) {
            compare(here.parts, there.parts);
        } else if (one.is(Kind::Row)) {
            return one.enter();
        } else if (other.is(Kind::Row)) {
            return other.enter();
        } else if (!value || !its || !fits(value->word, its->word)) {
            tell(here, there.where,
                 "field '" + here.path + "' is " + shown(value ? *value : here) + ", the message has " +
                     shown(its ? *its : there) + " there, '" + there.path + "'");
        }
        // A row of one value may stand for as many fields of the other.
        const bool isShared = value && its && !areRows;
        const std::uint64_t count = std::min(one.left(), other.left());
        one.take(isShared ? count : one.left());
        other.take(isShared ? count : other.left());
    }

    std::set<std::pair<std::string, diag::Location>> told_;
};

}  // namespace

std::vector<Difference> compareWires(const Wires& type, const Wires& message, Pairs& pairs) {
    std::size_t steps = 0;
    if (areEqual(type, message, pairs, steps)) return {};
    Teller teller;
    teller.compare(type, message);
    if (teller.differences.empty())
        teller.differences.push_back({{}, "other arrays than the message, or too many elements to compare", {}});
    return teller.differences;
}

}  // namespace oroforge::messages
