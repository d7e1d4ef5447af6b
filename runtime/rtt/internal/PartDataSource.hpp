// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PART_DATA_SOURCE_HPP
#define ORO_PART_DATA_SOURCE_HPP

#include <rtt/types/carray.hpp>
#include "DataSource.hpp"
#include <memory>
#include <cstddef>

namespace RTT {
namespace internal {

/** How many bytes `part` lies behind the start of its parent's value. */
RTT_API std::ptrdiff_t partOffset(const void* part, base::DataSourceBase& parent);

/**
 * A part, stored inside the value of another source, which is kept alive. Changes are reported to the parent.
 * The parent's value must not move while parts of it are in use.
 */
template <typename T>
class PartDataSource : public AssignableDataSource<T> {
public:
    typedef boost::intrusive_ptr<PartDataSource<T>> shared_ptr;
    typedef typename AssignableDataSource<T>::reference_t reference_t;

    PartDataSource(reference_t ref, base::DataSourceBase::shared_ptr parent)
        : ref_(std::addressof(ref)), parent_(std::move(parent)) {}

    typename DataSource<T>::result_t get() const override { return *ref_; }
    typename DataSource<T>::result_t value() const override { return *ref_; }
    typename DataSource<T>::const_reference_t rvalue() const override { return *ref_; }
    bool evaluate() const override { return parent_->evaluate(); }
    void set(typename AssignableDataSource<T>::param_t value) override {
        *ref_ = value;
        parent_->updated();
    }
    reference_t set() override { return *ref_; }
    void updated() override { parent_->updated(); }
    base::DataSourceBase::shared_ptr getParent() override { return parent_; }

    PartDataSource<T>* clone() const override { return new PartDataSource<T>(*ref_, parent_); }
    PartDataSource<T>* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        if (auto* known = this->knownCopy(cloned)) return static_cast<PartDataSource<T>*>(known);
        base::DataSourceBase* parent = parent_->copy(cloned);
        auto* at = static_cast<char*>(parent->getRawPointer()) + partOffset(ref_, *parent_);
        auto* made = new PartDataSource<T>(*reinterpret_cast<typename DataSource<T>::value_t*>(at), parent);
        this->noteCopy(cloned, made);
        return made;
    }

private:
    typename DataSource<T>::value_t* ref_;
    base::DataSourceBase::shared_ptr parent_;
};

/** An array inside the value of another source, which is kept alive; its value is a view on the array. */
template <typename E>
class ArrayPartDataSource : public AssignableDataSource<types::carray<E>> {
public:
    typedef types::carray<E> T;

    ArrayPartDataSource(E* at, std::size_t count, base::DataSourceBase::shared_ptr parent)
        : view_(at, count), parent_(std::move(parent)) {}

    T get() const override { return view_; }
    T value() const override { return view_; }
    const T& rvalue() const override { return view_; }
    bool evaluate() const override { return parent_->evaluate(); }
    void set(const T& value) override {
        view_ = value;
        parent_->updated();
    }
    T& set() override { return view_; }
    void updated() override { parent_->updated(); }
    base::DataSourceBase::shared_ptr getParent() override { return parent_; }

    ArrayPartDataSource<E>* clone() const override {
        return new ArrayPartDataSource<E>(view_.address(), view_.count(), parent_);
    }
    ArrayPartDataSource<E>* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        if (auto* known = this->knownCopy(cloned)) return static_cast<ArrayPartDataSource<E>*>(known);
        base::DataSourceBase* parent = parent_->copy(cloned);
        auto* at = static_cast<char*>(parent->getRawPointer()) + partOffset(view_.address(), *parent_);
        auto* made = new ArrayPartDataSource<E>(reinterpret_cast<E*>(at), view_.count(), parent);
        this->noteCopy(cloned, made);
        return made;
    }

private:
    T view_;
    base::DataSourceBase::shared_ptr parent_;
};

}  // namespace internal
}  // namespace RTT

#endif
