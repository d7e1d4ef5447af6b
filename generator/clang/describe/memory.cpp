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
    const Value* found = find(value.place);
    return found == nullptr ? Value() : *found;
}

std::optional<long long> Memory::sizeOf(const Place& container) const {
    const Value* size = find(container.of(Place::Kind::Size));
    return size != nullptr && size->is(Value::Kind::Number) ? std::optional(size->number) : std::nullopt;
}

void Memory::forget(const Place& place) {
    for (auto& [at, value] : values_) {
        if (at.isPartOf(place)) value = Value();
    }
    set(place, Value());
    noteChange(place);
}

void Memory::noteChange(const Place& place) {
    for (Place part = place; !part.empty();) {
        const Place::Kind kind = part.kind();
        part = part.whole();
        if (kind != Place::Kind::Field && kind != Place::Kind::Element && kind != Place::Kind::Key) continue;
        set(part.of(Place::Kind::Changed), Value::ofBoolean(true));
        // One character of a text changed.
        if (const auto text = values_.find(part); text != values_.end() && text->second.is(Value::Kind::Text))
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
        if (at.isPartOf(from)) copies.emplace_back(at.moved(from, to), value);
    }
    for (auto& [at, value] : copies) set(at, findings_.isCertain() ? std::move(value) : Value());
}

void Memory::store(const Place& at, const Value& value) {
    if (value.is(Value::Kind::Place)) copy(value.place, at);
    if (find(at) == nullptr) set(at, load(value));
}

}  // namespace oroforge::cxx
