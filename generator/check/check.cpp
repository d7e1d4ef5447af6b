// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <check/check.hpp>

namespace oroforge::check {

void run(const model::Package& package, diag::Sink& sink) {
    names(package, sink);
    duplicates(package, sink);
    types(package, sink);
    values(package, sink);
    activities(package, sink);
    ports(package, sink);
}

}  // namespace oroforge::check
