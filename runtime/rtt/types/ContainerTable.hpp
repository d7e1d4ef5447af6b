// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Tables of standard containers other than std::vector, which are sequences in scripts and property files.
#ifndef ORO_CONTAINER_TABLE_HPP
#define ORO_CONTAINER_TABLE_HPP

#include "KeyValue.hpp"
#include "SequenceTable.hpp"
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace RTT {
namespace types {

namespace detail {

/** std::list and std::forward_list: elements have addresses, but are found by counting from the first one. */
template <class C>
struct LinkedSequence {
    using Element = typename C::value_type;

    static std::size_t size(const void* c) {
        const C& all = *static_cast<const C*>(c);
        return static_cast<std::size_t>(std::distance(all.begin(), all.end()));
    }
    static bool resize(void* c, std::size_t n) {
        static_cast<C*>(c)->resize(n);
        return true;
    }
    static void* at(void* c, std::size_t i) {
        auto element = static_cast<C*>(c)->begin();
        std::advance(element, i);
        return std::addressof(*element);
    }
    static void load(const void* c, std::size_t i, void* to) {
        *static_cast<Element*>(to) = *static_cast<const Element*>(at(const_cast<void*>(c), i));
    }
    static void store(void* c, std::size_t i, const void* from) {
        *static_cast<Element*>(at(c, i)) = *static_cast<const Element*>(from);
    }
    static void visit(const void* c, void (*each)(void*, const void*), void* context) {
        for (const Element& element : *static_cast<const C*>(c)) each(context, std::addressof(element));
    }
};

template <class C, class = void>
struct IsMap : std::false_type {};
template <class C>
struct IsMap<C, std::void_t<typename C::mapped_type>> : std::true_type {};

template <class C, class = void>
struct IsOrdered : std::false_type {};
template <class C>
struct IsOrdered<C, std::void_t<typename C::key_compare>> : std::true_type {};

template <class C, bool map = IsMap<C>::value>
struct KeyedElement {
    using Type = typename C::value_type;
    static const Type& of(const typename C::value_type& element) { return element; }
    static typename C::value_type from(const Type& element) { return element; }
    static const typename C::key_type& key(const Type& element) { return element; }
    static constexpr bool hasValue = false;
};
template <class C>
struct KeyedElement<C, true> {
    using Type = KeyValue<typename C::key_type, typename C::mapped_type>;
    static Type of(const typename C::value_type& element) { return {element.first, element.second}; }
    static typename C::value_type from(const Type& element) { return {element.key, element.value}; }
    static const typename C::key_type& key(const Type& element) { return element.key; }
    static constexpr bool hasValue = true;
};

/** Sets and maps. Hashing ones are shown in the order of their keys, so that files do not depend on the library. */
template <class C>
struct Keyed {
    using Rules = KeyedElement<C>;
    using Element = typename Rules::Type;
    using Place = typename C::const_iterator;

    static const C& of(const void* c) { return *static_cast<const C*>(c); }
    static C& of(void* c) { return *static_cast<C*>(c); }

    static const auto& keyAt(const Place& place) {
        if constexpr (Rules::hasValue)
            return place->first;
        else
            return *place;
    }
    static std::vector<Place> sorted(const C& all) {
        std::vector<Place> places;
        places.reserve(all.size());
        for (Place place = all.begin(); place != all.end(); ++place) places.push_back(place);
        std::stable_sort(places.begin(), places.end(),
                         [](const Place& a, const Place& b) { return keyAt(a) < keyAt(b); });
        return places;
    }
    static Place placeOf(const C& all, std::size_t i) {
        if constexpr (IsOrdered<C>::value)
            return std::next(all.begin(), static_cast<std::ptrdiff_t>(i));
        else
            return sorted(all)[i];
    }

    static std::size_t size(const void* c) { return of(c).size(); }
    static bool resize(void* c, std::size_t n) {
        if (n == 0) of(c).clear();
        return of(c).size() == n;
    }
    static void load(const void* c, std::size_t i, void* to) {
        *static_cast<Element*>(to) = Rules::of(*placeOf(of(c), i));
    }
    /** An element with another key moves, as in the container itself. */
    static void store(void* c, std::size_t i, const void* from) {
        C& all = of(c);
        all.erase(placeOf(all, i));
        all.insert(Rules::from(*static_cast<const Element*>(from)));
    }
    static bool insert(void* c, const void* element) {
        const std::size_t before = size(c);
        of(c).insert(Rules::from(*static_cast<const Element*>(element)));
        return size(c) != before;
    }
    static void visit(const void* c, void (*each)(void*, const void*), void* context) {
        const auto show = [&](const typename C::value_type& value) {
            const Element& element = Rules::of(value);
            each(context, std::addressof(element));
        };
        if constexpr (IsOrdered<C>::value) {
            for (const auto& value : of(c)) show(value);
        } else {
            for (const Place& place : sorted(of(c))) show(*place);
        }
    }
};

/** std::optional: a sequence with no element or one. */
template <class C>
struct Optional {
    using Element = typename C::value_type;

    static C& of(void* c) { return *static_cast<C*>(c); }
    static std::size_t size(const void* c) { return static_cast<const C*>(c)->has_value() ? 1 : 0; }
    static std::size_t capacity(const void*) { return 1; }
    static bool resize(void* c, std::size_t n) {
        if (n > 1) return false;
        if (n == 0)
            of(c).reset();
        else if (!of(c))
            of(c).emplace();
        return true;
    }
    static void* at(void* c, std::size_t) { return std::addressof(*of(c)); }
    static void load(const void* c, std::size_t, void* to) { *static_cast<Element*>(to) = **static_cast<const C*>(c); }
    static void store(void* c, std::size_t, const void* from) { *of(c) = *static_cast<const Element*>(from); }
};

}  // namespace detail

/** For std::list and std::forward_list. */
template <class C>
const SequenceOps& linkedOps() {
    using S = detail::LinkedSequence<C>;
    static constexpr SequenceOps table = {
        &S::size, &S::size, &S::resize, &S::at, &S::load, &S::store, &typeRef<typename S::Element>, nullptr, &S::visit};
    return table;
}

/** For sets, and for maps, whose elements are KeyValue, a separate type. */
template <class C>
const SequenceOps& keyedOps() {
    using S = detail::Keyed<C>;
    static constexpr SequenceOps table = {
        &S::size,   &S::size, &S::resize, nullptr, &S::load, &S::store, &typeRef<typename S::Element>,
        &S::insert, &S::visit};
    return table;
}

template <class C>
const SequenceOps& optionalOps() {
    using S = detail::Optional<C>;
    static constexpr SequenceOps table = {
        &S::size, &S::capacity, &S::resize, &S::at, &S::load, &S::store, &typeRef<typename S::Element>};
    return table;
}

}  // namespace types
}  // namespace RTT

#endif
