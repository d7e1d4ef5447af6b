// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Objects of RTT's classes that a constructor has made, by their places, and what was added to them.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_REGISTRY_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_REGISTRY_HPP

#include <deque>
#include <map>

#include "component_state.hpp"

namespace oroforge::cxx {

class Registry {
public:
    std::map<Place, Element> elements;
    std::map<Place, Scope*> scopes;
    std::map<Place, Requester*> requesters;
    std::map<Place, model::Activity> activities;
    std::optional<model::Activity> activity;
    model::InitialState initial = model::InitialState::Stopped;

    /// Returns null if there is none.
    Element* elementAt(const Place& place) { return at(elements, place); }
    Scope* scopeAt(const Place& place) {
        Scope** found = at(scopes, place);
        return found == nullptr ? nullptr : *found;
    }
    model::Activity* activityAt(const Place& place) { return at(activities, place); }

    Scope& makeScope(std::string name, diag::Location where) {
        allScopes_.push_back({std::move(name), "", std::move(where), {}, {}});
        return allScopes_.back();
    }
    Requester& makeRequester(std::string name, diag::Location where) {
        allRequesters_.push_back({std::move(name), std::move(where), {}});
        return allRequesters_.back();
    }

private:
    template <class Object>
    static Object* at(std::map<Place, Object>& objects, const Place& place) {
        const auto found = objects.find(place);
        return found == objects.end() ? nullptr : &found->second;
    }

    std::deque<Scope> allScopes_;
    std::deque<Requester> allRequesters_;
};

}  // namespace oroforge::cxx

#endif
