// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What variables hold while a constructor is followed.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_MEMORY_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_MEMORY_HPP

#include <map>
#include <optional>

#include "component_state.hpp"
#include "findings.hpp"

namespace oroforge::cxx {

class Memory {
public:
    explicit Memory(const Findings& findings) : findings_(findings) {}

    const Value* find(const Place& place) const;
    /// Of a place: what is stored there. Any other value is itself.
    Value load(const Value& value) const;
    std::optional<long long> sizeOf(const Place& container) const;

    /// As part of making the object, whatever is certain.
    void set(const Place& place, Value value) { values_[place] = std::move(value); }
    void erase(const Place& place) { values_.erase(place); }
    /// The objects that the place is a part of are not any more what they were made as.
    void assign(const Place& place, Value value);
    void noteChange(const Place& place);
    void forget(const Place& place);
    void copy(const Place& from, const Place& to);
    /// A copy of what an argument refers to, if nothing is there yet.
    void store(const Place& at, const Value& value);

    /// A place that nothing else has.
    Place fresh() { return Place::made(++made_); }

private:
    const Findings& findings_;
    std::map<Place, Value> values_;
    unsigned made_ = 0;
};

}  // namespace oroforge::cxx

#endif
