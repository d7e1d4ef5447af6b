// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef CORELIB_DATASOURCE_HPP
#define CORELIB_DATASOURCE_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/types/ValueTraits.hpp>
#include "DataSourceTypeInfo.hpp"

#include <type_traits>

namespace RTT {
namespace internal {

/** Shorthand for the map that copy() carries along. */
typedef std::map<const base::DataSourceBase*, base::DataSourceBase*> CopyMap;

/**
 * Lets a constructor take P as a pointer to a Source, plain or counted, or as nullptr. The literal 0 and {} are
 * excluded: they are values, although a parameter of type Source* would accept them.
 */
template <class P, class Source>
using IfSource = std::enable_if_t<std::is_convertible<P, boost::intrusive_ptr<Source>>::value>;

/**
 * A readable value of type T, which may be a reference type (the result of a function that returns one). get()
 * evaluates and returns; value() and rvalue() return the value of the last evaluation.
 */
template <typename T>
class DataSource : public base::DataSourceBase {
public:
    typedef typename remove_cr<T>::type value_t;
    typedef T result_t;
    typedef std::add_lvalue_reference_t<std::add_const_t<value_t>> const_reference_t;
    typedef boost::intrusive_ptr<DataSource<T>> shared_ptr;
    typedef boost::intrusive_ptr<const DataSource<T>> const_ptr;

    bool evaluate() const override;
    virtual result_t get() const = 0;
    virtual result_t value() const = 0;
    virtual const_reference_t rvalue() const = 0;

    DataSource<T>* clone() const override = 0;
    DataSource<T>* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const override = 0;

    std::string getType() const override;
    static std::string GetType() { return DataSourceTypeInfo<T>::getType(); }
    const types::TypeInfo* getTypeInfo() const override;
    static const types::TypeInfo* GetTypeInfo() { return DataSourceTypeInfo<T>::getTypeInfo(); }
    const std::type_info* getTypeId() const override;
    const void* getRawConstPointer() override;

    /** `source` as a source of exactly T; null if its type is another one. */
    static DataSource<T>* narrow(base::DataSourceBase* source) { return dynamic_cast<DataSource<T>*>(source); }
};

/** A value of type T that can also be changed. */
template <typename T>
class AssignableDataSource : public DataSource<T> {
public:
    typedef typename DataSource<T>::value_t value_t;
    typedef typename DataSource<T>::const_reference_t const_reference_t;
    typedef const_reference_t param_t;
    typedef value_t& reference_t;
    typedef boost::intrusive_ptr<AssignableDataSource<T>> shared_ptr;
    typedef boost::intrusive_ptr<const AssignableDataSource<T>> const_ptr;

    virtual void set(param_t value) = 0;
    /** The stored value, to be changed in place; call updated() afterwards. */
    virtual reference_t set() = 0;

    bool isAssignable() const override { return std::is_copy_assignable<value_t>::value; }
    bool assignValue(const void* value) override;
    void* getRawPointer() override;

    AssignableDataSource<T>* clone() const override = 0;
    AssignableDataSource<T>* copy(
        std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const override = 0;

    static AssignableDataSource<T>* narrow(base::DataSourceBase* source) {
        return dynamic_cast<AssignableDataSource<T>*>(source);
    }
};

}  // namespace internal
}  // namespace RTT

#include "DataSource.inl"

#endif
