// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/FactoryExceptions.hpp>

namespace RTT {

name_not_found_exception::name_not_found_exception(const std::string& what_name)
    : std::runtime_error("there is no operation '" + what_name + "'"), name(what_name) {}
no_asynchronous_operation_exception::no_asynchronous_operation_exception(const std::string& reason)
    : std::runtime_error(reason) {}
no_synchronous_operation_exception::no_synchronous_operation_exception(const std::string& reason)
    : std::runtime_error(reason) {}
wrong_number_of_args_exception::wrong_number_of_args_exception(int w, int r)
    : std::runtime_error("wrong number of arguments: expected " + std::to_string(w) + ", found " + std::to_string(r)),
      wanted(w),
      received(r) {}
wrong_types_of_args_exception::wrong_types_of_args_exception(int which, const std::string& expected,
                                                             const std::string& received)
    : std::runtime_error("argument " + std::to_string(which) + " has the wrong type: expected " + expected +
                         ", found " + received),
      whicharg(which),
      expected_(expected),
      received_(received) {}
non_lvalue_args_exception::non_lvalue_args_exception(int which, const std::string& type)
    : std::runtime_error("argument " + std::to_string(which) +
                         " is changed by the operation: expected a variable, found a value of type " + type),
      whicharg(which),
      received_(type) {}
invalid_handle_exception::invalid_handle_exception()
    : std::runtime_error("the send handle belongs to no sent operation") {}

}  // namespace RTT
