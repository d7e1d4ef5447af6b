// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SHOWN_TABLE_HPP
#define ORO_SHOWN_TABLE_HPP

#include <rtt/rtt-config.h>
#include "StructTable.hpp"
#include <chrono>
#include <string>
#include <type_traits>
#include "TypeThunks.hpp"

namespace RTT {
namespace types {

/** Another type as which values are shown and from which they are read. */
struct ShownAs {
    TypeRef type;
    void (*show)(const void* value, void* shown);
    /** False if there is no such value. */
    bool (*take)(const void* shown, void* value);
    /** A further type with conversions from and to. */
    const ShownAs* also = nullptr;
};

namespace detail {

template <class T>
struct TickCount {
    static auto of(const T& duration) { return duration.count(); }
    using Duration = T;
};
template <class Clock, class D>
struct TickCount<std::chrono::time_point<Clock, D>> {
    static auto of(const std::chrono::time_point<Clock, D>& time) { return time.time_since_epoch().count(); }
    using Duration = D;
};

/** `Number` is what a T holds, `get` and `make` convert between them. */
template <class T, class Shown, class Number, Number (*get)(const T&), T (*make)(Number)>
struct NumberTable {
    static void show(const void* value, void* shown) {
        *static_cast<Shown*>(shown) = static_cast<Shown>(get(*static_cast<const T*>(value)));
    }
    static bool take(const void* shown, void* value) {
        const Shown number = *static_cast<const Shown*>(shown);
        if (!std::is_floating_point_v<Number> && static_cast<Shown>(static_cast<Number>(number)) != number)
            return false;
        *static_cast<T*>(value) = make(static_cast<Number>(number));
        return true;
    }
    static constexpr ShownAs table(const ShownAs* also) { return {&typeRef<Shown>, &show, &take, also}; }
};

template <class T, class N = typename TickCount<T>::Duration::rep>
struct Ticks {
    static N get(const T& value) { return TickCount<T>::of(value); }
    static T make(N number) { return T(typename TickCount<T>::Duration(number)); }
    template <class Shown>
    using Table = NumberTable<T, Shown, N, &get, &make>;
};

template <class T, class N>
struct Plain {
    static N get(const T& value) { return static_cast<N>(value); }
    static T make(N number) { return static_cast<T>(number); }
    template <class Shown>
    using Table = NumberTable<T, Shown, N, &get, &make>;
};

/** The number with all its digits. */
RTT_API std::string textOf(long double number);
RTT_API bool fromText(const std::string& text, long double& number);

RTT_API TypeInfoGenerator* newShownGenerator(const char* name, const char* doc, TypeRef self, const TypeOps& ops,
                                             const TypeThunks& thunks, const ShownAs& shown);
}  // namespace detail

/** A duration or time point as its number of ticks. */
template <class T>
const ShownAs& shownAsCount() {
    using Ticks = detail::Ticks<T>;
    constexpr bool isReal = std::is_floating_point_v<typename detail::TickCount<T>::Duration::rep>;
    static constexpr ShownAs asInt = Ticks::template Table<int>::table(nullptr);
    static constexpr ShownAs table =
        Ticks::template Table<std::conditional_t<isReal, double, long long>>::table(&asInt);
    return table;
}

/** Wide characters and std::byte as their number. */
template <class T>
const ShownAs& shownAsNumber() {
    using Number = std::conditional_t<sizeof(T) == 1, unsigned char, std::conditional_t<sizeof(T) == 2, char16_t, int>>;
    static constexpr ShownAs table = detail::Plain<T, Number>::template Table<int>::table(nullptr);
    return table;
}

/** long double as text, so that files keep all its digits; scripts may compute with it as a double. */
template <class T>
const ShownAs& shownAsText() {
    static constexpr ShownAs asDouble = detail::Plain<T, long double>::template Table<double>::table(nullptr);
    static constexpr ShownAs table = {
        &typeRef<std::string>,
        [](const void* value, void* shown) {
            *static_cast<std::string*>(shown) = detail::textOf(*static_cast<const T*>(value));
        },
        [](const void* shown, void* value) {
            return detail::fromText(*static_cast<const std::string*>(shown), *static_cast<T*>(value));
        },
        &asDouble,
    };
    return table;
}

/** A std::bitset as its digits, the highest bit first. */
template <class T>
const ShownAs& shownAsDigits() {
    static constexpr ShownAs table = {
        &typeRef<std::string>,
        [](const void* value, void* shown) {
            *static_cast<std::string*>(shown) = static_cast<const T*>(value)->to_string();
        },
        [](const void* shown, void* value) {
            const std::string& digits = *static_cast<const std::string*>(shown);
            T& bits = *static_cast<T*>(value);
            if (digits.size() > bits.size() || digits.find_first_not_of("01") != std::string::npos) return false;
            bits = T(digits);
            return true;
        },
    };
    return table;
}

/** A type that shows, reads and stores its values as those of another type: a duration as a number of ticks. */
template <class T>
TypeInfoGenerator* makeShownType(const char* name, const ShownAs& shown, const char* doc = "") {
    return detail::newShownGenerator(name, doc, &typeRef<T>, typeOps<T>(), typeThunks<T>(), shown);
}

}  // namespace types
}  // namespace RTT

#endif
