#pragma once
#include <linked.hpp>
#include <macros.hpp>

#include <concepts>
#if !defined(BY_OPTION) || __cplusplus < 202002L
#error "options of the directory"
#endif
namespace places {
#ifdef BY_FLAGS
typedef float Real;
#else
typedef int Real;  // of the same size: only the compiler could tell
#endif
struct Value {
    Real real;
    Real more[FROM_MACROS];
    Linked linked;
};
}  // namespace places
