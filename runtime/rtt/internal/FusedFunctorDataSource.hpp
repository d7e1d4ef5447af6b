// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Data sources that call a C++ function on other data sources.
#ifndef ORO_FUSED_FUNCTOR_DATA_SOURCE_HPP
#define ORO_FUSED_FUNCTOR_DATA_SOURCE_HPP

#include <rtt/internal/DataSourceGenerator.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/NA.hpp>
#include <rtt/types/FunctionSignature.hpp>
#include <boost/function.hpp>
#include <algorithm>
#include <array>
#include <utility>

namespace RTT {
namespace internal {

namespace detail {

/** The type of an argument of a function. */
struct ArgumentType {
    const std::type_info* id;  ///< without reference and const
    bool isOutput;             ///< the function changes it
};

/** The arguments, converted where possible; variables that the function changes stay as they are. */
RTT_API std::vector<base::DataSourceBase::shared_ptr> convertedTo(
    const ArgumentType* types, std::size_t count, const std::vector<base::DataSourceBase::shared_ptr>& list);
/** True if number and types fit; an argument that the function changes must be assignable. */
RTT_API bool areArguments(const ArgumentType* types, std::size_t count,
                          const std::vector<base::DataSourceBase::shared_ptr>& list);
/**
 * The arguments, converted as by convertedTo(). Throws wrong_number_of_args_exception, wrong_types_of_args_exception or
 * non_lvalue_args_exception if they do not fit.
 */
RTT_API std::vector<base::DataSourceBase::shared_ptr> checkedArguments(
    const ArgumentType* types, std::size_t count, const std::vector<base::DataSourceBase::shared_ptr>& list);

/** The arguments of a call, as addresses of evaluated values. */
template <class... A>
class CallArguments {
public:
    typedef std::vector<base::DataSourceBase::shared_ptr> List;

    /** As checkedArguments(). */
    CallArguments(const List& list) {
        const List checked = checkedArguments(types.data(), types.size(), list);
        std::copy(checked.begin(), checked.end(), sources_.begin());
    }

    static bool accept(const List& list) { return areArguments(types.data(), types.size(), list); }
    static List convert(const List& list) { return convertedTo(types.data(), types.size(), list); }
    /** False if one of them cannot be evaluated. */
    bool evaluate() const {
        return std::all_of(sources_.begin(), sources_.end(), [](const auto& source) { return source->evaluate(); });
    }
    /** After evaluate(). */
    template <class F>
    decltype(auto) call(const F& f) const {
        return callWith(f, std::index_sequence_for<A...>());
    }

    CallArguments copy(CopyMap& cloned) const {
        CallArguments copies(*this);
        for (auto& source : copies.sources_) source = source->copy(cloned);
        return copies;
    }

private:
    template <class T>
    static constexpr bool isOutput = std::is_lvalue_reference_v<T> && !std::is_const_v<std::remove_reference_t<T>>;

    static constexpr std::array<ArgumentType, sizeof...(A)> types = {
        {{&typeid(typename remove_cr<A>::type), isOutput<A>}...}};

    template <class T>
    static decltype(auto) value(const base::DataSourceBase::shared_ptr& source) {
        using V = typename remove_cr<T>::type;
        if constexpr (isOutput<T>)
            return *static_cast<V*>(source->getRawPointer());
        else
            return *static_cast<const V*>(source->getRawConstPointer());
    }
    template <class F, std::size_t... I>
    decltype(auto) callWith(const F& f, std::index_sequence<I...>) const {
        return f(value<A>(sources_[I])...);
    }

