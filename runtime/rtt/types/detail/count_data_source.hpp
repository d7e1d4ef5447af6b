// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_COUNT_DATA_SOURCE_HPP
#define ORO_COUNT_DATA_SOURCE_HPP

#include <rtt/internal/DataSource.hpp>
#include <cstddef>
#include <utility>

namespace RTT {
namespace types {
namespace detail {

/** The number of elements, read anew each time. */
class CountDataSource : public internal::DataSource<int> {
public:
    CountDataSource(base::DataSourceBase::shared_ptr of, std::size_t (*count)(const void*))
        : of_(std::move(of)), count_(count), last_(0) {}

    int get() const override {
        last_ = of_->evaluate() ? static_cast<int>(count_(of_->getRawConstPointer())) : 0;
        return last_;
    }
    int value() const override { return last_; }
    const int& rvalue() const override { return last_; }
    CountDataSource* clone() const override { return new CountDataSource(of_, count_); }
    CountDataSource* copy(internal::CopyMap& cloned) const override {
        return new CountDataSource(of_->copy(cloned), count_);
    }

private:
    base::DataSourceBase::shared_ptr of_;
    std::size_t (*count_)(const void*);
    mutable int last_;
};

}  // namespace detail
}  // namespace types
}  // namespace RTT

#endif
