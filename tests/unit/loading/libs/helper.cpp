// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library that lies beside component libraries and holds none itself.
extern "C" int helper() { return 1; }
