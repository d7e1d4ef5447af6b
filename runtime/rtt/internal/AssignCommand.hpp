// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_ASSIGN_COMMAND_HPP
#define ORO_CORELIB_ASSIGN_COMMAND_HPP

#include <rtt/base/ActionInterface.hpp>
#include "DataSource.hpp"

namespace RTT {
namespace internal {

/** Assigns the value of one source to another when executed. As real-time safe as the assignment of T. */
template <typename T, typename S = T>
class AssignCommand : public base::ActionInterface {
public:
    typedef typename AssignableDataSource<T>::shared_ptr LHSSource;
    typedef typename DataSource<S>::const_ptr RHSSource;

    AssignCommand(LHSSource left, RHSSource right) : lhs_(std::move(left)), rhs_(std::move(right)) {}

    void readArguments() override { ready_ = rhs_->evaluate(); }
    bool execute() override {
        if (!ready_) return false;
        lhs_->set(rhs_->rvalue());
        ready_ = false;
        return true;
    }
    base::ActionInterface* clone() const override { return new AssignCommand(lhs_, rhs_); }
    base::ActionInterface* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        return new AssignCommand(lhs_->copy(cloned), rhs_->copy(cloned));
    }

private:
    LHSSource lhs_;
    RHSSource rhs_;
    bool ready_ = false;
};

}  // namespace internal
}  // namespace RTT

#endif
