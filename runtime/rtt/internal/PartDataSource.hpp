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

/** What parts have in common, whatever their type: where they are in the value of their parent, which is kept alive. */
class RTT_API PartPlace {
public:
    PartPlace(void* at, base::DataSourceBase* parent);

    /** Found anew if the parent's value may move, because it is an element of a container. */
    void* address() const { return parent->hasFixedAddress() ? at_ : moved(); }
    /** The place of this part in a copy of the parent. */
    void* addressIn(base::DataSourceBase& copyOfParent) const;

    const base::DataSourceBase::shared_ptr parent;

private:
    void* moved() const;

    void* at_;
    std::ptrdiff_t offset_;
};

/** A part, stored inside the value of another source. Changes are reported to the parent. */
template <typename T>
class PartDataSource : public AssignableDataSource<T> {
public:
    typedef boost::intrusive_ptr<PartDataSource<T>> shared_ptr;
    typedef typename AssignableDataSource<T>::reference_t reference_t;
    typedef typename DataSource<T>::value_t value_t;

    PartDataSource(reference_t ref, const base::DataSourceBase::shared_ptr& parent)
        : PartDataSource(ref, parent.get()) {}
    PartDataSource(reference_t ref, base::DataSourceBase* parent) : place_(std::addressof(ref), parent) {
        if (place_.parent->hasFixedAddress()) this->addressIsFixed();
    }

    [[gnu::cold, gnu::noinline]] static PartDataSource<T>* make(reference_t ref, base::DataSourceBase* parent) {
        return new PartDataSource<T>(ref, parent);
    }

    typename DataSource<T>::result_t get() const override { return types::copyOf<T>(part()); }
    typename DataSource<T>::result_t value() const override { return types::copyOf<T>(part()); }
    typename DataSource<T>::const_reference_t rvalue() const override { return part(); }
    bool evaluate() const override { return place_.parent->evaluate(); }
    void set(typename AssignableDataSource<T>::param_t value) override {
        types::assignValue(part(), value);
        place_.parent->updated();
    }
    reference_t set() override { return part(); }
    void updated() override { place_.parent->updated(); }
    base::DataSourceBase::shared_ptr getParent() override { return place_.parent; }

    [[gnu::cold]] PartDataSource<T>* clone() const override { return make(part(), place_.parent.get()); }
    [[gnu::cold]] PartDataSource<T>* copy(
        std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        if (auto* known = this->knownCopy(cloned)) return static_cast<PartDataSource<T>*>(known);
        base::DataSourceBase* parent = place_.parent->copy(cloned);
        auto* made = make(*static_cast<value_t*>(place_.addressIn(*parent)), parent);
        this->noteCopy(cloned, made);
        return made;
    }

private:
    value_t& part() const { return *static_cast<value_t*>(place_.address()); }

    PartPlace place_;
};

/** An array inside the value of another source; its value is a view on the array. */
template <typename E>
class ArrayPartDataSource : public AssignableDataSource<types::carray<E>> {
public:
    typedef types::carray<E> T;

    ArrayPartDataSource(E* at, std::size_t count, const base::DataSourceBase::shared_ptr& parent)
        : place_(at, parent.get()), view_(at, count) {}

    T get() const override { return view(); }
    T value() const override { return view(); }
    const T& rvalue() const override { return view(); }
    bool evaluate() const override { return place_.parent->evaluate(); }
    void set(const T& value) override {
        view() = value;
        place_.parent->updated();
    }
    T& set() override { return view(); }
    void updated() override { place_.parent->updated(); }
    base::DataSourceBase::shared_ptr getParent() override { return place_.parent; }

    [[gnu::cold]] ArrayPartDataSource<E>* clone() const override {
        return new ArrayPartDataSource<E>(view().address(), view_.count(), place_.parent);
    }
    [[gnu::cold]] ArrayPartDataSource<E>* copy(
        std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        if (auto* known = this->knownCopy(cloned)) return static_cast<ArrayPartDataSource<E>*>(known);
        base::DataSourceBase* parent = place_.parent->copy(cloned);
        auto* made = new ArrayPartDataSource<E>(static_cast<E*>(place_.addressIn(*parent)), view_.count(), parent);
        this->noteCopy(cloned, made);
        return made;
    }

private:
    T& view() const {
        view_.init(static_cast<E*>(place_.address()), view_.count());
        return view_;
    }

    PartPlace place_;
    mutable T view_;
};

}  // namespace internal
}  // namespace RTT

#endif
