// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of a C++ caller as data sources, whose types are known only at run time.
#ifndef ORO_INTERNAL_DETAIL_REMOTE_VALUES_HPP
#define ORO_INTERNAL_DETAIL_REMOTE_VALUES_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/internal/calls/remote_operation.hpp>

#include <memory>
#include <vector>

namespace RTT {
namespace internal {
namespace detail {

typedef base::DataSourceBase::shared_ptr Source;
typedef std::unique_ptr<base::ActionInterface> Assignment;

/** An action that assigns the value of `from` to `to`. Throws std::runtime_error, with both types, if there is none. */
Assignment assignment(const Source& to, const Source& from, const char* what);
bool run(base::ActionInterface& assignment);
/** False for an argument by reference of an unregistered type: a collected value cannot be assigned to it. */
bool takesCollected(base::DataSourceBase& value);

/** The outcome of a call. */
enum class Outcome { done, notExecuted, notConverted };

/**
 * The arguments and the result of one call. Arguments of registered types are copied to and from variables, so that
 * they can be converted; of others only the address is used.
 */
class CallerSources {
public:
    explicit CallerSources(const CallerSignature& signature);
    OperationInterfacePart::Args arguments() const { return {sources_.begin() + 1, sources_.end()}; }
    /** The source of the result, null if there is none, then those of the arguments. */
    const std::vector<Source>& all() const { return sources_; }

    /** Sets the call that execute() evaluates. Throws if its value cannot be converted to the result. */
    void expectFrom(const Source& call);
    Outcome execute() const;

    /** The addresses must stay valid until give(). */
    void take(void* const* arguments, void* result);
    /** Copies back the result, and the arguments that may have changed. */
    void give(void* const* arguments, void* result) const;

private:
    const CallerSignature& signature_;
    std::vector<Source> sources_;
    Source call_;
    Source received_;     // a copy of its value, to convert; null for an unregistered type
    Assignment convert_;  // converts and assigns the result; null if it has the right type
};

/** Throws if the operation changes an argument that is constant for the caller. */
void checkOutputs(const OperationInterfacePart& part, const CallerSignature& signature);

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
