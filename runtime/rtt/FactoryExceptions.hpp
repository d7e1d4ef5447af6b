// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Errors of generic calls of operations, thrown while a call is put together and never while it runs.
#ifndef ORO_FACTORY_EXCEPTIONS_HPP
#define ORO_FACTORY_EXCEPTIONS_HPP

#include <rtt/rtt-config.h>

#include <stdexcept>
#include <string>

namespace RTT {

struct RTT_API name_not_found_exception : std::runtime_error {
    explicit name_not_found_exception(const std::string& what_name = "");
    std::string name;
};

struct RTT_API no_asynchronous_operation_exception : std::runtime_error {
    explicit no_asynchronous_operation_exception(const std::string& reason);
};

struct RTT_API no_synchronous_operation_exception : std::runtime_error {
    explicit no_synchronous_operation_exception(const std::string& reason);
};

struct RTT_API wrong_number_of_args_exception : std::runtime_error {
    wrong_number_of_args_exception(int wanted, int received);
    int wanted, received;
};

struct RTT_API wrong_types_of_args_exception : std::runtime_error {
    wrong_types_of_args_exception(int which_argument, const std::string& expected, const std::string& received);
    int whicharg;  ///< counted from 1
    std::string expected_, received_;
};

struct RTT_API non_lvalue_args_exception : std::runtime_error {
    non_lvalue_args_exception(int which_argument, const std::string& type);
    int whicharg;  ///< counted from 1
    std::string received_;
};

struct RTT_API invalid_handle_exception : std::runtime_error {
    invalid_handle_exception();
};

}  // namespace RTT

#endif
