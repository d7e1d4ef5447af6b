// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Tables for classes that an adapter describes; generated code provides the access to their parts.
#ifndef ORO_ADAPTED_TABLE_HPP
#define ORO_ADAPTED_TABLE_HPP

#include <rtt/rtt-config.h>
#include "SequenceOps.hpp"
#include "StructTable.hpp"
#include "TypeThunks.hpp"
#include "ValueTraits.hpp"
#include <array>
#include <vector>

namespace RTT {
namespace types {

/** Like memberAccess(), for a member to which a function returns a reference. */
constexpr SequenceOps memberAt(void* (*at)(void* object, std::size_t),
                               void (*load)(const void* object, std::size_t, void* field),
                               void (*store)(void* object, std::size_t, const void* field)) {
    SequenceOps ops = memberAccess(load, store);
    ops.at = at;
    return ops;
}

namespace detail {

/** `A` is generated and has Object, Element, size(), load(), store(), and perhaps at() and resize(). */
template <class A>
struct AdaptedSequence {
    using Object = typename A::Object;
    using Element = typename A::Element;

    static Object& of(void* c) { return *static_cast<Object*>(c); }
    static const Object& of(const void* c) { return *static_cast<const Object*>(c); }

    static std::size_t size(const void* c) { return static_cast<std::size_t>(A::size(of(c))); }
    /** Keeps the elements, because many classes drop them in a resize and leave new ones undefined. */
    static bool resize(void* c, std::size_t n) {
        const std::size_t old = size(c);
        if (n == old) return true;
        const Object before = of(c);
        A::resize(of(c), n);
        if (size(c) != n) {
            of(c) = before;
            return false;
        }
        for (std::size_t i = 0; i != n; ++i) {
            Element element = ValueTraits<Element>::make();
            if (i < old) A::load(before, i, element);
            A::store(of(c), i, element);
        }
        return true;
    }
    static void* at(void* c, std::size_t i) { return &reinterpret_cast<char&>(A::at(of(c), i)); }
    static void load(const void* c, std::size_t i, void* to) { A::load(of(c), i, *static_cast<Element*>(to)); }
    static void store(void* c, std::size_t i, const void* from) {
        A::store(of(c), i, *static_cast<const Element*>(from));
    }

    using Resize = bool (*)(void*, std::size_t);
    using At = void* (*)(void*, std::size_t);
    static constexpr Resize resizeOrNull() {
        if constexpr (A::canResize)
            return &resize;
        else
            return nullptr;
    }
    static constexpr At atOrNull() {
        if constexpr (A::hasAddress)
            return &at;
        else
            return nullptr;
    }
};

RTT_API void reportRow(std::size_t row, std::size_t size, std::size_t columns);

/** A matrix as the sequence of its rows. `A` is generated: Object, Element, Row, rows(), columns(), which of
    them never change, load(), store(), and resize() if it can. */
template <class A>
struct AdaptedMatrix {
    using Object = typename A::Object;
    using Element = typename A::Element;
    using Row = typename A::Row;

    static Object& of(void* c) { return *static_cast<Object*>(c); }
    static const Object& of(const void* c) { return *static_cast<const Object*>(c); }

    static std::size_t rows(const void* c) { return static_cast<std::size_t>(A::rows(of(c))); }
    static std::size_t columns(const void* c) { return static_cast<std::size_t>(A::columns(of(c))); }

    static bool resizeTo(Object& object, std::size_t newRows, std::size_t newColumns) {
        const std::size_t oldRows = rows(&object), oldColumns = columns(&object);
        if (newRows == oldRows && newColumns == oldColumns) return true;
        if constexpr (A::canResize) {
            // The class must not be asked to change a fixed dimension.
            if ((A::fixedRows && newRows != oldRows) || (A::fixedColumns && newColumns != oldColumns)) return false;
            const Object before = object;
            A::resize(object, newRows, newColumns);
            if (rows(&object) != newRows || columns(&object) != newColumns) {
                object = before;
                return false;
            }
            for (std::size_t r = 0; r != newRows; ++r) {
                for (std::size_t c = 0; c != newColumns; ++c) {
                    Element element = ValueTraits<Element>::make();
                    if (r < oldRows && c < oldColumns) A::load(before, r, c, element);
                    A::store(object, r, c, element);
                }
            }
            return true;
        } else {
            return false;
        }
    }
    static bool resize(void* c, std::size_t n) { return resizeTo(of(c), n, columns(c)); }

    static void load(const void* c, std::size_t i, void* to) {
        Row& row = *static_cast<Row*>(to);
        const std::size_t n = columns(c);
        if constexpr (hasFreeRows) row.resize(n);
        for (std::size_t j = 0; j != n; ++j) {
            Element element = ValueTraits<Element>::make();
            A::load(of(c), i, j, element);
            row[j] = element;
        }
    }
    /** The first row determines the number of columns. */
    static void store(void* c, std::size_t i, const void* from) {
        const Row& row = *static_cast<const Row*>(from);
        if (row.size() != columns(c) && (i != 0 || !resizeTo(of(c), rows(c), row.size())))
            return reportRow(i, row.size(), columns(c));
        for (std::size_t j = 0; j != row.size(); ++j) A::store(of(c), i, j, row[j]);
    }

    using Resize = bool (*)(void*, std::size_t);
    static constexpr Resize resizeOrNull() {
        if constexpr (A::canResize)
            return &resize;
        else
            return nullptr;
    }

private:
    static constexpr bool hasFreeRows = std::is_same<Row, std::vector<Element>>::value;
};

RTT_API TypeInfoGenerator* newAdaptedGenerator(const char* name, const char* doc, const SequenceOps& elements,
                                               const TypeOps& ops, const TypeThunks& thunks,
                                               std::size_t (*columns)(const void*) = nullptr);
}  // namespace detail

/** A sequence of the elements that `A` reaches. */
template <class A>
TypeInfoGenerator* makeAdaptedSequence(const char* name, const char* doc) {
    using S = detail::AdaptedSequence<A>;
    using T = typename A::Object;
    static constexpr SequenceOps table = {
        &S::size, &S::size, S::resizeOrNull(), S::atOrNull(), &S::load, &S::store, &typeRef<typename A::Element>};
    return detail::newAdaptedGenerator(name, doc, table, typeOps<T>(), typeThunks<T>());
}

/** A sequence of rows, which are sequences. */
template <class A>
TypeInfoGenerator* makeAdaptedMatrix(const char* name, const char* doc) {
    using S = detail::AdaptedMatrix<A>;
    using T = typename A::Object;
    static constexpr SequenceOps table = {&S::rows, &S::rows,  S::resizeOrNull(),        nullptr,
                                          &S::load, &S::store, &typeRef<typename A::Row>};
    return detail::newAdaptedGenerator(name, doc, table, typeOps<T>(), typeThunks<T>(), &S::columns);
}

}  // namespace types
}  // namespace RTT

#endif
