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
 * All types of the process, by name and by C++ type. C++ types are compared by type_info::name(), so that
 * plugins agree whatever way they were loaded. Thread safe; not for real-time contexts.
 */
class RTT_API TypeInfoRepository {
public:
    typedef boost::shared_ptr<TypeInfoRepository> shared_ptr;

    static shared_ptr Instance();
    /** For programs that end with it: nothing happens, the types are kept until the process ends. */
    static void Release() {}
    ~TypeInfoRepository();

    /**
     * Takes ownership of the generator. A further name for a known C++ type becomes an alias and the new factories
     * replace the old ones; a name that another C++ type has is refused with an error in the log.
     */
    bool addType(TypeInfoGenerator* generator);
    /** Takes ownership. */
    bool addType(TypeInfo* info);
    /** A further name for a registered type; false, and an error in the log, if another type has it. */
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
    /** The type that stands for all unregistered ones: "unknown_t". */
    TypeInfo* unknownType() const;

    /** Registered names, sorted. */
    std::vector<std::string> getTypes() const;
    std::vector<std::string> getDottedTypes() const;
    /** "/pkg/Type" as scripts write it: "pkg.Type". */
    std::string toDot(const std::string& name) const;

    /** Offers each known and every later type to the transport. Does not take ownership. */
    void registerTransport(TransportPlugin* transport);
    /** A function that may load a typekit for an unknown name and says whether it did. */
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
