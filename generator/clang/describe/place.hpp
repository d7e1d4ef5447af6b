// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_PLACE_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_PLACE_HPP

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace oroforge::cxx {

/// An object met while a constructor is followed, and the steps to one of its parts or to a fact about it.
class Place {
public:
    enum class Kind {
        // Objects.
        Component,  ///< the component whose constructor is followed
        Made,       ///< a variable, a temporary, an object from 'new': each has a number
        Global,     ///< by the number of its declaration
        Requester,  ///< by the name of the required service
        // Parts.
        Field,
        Element,  ///< of an array or a sequence
        Key,      ///< of a map
        Held,     ///< the value of a property or an attribute
        // Facts about an object.
        Size,         ///< number of elements
        Text,         ///< contents of a stream
        Changed,      ///< it has changed since it was made
        Initialised,  ///< a global
        Activity      ///< of the component
    };

    /// Makes a place without an object.
    Place() = default;
    static Place component() { return Place({{Kind::Component, 0, ""}}); }
    static Place made(long long number) { return Place({{Kind::Made, number, ""}}); }
    static Place global(long long number) { return Place({{Kind::Global, number, ""}}); }
    static Place requester(std::string name) { return Place({{Kind::Requester, 0, std::move(name)}}); }

    Place field(std::string name) const { return with({Kind::Field, 0, std::move(name)}); }
    Place element(long long index) const { return with({Kind::Element, index, ""}); }
    Place key(std::string name) const { return with({Kind::Key, 0, std::move(name)}); }
    Place of(Kind known) const { return with({known, 0, ""}); }

    bool empty() const { return steps_.empty(); }
    bool isComponent() const { return steps_.size() == 1 && isOf(Kind::Component); }
    /// True for an object of this kind, and for parts of one.
    bool isOf(Kind object) const { return !empty() && steps_.front().kind == object; }
    /// True also for the whole itself.
    bool isPartOf(const Place& whole) const {
        return !whole.empty() && steps_.size() >= whole.steps_.size() &&
               std::equal(whole.steps_.begin(), whole.steps_.end(), steps_.begin());
    }

    /// False for the whole itself, and for facts about it.
    bool isInFieldOf(const Place& whole) const {
        return isPartOf(whole) && steps_.size() > whole.steps_.size() &&
               steps_[whole.steps_.size()].kind == Kind::Field;
    }

    /// kind(), index() and whole() need a place that is not empty; they are about its last step.
    Kind kind() const { return steps_.back().kind; }
    long long index() const { return steps_.back().number; }
    Place whole() const { return Place({steps_.begin(), steps_.end() - 1}); }
    /// Returns the same part of another object.
    Place moved(const Place& from, const Place& to) const {
        Place place = to;
        place.steps_.insert(place.steps_.end(), steps_.begin() + std::ptrdiff_t(from.steps_.size()), steps_.end());
        return place;
    }

    bool operator==(const Place& other) const { return steps_ == other.steps_; }
    bool operator!=(const Place& other) const { return !(*this == other); }
    bool operator<(const Place& other) const { return steps_ < other.steps_; }

private:
    struct Step {
        Kind kind;
        long long number;
        std::string name;
        auto tied() const { return std::tie(kind, number, name); }
        bool operator==(const Step& other) const { return tied() == other.tied(); }
        bool operator<(const Step& other) const { return tied() < other.tied(); }
    };

    explicit Place(std::vector<Step> steps) : steps_(std::move(steps)) {}
    Place with(Step step) const {
        Place place = *this;
        place.steps_.push_back(std::move(step));
        return place;
    }

    std::vector<Step> steps_;
};

}  // namespace oroforge::cxx

#endif
