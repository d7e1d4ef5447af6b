// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A data source whose evaluation calls an operation.
#ifndef ORO_INTERNAL_CALL_SOURCE_HPP
#define ORO_INTERNAL_CALL_SOURCE_HPP

#include <rtt/FlowStatus.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/TypedCall.hpp>

#include <boost/shared_ptr.hpp>

#include <map>
#include <string>
#include <vector>

namespace RTT {
namespace base {
class OperationCallerInterface;
}
namespace internal {

struct OperationTable;

/** An operation with the sources of its arguments. */
class RTT_API GenericCall {
public:
    typedef base::DataSourceBase::shared_ptr Source;
    typedef std::map<const base::DataSourceBase*, base::DataSourceBase*> CopyMap;

    /** The types of the sources have been checked. */
    GenericCall(boost::shared_ptr<base::OperationCallerInterface> caller, const OperationTable& table,
                std::vector<Source> arguments);

    /** Evaluates the arguments and calls; `result` is a ResultStore of the result's type. */
    void invoke(void* result) const;
    /** Evaluates the arguments and sends; null if refused. */
    SentCall::shared_ptr send() const;
    GenericCall copy(CopyMap& cloned) const;

private:
    void evaluateArguments() const;

    boost::shared_ptr<base::OperationCallerInterface> caller_;
    const OperationTable* table_;
    std::vector<Source> arguments_;
    mutable std::vector<void*> addresses_;  // of the evaluated arguments
};

/** The result is kept, so that value() can give it again. */
template <class R>
class CallSource final : public DataSource<R> {
public:
    explicit CallSource(GenericCall call) : call_(std::move(call)) {}

    bool evaluate() const override {
        call_.invoke(&result_);
        return true;
    }
    R get() const override {
        call_.invoke(&result_);
        return result_.get();
    }
    R value() const override { return result_.get(); }
    typename DataSource<R>::const_reference_t rvalue() const override { return result_.get(); }
    /** Null before the first evaluation. */
    const void* getRawConstPointer() override { return result_.address(); }
    CallSource* clone() const override { return new CallSource(call_); }
    CallSource* copy(GenericCall::CopyMap& cloned) const override { return new CallSource(call_.copy(cloned)); }

private:
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
