// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "memory.hpp"

namespace oroforge::cxx {

const Value* Memory::find(const Place& place) const {
    const auto found = values_.find(place);
    return found == values_.end() ? nullptr : &found->second;
}

Value Memory::load(const Value& value) const {
    if (!value.is(Value::Kind::Place)) return value;
    const Value* found = find(value.text);
    return found == nullptr ? Value() : *found;
}

std::optional<long long> Memory::sizeOf(const Place& container) const {
    const Value* size = find(container + "#size");
    return size != nullptr && size->is(Value::Kind::Number) ? std::optional(size->number) : std::nullopt;
}

void Memory::forget(const Place& place) {
    const auto isPart = [&](const Place& other) {
        return other.compare(0, place.size(), place) == 0 &&
               (other.size() == place.size() || std::string(".[#").find(other[place.size()]) != std::string::npos);
    };
    for (auto& [at, value] : values_) {
        if (isPart(at)) value = Value();
    }
    set(place, Value());
    noteChange(place);
}

void Memory::noteChange(const Place& place) {
    for (std::size_t i = 1; i < place.size(); ++i) {
        if (place[i] != '.' && place[i] != '[') continue;
        const Place whole = place.substr(0, i);
        set(whole + "#changed", Value::ofBoolean(true));
        // Of a text one character.
        if (const auto text = values_.find(whole); text != values_.end() && text->second.is(Value::Kind::Text))
            text->second = Value();
    }
}

void Memory::assign(const Place& place, Value value) {
    noteChange(place);
    set(place, findings_.isCertain() ? std::move(value) : Value());
}

void Memory::copy(const Place& from, const Place& to) {
    if (from == to) return;
    std::vector<std::pair<Place, Value>> copies;
    for (const auto& [at, value] : values_) {
        if (at.compare(0, from.size(), from) != 0) continue;
        const std::string rest = at.substr(from.size());
        if (rest.empty() || std::string(".[#").find(rest[0]) != std::string::npos)
            copies.emplace_back(to + rest, value);
    }
    for (auto& [at, value] : copies) set(at, findings_.isCertain() ? std::move(value) : Value());
}

void Memory::store(const Place& at, const Value& value) {
    if (value.is(Value::Kind::Place)) copy(value.text, at);
    if (find(at) == nullptr) set(at, load(value));
}

}  // namespace oroforge::cxx
