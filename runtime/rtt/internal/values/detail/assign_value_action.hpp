// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ASSIGN_VALUE_ACTION_HPP
#define ORO_ASSIGN_VALUE_ACTION_HPP

#include <rtt/base/ActionInterface.hpp>
#include <rtt/base/DataSourceBase.hpp>

namespace RTT {
namespace internal {

/** Assigns between two sources of the same C++ type, which need not be known here. */
class AssignValueAction : public base::ActionInterface {
public:
    typedef base::DataSourceBase::shared_ptr SourcePtr;

    AssignValueAction(SourcePtr target, SourcePtr source) : target_(std::move(target)), source_(std::move(source)) {}

    void readArguments() override { ready_ = source_->evaluate(); }
    bool execute() override {
        if (!ready_) return false;
        ready_ = false;
        return target_->assignValue(source_->getRawConstPointer());
    }
    ActionInterface* clone() const override { return new AssignValueAction(target_, source_); }
    ActionInterface* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        return new AssignValueAction(target_->copy(cloned), source_->copy(cloned));
    }

private:
    SourcePtr target_;
    SourcePtr source_;
    bool ready_ = false;
};

}  // namespace internal
}  // namespace RTT

#endif
