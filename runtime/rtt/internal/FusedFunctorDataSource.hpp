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

/** The arguments of a call, as addresses of evaluated values. */
template <class... A>
class CallArguments {
public:
    typedef std::vector<base::DataSourceBase::shared_ptr> List;

    explicit CallArguments(const List& list) { std::copy_n(list.begin(), sizeof...(A), sources_.begin()); }

    /** True if number and types fit; arguments taken by non-const reference need assignable sources. */
    static bool accept(const List& list) {
        return list.size() == sizeof...(A) && accept(list, std::index_sequence_for<A...>());
    }
    /** False if one of them cannot be. */
    bool evaluate() const {
        return std::all_of(sources_.begin(), sources_.end(), [](const auto& source) { return source->evaluate(); });
    }
    /** After evaluate(). */
    template <class F>
    decltype(auto) call(const F& f) const {
        return callWith(f, std::index_sequence_for<A...>());
    }

    List copy(CopyMap& cloned) const {
        List copies;
        for (const auto& source : sources_) copies.push_back(source->copy(cloned));
        return copies;
    }
    List list() const { return List(sources_.begin(), sources_.end()); }

private:
    template <class T>
    static constexpr bool isOutput = std::is_lvalue_reference_v<T> && !std::is_const_v<std::remove_reference_t<T>>;

    template <class T>
    static bool acceptOne(const base::DataSourceBase::shared_ptr& source) {
        return source && source->getTypeId() && *source->getTypeId() == typeid(typename remove_cr<T>::type) &&
               (!isOutput<T> || source->isAssignable());
    }
    template <std::size_t... I>
    static bool accept(const List& list, std::index_sequence<I...>) {
        (void)list;
        return (acceptOne<A>(list[I]) && ...);
    }
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

    FusedFunctorDataSource(function_type f, detail::CallArguments<A...> arguments)
        : function_(std::move(f)), arguments_(std::move(arguments)), result_() {}

    bool evaluate() const override {
        if (!arguments_.evaluate()) return false;
        result_ = arguments_.call(function_);
        return true;
    }
    typename DataSource<R>::result_t get() const override {
        evaluate();
        return result_;
    }
    typename DataSource<R>::result_t value() const override { return result_; }
    typename DataSource<R>::const_reference_t rvalue() const override { return result_; }
    FusedFunctorDataSource* clone() const override { return new FusedFunctorDataSource(function_, arguments_); }
    FusedFunctorDataSource* copy(CopyMap& cloned) const override {
        return new FusedFunctorDataSource(function_, detail::CallArguments<A...>(arguments_.copy(cloned)));
    }

private:
    function_type function_;
    detail::CallArguments<A...> arguments_;
    mutable value_t result_;
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
        return new FusedFunctorDataSource(function_, detail::CallArguments<A...>(arguments_.copy(cloned)));
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
base::DataSourceBase* makeFunctorSource(F f, const std::vector<base::DataSourceBase::shared_ptr>& arguments,
                                        types::detail::Signature<R(A...)>) {
    if (!CallArguments<A...>::accept(arguments)) return nullptr;
    return new FusedFunctorDataSource<R(A...)>(std::move(f), CallArguments<A...>(arguments));
}
}  // namespace detail

/**
 * A new source that calls `f`, a function pointer or a function object whose signature can be told, on the
 * arguments; null if their number or types do not fit.
 */
template <class F>
base::DataSourceBase* newFunctorDataSource(F f, const std::vector<base::DataSourceBase::shared_ptr>& arguments) {
    return detail::makeFunctorSource(std::move(f), arguments, typename types::detail::SignatureOf<F>::type());
}

}  // namespace internal
}  // namespace RTT

#endif
