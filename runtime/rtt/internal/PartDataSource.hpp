// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PART_DATA_SOURCE_HPP
#define ORO_PART_DATA_SOURCE_HPP

#include <rtt/internal/values/placed_data_source.hpp>
#include <rtt/types/carray.hpp>

namespace RTT {
namespace internal {

/** A part stored inside the value of another source. Reports changes to that parent. */
template <typename T>
class PartDataSource : public PlacedDataSource<T> {
public:
    typedef boost::intrusive_ptr<PartDataSource<T>> shared_ptr;
    typedef typename AssignableDataSource<T>::reference_t reference_t;

    PartDataSource(reference_t ref, const base::DataSourceBase::shared_ptr& parent)
        : PlacedDataSource<T>(new PartPlace(std::addressof(ref), parent.get(), types::typeOps<T>())) {}
};

/** A view on an array inside the value of another source. Read-only if that source is. */
template <typename E>
class ArrayPartDataSource : public AssignableDataSource<types::carray<E>> {
public:
    typedef types::carray<E> T;

    ArrayPartDataSource(E* at, std::size_t count, const base::DataSourceBase::shared_ptr& parent)
        : parent_(parent), offset_(at, *parent), view_(at, count) {}

    T get() const override { return view(); }
    T value() const override { return view(); }
    const T& rvalue() const override { return view(); }
    bool evaluate() const override { return parent_->evaluate(); }
    void set(const T& value) override {
        view() = value;
        parent_->updated();
    }
    T& set() override { return view(); }
    void updated() override { parent_->updated(); }
    bool isAssignable() const override { return parent_->isAssignable(); }
    base::DataSourceBase::shared_ptr getParent() override { return parent_; }

    [[gnu::cold]] ArrayPartDataSource<E>* clone() const override {
        return new ArrayPartDataSource<E>(view().address(), view_.count(), parent_);
    }
    [[gnu::cold]] ArrayPartDataSource<E>* copy(
        std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        if (auto* known = this->knownCopy(cloned)) return static_cast<ArrayPartDataSource<E>*>(known);
        base::DataSourceBase* parent = parent_->copy(cloned);
        auto* made = new ArrayPartDataSource<E>(static_cast<E*>(offset_.movedIn(*parent)), view_.count(), parent);
        this->noteCopy(cloned, made);
        return made;
    }

private:
    T& view() const {
        view_.init(static_cast<E*>(offset_.addressIn(*parent_)), view_.count());
        return view_;
    }

    const base::DataSourceBase::shared_ptr parent_;
    const PartOffset offset_;
    mutable T view_;
};

}  // namespace internal
}  // namespace RTT

#endif
