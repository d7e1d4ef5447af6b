// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The values of variables while a constructor is followed.
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
    /// Returns the value stored at a place; any other value is returned as it is.
    Value load(const Value& value) const;
    std::optional<long long> sizeOf(const Place& container) const;

    /// Sets a value while the object is made, even if there is a doubt.
    void set(const Place& place, Value value) { values_[place] = std::move(value); }
    void erase(const Place& place) { values_.erase(place); }
    /// Also marks the objects around the place as changed since they were made.
    void assign(const Place& place, Value value);
    void noteChange(const Place& place);
    void forget(const Place& place);
    void copy(const Place& from, const Place& to);
    /// Copies an argument's target, if nothing is stored here yet.
    void store(const Place& at, const Value& value);

    /// Returns an unused place.
    Place fresh() { return Place::made(++made_); }

private:
    const Findings& findings_;
    std::map<Place, Value> values_;
    unsigned made_ = 0;
};

}  // namespace oroforge::cxx

#endif
