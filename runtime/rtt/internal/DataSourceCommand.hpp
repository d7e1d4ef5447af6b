// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_DATA_SOURCE_COMMAND_HPP
#define ORO_DATA_SOURCE_COMMAND_HPP

#include <rtt/base/ActionInterface.hpp>
#include "DataSource.hpp"

namespace RTT {
namespace internal {

/**
 * Evaluates a source when executed, such as a call whose result is not used. The value of a bool source says whether
 * the action succeeded. As real-time safe as the source.
 */
class DataSourceCommand : public base::ActionInterface {
public:
    explicit DataSourceCommand(base::DataSourceBase::shared_ptr source) : source_(std::move(source)) {}

    void readArguments() override {}
    bool execute() override {
        if (!source_->evaluate()) return false;
        auto* const answer = DataSource<bool>::narrow(source_.get());
        return !answer || answer->value();
    }
    void reset() override { source_->reset(); }
    base::ActionInterface* clone() const override { return new DataSourceCommand(source_); }
    base::ActionInterface* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        return new DataSourceCommand(source_->copy(cloned));
    }

private:
    base::DataSourceBase::shared_ptr source_;
};

}  // namespace internal
}  // namespace RTT

#endif
