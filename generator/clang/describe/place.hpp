// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_PLACE_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_PLACE_HPP

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace oroforge::cxx {

/// An object that is met while a constructor is followed, and the way to one of its parts; or to what is known of that.
class Place {
public:
    enum class Kind {
        // Objects.
        Component,  ///< the one whose constructor is followed
        Made,       ///< a variable, a temporary, what 'new' makes: they have numbers
        Global,     ///< by the number of its declaration
        Requester,  ///< by the name of the service that is required
        // Parts.
        Field,
        Element,  ///< of an array or a sequence
        Key,      ///< of a map
        Held,     ///< the value of a property or an attribute
        // What is known of an object.
        Size,         ///< how many elements it has
        Text,         ///< what a stream holds
        Changed,      ///< it is not any more what it was made as
        Initialised,  ///< a global
        Activity      ///< of the component
    };

    /// No object.
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
    /// Whether it is an object of this kind, or a part of one.
    bool isOf(Kind object) const { return !empty() && steps_.front().kind == object; }
    /// Or the whole itself.
    bool isPartOf(const Place& whole) const {
        return !whole.empty() && steps_.size() >= whole.steps_.size() &&
               std::equal(whole.steps_.begin(), whole.steps_.end(), steps_.begin());
    }

    /// Not the whole itself, and not what is known of it.
    bool isInFieldOf(const Place& whole) const {
        return isPartOf(whole) && steps_.size() > whole.steps_.size() &&
               steps_[whole.steps_.size()].kind == Kind::Field;
    }

    /// Of a place that is not empty: what the last step leads to, and from where.
    Kind kind() const { return steps_.back().kind; }
    long long index() const { return steps_.back().number; }
    Place whole() const { return Place({steps_.begin(), steps_.end() - 1}); }
    /// The same part of another object.
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
