// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Sources that send an operation and collect its results. For every signature a handle is a
// DataSource<SentCall::shared_ptr>.
#ifndef RTT_INTERNAL_DETAIL_CALL_HANDLES_HPP
#define RTT_INTERNAL_DETAIL_CALL_HANDLES_HPP

#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/calls/call_source.hpp>

namespace RTT {
namespace internal {
namespace detail {

/** Sends with each evaluation; the value is the handle, null if the operation was refused. Fails like a CallSource. */
class SendSource final : public DataSource<SentCall::shared_ptr> {
public:
    explicit SendSource(GenericCall call) : call_(std::move(call)) {}
    bool evaluate() const override { return call_.send(sent_) || call_.report(); }
    SentCall::shared_ptr get() const override {
        if (!call_.send(sent_)) call_.fail();
        return sent_;
    }
    SentCall::shared_ptr value() const override { return sent_; }
    const SentCall::shared_ptr& rvalue() const override { return sent_; }
    SendSource* clone() const override { return new SendSource(call_); }
    SendSource* copy(CopyMap& cloned) const override { return new SendSource(call_.copy(cloned)); }

private:
    GenericCall call_;
    mutable SentCall::shared_ptr sent_;
};

/** Collects with each evaluation and assigns variables on success. The value is the status; CollectFailure if a
    variable cannot be assigned. */
class CollectSource final : public DataSource<SendStatus> {
public:
    typedef DataSource<SentCall::shared_ptr>::shared_ptr Handle;
    typedef std::vector<base::DataSourceBase::shared_ptr> Variables;

    /** The types of the variables have been checked. */
    CollectSource(const OperationTable& table, Handle handle, Variables variables,
                  DataSource<bool>::shared_ptr blocking);
    SendStatus get() const override;
    SendStatus value() const override { return status_; }
    const SendStatus& rvalue() const override { return status_; }
    CollectSource* clone() const override { return new CollectSource(*table_, handle_, variables_, blocking_); }
    CollectSource* copy(CopyMap& cloned) const override;

private:
    bool fill(SentCall& call) const;

    const OperationTable* table_;
    Handle handle_;
    Variables variables_;
    DataSource<bool>::shared_ptr blocking_;  // null means true
    mutable SendStatus status_ = SendNotReady;
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