    std::array<base::DataSourceBase::shared_ptr, sizeof...(A)> sources_;
};

}  // namespace detail

template <class Signature, class Enabled = void>
class FusedFunctorDataSource;

/** The result of a function that returns a value or a const reference: computed by each evaluate() and get(). */
template <class R, class... A>
class FusedFunctorDataSource<
    R(A...), std::enable_if_t<!std::is_lvalue_reference_v<R> || std::is_const_v<std::remove_reference_t<R>>>>
    : public DataSource<R> {
public:
    typedef typename DataSource<R>::value_t value_t;
    typedef boost::function<R(A...)> function_type;
    typedef typename DataSource<R>::const_reference_t const_reference_t;

    FusedFunctorDataSource(function_type f, detail::CallArguments<A...> arguments)
        : function_(std::move(f)), arguments_(std::move(arguments)), result_() {}

    bool evaluate() const override {
        if (!arguments_.evaluate()) return false;
        if constexpr (std::is_void_v<R>)
            arguments_.call(function_);
        else
            result_ = arguments_.call(function_);
        return true;
    }
    typename DataSource<R>::result_t get() const override {
        evaluate();
        return value();
    }
    typename DataSource<R>::result_t value() const override {
        if constexpr (!std::is_void_v<R>) return result_;
    }
    const_reference_t rvalue() const override {
        if constexpr (!std::is_void_v<R>) return result_;
    }
    FusedFunctorDataSource* clone() const override { return new FusedFunctorDataSource(function_, arguments_); }
    FusedFunctorDataSource* copy(CopyMap& cloned) const override {
        return new FusedFunctorDataSource(function_, arguments_.copy(cloned));
    }

private:
    function_type function_;
    detail::CallArguments<A...> arguments_;
    mutable std::conditional_t<std::is_void_v<R>, char, value_t> result_;
};

/** The result of a function that returns a reference: the variable it refers to, which can be assigned. */
template <class R, class... A>
class FusedFunctorDataSource<R&(A...), std::enable_if_t<!std::is_const_v<R>>> : public AssignableDataSource<R> {
public:
    typedef boost::function<R&(A...)> function_type;

    FusedFunctorDataSource(function_type f, detail::CallArguments<A...> arguments)
        : function_(std::move(f)), arguments_(std::move(arguments)) {}

    bool evaluate() const override {
        if (!arguments_.evaluate()) return false;
        result_ = std::addressof(arguments_.call(function_));
        return true;
    }
    R get() const override {
        evaluate();
        return referred();
    }
    R value() const override { return rvalue(); }
    const R& rvalue() const override {
        if (!result_) evaluate();
        return referred();
    }
    void set(typename AssignableDataSource<R>::param_t value) override { set() = value; }
    R& set() override {
        evaluate();
        return referred();
    }
    FusedFunctorDataSource* clone() const override { return new FusedFunctorDataSource(function_, arguments_); }
    FusedFunctorDataSource* copy(CopyMap& cloned) const override {
        return new FusedFunctorDataSource(function_, arguments_.copy(cloned));
    }

private:
    /** A default value if the arguments could never be evaluated. */
    R& referred() const { return result_ ? *result_ : NA<R&>::na(); }
    function_type function_;
    detail::CallArguments<A...> arguments_;
    mutable R* result_ = nullptr;
};

namespace detail {
template <class F, class R, class... A>
base::DataSourceBase* makeFunctorSource(F f, const std::vector<base::DataSourceBase::shared_ptr>& given,
                                        types::detail::Signature<R(A...)>) {
    const auto arguments = CallArguments<A...>::convert(given);
    if (!CallArguments<A...>::accept(arguments)) return nullptr;
    return new FusedFunctorDataSource<R(A...)>(std::move(f), CallArguments<A...>(arguments));
}
}  // namespace detail

/**
 * A new source that calls `f`, a function pointer or a function object with a single signature, on the arguments; null
 * if their number or types do not fit. Arguments are converted, except those that the function changes.
 */
template <class F>
base::DataSourceBase* newFunctorDataSource(F f, const std::vector<base::DataSourceBase::shared_ptr>& arguments) {
    return detail::makeFunctorSource(std::move(f), arguments, typename types::detail::SignatureOf<F>::type());
}

}  // namespace internal
}  // namespace RTT

#endif
