// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "follow.hpp"

namespace oroforge::cxx {

using Kind = Value::Kind;

Value Follower::load(const Value& value) const {
    if (!value.is(Kind::Place)) return value;
    const auto found = memory_.find(value.text);
    return found == memory_.end() ? Value() : found->second;
}

Value Follower::content(const clang::Expr* expression) {
    const Value value = eval(expression);
    return expression->isGLValue() || expression->getType()->isRecordType() ? load(value) : value;
}

std::optional<std::string> Follower::textOf(const clang::Expr* expression) {
    if (expression == nullptr) return std::nullopt;
    Value value = eval(expression);
    if (value.is(Kind::Place)) value = load(value);
    if (!value.is(Kind::Text)) return std::nullopt;
    return value.text;
}

std::optional<bool> Follower::truth(const clang::Expr* condition) {
    const Value value = content(condition);
    if (value.is(Kind::Real)) return value.real != 0;
    if (value.is(Kind::Number) || value.is(Kind::Boolean)) return value.number != 0;
    if (value.is(Kind::Null)) return false;
    return std::nullopt;
}

void Follower::forget(const Place& place) {
    const auto isPart = [&](const Place& other) {
        return other.compare(0, place.size(), place) == 0 &&
               (other.size() == place.size() || std::string(".[#").find(other[place.size()]) != std::string::npos);
    };
    for (auto& [at, value] : memory_) {
        if (isPart(at)) value = Value();
    }
    memory_[place] = Value();
    noteChange(place);
}

/// The objects that it is a part of are not any more what they were made as.
void Follower::noteChange(const Place& place) {
    for (std::size_t i = 1; i < place.size(); ++i) {
        if (place[i] != '.' && place[i] != '[') continue;
        const Place whole = place.substr(0, i);
        memory_[whole + "#changed"] = Value::ofBoolean(true);
        // Of a text one character.
        if (const auto text = memory_.find(whole); text != memory_.end() && text->second.is(Kind::Text))
            text->second = Value();
    }
}

void Follower::assign(const Place& place, Value value) {
    noteChange(place);
    memory_[place] = undecided_.empty() ? std::move(value) : Value();
}

void Follower::copyObject(const Place& from, const Place& to) {
    if (from == to) return;
    std::vector<std::pair<Place, Value>> copies;
    for (const auto& [at, value] : memory_) {
        if (at.compare(0, from.size(), from) != 0) continue;
        const std::string rest = at.substr(from.size());
        if (rest.empty() || std::string(".[#").find(rest[0]) != std::string::npos)
            copies.emplace_back(to + rest, value);
    }
    for (auto& [at, value] : copies) memory_[at] = undecided_.empty() ? std::move(value) : Value();
}

}  // namespace oroforge::cxx
