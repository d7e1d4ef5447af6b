// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_INFO_REPOSITORY_HPP
#define ORO_TYPE_INFO_REPOSITORY_HPP

#include <rtt/internal/DataSourceTypeInfo.hpp>
#include <boost/function.hpp>
#include <boost/shared_ptr.hpp>
#include <memory>
#include <string>
#include <vector>

namespace RTT {
namespace types {

class TypeInfo;
class TypeInfoGenerator;
class TransportPlugin;

/**
 * All types of the process, by name and by C++ type. C++ types are compared by type_info::name(), so that plugins agree
 * however they were loaded. Thread safe; not for real-time contexts.
 */
class RTT_API TypeInfoRepository {
public:
    typedef boost::shared_ptr<TypeInfoRepository> shared_ptr;

    static shared_ptr Instance();
    /** Does nothing, because the types are kept until the process ends. For programs that call it at their end. */
    static void Release() {}
    ~TypeInfoRepository();

    /**
     * Takes ownership of the generator. Another name for a known C++ type becomes an alias, and the new factories
     * replace the old ones. A name that another C++ type has is refused with an error in the log.
     */
    bool addType(TypeInfoGenerator* generator);
    /** Takes ownership. */
    bool addType(TypeInfo* info);
    /** Adds a name for a registered type. Logs an error and returns false if another type has it. */
    bool aliasType(const std::string& alias, TypeInfo* info);

    /** The type of that name (exact, dotted or alias), asking the auto-loader once for unknown names; or null. */
    TypeInfo* type(const std::string& name) const;
    /** The type of that C++ type, or null. */
    TypeInfo* getTypeById(const std::type_info* id) const;
    TypeInfo* getTypeById(const char* idName) const;
    template <class T>
    TypeInfo* getTypeInfo() const {
        return getTypeById(&typeid(typename internal::remove_cr<T>::type));
    }
    /** The type that views on arrays of the given element type have, or null. */
    TypeInfo* getArrayType(const char* elementIdName) const;
    /** The type used for all unregistered ones: "unknown_t". */
    TypeInfo* unknownType() const;

    /** Registered names, sorted. */
    std::vector<std::string> getTypes() const;
    std::vector<std::string> getDottedTypes() const;
    /** "/pkg/Type" as scripts write it: "pkg.Type". */
    std::string toDot(const std::string& name) const;

    /** Offers each known and every later type to the transport. Does not take ownership. */
    void registerTransport(TransportPlugin* transport);
    /** Sets a function that may load a typekit for an unknown name and returns whether it did. */
    void setAutoLoader(const boost::function<bool(const std::string&)>& loader);
    /** Writes all types to the log, at level Debug. */
    void logTypeInfo() const;

private:
    TypeInfoRepository();
    struct State;
    std::unique_ptr<State> state_;
};

/** Shortcut for TypeInfoRepository::Instance(). */
RTT_API TypeInfoRepository::shared_ptr Types();

}  // namespace types
}  // namespace RTT

#endif
