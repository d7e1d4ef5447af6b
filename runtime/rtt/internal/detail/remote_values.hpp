// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of a C++ caller as data sources, whose types are known at run time only.
#ifndef ORO_INTERNAL_DETAIL_REMOTE_VALUES_HPP
#define ORO_INTERNAL_DETAIL_REMOTE_VALUES_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/internal/RemoteOperation.hpp>

#include <memory>
#include <vector>

namespace RTT {
namespace internal {
namespace detail {

typedef base::DataSourceBase::shared_ptr Source;
typedef std::unique_ptr<base::ActionInterface> Assignment;

/** What assigns the value of `from` to `to`. Throws std::runtime_error with both types if nothing can. */
Assignment assignment(const Source& to, const Source& from, const char* what);
bool run(base::ActionInterface& assignment);
/** False for an argument by reference whose type the type system does not know: what is collected cannot be assigned. */
bool takesCollected(base::DataSourceBase& value);

/** What became of a call. */
enum class Outcome { done, notExecuted, notConverted };

/**
 * The arguments and the result of one call. Types of the type system have variables, which the arguments are copied to and
 * from, so that they can be converted; of others there is the address only.
 */
class CallerSources {
public:
    explicit CallerSources(const CallerSignature& signature);
    OperationInterfacePart::Args arguments() const { return {sources_.begin() + 1, sources_.end()}; }
    /** Of the result, then of the arguments. The first is null if there is no result. */
    const std::vector<Source>& all() const { return sources_; }

    /** What execute() evaluates. Throws if the result cannot be made of its value. */
    void expectFrom(const Source& call);
    Outcome execute() const;

    /** The addresses have to be valid until the values are given. */
    void take(void* const* arguments, void* result);
    /** Copies the result, and the arguments that may have been changed. */
    void give(void* const* arguments, void* result) const;

private:
    const CallerSignature& signature_;
    std::vector<Source> sources_;
    Source call_;
    Source received_;     // a copy of its value, for the conversion; null: of a type that has no variables
    Assignment convert_;  // assigns the result, converted; null: it is of the right type
};

/** A caller cannot have constants changed. Throws then. */
void checkOutputs(const OperationInterfacePart& part, const CallerSignature& signature);

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
