// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A data source whose evaluation calls an operation.
#ifndef ORO_INTERNAL_CALL_SOURCE_HPP
#define ORO_INTERNAL_CALL_SOURCE_HPP

#include <rtt/FlowStatus.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/NA.hpp>
#include <rtt/internal/calls/typed_call.hpp>

#include <boost/shared_ptr.hpp>

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace RTT {
namespace base {
class OperationCallerInterface;
struct OperationDescription;
}  // namespace base
namespace internal {

struct OperationTable;

/** An operation with the sources of its arguments. */
class RTT_API GenericCall {
public:
    typedef base::DataSourceBase::shared_ptr Source;
    typedef std::map<const base::DataSourceBase*, base::DataSourceBase*> CopyMap;

    /** The types of the sources have been checked. The description is for messages. */
    GenericCall(boost::shared_ptr<base::OperationCallerInterface> caller, const OperationTable& table,
                std::vector<Source> arguments, std::shared_ptr<const base::OperationDescription> description);
    GenericCall(const GenericCall&);
    GenericCall(GenericCall&&) noexcept;
    ~GenericCall();

    /** Evaluates the arguments and calls; `result` is a ResultStore of the result's type. False, without a call, if an
        argument cannot be evaluated. Throws what the operation throws, which puts its component into Exception. */
    bool invoke(void* result) const;
    /** Evaluates the arguments and sends; `sent` is null if refused. False, without sending, if an argument cannot be
        evaluated. An operation that throws puts its component into Exception, whichever engine executes it. */
    bool send(SentCall::shared_ptr& sent) const;
    /** For use after invoke() or send() gave false: logs why; returns false. */
    bool report() const;
    /** The same, but throws std::runtime_error. */
    [[noreturn]] void fail() const;
    GenericCall copy(CopyMap& cloned) const;
    base::OperationCallerInterface& caller() const { return *caller_.get(); }

private:
    bool evaluateArguments() const;
    void threw(const char* what) const;
    std::string whyNot() const;

    boost::shared_ptr<base::OperationCallerInterface> caller_;
    const OperationTable* table_;
    std::vector<Source> arguments_;
    std::shared_ptr<const base::OperationDescription> description_;
    mutable std::vector<void*> addresses_;  // of the evaluated arguments
    mutable std::size_t failed_ = 0;        // the argument that could not be evaluated
};

/** Keeps the result, so that value() can give it again; it is a default value before the first call and after the
    operation threw. If an argument cannot be evaluated the operation is not called: evaluate() logs an error and is
    false, get() throws std::runtime_error. Both throw what the operation throws. */
template <class R>
class CallSource final : public DataSource<R> {
public:
    explicit CallSource(GenericCall call) : call_(std::move(call)) {}

    bool evaluate() const override { return call_.invoke(&result_) || call_.report(); }
    R get() const override {
        if (!call_.invoke(&result_)) call_.fail();
        return result_.get();
    }
    R value() const override { return kept().get(); }
    typename DataSource<R>::const_reference_t rvalue() const override { return kept().get(); }
    /** Null before the first evaluation. */
    const void* getRawConstPointer() override { return result_.address(); }
    [[gnu::cold]] CallSource* clone() const override { return new CallSource(call_); }
    [[gnu::cold]] CallSource* copy(GenericCall::CopyMap& cloned) const override {
        return new CallSource(call_.copy(cloned));
    }

private:
    const ResultStore<R>& kept() const {
        if (!result_.address()) result_.take(&NA<R>::na);
        return result_;
    }
    GenericCall call_;
    mutable ResultStore<R> result_;
};

extern template class CallSource<void>;
extern template class CallSource<bool>;
extern template class CallSource<int>;
extern template class CallSource<unsigned>;
extern template class CallSource<double>;
extern template class CallSource<std::string>;
extern template class CallSource<FlowStatus>;
extern template class CallSource<WriteStatus>;

}  // namespace internal
}  // namespace RTT

#endif
