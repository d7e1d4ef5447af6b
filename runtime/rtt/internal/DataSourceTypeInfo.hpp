// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_DATASOURCE_TYPE_INFO_HPP
#define ORO_DATASOURCE_TYPE_INFO_HPP

#include <rtt/rtt-config.h>
#include <rtt/types/TypeInfo.hpp>
#include <atomic>
#include <string>
#include <type_traits>
#include <typeinfo>

namespace RTT {

namespace types {
class TypeInfo;
}

namespace internal {

/** Represents every C++ type that no typekit has registered; its name is "unknown_t". */
struct UnknownType {};

/** T without reference and const. */
template <class T>
struct remove_cr {
    typedef std::remove_cv_t<std::remove_reference_t<T>> type;
};

namespace detail {
/** Finds the type by the name of its type_info and keeps it in `cache`; unknown_t, which is not kept, if unknown. */
RTT_API types::TypeInfo* typeInfoFor(const std::type_info& id, std::atomic<types::TypeInfo*>& cache);
RTT_API const std::string& plainTypeName(const types::TypeInfo* info);
RTT_API const std::string& qualifierText(bool isConst, bool isReference, bool isPointer);
/** Plain name and qualifier. */
RTT_API std::string fullTypeName(const types::TypeInfo* info, const std::string& qualifier);

/** One cache per type, shared by T, T& and const T&. Types are found by name, so copies in several libraries agree. */
template <class T>
types::TypeInfo* cachedTypeInfo() {
    static std::atomic<types::TypeInfo*> cache{nullptr};
    if (types::TypeInfo* found = cache.load(std::memory_order_acquire)) return found;
    return typeInfoFor(typeid(T), cache);
}
}  // namespace detail

/** The registered type information of T. Never null: unregistered types yield that of UnknownType. */
template <class T>
struct DataSourceTypeInfo {
    typedef typename remove_cr<T>::type value_type;
    typedef DataSourceTypeInfo<value_type> value_type_info;

    static types::TypeInfo* getTypeInfo() { return detail::cachedTypeInfo<value_type>(); }
    static const std::string& getTypeName() { return detail::plainTypeName(getTypeInfo()); }
    /** " const&", " &" or nothing. */
    static const std::string& getQualifier() {
        return detail::qualifierText(std::is_const_v<std::remove_reference_t<T>>, std::is_reference_v<T>,
                                     std::is_pointer_v<std::remove_reference_t<T>>);
    }
    /** Plain name and qualifier. */
    static std::string getType() { return detail::fullTypeName(getTypeInfo(), getQualifier()); }
};

}  // namespace internal
}  // namespace RTT

#endif
