// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_DATASOURCE_BASE_HPP
#define ORO_CORELIB_DATASOURCE_BASE_HPP

#include <rtt/rtt-config.h>
#include <boost/intrusive_ptr.hpp>
#include <atomic>
#include <exception>
#include <iosfwd>
#include <map>
#include <string>
#include <typeinfo>
#include <vector>

namespace RTT {

namespace types {
class TypeInfo;
}
namespace base {
class DataSourceBase;
class ActionInterface;
}  // namespace base

namespace internal {
/** Thrown by DataSourceBase::updateAction() when no assignment between the two types exists. */
struct RTT_API bad_assignment : std::exception {
    const char* what() const noexcept override;
};
}  // namespace internal

namespace base {
using internal::bad_assignment;

RTT_API void intrusive_ptr_add_ref(const DataSourceBase* source) noexcept;
RTT_API void intrusive_ptr_release(const DataSourceBase* source) noexcept;

/**
 * A value behind an interface that does not depend on its type: a constant, a variable, a member of another value, the
 * result of a function. Reference counted (atomically), so that expressions can share sources; always allocate with new
 * and hold in a shared_ptr.
 *
 * Reading, evaluating and updating are real-time safe if copying the value type is; creating and copying
 * sources allocates. One source must not be used by two threads at the same time.
 */
class RTT_API DataSourceBase {
public:
    typedef boost::intrusive_ptr<DataSourceBase> shared_ptr;
    typedef boost::intrusive_ptr<const DataSourceBase> const_ptr;

    DataSourceBase() noexcept : refs_(0) {}
    DataSourceBase(const DataSourceBase&) = delete;
    DataSourceBase& operator=(const DataSourceBase&) = delete;

    void ref() const noexcept { refs_.fetch_add(1, std::memory_order_relaxed); }
    void deref() const noexcept;
    /** Returns a new source as a plain pointer without the reference of `source`: the receiver takes the first one. */
    static DataSourceBase* release(shared_ptr&& source) noexcept {
        DataSourceBase* const plain = source.detach();
        if (plain) plain->refs_.fetch_sub(1, std::memory_order_relaxed);
        return plain;
    }

    /** Drops a stored result, if any. */
    virtual void reset();
    /** Computes the value anew; false if that failed. */
    virtual bool evaluate() const = 0;

    /** Assigns the value of `other` if that has exactly this type and this is assignable; otherwise false. */
    virtual bool update(DataSourceBase* other);
    /**
     * An action that assigns the then current value of `other` to this source, with conversions of the type. The caller
     * owns it. @throw bad_assignment
     */
    virtual ActionInterface* updateAction(DataSourceBase* other);
    /** True if the value can be changed through this source. */
    virtual bool isAssignable() const;
    /** Assigns the value at `value`, which must have exactly this source's type; false if not assignable. */
    virtual bool assignValue(const void* value);
    /** The C++ type of the value without reference and const; null if unknown. */
    virtual const std::type_info* getTypeId() const;
    /** True if both are known to hold the same C++ type, registered or not. */
    bool hasTypeOf(const DataSourceBase& other) const;
    /** Call it after changing the value through a reference or pointer. */
    virtual void updated();

    /** A new source of the same kind with its own value. */
    virtual DataSourceBase* clone() const = 0;
    /**
     * The counterpart of this source in a copied expression. Sources of a shared value return themselves.
     * `alreadyCloned` maps sources that were copied before to their copies.
     */
    virtual DataSourceBase* copy(std::map<const DataSourceBase*, DataSourceBase*>& alreadyCloned) const = 0;

    /** The type name with reference and const, such as "string const&". */
    virtual std::string getType() const = 0;
    /** Never null; "unknown_t" if no typekit knows the type. */
    virtual const types::TypeInfo* getTypeInfo() const = 0;
    /** The plain type name. */
    std::string getTypeName() const;

    /** Writes the value as text by the type's stream function. Not real-time safe. */
    std::ostream& write(std::ostream& os);
    std::string toString();

    /** The source that this one is a part of; itself if it is whole. */
    virtual shared_ptr getParent();
    /** A live part of the value by member name, dotted path of members, or sequence index; null if there is none. */
    virtual shared_ptr getMember(const std::string& name);
    virtual shared_ptr getMember(shared_ptr id);
    virtual std::vector<std::string> getMemberNames() const;

    /** The address of the stored value; null if it cannot be changed. */
    virtual void* getRawPointer();
    /** The address of the last evaluated value; null if there is none. */
    virtual const void* getRawConstPointer();
    /** True if both addresses stay the same as long as this source exists. */
    bool hasFixedAddress() const noexcept { return fixedAddress_; }
    /** From now on copy() makes a new variable each time instead of returning this one. Only for variables. */
    void copiesAnew() noexcept { copiedAnew_ = true; }
    /** For copy(): registers the copy of this source. */
    void noteCopy(std::map<const DataSourceBase*, DataSourceBase*>& alreadyCloned, DataSourceBase* made) const;

protected:
    virtual ~DataSourceBase();

    /** For constructors of sources that store their value, or refer to one that does not move. */
    void addressIsFixed() noexcept { fixedAddress_ = true; }

    bool isCopiedAnew() const noexcept { return copiedAnew_; }

    /** For copy(): the earlier copy of this source; null if there is none. */
    DataSourceBase* knownCopy(const std::map<const DataSourceBase*, DataSourceBase*>& alreadyCloned) const;

private:
    mutable std::atomic<int> refs_;
    bool fixedAddress_ = false;
    bool copiedAnew_ = false;
};

RTT_API std::ostream& operator<<(std::ostream& os, const DataSourceBase::shared_ptr& source);

}  // namespace base
}  // namespace RTT

#endif
